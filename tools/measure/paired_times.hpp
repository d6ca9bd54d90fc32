// How long things take beside each other: every round runs each once, so that a machine that is busy is busy for all,
// and what is compared is the difference within a round.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace kreda::tools {

/// Of one work over all rounds, in milliseconds.
struct PairedTime {
    double median = 0.0;
    double lower = 0.0, upper = 0.0;  ///< quartiles: half of the rounds lie between
    double ratio = 1.0;               ///< median over the rounds of its time / the first work's
    bool is_told_apart = false;       ///< from the first work: three rounds of four agree which is faster
};

/// Each of `works` once a round, beginning with another one each time. Requires a work and a round.
[[nodiscard]] std::vector<PairedTime> paired_times(const std::vector<std::function<void()>>& works, int rounds);

/// The same from times that were taken already: a row a round, an entry a work.
[[nodiscard]] std::vector<PairedTime> paired_times_of(const std::vector<std::vector<double>>& rounds);

/// "2.35 times the time of X", or "as long as X: the noise is larger than the difference".
[[nodiscard]] std::string in_words(const PairedTime& time, const std::string& first_name);

}  // namespace kreda::tools
