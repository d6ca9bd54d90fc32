// The assignments are as good as the mistakes they catch: every one of the catalogue must cost points.
#include <doctest/doctest.h>

#include <cstdio>

#include "tests/grading/lab.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("every catalogued mistake costs points and no solution loses any") {
    for (const std::string& folder : assignment_folders()) {
        const Lab& l = lab(folder);
        const double most =
            tools::max_points_of(tools::score(l.rubric, l.cases, all_answered(l.catalogue.answers[0]), false));
        std::vector<double> single(l.catalogue.mistakes.size(), -1.0);
        for (std::size_t k = 0; k < l.catalogue.variants.size(); ++k) {
            const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
            const std::string name = names(l, mistakes);
            CAPTURE(folder);
            CAPTURE(name);
            const double p = points(l, l.catalogue.answers[k]);
            if (mistakes.empty()) {
                CHECK(p == most);
                const std::string wrong =
                    tools::first_wrong_stage(l.rubric, l.cases, all_answered(l.catalogue.answers[k]));
                CHECK(wrong == "");
            } else if (mistakes.size() == 1) {
                CHECK(p < most);
                if (single[mistakes[0]] < 0.0) single[mistakes[0]] = p;
            } else {
                CHECK(p <= std::min(single[mistakes[0]], single[mistakes[1]]));
            }
        }
    }
}

TEST_CASE("the catalogue names its own mistakes") {
    for (const std::string& folder : assignment_folders()) {
        const Lab& l = lab(folder);
        int pairs = 0, right = 0;
        for (std::size_t k = 0; k < l.catalogue.variants.size(); ++k) {
            const std::vector<std::size_t>& mistakes = l.catalogue.variants[k].mistakes;
            if (mistakes.empty()) continue;
            const tools::Diagnosis d = diagnosis(l, l.catalogue.answers[k]);
            CAPTURE(folder);
            CAPTURE(names(l, mistakes));
            CAPTURE(names(l, d.mistakes));
            if (mistakes.size() == 1) CHECK(d.mistakes == mistakes);
            if (mistakes.size() == 2) {
                ++pairs;
                right += d.mistakes == mistakes ? 1 : 0;
                if (d.mistakes != mistakes) {
                    MESSAGE("pair " << names(l, mistakes) << " looks like " << names(l, d.mistakes));
                }
            }
        }
        MESSAGE(folder << ": " << right << " of " << pairs << " pairs named");
    }
}
