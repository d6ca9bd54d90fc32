// The curves and the table of 40_fresnel against numbers worked by hand and by another program.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "course.hpp"
#include "lighting/fresnel.hpp"
#include "tools/measure/fresnel_methods.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;

TEST_CASE("40_fresnel: Schlick's curve of platinum's red is where a pocket calculator says") {
    // R0 = (1.49^2 + 4.44^2) / (3.49^2 + 4.44^2) = 0.68771; (1 - cos 80)^5 = 0.82635^5 = 0.38533
    const double F = golden_value("40_fresnel/methods", "\"Schlick, NVIDIA 5\"", 80.0);
    CHECK(std::abs(F - (0.68771 + 0.31229 * 0.38533)) < 2e-5);  // of numbers with five digits
}

TEST_CASE("40_fresnel: the exact curve of platinum's red dips to its known minimum") {
    double least = 1e9;
    for (const glm::dvec2& p : golden_series("40_fresnel/methods", "exact")) least = std::min(least, p.y);
    // By a program of its own in long double, at 76.25 degrees; a point every quarter of a degree.
    CHECK(std::abs(least - 0.627162) < 2e-6);
}

TEST_CASE("40_fresnel: p vanishes at Brewster's angle and both are one when light grazes") {
    for (const auto& [plot, n] : {std::pair("40_fresnel/water", 1.33), std::pair("40_fresnel/germanium", 4.01)}) {
        const double brewster = std::atan(n) * 180.0 / std::numbers::pi;
        glm::dvec2 least(0.0, 1e9);
        for (const glm::dvec2& p : golden_series(plot, "$p$")) least = p.y < least.y ? p : least;
        CHECK(std::abs(least.x - brewster) <= 0.375);  // half a step of 0.75 degrees
        CHECK(golden_value(plot, "mean", 90.0) == doctest::Approx(1.0).epsilon(1e-5));
        const double at_0 = (n - 1.0) / (n + 1.0);
        CHECK(golden_value(plot, "mean", 0.0) == doctest::Approx(at_0 * at_0).epsilon(1e-4));
    }
}

TEST_CASE("40_fresnel: every number of the page's table is what a million angles give") {
    const std::vector<float> cosines = cosines_of_even_angles(1'000'000);
    std::vector<std::vector<double>> errors;
    for (const char* name : {"gold", "platinum", "water", "diamond"}) {
        const lighting::ThreeChannelIndex index = lighting::published_index(name);
        errors.push_back(mean_errors_percent(fresnel_curves(index), index, cosines));
    }
    const std::pair<const char*, std::size_t> rows[] = {
        {"(4) Schlick with k", 1}, {"(5) corrected", 2}, {"(6) F82", 4}, {"(7) table of 16", 5}};
    for (const auto& [row, method] : rows) {
        CAPTURE(std::string(row));
        const std::vector<QuotedNumber> quoted = documented_row("40_fresnel", "gold", row);
        REQUIRE(quoted.size() == errors.size());
        for (std::size_t m = 0; m < errors.size(); ++m) {
            CAPTURE(m);
            CAPTURE(errors[m][method]);
            CHECK(rounds_to(errors[m][method], quoted[m]));
        }
    }
    CHECK(rounds_to(errors[0][3], quoted_number("40_fresnel", "gold_as_printed")));
    CHECK(rounds_to(errors[1][3], quoted_number("40_fresnel", "platinum_as_printed")));
}

TEST_CASE("40_fresnel: the numbers of the page worked by hand") {
    CHECK(lighting::f0_from_index(1.5f, 0.0f) == doctest::Approx(documented_number("40_fresnel", "glass")));
    const double brewster = documented_number("40_fresnel", "brewster") * std::numbers::pi / 180.0;
    CHECK(std::tan(brewster) == doctest::Approx(4.01).epsilon(0.01));
}

TEST_CASE("40_fresnel: the curves by index and NVIDIA's form are what their equations give") {
    // Fresnel's equations in double; the sine of the refracted ray by Snell.
    const auto exact = [](double degrees, double n) {
        const double theta = degrees * 3.14159265358979 / 180.0, c = std::cos(theta), s = std::sin(theta) / n;
        const double t = std::sqrt(1.0 - s * s);
        const double r_s = (c - n * t) / (c + n * t), r_p = (n * c - t) / (n * c + t);
        return 0.5 * (r_s * r_s + r_p * r_p);
    };
    const double hydrogen = golden_value("40_fresnel/index_of_refraction", "1.001", 0.0);
    CHECK(rounds_to(hydrogen, quoted_number("40_fresnel", "hydrogen")));
    CHECK(hydrogen == doctest::Approx(exact(0.0, 1.001)).epsilon(1e-3));  // n - 1 in floats
    for (const double degrees : {60.0, 75.0}) {
        CHECK(golden_value("40_fresnel/index_of_refraction", "4.010", degrees) ==
              doctest::Approx(exact(degrees, 4.01)).epsilon(1e-4));
    }
    const double x = 1.0 - std::cos(80.25 * 3.14159265358979 / 180.0);
    CHECK(golden_value("40_fresnel/nvidia", "6", 80.25) == doctest::Approx(0.05 + 0.8 * std::pow(x, 6)).epsilon(1e-4));
    CHECK(rounds_to(exact(60.0, 1.33), quoted_number("40_fresnel", "water_60")));
    CHECK(rounds_to(exact(80.0, 1.33), quoted_number("40_fresnel", "water_80")));
    CHECK(rounds_to(golden_value("40_fresnel/nvidia", "5", 60.0), quoted_number("40_fresnel", "nvidia_60")));
    const auto schlick = [](double c) { return 0.02 + 0.98 * std::pow(1.0 - c, 5); };
    CHECK(rounds_to(schlick(std::cos(80.0 * 3.14159265358979 / 180.0)), quoted_number("40_fresnel", "nvidia_80")));
}
