#include "scene/render/debug_pixel.hpp"

#include <algorithm>

namespace kreda::scene {

DebugPixel debug_pixel;

// The empty asm statement keeps a compiler that looks through all files at once from dropping the calls.
void picture_begins([[maybe_unused]] int width, [[maybe_unused]] int height) {
    asm volatile("");
}
void pixel_reached([[maybe_unused]] int x, [[maybe_unused]] int y) {
    asm volatile("");
}
void pixel_not_covered([[maybe_unused]] int x, [[maybe_unused]] int y) {
    asm volatile("");
}

glm::ivec2 sample_to_debug(const raster::TileArea& area, int n) {
    const int x = debug_pixel.x * n + n / 2 - area.x;
    const int y = debug_pixel.y * n + n / 2 - area.y;
    const bool in_tile = debug_pixel.x >= 0 && x >= 0 && x < area.width && y >= 0 && y < area.height;
    return in_tile ? glm::ivec2(x, y) : glm::ivec2(-1);
}

int cut_out_sample(raster::Run* runs, int& run_count, const glm::ivec2& sample) {
    using raster::Run;
    const auto holds_sample = [=](const Run& run) {
        const int along = sample.x - run.x;
        return run.y == sample.y && along >= 0 && along % run.step == 0 && along / run.step < run.count;
    };
    Run* const end = runs + run_count;
    Run* at = std::find_if(runs, end, holds_sample);
    if (at == end) return run_count;

    const Run whole = *at;
    const auto part = [&](int first_x, int count) {
        Run run = whole;
        run.x = static_cast<std::uint16_t>(first_x);
        run.count = static_cast<std::uint16_t>(count);
        return run;
    };
    const int before = (sample.x - whole.x) / whole.step;
    const int after = whole.count - before - 1;
    const int more = (before > 0) + (after > 0);
    std::copy_backward(at + 1, end, end + more);
    run_count += more;
    if (before > 0) *at++ = part(whole.x, before);
    *at = part(sample.x, 1);
    if (after > 0) at[1] = part(sample.x + whole.step, after);
    return static_cast<int>(at - runs);
}

}  // namespace kreda::scene
