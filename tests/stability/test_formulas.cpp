// Every formula over its whole domain: the result is in its range, its error below what is stated, and the page of
// 97_extremes shows the table.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include <doctest/doctest.h>

#include "tests/stability/formula_sweep.hpp"

using namespace kreda::tests;

namespace {

constexpr int kRandomInputs = 60'000;

std::string page() {
    std::ifstream file(KREDA_SOURCE_DIR "/docs/97_extremes.md");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string list_of(const Inputs& inputs) {
    std::ostringstream list;
    list.precision(9);
    for (const float x : inputs) list << x << " ";
    return list.str();
}

void check_all(const std::vector<Formula>& formulas) {
    const std::string text = page();
    for (const Formula& formula : formulas) {
        const SweepResult result = sweep(formula, kRandomInputs);
        CAPTURE(formula.name);
        CAPTURE(list_of(result.where_outside));
        CHECK(result.outside == 0);
        CAPTURE(list_of(result.where));
        CHECK(result.error <= formula.most_error);
        const std::string row = table_row(formula, result);
        const bool is_on_page = text.find(row + "\n") != std::string::npos;
        CHECK_MESSAGE(is_on_page, "docs/97_extremes.md needs the row\n", row);
        if (std::getenv("KREDA_PRINT_FORMULAS")) std::cout << row << "\n";
    }
}

}  // namespace

TEST_CASE("formulas: Fresnel over its whole domain") {
    check_all(formulas_of_fresnel());
}

TEST_CASE("formulas: microfacets over their whole domain") {
    check_all(formulas_of_microfacets());
}

TEST_CASE("formulas: energy over its whole domain") {
    check_all(formulas_of_energy());
}

TEST_CASE("formulas: reflection over its whole domain") {
    check_all(formulas_of_reflection());
}

TEST_CASE("formulas: lights and fog and film over their whole domain") {
    check_all(formulas_of_lights());
}

TEST_CASE("formulas: scalar functions over their whole domain") {
    check_all(formulas_of_raster());
}

TEST_CASE("formulas: bias of shadow maps over its whole domain") {
    check_all(formulas_of_shadows());
}
