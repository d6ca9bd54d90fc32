// The multiple-choice knapsack: one option of every class, as cheap as can be within an error, exactly.
//
// Classes are merged one by one. Of two partial choices the one that is dearer and errs no less is never part of a best
// whole, so only the front is kept.      Sinha & Zoltners 1979; Funkhouser & Sequin 1993 for rendering, by a heuristic
#pragma once

#include <limits>
#include <vector>

namespace kreda::tools {

/// Both add up over the classes. error >= 0; a cost may be negative.
struct KnapsackOption {
    double cost = 0.0;
    double error = 0.0;
};

/// One option of each class, by number.
struct KnapsackChoice {
    double cost = 0.0;
    double error = 0.0;
    std::vector<int> chosen;
};

/// All choices that no other beats in both, the least error first, with errors up to `most_error`. No class is empty.
[[nodiscard]] std::vector<KnapsackChoice> pareto_front(const std::vector<std::vector<KnapsackOption>>& classes,
                                                       double most_error = std::numeric_limits<double>::infinity());

/// Those of any choices that no other beats, the least error first.
[[nodiscard]] std::vector<KnapsackChoice> front_of(std::vector<KnapsackChoice> choices);

/// The area between the front and a corner of great cost and error: what the front is worth. Costs and errors beyond
/// the corner count nothing.    Zitzler & Thiele 1998
[[nodiscard]] double hypervolume(const std::vector<KnapsackChoice>& choices, double corner_cost, double corner_error);

}  // namespace kreda::tools
