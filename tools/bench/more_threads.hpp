// How the time of a frame falls with threads: measured as far as there are cores, and beyond from the times of its
// tiles.
#pragma once

#include <string>
#include <vector>

namespace kreda::tools {

/// A frame that one thread drew.
struct FrameWork {
    double before_tiles_ms = 0.0;  ///< vertices, triangles, shadow maps: hundreds of pieces, counted as evenly shared
    std::vector<double> tile_ms;   ///< each tile, in the order in which they are drawn
};

/// When the last piece is done if each goes to the thread that is free first, in order (OpenMP's `schedule(dynamic)`),
/// in the unit of the pieces.
[[nodiscard]] double makespan(const std::vector<double>& pieces, int threads);

/// Milliseconds of the frame with so many threads, if they shared caches and memory without a loss.
[[nodiscard]] double simulated_ms(const FrameWork& work, int threads);

/// A row a scene, as a Markdown table on stdout.
void measure_threads(const std::vector<std::string>& scenes, int frames);

}  // namespace kreda::tools
