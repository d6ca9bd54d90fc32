// Laws about 96: a choice that is verified keeps its budget, and none that keeps it is far cheaper.
#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "course.hpp"
#include "examples/error_budget.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tests;

namespace {

constexpr glm::ivec2 kSize{320, 180}, kSmall{80, 45};

struct Lesson {
    glm::ivec2 size;
    std::vector<BudgetTerm> terms = terms_of_lesson();
    BudgetSet exact = draw_set(terms, std::vector<int>(terms.size(), 0), size, nullptr);
    std::vector<tools::KnapsackChoice> front;
    explicit Lesson(glm::ivec2 picture) : size(picture) {
        measure_ways(terms, size, exact);
        front = budget_front(terms);
    }
};

}  // namespace

TEST_CASE("96_error_budget: the two heaps of the exercise merge to the front of its answer") {
    const std::vector<tools::KnapsackChoice> front = tools::pareto_front({{{4, 0}, {2, 1}, {1, 3}}, {{3, 0}, {1, 2}}});
    REQUIRE(front.size() == 4);
    const double costs[4] = {7, 5, 3, 2}, errors[4] = {0, 1, 3, 5};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(front[i].cost == costs[i]);
        CHECK(front[i].error == errors[i]);
    }
    CHECK(cheapest_within(front, 3.0) == 2);
    CHECK(cheapest_within(front, 2.9) == 1);
}

TEST_CASE("96_error_budget: every budget is kept and by nearly the cheapest of all sets") {
    const Lesson lesson(kSmall);
    std::vector<BudgetSet> all;
    for (const std::vector<int>& chosen : all_sets(lesson.terms))
        all.push_back(draw_set(lesson.terms, chosen, lesson.size, &lesson.exact));
    CHECK(all.size() == 54);
    for (const double budget : {0.0, 0.1, 0.5, 1.0, 5.0}) {
        CAPTURE(budget);
        const std::vector<BudgetTrial> trials =
            keep_budget(lesson.terms, lesson.front, budget, lesson.size, lesson.exact);
        CHECK(trials.back().drawn.error.mean <= budget);
        // The operations that sets save do add up here: all of these terms are of the same points.
        CHECK(trials.back().predicted.cost == doctest::Approx(trials.back().drawn.cost).epsilon(0.02));
        double cheapest = 1.0;
        for (const BudgetSet& set : all) {
            if (set.error.mean <= budget) cheapest = std::min(cheapest, set.cost);
        }
        // Errors that cancel or hide each other are not seen by a sum: up to a tenth may be left lying.
        CHECK(trials.back().drawn.cost <= cheapest + 0.1);
    }
}

TEST_CASE("96_error_budget: the tables of the page") {
    const Lesson lesson(kSize);
    for (const BudgetTerm& term : lesson.terms) {
        for (const Way& way : term.ways) {
            CAPTURE(way.name);
            const std::vector<QuotedNumber> page =
                documented_row("96_error_budget", "error alone", term.name + ": " + way.name);
            REQUIRE(page.size() == 2);
            CHECK(rounds_to(100.0 * way.cost, page[0]));
            CHECK(rounds_to(way.error, page[1]));
        }
    }
    for (const double budget : {0.1, 1.0}) {
        const std::vector<BudgetTrial> trials =
            keep_budget(lesson.terms, lesson.front, budget, lesson.size, lesson.exact);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const std::string row = std::string(budget < 1.0 ? "0.1" : "1") + ", trial " + std::to_string(i + 1);
            CAPTURE(row);
            const std::vector<QuotedNumber> page = documented_row("96_error_budget", "predicted", row);
            REQUIRE(page.size() >= 3);
            CHECK(rounds_to(trials[i].predicted.error, page[0]));
            CHECK(rounds_to(trials[i].drawn.error.mean, page[1]));
            CHECK(rounds_to(100.0 * trials[i].drawn.cost, page[2]));
        }
    }
    CHECK(rounds_to(keep_budget(lesson.terms, lesson.front, 0.1, lesson.size, lesson.exact).back().drawn.cost,
                    quoted_number("96_error_budget", "cost")));
}
