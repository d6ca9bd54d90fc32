// The assignments are as good as the mistakes they catch: every one of the catalogue must cost points.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/grading/lab.hpp"
#include "tools/grade/assignment/stage_check.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Does the variant answer every row as another one does? Then one of its mistakes hides the other, or they cancel out.
bool answers_like(const Lab& l, std::size_t variant, std::size_t other) {
    for (std::size_t i = 0; i < l.cases.inputs.size(); ++i) {
        const tools::RubricStage& stage = *l.rubric.find_stage(l.cases.inputs[i].stage);
        if (!tools::same_answers(stage, l.cases.inputs[i], l.catalogue.answers[variant][i],
                                 l.catalogue.answers[other][i], 0.0)) {
            return false;
        }
    }
    return true;
}

void check_mistakes(const std::string& folder) {
    const Lab& l = lab(folder);
    const double most = points(l, l.cases.expected);
    REQUIRE(most > 0.0);
    CHECK(points(l, l.catalogue.answers[0]) == most);
    CHECK(tools::first_wrong_stage(l.rubric, l.cases, all_answered(l.catalogue.answers[0])) == "");
    std::vector<double> single(l.catalogue.mistakes.size(), -1.0);
    std::vector<std::size_t> first(l.catalogue.mistakes.size());
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        const std::string name = names(l, mistakes);
        CAPTURE(folder);
        CAPTURE(name);
        if (mistakes.size() == 1) {
            const double p = points(l, l.catalogue.answers[k]);
            CHECK(p < most);
            if (single[mistakes[0]] < 0.0) {
                single[mistakes[0]] = p;
                first[mistakes[0]] = k;
            }
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
    int pairs = 0, right = 0;
    for (std::size_t k = 1; k < l.catalogue.variants.size(); ++k) {
        const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
        if (mistakes.size() == 2 && k % 11 != 0) continue;  // pairs are many
        const tools::Diagnosis d = diagnosis(l, l.catalogue.answers[k]);
        CAPTURE(folder);
        CAPTURE(names(l, mistakes));
        CAPTURE(names(l, d.mistakes));
        if (mistakes.size() == 1) CHECK(d.mistakes == mistakes);
        pairs += mistakes.size() == 2 ? 1 : 0;
        right += mistakes.size() == 2 && d.mistakes == mistakes ? 1 : 0;
    }
    MESSAGE(folder << ": " << right << " of " << pairs << " pairs named");
    CHECK(right >= 0.9 * pairs);  // the others answer as one of their two mistakes alone
}

}  // namespace

TEST_CASE("A1: every catalogued mistake costs points and is named") {
    check_mistakes("A1_coverage");
    check_own_names("A1_coverage");
}
TEST_CASE("A2: every catalogued mistake costs points and is named") {
    check_mistakes("A2_depth");
    check_own_names("A2_depth");
}
TEST_CASE("A3: every catalogued mistake costs points and is named") {
    check_mistakes("A3_lights");
    check_own_names("A3_lights");
}
TEST_CASE("A4: every catalogued mistake costs points and is named") {
    check_mistakes("A4_shading");
    check_own_names("A4_shading");
}
TEST_CASE("A5: every catalogued mistake costs points and is named") {
    check_mistakes("A5_fog");
    check_own_names("A5_fog");
}
TEST_CASE("A6: every catalogued mistake costs points and is named") {
    check_mistakes("A6_microfacets");
    check_own_names("A6_microfacets");
}
TEST_CASE("A7: every catalogued mistake costs points and is named") {
    check_mistakes("A7_shadow_map");
    check_own_names("A7_shadow_map");
}
TEST_CASE("A8: every catalogued mistake costs points and is named") {
    check_mistakes("A8_image_light");
    check_own_names("A8_image_light");
}
