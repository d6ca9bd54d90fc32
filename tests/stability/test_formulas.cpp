// Every formula over its whole domain: the result is in its range, its error below what is stated, and the page of
// 97_extremes shows the table.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include "tests/stability/formula_sweep.hpp"

using namespace kreda::tests;

namespace {

constexpr int kRandomInputs = 30'000;

/// Fewer where somebody wants an answer soon; the page's table is made with all.
int random_inputs() {
    const char* const wish = std::getenv("KREDA_SWEEP_INPUTS");
    return wish ? std::atoi(wish) : kRandomInputs;
}

std::string page_name() {
    return KREDA_SOURCE_DIR "/docs/97_extremes.md";
}

std::string page() {
    std::ifstream file(page_name());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// What stands between marks.
std::vector<std::string> parts_of(const std::string& text, char mark) {
    std::vector<std::string> parts;
    std::istringstream rest(text);
    for (std::string part; std::getline(rest, part, mark);) parts.push_back(part);
    return parts;
}

/// Do these cells of a table say the same? Two that begin with an error, "1.2e-07 at 0.5", may be a tenth apart and
/// found elsewhere: the logarithms and sines that inputs are made with come from the C library, and each rounds them
/// its own way.
bool is_same_cell(const std::string& a, const std::string& b) {
    const double x = std::atof(a.c_str()), y = std::atof(b.c_str());
    const bool are_errors = x > 0.0 && a.find("e-") == 4 && b.find("e-") == 4;
    return a == b || (are_errors && std::fabs(x - y) <= 0.1 * std::max(x, y));
}

bool is_same_row(const std::string& a, const std::string& b) {
    const std::vector<std::string> these = parts_of(a, '|'), those = parts_of(b, '|');
    return std::equal(these.begin(), these.end(), those.begin(), those.end(), is_same_cell);
}

bool is_same_table(const std::string& a, const std::string& b) {
    const std::vector<std::string> these = parts_of(a, '\n'), those = parts_of(b, '\n');
    return std::equal(these.begin(), these.end(), those.begin(), those.end(), is_same_row);
}

std::string list_of(const Inputs& inputs) {
    std::ostringstream list;
    list.precision(9);
    for (const float x : inputs) list << x << " ";
    return list.str();
}

/// The table of a group, as the page has it.
struct GroupTable {
    std::string title;
    std::size_t rows = 0;
    std::uint64_t tried = 0;
    double of_range = 0.0, of_result = 0.0;  ///< the largest errors: of the range's larger end, of the result
    std::string worst_of_range = "", worst_of_result = "";  ///< whose they are
    std::string lines = "";

    void add(const Formula& formula, const SweepResult& result) {
        ++rows;
        tried += result.tried;
        lines += table_row(formula, result) + "\n";
        const double range = std::max({std::fabs(formula.lowest), std::fabs(formula.highest), 1.0});
        const double error = formula.is_relative ? result.error : result.error / range;
        double& largest = formula.is_relative ? of_result : of_range;
        if (error <= largest) return;
        largest = error;
        (formula.is_relative ? worst_of_result : worst_of_range) = " (`" + formula.name + "`)";
    }
    [[nodiscard]] std::string summary() const {
        return "| " + title + " | " + std::to_string(rows) + " | " + rounded_up(of_range) + worst_of_range + " | " +
               rounded_up(of_result) + worst_of_result + " | " + with_commas(tried) + " |\n";
    }
    [[nodiscard]] std::string begin() const {
        return "<details><summary>" + title + "</summary>";
    }
    [[nodiscard]] std::string table() const {
        return begin() + "\n\n| formula | domain | range | largest error | tried |\n| --- | --- | --- | --- | --- |\n" +
               lines + "\n</details>\n";
    }
};

/// The part of the page from one mark to the end of the next.
std::string part_of_page(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin), to = text.find(end, from);
    REQUIRE(from != std::string::npos);
    REQUIRE(to != std::string::npos);
    return text.substr(from, to + end.size() - from);
}

/// The group's line of the page's first table, and its own table.
struct GroupOnPage {
    std::string summary, table;
};
GroupOnPage group_on_page(const std::string& text, const GroupTable& group) {
    return {part_of_page(text, "| " + group.title + " |", "|\n"), part_of_page(text, group.begin(), "</details>\n")};
}

void write_to_page(const GroupTable& group) {
    std::string text = page();
    const GroupOnPage old = group_on_page(text, group);
    text.replace(text.find(old.summary), old.summary.size(), group.summary());
    text.replace(text.find(old.table), old.table.size(), group.table());
    std::ofstream(page_name()) << text;
}

void check_group(const std::string& title, const std::vector<Formula>& formulas) {
    GroupTable group{title};
    for (const Formula& formula : formulas) {
        const SweepResult result = sweep(formula, random_inputs());
        CAPTURE(formula.name);
        CAPTURE(formula.domain);
        CAPTURE(list_of(result.where_outside));
        CHECK(result.outside == 0);
        CAPTURE(list_of(result.where));
        CHECK(result.error <= formula.most_error);
        group.add(formula, result);
    }
    if (random_inputs() != kRandomInputs) return;
    if (std::getenv("KREDA_WRITE_FORMULAS")) write_to_page(group);
    const GroupOnPage on_page = group_on_page(page(), group);
    const bool is_on_page =
        is_same_table(on_page.summary, group.summary()) && is_same_table(on_page.table, group.table());
    CHECK_MESSAGE(is_on_page, "docs/97_extremes.md has another table of ", title,
                  ": KREDA_WRITE_FORMULAS=1 test_stability -tc=formulas* writes it");
}

}  // namespace

TEST_CASE("formulas: Fresnel over the whole domain") {
    check_group("Fresnel", formulas_of_fresnel());
}

TEST_CASE("formulas: Schlick over the whole domain") {
    check_group("Fresnel: Schlick and tables", formulas_of_schlick());
}

TEST_CASE("formulas: distributions of facets over the whole domain") {
    check_group("Facets: how many", formulas_of_distributions());
}

TEST_CASE("formulas: visibility of facets over the whole domain") {
    check_group("Facets: seen by light and viewer", formulas_of_visibility());
}

TEST_CASE("formulas: Ward over the whole domain") {
    check_group("Ward", formulas_of_ward());
}

TEST_CASE("formulas: energy over the whole domain") {
    check_group("Energy", formulas_of_energy());
}

TEST_CASE("formulas: reflection over the whole domain") {
    check_group("Reflection: parts", formulas_of_reflection());
}

TEST_CASE("formulas: models of reflection over the whole domain") {
    check_group("Reflection: models", formulas_of_models());
}

TEST_CASE("formulas: lights and fog over the whole domain") {
    check_group("Lights and fog", formulas_of_lights());
}

TEST_CASE("formulas: film over the whole domain") {
    check_group("Film", formulas_of_film());
}

TEST_CASE("formulas: directions and frames over the whole domain") {
    check_group("Directions and frames", formulas_of_directions());
}

TEST_CASE("formulas: bias of shadow maps over the whole domain") {
    check_group("Shadow maps: bias", formulas_of_bias());
}

TEST_CASE("formulas: places on shadow maps over the whole domain") {
    check_group("Shadow maps: places", formulas_of_map_points());
}

TEST_CASE("formulas: exact shadows over the whole domain") {
    check_group("Exact shadows", formulas_of_rays());
}

TEST_CASE("formulas: depth and angles over the whole domain") {
    check_group("Depth and angles", formulas_of_depth());
}

TEST_CASE("formulas: weights along a run over the whole domain") {
    check_group("Weights along a run", formulas_of_runs());
}

TEST_CASE("formulas: textures over the whole domain") {
    check_group("Textures", formulas_of_textures());
}

TEST_CASE("formulas: scalar functions over the whole domain") {
    check_group("Scalar functions", formulas_of_raster());
}

TEST_CASE("formulas: normals over the whole domain") {
    check_group("Normals", formulas_of_normals());
}

TEST_CASE("formulas: places in environments over the whole domain") {
    check_group("Environments: places", formulas_of_environments());
}

TEST_CASE("formulas: light of environments over the whole domain") {
    check_group("Environments: light", formulas_of_skies());
}
