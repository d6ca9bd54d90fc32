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

/// Fewer where somebody wants an answer soon; the page's table is made with all.
int random_inputs() {
    const char* const wish = std::getenv("KREDA_SWEEP_INPUTS");
    return wish ? std::atoi(wish) : kRandomInputs;
}

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
        const SweepResult result = sweep(formula, random_inputs());
        CAPTURE(formula.name);
        CAPTURE(list_of(result.where_outside));
        CHECK(result.outside == 0);
        CAPTURE(list_of(result.where));
        CHECK(result.error <= formula.most_error);
        if (random_inputs() != kRandomInputs) continue;
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

TEST_CASE("formulas: models of reflection over their whole domain") {
    check_all(formulas_of_models());
}

TEST_CASE("formulas: directions and frames over their whole domain") {
    check_all(formulas_of_directions());
}

TEST_CASE("formulas: depth and angles over their whole domain") {
    check_all(formulas_of_depth());
}

TEST_CASE("formulas: textures over their whole domain") {
    check_all(formulas_of_textures());
}
