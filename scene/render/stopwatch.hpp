// Milliseconds between laps.
#pragma once

#include <chrono>

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

}  // namespace kreda::scene
