// Laws about 92: what light per triangle, per vertex and per pixel misses, against the number of triangles.
#include <vector>

#include <doctest/doctest.h>

#include "course.hpp"
#include "tools/measure/frequency_error.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

std::vector<tools::FrequencyRow> rows_of(std::size_t frequency) {
    return tools::measure_frequency_rows(frequency, {8, 16, 32, 64, 128}, tools::finest_ball(), 1, 0);
}

}  // namespace

TEST_CASE("92_shading_frequency: finer triangles err less and light computed more often errs less") {
    const std::vector<tools::FrequencyRow> flat = rows_of(0), gouraud = rows_of(1), phong = rows_of(2);
    for (std::size_t i = 0; i < flat.size(); ++i) {
        CAPTURE(flat[i].detail);
        CHECK(flat[i].error.mean > gouraud[i].error.mean);
        CHECK(gouraud[i].error.mean > phong[i].error.mean);
        if (i == 0) continue;
        for (const auto* rows : {&flat, &gouraud, &phong}) CHECK((*rows)[i].error.mean < (*rows)[i - 1].error.mean);
    }
    // A facet's colour is off by its size, a Gouraud triangle's by the square: half the side, half and a quarter. The
    // outline, which all three share, falls by the square, too. Once both are small, within a third of that.
    CHECK(flat[3].error.mean / flat[4].error.mean == doctest::Approx(2.0).epsilon(0.33));
    CHECK(gouraud[3].error.mean / gouraud[4].error.mean == doctest::Approx(4.0).epsilon(0.33));
}

TEST_CASE("92_shading_frequency: the table of the page") {
    const char* names[3] = {"flat", "Gouraud", "Phong"};
    for (std::size_t f = 0; f < 3; ++f) {
        const std::vector<tools::FrequencyRow> rows = rows_of(f);
        const std::vector<QuotedNumber> page = documented_row("92_shading_frequency", "mean error", names[f]);
        REQUIRE(page.size() == rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            CAPTURE(names[f]);
            CAPTURE(rows[i].detail);
            CHECK(rounds_to(rows[i].error.mean, page[i]));
        }
    }
}
