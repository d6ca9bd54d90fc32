#include "tools/tune/set_errors.hpp"

#include <cmath>

#include "raster/platform.hpp"

namespace kreda::tools {

namespace {

/// Beside what is added, each term that differs may work otherwise together with the rest: some codes for each.
constexpr double kUnmeasured = 0.05;

double mean_distance(const Differences& a, const Differences& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double{std::abs(a[i] - b[i])};
    return a.empty() ? 0.0 : sum / static_cast<double>(a.size());
}

}  // namespace

Differences signed_differences(const raster::Image& encoded, const raster::Image& other) {
    KREDA_EXPECT(encoded.width == other.width && encoded.height == other.height && encoded.channels == 3);
    Differences differences(encoded.values.size());
    for (std::size_t i = 0; i < differences.size(); ++i) {
        differences[i] = 255.0f * (encoded.values[i] - other.values[i]);
    }
    return differences;
}

CodeError error_of(const Differences& differences) {
    const std::size_t pixels = differences.size() / 3;
    std::vector<float> most(pixels, 0.0f);
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < pixels; ++i) { most[i] = std::max(most[i], std::abs(differences[c * pixels + i])); }
    }
    return code_error(most);
}

void measure_distances(SetErrors& errors) {
    errors.apart.clear();
    for (const std::vector<Differences>& options : errors.changed) {
        std::vector<std::vector<double>> rows;
        for (const Differences& one : options) {
            rows.emplace_back();
            for (const Differences& other : options) rows.back().push_back(mean_distance(one, other));
        }
        errors.apart.push_back(std::move(rows));
    }
}

double distance_from(const SetErrors& errors, const DrawnProbe& drawn, const std::vector<int>& chosen) {
    double distance = 0.0;
    for (std::size_t t = 0; t < chosen.size(); ++t) {
        if (drawn.chosen[t] == chosen[t]) continue;
        const auto from = static_cast<std::size_t>(drawn.chosen[t]), to = static_cast<std::size_t>(chosen[t]);
        distance += errors.apart[t][from][to] + kUnmeasured;
    }
    return distance;
}

CodeError predicted_error(const SetErrors& errors, const DrawnProbe& from, const std::vector<int>& chosen) {
    Differences sum = from.missed;
    for (std::size_t t = 0; t < chosen.size(); ++t) {
        if (from.chosen[t] == chosen[t]) continue;
        const Differences& less = errors.changed[t][static_cast<std::size_t>(from.chosen[t])];
        const Differences& more = errors.changed[t][static_cast<std::size_t>(chosen[t])];
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i] - less[i];
    }
    return error_of(sum);
}

}  // namespace kreda::tools
