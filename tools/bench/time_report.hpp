// What `kreda render --time` prints: one line of JSON, medians over the repeated frames.
#pragma once

#include <string>
#include <vector>

#include "scene/render/render.hpp"

namespace kreda::tools {

/// The middle value; of an even number of values the mean of the middle two. Requires at least one.
[[nodiscard]] double median(std::vector<double> values);

/// Milliseconds of what a process does around its frames.
struct AroundFrames {
    double load = 0.0;   ///< reading the scene and all its files, and planning
    double bake = 0.0;   ///< the environment's maps, or reading them where they are kept
    double write = 0.0;  ///< tone mapping, encoding and writing the picture
};

/// What a row of frames of one scene took. Requires at least one frame; all have the same stages.
struct TimeReport {
    std::vector<scene::RenderStatistics> frames;
    AroundFrames around;
    int width = 0;  ///< in pixels
    int height = 0;
    int samples = 1;  ///< n x n samples a pixel
    int threads = 1;
};

/// {"stages": {"vertices": ms, ...}, "total_ms": ..., "around": {"loading": ms, "baking": ms, "encoding": ms,
/// "writing": ms}, "triangles": ..., "pixels_shaded": ..., ...} on one line.
[[nodiscard]] std::string json_line(const TimeReport& report);

}  // namespace kreda::tools
