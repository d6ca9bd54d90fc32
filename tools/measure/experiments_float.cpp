// How far formulas in float are from double.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/vec2.hpp>

#include "lighting/fresnel.hpp"
#include "lighting/microfacet.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/fresnel_methods.hpp"

namespace kreda::tools {

namespace {

struct FloatCase {
    std::string formula, range;
    double absolute = 0.0, relative = 0.0;  ///< greatest errors
    void add(double in_float, double exact) {
        absolute = std::max(absolute, std::abs(in_float - exact));
        if (exact != 0.0) relative = std::max(relative, std::abs(in_float - exact) / std::abs(exact));
    }
};

/// i of a sequence that fills [0, 1) evenly, one for each dimension.   Roberts 2018
double even(int i, int dimension) {
    constexpr std::array<double, 3> kSteps = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    const double x = 0.5 + kSteps[static_cast<std::size_t>(dimension)] * (i + 1);
    return x - std::floor(x);
}

FloatCase conductor_case(const std::string& range, glm::dvec2 n_range, glm::dvec2 k_range, int count) {
    FloatCase result{"exact Fresnel", range};
    for (int i = 0; i < count; ++i) {
        const float c = static_cast<float>(even(i, 0)),
                    n = static_cast<float>(n_range.x + even(i, 1) * (n_range.y - n_range.x));
        const float k = static_cast<float>(k_range.x + even(i, 2) * (k_range.y - k_range.x));
        result.add(double{lighting::fresnel_conductor(c, n, k)}, exact_fresnel(double{c}, double{n}, double{k}));
    }
    return result;
}

/// D of GGX in double from the cosine and sine that the float formula got.
FloatCase ggx_case(bool textbook, int count) {
    FloatCase result{textbook ? "GGX as printed, (n.h)^2 (a^2 - 1) + 1" : "GGX from sin^2",
                     "alpha 1e-4 .. 1, near the highlight"};
    for (int i = 0; i < count; ++i) {
        const double alpha = std::pow(10.0, -4.0 * even(i, 0)), theta = alpha * 3.0 * even(i, 1);
        const float a = static_cast<float>(alpha), c = static_cast<float>(std::cos(theta)),
                    s2 = static_cast<float>(std::sin(theta) * std::sin(theta));
        const double q = std::sin(theta) * std::sin(theta) + std::cos(theta) * std::cos(theta) * double{a} * double{a};
        const double exact = double{a} * double{a} / (3.14159265358979323846 * q * q);
        const float bracket = c * c * (a * a - 1.0f) + 1.0f;
        const float printed = a * a / (raster::kPi * bracket * bracket);
        result.add(double{textbook ? printed : lighting::ggx_distribution(c, s2, a)}, exact);
    }
    return result;
}

FloatCase pow_case(int count) {
    FloatCase result{"pow(x, y)", "x 0.01 .. 1, y 1 .. 200"};
    for (int i = 0; i < count; ++i) {
        const float x = static_cast<float>(0.01 + 0.99 * even(i, 0)), y = static_cast<float>(1.0 + 199.0 * even(i, 1));
        const double exact = std::pow(double{x}, double{y});
        if (exact > 1e-30) result.add(double{raster::pow(x, y)}, exact);
    }
    return result;
}

}  // namespace

Finding measure_float(const Effort& effort) {
    Finding finding{
        {{"formula", "range", "greatest error", "greatest relative error"}, {}},
        {"formula, in the order of the table", "greatest relative error", false, true, {{"relative", {}}}, false},
        ""};
    const int count = effort.count(100'000, 2'000'000);
    std::vector<FloatCase> cases = {conductor_case("metals, n 0.03 .. 3, k 1.5 .. 9", {0.03, 3.0}, {1.5, 9.0}, count),
                                    conductor_case("dielectrics, n 1.0001 .. 3", {1.0001, 3.0}, {0.0, 0.0}, count),
                                    conductor_case("n 0.001 .. 0.1, k 5 .. 100", {0.001, 0.1}, {5.0, 100.0}, count),
                                    ggx_case(false, count),
                                    ggx_case(true, count),
                                    pow_case(count)};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        finding.table.add({cases[i].formula, cases[i].range, digits(cases[i].absolute), digits(cases[i].relative)});
        finding.plot.series[0].points.emplace_back(static_cast<double>(i), cases[i].relative);
    }
    effort.show(1.0);
    finding.text = "Over " + std::to_string(count) + " inputs each, float errs by at most " +
                   digits(cases[0].relative) + " (relative) in the exact Fresnel term of metals, " +
                   digits(cases[3].relative) + " in GGX written with sin^2 and " +
                   (std::isfinite(cases[4].relative) ? "by " + digits(cases[4].relative) : "without any bound") +
                   " in GGX as textbooks print it: in a narrow highlight (n.h)^2 (a^2 - 1) + 1 cancels, down to 0. "
                   "pow errs by " +
                   digits(cases[5].relative) + ".";
    return finding;
}

}  // namespace kreda::tools
