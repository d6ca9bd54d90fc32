// A formula tried at the edges of its domain and at random inputs within it, beside the same equation in long double.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kreda::tests {

/// One input: where it may lie, how random ones are spread, and what is tried for certain beside the two ends.
struct Axis {
    float low = 0.0f, high = 1.0f;
    enum class Spread { even, logarithmic } spread = Spread::even;  ///< logarithmic: low > 0
    std::vector<float> edges = {};
};

using Spread = Axis::Spread;
using Real = long double;
using Inputs = std::vector<float>;

inline constexpr Real kPi = 3.14159265358979323846264L;

/// What many formulas take.
inline const Axis kCosine{0.0f, 1.0f, Spread::even, {1e-8f, 1e-4f, 0.5f}};
inline const Axis kRoughness{0.0f, 1.0f, Spread::even, {1e-8f, 0.045f, 0.5f}};

struct Formula {
    std::string name;
    std::string domain;  ///< as the declaration has it
    std::string range;
    double lowest = 0.0, highest = 1.0;  ///< the range
    bool is_relative = false;            ///< the error is divided by the exact value, where that is at least `least`
    double most_error = 0.0;             ///< what the table may show
    std::vector<Axis> axes;
    std::function<float(const Inputs&)> value;
    std::function<long double(const Inputs&)> exact;
    double least = 1e-37;  ///< what is smaller is as good as 0: subnormal numbers are
};

/// What was found.
struct SweepResult {
    std::uint64_t tried = 0;
    std::uint64_t outside = 0;  ///< of the range, NaN and infinity among them
    double error = 0.0;         ///< the largest
    Inputs where;               ///< its inputs
    Inputs where_outside;       ///< the first of those
};

/// All combinations of ends and edges, then `random` others; the same ones on every machine.
[[nodiscard]] SweepResult sweep(const Formula& formula, int random);

/// "| `fresnel_schlick` | c, R_0 in [0, 1] | [0, 1] | 1.1e-07 at 0.25, 0.5 | 120,000 |". The error is rounded up.
[[nodiscard]] std::string table_row(const Formula& formula, const SweepResult& result);

/// The formulas of each header.
[[nodiscard]] std::vector<Formula> formulas_of_fresnel();
[[nodiscard]] std::vector<Formula> formulas_of_microfacets();
[[nodiscard]] std::vector<Formula> formulas_of_energy();
[[nodiscard]] std::vector<Formula> formulas_of_lights();
[[nodiscard]] std::vector<Formula> formulas_of_reflection();
[[nodiscard]] std::vector<Formula> formulas_of_raster();
[[nodiscard]] std::vector<Formula> formulas_of_shadows();

}  // namespace kreda::tests
