// The error budget of lesson 96: terms of one small scene, each with several ways to compute it, what each way takes
// and misses alone, and what sets of them really take and miss.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "tools/measure/picture.hpp"
#include "tools/tune/knapsack.hpp"

namespace kreda::examples {

/// One way to compute a term.
struct Way {
    std::string name;
    std::vector<std::string> settings;  ///< of the scene file: "material.0.fresnel=schlick"
    double cost = 0.0;   ///< beside the oracle, all else exact: share of the operations of the exact picture; below 0
    double error = 0.0;  ///< alone, in codes of the mean
};

struct BudgetTerm {
    std::string name;
    std::vector<Way> ways;  ///< the first is the oracle
};

/// A set: one way of each term.
struct BudgetSet {
    std::vector<int> chosen;
    tools::CodeError error;  ///< against the exact picture
    double cost = 1.0;       ///< share of the exact picture's operations, by the plan
    raster::Image picture;   ///< as a display has it, 0..1
};

/// The scene of the lesson and its terms, not yet measured.
[[nodiscard]] std::vector<BudgetTerm> terms_of_lesson();

/// Draws a set; `exact` is the picture of the first ways, or nullptr while there is none.
[[nodiscard]] BudgetSet draw_set(const std::vector<BudgetTerm>& terms, const std::vector<int>& chosen, glm::ivec2 size,
                                 const BudgetSet* exact);

/// Fills in cost and error of every way, alone.
void measure_ways(std::vector<BudgetTerm>& terms, glm::ivec2 size, const BudgetSet& exact);

/// The sets that no other beats, if costs and errors add up.
[[nodiscard]] std::vector<tools::KnapsackChoice> budget_front(const std::vector<BudgetTerm>& terms);

/// The number in the front of the cheapest whose errors add up to no more; the front begins with the least error.
[[nodiscard]] std::size_t cheapest_within(const std::vector<tools::KnapsackChoice>& front, double budget);

/// A set that was tried, what was predicted of it and what is so.
struct BudgetTrial {
    tools::KnapsackChoice predicted;
    BudgetSet drawn;
};

/// Chooses, draws, and where the budget is broken goes on to the next set of less error: the last trial keeps it.
[[nodiscard]] std::vector<BudgetTrial> keep_budget(const std::vector<BudgetTerm>& terms,
                                                   const std::vector<tools::KnapsackChoice>& front, double budget,
                                                   glm::ivec2 size, const BudgetSet& exact);

/// All of them, one by one.
[[nodiscard]] std::vector<std::vector<int>> all_sets(const std::vector<BudgetTerm>& terms);

}  // namespace kreda::examples
