#include "tools/measure/paired_times.hpp"

#include <algorithm>
#include <chrono>

#include "raster/platform.hpp"
#include "tools/measure/finding.hpp"

namespace kreda::tools {

namespace {

/// The value that this share of the values lie below, by the nearest rank.
double quantile(std::vector<double> values, double share) {
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

double milliseconds_of(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::vector<PairedTime> paired_times_of(const std::vector<std::vector<double>>& rounds) {
    KREDA_EXPECT(!rounds.empty() && !rounds.front().empty());
    std::vector<PairedTime> times;
    for (std::size_t w = 0; w < rounds.front().size(); ++w) {
        std::vector<double> own, ratios;
        std::size_t faster = 0, slower = 0;
        for (const std::vector<double>& round : rounds) {
            own.push_back(round[w]);
            ratios.push_back(round[w] / round[0]);
            faster += round[w] < round[0];
            slower += round[w] > round[0];
        }
        times.push_back({quantile(own, 0.5), quantile(own, 0.25), quantile(own, 0.75), quantile(ratios, 0.5),
                         4 * std::max(faster, slower) >= 3 * rounds.size()});
    }
    return times;
}

std::vector<PairedTime> paired_times(const std::vector<std::function<void()>>& works, int rounds) {
    KREDA_EXPECT(!works.empty() && rounds > 0);
    std::vector<std::vector<double>> taken;
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> times(works.size());
        for (std::size_t i = 0; i < works.size(); ++i) {
            const std::size_t w = (i + static_cast<std::size_t>(round)) % works.size();
            times[w] = milliseconds_of(works[w]);
        }
        taken.push_back(times);
    }
    return paired_times_of(taken);
}

std::string in_words(const PairedTime& time, const std::string& first_name) {
    if (!time.is_told_apart) return "as long as " + first_name + ": the noise is larger than the difference";
    return fixed(time.ratio, 2) + " times the time of " + first_name;
}

}  // namespace kreda::tools
