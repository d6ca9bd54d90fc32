// The assignments are as good as the mistakes they catch: every one of the catalogue must cost points.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/grading/lab.hpp"
#include "tools/grade/assignment/stage_check.hpp"
#include "tools/grade/assignment/table_reader.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Does the variant answer every row as another one does? Then one of its mistakes hides the other, or they cancel out.
bool answers_like(const Lab& l, std::size_t variant, std::size_t other) {
    for (std::size_t i = 0; i < l.cases.inputs.size(); ++i) {
        const tools::RubricStage& stage = *l.rubric.find_stage(l.cases.inputs[i].stage);
        if (!tools::same_answers(stage, l.cases.inputs[i], l.catalogue.answers[variant][i],
                                 l.catalogue.answers[other][i], 0.002)) {
            return false;
        }
    }
    return true;
}

/// The first way of each mistake, as a variant.
std::vector<std::size_t> first_ways(const Lab& l) {
    std::vector<std::size_t> first(l.catalogue.mistakes.size(), 0);
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        if (mistakes.size() == 1 && first[mistakes[0]] == 0) first[mistakes[0]] = k;
    }
    return first;
}

void check_mistakes(const std::string& folder) {
    const Lab& l = lab(folder);
    const double most = points(l, l.cases.expected);
    REQUIRE(most > 0.0);
    CHECK(points(l, l.catalogue.answers[0]) == most);
    CHECK(tools::first_wrong_stage(l.rubric, l.cases, all_answered(l.catalogue.answers[0])) == "");
    std::vector<double> single(l.catalogue.mistakes.size(), -1.0);
    const std::vector<std::size_t> first = first_ways(l);
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        const std::string name = names(l, mistakes);
        CAPTURE(folder);
        CAPTURE(name);
        if (mistakes.size() == 1) {
            const double p = points(l, l.catalogue.answers[k]);
            CHECK(p < most);
            if (k == first[mistakes[0]]) single[mistakes[0]] = p;
        } else if (k % 5 == 0) {  // pairs are many
            const double p = points(l, l.catalogue.answers[k]);
            if (p <= std::min(single[mistakes[0]], single[mistakes[1]])) continue;
            const bool hidden = answers_like(l, k, 0) || answers_like(l, k, first[mistakes[0]]) ||
                                answers_like(l, k, first[mistakes[1]]);
            CHECK_MESSAGE(hidden,
                          p << " points, " << single[mistakes[0]] << " and " << single[mistakes[1]] << " alone");
        }
    }
}

void check_own_names(const std::string& folder) {
    const Lab& l = lab(folder);
    const std::vector<std::size_t> first = first_ways(l);
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        if (mistakes.size() == 2 && k % 11 != 0) continue;  // pairs are many
        const tools::Diagnosis d = diagnosis(l, l.catalogue.answers[k]);
        if (d.mistakes == mistakes) continue;
        CAPTURE(folder);
        CAPTURE(names(l, mistakes));
        CAPTURE(names(l, d.mistakes));
        REQUIRE(mistakes.size() == 2);  // a mistake alone is named
        // A pair may answer as one mistake alone: one of its own, which hides the other, or the two add up to a third.
        REQUIRE(d.mistakes.size() <= 2);
        const bool alike = answers_like(l, k, 0) || answers_like(l, k, first[d.mistakes.at(0)]);
        CHECK((alike || d.mistakes.size() == 2));
    }
}

/// The row of docs/grading.md, which is true because check_mistakes holds.
void check_table(const std::string& folder) {
    const Lab& l = lab(folder);
    std::size_t ways = 0;
    for (const tools::Mistake& mistake : l.catalogue.mistakes) ways += mistake.ways.size();
    const std::string row = "| " + l.rubric.assignment + " " + l.rubric.title + " | " +
                            std::to_string(l.catalogue.mistakes.size()) + " | " + std::to_string(ways) + " | 100 % |";
    const std::string page = tools::read_text(std::string(KREDA_SOURCE_DIR) + "/docs/grading.md");
    CHECK_MESSAGE(page.find(row) != std::string::npos, "docs/grading.md misses the row " << row);
}

}  // namespace

TEST_CASE("A1: every catalogued mistake costs points and is named") {
    check_mistakes("A1_coverage");
    check_own_names("A1_coverage");
    check_table("A1_coverage");
}
TEST_CASE("A2: every catalogued mistake costs points and is named") {
    check_mistakes("A2_depth");
    check_own_names("A2_depth");
    check_table("A2_depth");
}
TEST_CASE("A3: every catalogued mistake costs points and is named") {
    check_mistakes("A3_lights");
    check_own_names("A3_lights");
    check_table("A3_lights");
}
TEST_CASE("A4: every catalogued mistake costs points and is named") {
    check_mistakes("A4_shading");
    check_own_names("A4_shading");
    check_table("A4_shading");
}
TEST_CASE("A5: every catalogued mistake costs points and is named") {
    check_mistakes("A5_fog");
    check_own_names("A5_fog");
    check_table("A5_fog");
}
TEST_CASE("A6: every catalogued mistake costs points and is named") {
    check_mistakes("A6_microfacets");
    check_own_names("A6_microfacets");
    check_table("A6_microfacets");
}
TEST_CASE("A7: every catalogued mistake costs points and is named") {
    check_mistakes("A7_shadow_map");
    check_own_names("A7_shadow_map");
    check_table("A7_shadow_map");
}
TEST_CASE("A8: every catalogued mistake costs points and is named") {
    check_mistakes("A8_image_light");
    check_own_names("A8_image_light");
    check_table("A8_image_light");
}
