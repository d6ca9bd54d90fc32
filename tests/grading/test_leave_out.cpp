// The catalogue without one of its mistakes, or without one way to make it: what is no longer there must not get a
// wrong name, and what is still there in other ways should be named.
#include <doctest/doctest.h>

#include <set>

#include "tests/grading/lab.hpp"
#include "tools/grade/assignment/stage_check.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Do two variants answer every row alike?
bool are_alike(const Lab& l, std::size_t a, std::size_t b) {
    const tools::VariantAnswers& answers = l.catalogue.answers;
    for (std::size_t i = 0; i < l.cases.inputs.size(); ++i) {
        if (answers.number[a][i] == answers.number[b][i]) continue;
        const tools::RubricStage& stage = *l.rubric.find_stage(l.cases.inputs[i].stage);
        if (!tools::same_answers(stage, l.cases.inputs[i], answers.of(a, i), answers.of(b, i), 0.002)) return false;
    }
    return true;
}

/// How many ways there are, each different one once, and what was said without it.
struct LeaveOut {
    int ways = 0, named_right = 0, named_wrong = 0;  ///< other ways of the mistake are left
    int mistakes = 0, wrong_names = 0;               ///< the mistake is left out with all its ways
};

/// What stands twice in the catalogue is left out twice: ways that answer alike. A mistake of which another one is the
/// same is not left out: its name would not be wrong.
LeaveOut leave_out(const Lab& l) {
    LeaveOut tally;
    const std::size_t count = l.catalogue.variants.size();
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t mistake = l.catalogue.variants[k].mistakes[0], way = l.catalogue.variants[k].ways[0];
        std::set<std::size_t> same_ways;
        bool has_twin = false, has_other_ways = false;
        for (std::size_t other = 1; other < count; ++other) {
            const tools::Variant& v = l.catalogue.variants[other];
            const bool alike = are_alike(l, other, k);
            if (v.mistakes[0] == mistake && alike) same_ways.insert(v.ways[0]);
            has_other_ways = has_other_ways || (v.mistakes[0] == mistake && !alike);
            has_twin = has_twin || (v.mistakes[0] != mistake && alike);
        }
        if (*same_ways.begin() < way) continue;
        const tools::Marking m = marking(l, k);
        const auto said = [&](const std::string& what, const tools::Diagnosis& d) {
            MESSAGE(l.rubric.assignment << " " << what << " " << names(l, {mistake}) << ", way " << way << ": "
                                        << names(l, d.mistakes));
        };
        if (!has_twin) {
            ++tally.mistakes;
            const tools::Catalogue rest =
                without(l.catalogue, [&](std::size_t a, std::size_t) { return a == mistake; });
            const tools::Diagnosis d = tools::diagnose(m, rest);
            tally.wrong_names += d.mistakes.empty() ? 0 : 1;
            if (!d.mistakes.empty()) said("without", d);
        }
        if (!has_other_ways) continue;
        ++tally.ways;
        const tools::Catalogue rest =
            without(l.catalogue, [&](std::size_t a, std::size_t b) { return a == mistake && same_ways.count(b) > 0; });
        const tools::Diagnosis d = tools::diagnose(m, rest);
        const bool right = d.mistakes == std::vector<std::size_t>{mistake};
        tally.named_right += right ? 1 : 0;
        tally.named_wrong += right || d.mistakes.empty() ? 0 : 1;
        if (!right) said("without this way", d);
    }
    return tally;
}

}  // namespace

// docs/grading.md says the numbers of a whole run.
TEST_CASE("leave one out: no wrong name without the mistake, the right one without the way" * doctest::skip()) {
    LeaveOut all;
    const auto of = [](int part, int whole) { return std::to_string(part) + " of " + std::to_string(whole); };
    for (const std::string& folder : assignment_folders()) {
        const LeaveOut t = leave_out(lab(folder, false));
        MESSAGE(folder << ": unknown without the mistake " << of(t.mistakes - t.wrong_names, t.mistakes)
                       << ", named without the way " << of(t.named_right, t.ways) << ", wrongly "
                       << std::to_string(t.named_wrong));
        all.ways += t.ways;
        all.named_right += t.named_right;
        all.named_wrong += t.named_wrong;
        all.mistakes += t.mistakes;
        all.wrong_names += t.wrong_names;
    }
    MESSAGE("all: unknown " << of(all.mistakes - all.wrong_names, all.mistakes) << ", named "
                            << of(all.named_right, all.ways) << ", wrongly " << std::to_string(all.named_wrong));
    CHECK(all.wrong_names <= 0.05 * all.mistakes);
    CHECK(all.named_wrong <= 0.02 * all.ways);
    CHECK(all.named_right >= 0.6 * all.ways);
}
