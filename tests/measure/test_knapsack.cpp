// The knapsack against all sets there are.
#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "tools/tune/knapsack.hpp"

using namespace kreda::tools;

namespace {

using Classes = std::vector<std::vector<KnapsackOption>>;

/// Costs and errors are multiples of 1/64, so that sums are exact and equal ones occur.
Classes random_classes(std::mt19937& random) {
    std::uniform_int_distribution<int> classes(1, 6), options(1, 5), number(-40, 200);
    Classes all(static_cast<std::size_t>(classes(random)));
    for (auto& one : all) {
        one.resize(static_cast<std::size_t>(options(random)));
        for (KnapsackOption& option : one) {
            option.cost = number(random) / 64.0;
            option.error = std::max(0, number(random)) / 64.0;
        }
    }
    return all;
}

/// The least cost within an error, by trying everything; a great number where there is none.
double least_cost(const Classes& classes, double error, std::size_t from = 0) {
    if (error < 0.0) return 1e30;
    if (from == classes.size()) return 0.0;
    double least = 1e30;
    for (const KnapsackOption& option : classes[from]) {
        least = std::min(least, option.cost + least_cost(classes, error - option.error, from + 1));
    }
    return least;
}

}  // namespace

TEST_CASE("knapsack: within every budget the front is as cheap as the best of all sets") {
    std::mt19937 random(18);
    for (int round = 0; round < 200; ++round) {
        const Classes classes = random_classes(random);
        const std::vector<KnapsackChoice> front = pareto_front(classes);
        for (const double budget : {0.0, 0.5, 1.0, 2.5, 5.0, 20.0}) {
            double cheapest = 1e30;
            for (const KnapsackChoice& choice : front) {
                if (choice.error <= budget) cheapest = std::min(cheapest, choice.cost);
            }
            CAPTURE(round);
            CAPTURE(budget);
            const double expected = least_cost(classes, budget);
            CHECK((expected > 1e20 ? cheapest > 1e20 : cheapest == expected));
        }
    }
}

TEST_CASE("knapsack: a choice of the front is what its options add up to and none beats another") {
    std::mt19937 random(7);
    const Classes classes = random_classes(random);
    const std::vector<KnapsackChoice> front = pareto_front(classes, 3.0);
    for (std::size_t i = 0; i < front.size(); ++i) {
        KnapsackChoice sum;
        for (std::size_t c = 0; c < classes.size(); ++c) {
            const KnapsackOption& option = classes[c][static_cast<std::size_t>(front[i].chosen[c])];
            sum.cost += option.cost;
            sum.error += option.error;
        }
        CHECK(front[i].cost == sum.cost);
        CHECK(front[i].error == sum.error);
        CHECK(front[i].error <= 3.0);
        if (i > 0) CHECK(front[i].cost < front[i - 1].cost);
        if (i > 0) CHECK(front[i].error > front[i - 1].error);
    }
}

TEST_CASE("hypervolume: of two steps it is the sum of two rectangles") {
    const std::vector<KnapsackChoice> steps = {{4.0, 1.0, {}}, {2.0, 3.0, {}}, {5.0, 2.0, {}}};  // the last is beaten
    // (10 - 4) x (5 - 1) + (4 - 2) x (5 - 3)
    CHECK(hypervolume(steps, 10.0, 5.0) == doctest::Approx(28.0));
}
