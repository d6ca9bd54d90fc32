// The curves and the table of 40_fresnel against numbers worked by hand and by another program.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/chart.hpp"
#include "lighting/fresnel.hpp"
#include "tools/measure/fresnel_methods.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

/// Value of the lowest or highest point that has this colour in a column of a chart; a blank chart tells its scale.
struct Reader {
    raster::Image image;
    Chart scale;

    [[nodiscard]] double lowest(int x, const glm::vec3& color) const {
        double least = 1e9;
        for (int y = static_cast<int>(scale.upper_right.y); y < static_cast<int>(scale.lower_left.y); ++y) {
            if (glm::distance(image.rgb(x, y), color) > 0.05f) continue;
            const double share = (scale.lower_left.y - (y + 0.5)) / (scale.lower_left.y - scale.upper_right.y);
            least = std::min(least, scale.y.from + share * (scale.y.to - scale.y.from));
        }
        return least;
    }
    [[nodiscard]] int column(double x) const {
        return static_cast<int>(scale.place(x, scale.y.from).x);
    }
};

Reader methods_chart() {
    return {linear_panel("40_fresnel/methods.png", 1, 1, 0),
            make_chart({320, 180}, 180, "", {60.0, 90.0, 10.0}, {0.4, 1.0, 0.2})};
}

}  // namespace

TEST_CASE("40_fresnel: Schlick's curve of platinum's red is where a pocket calculator says") {
    // R0 = (1.49^2 + 4.44^2) / (3.49^2 + 4.44^2) = 0.68771; (1 - cos 80)^5 = 0.82635^5 = 0.38533
    const Reader chart = methods_chart();
    const double one_row = 0.6 / (chart.scale.lower_left.y - chart.scale.upper_right.y);
    CHECK(std::abs(chart.lowest(chart.column(80.0), kYellow) - (0.68771 + 0.31229 * 0.38533)) < 2.0 * one_row);
}

TEST_CASE("40_fresnel: the exact curve of platinum's red dips to its known minimum") {
    const Reader chart = methods_chart();
    double least = 1e9;
    for (int x = chart.column(70.0); x < chart.column(82.0); ++x) least = std::min(least, chart.lowest(x, kChalk));
    const double one_row = 0.6 / (chart.scale.lower_left.y - chart.scale.upper_right.y);
    CHECK(std::abs(least - 0.627162) < 2.0 * one_row);  // by a program of its own in long double, at 76.25 degrees
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
