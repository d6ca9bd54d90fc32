// How long one thread was in each pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/render/stopwatch.hpp"

namespace kreda::scene {

/// Laps follow each other without a gap: what happens between two passes counts for the second one. In ticks().
struct PassClock {
    std::uint64_t last = 0;
    std::vector<std::uint64_t> spent;  ///< one a pass of the plan

    void clear(std::size_t pass_count) {
        spent.assign(pass_count, 0);
    }
    void start() {
        last = ticks();
    }
    /// What went by since the last lap belongs to this pass.
    void lap(std::size_t pass) {
        const std::uint64_t now = ticks();
        spent[pass] += now - last;
        last = now;
    }
};

}  // namespace kreda::scene
