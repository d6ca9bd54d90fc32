// How long things take, each a few times.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace kreda::examples {

/// Milliseconds of each: the shortest of `rounds`, for whatever else the machine does only adds. Everything runs once a
/// round, so that a busy minute is busy for all.
inline std::vector<double> shortest_times(const std::vector<std::function<void()>>& works, int rounds) {
    std::vector<double> shortest(works.size(), 1e30);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < works.size(); ++i) {
            const auto begin = std::chrono::steady_clock::now();
            works[i]();
            const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
            shortest[i] = std::min(shortest[i], time.count());
        }
    }
    return shortest;
}

}  // namespace kreda::examples
