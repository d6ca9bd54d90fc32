#include "tools/debugger/debug_save.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"

namespace kreda::tools {

namespace {

/// The nearest depth is 1, the farthest 0.2, what nothing covers 0.
raster::Image picture_of_depth(const float* depth, int width, int height) {
    raster::Image image = raster::make_image(width, height, 1);
    float nearest = raster::kClearDepth;
    float farthest = 0.0f;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        if (depth[i] >= raster::kClearDepth) continue;
        nearest = std::min(nearest, depth[i]);
        farthest = std::max(farthest, depth[i]);
    }
    const float range = farthest > nearest ? farthest - nearest : 1.0f;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const bool covered = depth[i] < raster::kClearDepth;
        image.values[i] = covered ? 1.0f - 0.8f * (depth[i] - nearest) / range : 0.0f;
    }
    return image;
}

/// No exception may leave a function that a debugger calls.
bool save(const char* path, const raster::Image& encoded) {
    try {
        scene::write_png(path, encoded);
        return true;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return false;
    }
}

}  // namespace

}  // namespace kreda::tools

using namespace kreda;

[[gnu::used]] bool kreda_save_image(const raster::Image* image, const char* path) {
    return tools::save(path, develop(*image, raster::FilmSettings{}));
}

[[gnu::used]] bool kreda_save_visibility(const raster::VisibilityBuffer* buffer, const char* path) {
    return tools::save(path, tools::picture_of_depth(buffer->depth.data(), buffer->width, buffer->height));
}

[[gnu::used]] bool kreda_save_tile(const raster::TileVisibility* tile, const char* path) {
    return tools::save(path, tools::picture_of_depth(tile->depth, raster::kTileSide, raster::kTileSide));
}

[[gnu::used]] bool kreda_save_frame_depth(const scene::Frame* frame, const char* path) {
    const raster::VisibilityBuffer buffer =
        rasterize_tiled(frame->buffers.streams, frame->buffers.triangles, frame->plan.viewport);
    return kreda_save_visibility(&buffer, path);
}

[[gnu::used]] bool kreda_save_frame_film(const scene::Frame* frame, const char* path) {
    return kreda_save_image(&frame->buffers.film, path);
}
