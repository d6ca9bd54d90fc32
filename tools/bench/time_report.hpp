// What `kreda render --time` prints: one line of JSON, medians over the repeated frames.
#pragma once

#include <string>
#include <vector>

#include "scene/render/render.hpp"

namespace kreda::tools {

/// The middle value; of an even number of values the mean of the middle two. Requires at least one.
[[nodiscard]] double median(std::vector<double> values);

/// What a row of frames of one scene took. Requires at least one frame; all have the same stages.
struct TimeReport {
    std::vector<scene::RenderStatistics> frames;
    int width = 0;  ///< in pixels
    int height = 0;
    int samples = 1;  ///< n x n samples a pixel
    int threads = 1;
};

/// {"stages": {"vertices": ms, ...}, "total_ms": ..., "triangles": ..., "pixels_shaded": ..., ...} on one line.
[[nodiscard]] std::string json_line(const TimeReport& report);

}  // namespace kreda::tools
