// The numbers of plots against formulas in double and against what is known of them.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "course.hpp"

using namespace kreda::tests;

namespace {

/// Do all points of a series lie on y = f(x)? The files have six digits: x is off by 5e-5 where slopes are 0.2, so y by
/// 1e-5; the programs compute in floats.
template <class F>
void check_curve(const char* plot, const char* series, F f) {
    for (const glm::dvec2& p : golden_series(plot, series)) {
        CAPTURE(series);
        CAPTURE(p.x);
        CHECK(std::abs(p.y - f(p.x)) <= 1e-5 + 2e-5 * std::abs(f(p.x)));
    }
}

}  // namespace

TEST_CASE("30_fog: the three curves are the three formulas") {
    check_curve("30_fog/curves", "linear", [](double z) { return std::clamp((12.0 - z) / 10.0, 0.0, 1.0); });
    check_curve("30_fog/curves", "exp", [](double z) { return std::exp(-0.15 * z); });
    check_curve("30_fog/curves", "exp2", [](double z) { return std::exp(-0.0225 * z * z); });
}

TEST_CASE("70_hdr_tone_mapping: the three curves are the three formulas") {
    check_curve("70_hdr_tone_mapping/curves", "clamp", [](double L) { return std::min(L, 1.0); });
    check_curve("70_hdr_tone_mapping/curves", "Reinhard", [](double L) { return L / (1.0 + L); });
    check_curve("70_hdr_tone_mapping/curves", "extended",
                [](double L) { return std::min(L * (1.0 + L / 36.0) / (1.0 + L), 1.0); });
}

TEST_CASE("41_microfacets: no geometry term exceeds one or grows with the angle") {
    for (const char* series : {"grooves", "correlated", "Smith", "Schlick-GGX"}) {
        double last = 1.0 + 1e-5;  // floats
        for (const glm::dvec2& p : golden_series("41_microfacets/geometry", series)) {
            CAPTURE(series);
            CAPTURE(p.x);
            CHECK(p.y <= last);
            last = p.y + 1e-5;
        }
    }
    check_curve("41_microfacets/geometry", "implicit", [](double degrees) {
        const double c = std::cos(degrees * 3.14159265358979 / 180.0);
        return c * c;
    });
}

TEST_CASE("43_metals: every reflectance is a share and gold's grows from blue to red") {
    for (const char* metal : {"gold", "silver", "copper", "aluminium", "platinum"}) {
        for (const glm::dvec2& p : golden_series("43_metals/spectra", metal)) CHECK((p.y > 0.0 && p.y < 1.0));
    }
    CHECK(golden_value("43_metals/spectra", "gold", 450.0) < 0.45);
    CHECK(golden_value("43_metals/spectra", "gold", 650.0) > 0.9);
}

TEST_CASE("95_depth_precision: sixteen bits keep the gap that the derivative of depth gives") {
    // d = f (z - n) / (z (f - n)): one step of 1/65535 is z^2 (f - n) / (f n) / 65535 away, to first order in the step.
    for (const glm::dvec2& p : golden_series("95_depth_precision/steps", "16 bits")) {
        const double first_order = p.x * p.x * (1e4 - 0.01) / (1e4 * 0.01) / 65535.0;
        if (first_order > 0.01 * p.x) continue;
        CAPTURE(p.x);
        CHECK(p.y == doctest::Approx(first_order).epsilon(0.02));
    }
}

TEST_CASE("97_extremes: as printed the error is that of a difference and as arranged it is a few roundings") {
    const auto worst = [](const char* series) {
        double most = 0.0;
        for (const glm::dvec2& p : golden_series("97_extremes/fresnel", series)) most = std::max(most, p.y);
        return most;
    };
    // At c = 1 g - c is 1e-5, and g and c are rounded to 6e-8: 0.6 percent of the difference, twice that of its square.
    CHECK(worst("as printed") > 1e-3);
    CHECK(worst("as printed") < 2e-2);
    CHECK(worst("$g$ − $c$ as ($n^2$ − 1) / ($g$ + $c$)") < 1e-5);
}
