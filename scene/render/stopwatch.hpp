// Time between laps: of passes in milliseconds, of the many small steps of a thread in ticks.
#pragma once

#include <chrono>
#include <cstdint>

namespace kreda::scene {

class Stopwatch {
public:
    /// Time since the last lap (or the beginning), in milliseconds.
    double lap_ms() {
        const Clock::time_point now = Clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

/// A counter that grows evenly; asking for it takes a few nanoseconds. Only ratios of its differences mean something.
inline std::uint64_t ticks() {
#if defined(__x86_64__)
    return __builtin_ia32_rdtsc();
#else
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

}  // namespace kreda::scene
