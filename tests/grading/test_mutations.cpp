// The assignments are as good as the mistakes they catch: every one of the catalogue must cost points.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>

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
        const tools::VariantAnswers& answers = l.catalogue.answers;
        if (!tools::same_answers(stage, l.cases.inputs[i], answers.of(variant, i), answers.of(other, i), 0.002)) {
            return false;
        }
    }
    return true;
}

/// Does it answer as the solution does, or as a single mistake that was named?
bool is_hidden_by(const Lab& l, std::size_t variant, const std::vector<std::size_t>& named) {
    bool hidden = answers_like(l, variant, 0);
    for (std::size_t k = 1; k < l.catalogue.variants.size() && !hidden; ++k) {
        hidden = l.catalogue.variants[k].mistakes == named && answers_like(l, variant, k);
    }
    return hidden;
}

/// Two turns of the fog's factor: with linear fog the second undoes the first, and pictures of it are right.
bool undo_each_other(const std::string& folder, const std::string& pair) {
    return folder == "A5_fog" && pair == "fog_inverted, linear_upside_down";
}

/// Every way of every mistake costs points, and no pair of ways scores more than either of its two.
void check_mistakes(const std::string& folder) {
    const Lab& l = lab(folder);
    const double most = points_of(marking(l, l.cases.expected));
    REQUIRE(most > 0.0);
    CHECK(points_of(marking(l, 0)) == most);
    CHECK(tools::first_wrong_stage(marking(l, 0)) == "");
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> single;  // mistake and way -> variant
    std::vector<double> points;
    for (std::size_t k = 0; k < l.catalogue.variants.size(); ++k) {
        const tools::Variant& variant = l.catalogue.variants[k];
        CAPTURE(folder);
        CAPTURE(names(l, variant.mistakes));
        points.push_back(points_of(marking(l, k)));
        if (variant.ways.size() == 1) {
            CHECK(points[k] < most);
            single[{variant.mistakes[0], variant.ways[0]}] = k;
        } else if (variant.ways.size() == 2) {
            const std::size_t a = single.at({variant.mistakes[0], variant.ways[0]});
            const std::size_t b = single.at({variant.mistakes[1], variant.ways[1]});
            if (points[k] <= std::min(points[a], points[b])) continue;
            const bool in_part = undo_each_other(folder, names(l, variant.mistakes));
            if (in_part && points[k] <= std::max(points[a], points[b])) continue;
            const bool hidden = answers_like(l, k, 0) || answers_like(l, k, a) || answers_like(l, k, b);
            CHECK_MESSAGE(hidden, points[k] << " points, " << points[a] << " and " << points[b] << " alone");
        }
    }
}

/// The diagnosis names every way of every mistake, and every pair.
void check_own_names(const std::string& folder) {
    const Lab& l = lab(folder);
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        const tools::Diagnosis d = tools::diagnose(marking(l, k), l.catalogue);
        if (d.mistakes == mistakes) continue;
        CAPTURE(folder);
        CAPTURE(names(l, mistakes));
        CAPTURE(names(l, d.mistakes));
        REQUIRE(mistakes.size() == 2);  // a mistake alone is named
        // A pair may answer as one mistake alone: one of its own, which hides the other, or the two add up to a third.
        REQUIRE(d.mistakes.size() <= 2);
        CHECK((d.mistakes.size() == 2 || is_hidden_by(l, k, d.mistakes)));
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
