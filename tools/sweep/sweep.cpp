#include "tools/sweep/sweep.hpp"

#include <algorithm>
#include <cstdlib>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/plan/plan.hpp"
#include "tools/draw/draw.hpp"

namespace kreda::tools {

raster::Image SweepRenderer::draw(const std::vector<std::string>& values) {
    SceneOptions options = options_;
    options.read.overrides.insert(options.read.overrides.end(), values.begin(), values.end());
    options.read.files = &kept_->files;
    scene::PlanRequest request;
    if (view_) request = {.views = {view_}, .film = false};
    auto [scene, plan] = load_and_plan(options, request);
    options_.quiet = true;  // what was said of the first picture holds for the others
    bake_kept(scene, plan, cache_, *kept_);
    render(scene, plan, kept_->buffers, threads_);
    return view_ ? as_rgb(picture_of(*view_, kept_->buffers.views[0], scene).encoded)
                 : raster::develop(kept_->buffers.film, film_settings(scene.image));
}

glm::ivec2 SweepRenderer::picture_size() {
    SceneOptions options = options_;
    options.quiet = true;
    options.read.files = &kept_->files;
    options.read.maps_later = true;  // the size alone is asked for
    const scene::Scene scene = load_scene(options);
    return {scene.image.width, scene.image.height};
}

void SweepRenderer::set_size(glm::ivec2 size) {
    options_.size = std::to_string(size.x) + "x" + std::to_string(size.y);
}

PictureError picture_error(const raster::Image& actual, const raster::Image& expected) {
    PictureError error;
    double sum = 0.0;
    for (std::size_t i = 0; i < actual.values.size(); ++i) {
        const int difference = std::abs(int{scene::byte_from_encoded(actual.values[i])} -
                                        int{scene::byte_from_encoded(expected.values[i])});
        sum += difference;
        error.worst = std::max(error.worst, difference);
    }
    error.mean = actual.values.empty() ? 0.0 : sum / static_cast<double>(actual.values.size());
    return error;
}

raster::Image picture_difference(const raster::Image& actual, const raster::Image& expected) {
    raster::Image difference = actual;
    for (std::size_t i = 0; i < actual.values.size(); ++i) {
        const int codes =
            int{scene::byte_from_encoded(actual.values[i])} - int{scene::byte_from_encoded(expected.values[i])};
        difference.values[i] = static_cast<float>(std::clamp(128 + 4 * codes, 0, 255)) / 255.0f;
    }
    return difference;
}

}  // namespace kreda::tools
