#include "examples/view_panels.hpp"

#include "raster/film.hpp"
#include "scene/plan/views.hpp"

namespace kreda::examples {

namespace {

/// Bytes as a PNG holds them, grey or sRGB, to the linear RGB that `save` encodes.
Image decoded(const Image& encoded) {
    Image picture = make_board(encoded.width, encoded.height);
    for (int y = 0; y < encoded.height; ++y) {
        for (int x = 0; x < encoded.width; ++x) {
            const glm::vec3 byte = encoded.rgb(x, y);
            picture.set_rgb(
                x, y,
                {raster::linear_from_srgb(byte.x), raster::linear_from_srgb(byte.y), raster::linear_from_srgb(byte.z)});
        }
    }
    return picture;
}

}  // namespace

Image shown(const scene::Scene& scene, const Image& radiance) {
    raster::FilmSettings film = film_settings(scene.image);
    film.transfer = raster::Transfer::linear;
    return develop(radiance, film);
}

std::vector<Panel> view_panels(const scene::Scene& scene, const std::vector<NamedView>& views,
                               scene::RenderBuffers buffers) {
    std::vector<const scene::View*> wanted;
    for (const NamedView& view : views) wanted.push_back(scene::find_view(view.view));
    render(scene, make_plan(scene, wanted), buffers);
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < views.size(); ++i) {
        Image& values = buffers.views[i];
        for (float& value : values.values) value *= views[i].gain;
        panels.emplace_back(decoded(picture_of(*wanted[i], values, scene).encoded), std::string(views[i].caption));
    }
    return panels;
}

}  // namespace kreda::examples
