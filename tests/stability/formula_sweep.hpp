// A formula tried at the edges of its domain and at random inputs within it, beside the same equation in long double.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace kreda::tests {

/// One input: where it may lie, how random ones are spread, and what is tried for certain beside the two ends.
struct Axis {
    float low = 0.0f, high = 1.0f;
    enum class Spread { even, logarithmic } spread = Spread::even;  ///< logarithmic: low > 0
    std::vector<float> edges = {};
    std::vector<float> outside = {};  ///< of the ends, and tried all the same: 0 where the spread is logarithmic
};

using Spread = Axis::Spread;
using Real = long double;
using Inputs = std::vector<float>;

inline constexpr Real kPi = 3.14159265358979323846264L;

/// What many formulas take.
inline const Axis kCosine{0.0f, 1.0f, Spread::even, {1e-8f, 1e-4f, 0.5f}};
inline const Axis kRoughness{0.0f, 1.0f, Spread::even, {1e-8f, 0.045f, 0.5f}};

/// A vector in long double.
using Wide = glm::vec<3, Real>;

/// A unit vector as floats have it: by height and turn.
[[nodiscard]] inline glm::vec3 direction(float height, float turn) {
    const Real sine = std::sqrt((1 - Real{height}) * (1 + Real{height})), phi = 2 * kPi * turn;
    return {static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)), height};
}

inline const Axis kHeight{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, 1e-4f, 0.999999f}};
inline const Axis kTurn{0.0f, 1.0f, Spread::even, {0.5f}};
/// Where a formula takes several directions: the ends alone, for there is no end to their combinations.
inline const Axis kAnyHeight{-1.0f, 1.0f, Spread::even, {}};
inline const Axis kUpperHeight{0.0f, 1.0f, Spread::even, {}};
inline const Axis kAnyTurn{0.0f, 1.0f, Spread::even, {}};

struct Formula {
    std::string name;
    std::string domain;  ///< as the declaration has it
    std::string range;
    double lowest = 0.0, highest = 1.0;  ///< the range
    bool is_relative = false;            ///< the error is divided by the exact value, where that is at least `least`
    double most_error = 0.0;             ///< what the table may show
    std::vector<Axis> axes;
    std::function<double(const Inputs&)> value;
    std::function<Real(const Inputs&)> exact;
    double least = 1e-37;                                ///< what is smaller is as good as 0: subnormal numbers are
    std::function<double(const Inputs&)> distance = {};  ///< where it is no number: between what it gives and the exact
};

/// A formula that gives a vector: its length lies in the range, and the error is its distance from the exact one.
struct VectorFormula {
    std::string name;
    std::string domain;
    std::string range;  ///< of the length
    double longest = 1.0;
    bool is_relative = false;
    double most_error = 0.0;
    std::vector<Axis> axes;
    std::function<glm::vec3(const Inputs&)> value;
    std::function<Wide(const Inputs&)> exact;
};
[[nodiscard]] Formula formula_of(const VectorFormula& vector);

/// Both lists, one behind the other.
[[nodiscard]] std::vector<Formula> joined(std::vector<Formula> first, const std::vector<Formula>& second);

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

/// A number of a table with two digits, rounded up; and one with commas.
[[nodiscard]] std::string rounded_up(double number);
[[nodiscard]] std::string with_commas(std::uint64_t number);

/// The formulas of each group, in the order of the page.
[[nodiscard]] std::vector<Formula> formulas_of_fresnel();
[[nodiscard]] std::vector<Formula> formulas_of_schlick();
[[nodiscard]] std::vector<Formula> formulas_of_distributions();
[[nodiscard]] std::vector<Formula> formulas_of_visibility();
[[nodiscard]] std::vector<Formula> formulas_of_ward();
[[nodiscard]] std::vector<Formula> formulas_of_energy();
[[nodiscard]] std::vector<Formula> formulas_of_reflection();
[[nodiscard]] std::vector<Formula> formulas_of_models();
[[nodiscard]] std::vector<Formula> formulas_of_lights();
[[nodiscard]] std::vector<Formula> formulas_of_film();
[[nodiscard]] std::vector<Formula> formulas_of_directions();
[[nodiscard]] std::vector<Formula> formulas_of_bias();
[[nodiscard]] std::vector<Formula> formulas_of_map_points();
[[nodiscard]] std::vector<Formula> formulas_of_rays();
[[nodiscard]] std::vector<Formula> formulas_of_depth();
[[nodiscard]] std::vector<Formula> formulas_of_runs();
[[nodiscard]] std::vector<Formula> formulas_of_textures();
[[nodiscard]] std::vector<Formula> formulas_of_raster();
[[nodiscard]] std::vector<Formula> formulas_of_normals();
[[nodiscard]] std::vector<Formula> formulas_of_environments();
[[nodiscard]] std::vector<Formula> formulas_of_skies();

}  // namespace kreda::tests
