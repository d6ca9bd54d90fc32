#include "tools/measure/picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"

namespace kreda::tools {

Picture draw_picture(const scene::Scene& scene, scene::RenderBuffers& buffers, int threads) {
    const auto begin = std::chrono::steady_clock::now();
    const scene::RenderStatistics statistics = render(scene, make_plan(scene), buffers, threads);
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - begin;
    const double frame = statistics.times.total_ms;
    return {develop(buffers.film, film_settings(scene.image)), frame, std::max(all.count() - frame, 0.0),
            statistics.times};
}

scene::Scene scene_of(const std::string& text, const std::vector<std::string>& overrides) {
    return scene::read_scene_text(text, "experiment", "", {.overrides = overrides});
}

std::vector<float> code_differences(const raster::Image& encoded, const raster::Image& exact) {
    KREDA_EXPECT(encoded.width == exact.width && encoded.height == exact.height);
    KREDA_EXPECT(encoded.channels == exact.channels);
    std::vector<float> differences(encoded.plane_size(), 0.0f);
    for (int c = 0; c < encoded.channels; ++c) {
        for (std::size_t i = 0; i < differences.size(); ++i) {
            const int codes =
                int{scene::byte_from_encoded(encoded.plane(c)[i])} - scene::byte_from_encoded(exact.plane(c)[i]);
            differences[i] = std::max(differences[i], static_cast<float>(std::abs(codes)));
        }
    }
    return differences;
}

CodeError code_error(const std::vector<float>& differences) {
    if (differences.empty()) return {};
    std::vector<float> sorted = differences;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(sorted.size()))) - 1;
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    const double sum = std::accumulate(differences.begin(), differences.end(), 0.0);
    return {sum / static_cast<double>(differences.size()), double{sorted[static_cast<std::size_t>(rank)]},
            double{*std::max_element(differences.begin(), differences.end())}};
}

CodeError code_error(const raster::Image& encoded, const raster::Image& exact) {
    return code_error(code_differences(encoded, exact));
}

}  // namespace kreda::tools
