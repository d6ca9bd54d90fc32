// Pictures of scenes and how far they are apart, in codes: steps of a display's 8 bits.
#pragma once

#include <string>
#include <vector>

#include "raster/image.hpp"
#include "scene/render/render.hpp"
#include "scene/scene.hpp"

namespace kreda::tools {

/// What a picture takes, in milliseconds.
struct Picture {
    raster::Image encoded;  ///< what the PNG holds, 0..1
    double frame_ms = 0.0;
    double bake_ms = 0.0;  ///< before the frame, where maps were not in the buffers yet
    scene::StageTimes times = {};
};

/// Renders with the buffers' memory. threads = 0: one a core.
[[nodiscard]] Picture draw_picture(const scene::Scene& scene, scene::RenderBuffers& buffers, int threads = 0);

/// A scene from text that names no files, with values in place of its own: "shading.frequency=flat".
[[nodiscard]] scene::Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {});

/// By how many codes each pixel differs: the most of its channels. Requires pictures of one size.
[[nodiscard]] std::vector<float> code_differences(const raster::Image& encoded, const raster::Image& exact);

struct CodeError {
    double mean = 0.0;
    double p99 = 0.0;  ///< 99 of 100 pixels differ by no more
    double worst = 0.0;
};
[[nodiscard]] CodeError code_error(const std::vector<float>& differences);
[[nodiscard]] CodeError code_error(const raster::Image& encoded, const raster::Image& exact);

}  // namespace kreda::tools
