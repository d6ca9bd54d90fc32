// The best sets of a scene's terms: predicted, and the most promising ones drawn, small.
#pragma once

#include <set>
#include <vector>

#include "tools/tune/knapsack.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

/// Everything that a set's cost and error are predicted from.
struct FrontSubject {
    const SceneSource& source;
    const std::vector<Term>& terms;
    const TuneOptions& options;
    DrawnSets& drawn;
    MeasuredTerms& measured;
    double pixels_of_probe = 1.0;  ///< of the picture whose cost is asked for
};

/// What a picture of the set costs, with its share of baking.
[[nodiscard]] double predicted_cost(const FrontSubject& subject, const std::vector<int>& chosen);

/// A set that is worth to be looked at.
struct Candidate {
    KnapsackChoice choice;    ///< with the cost and error that are predicted
    double distance = 1e30;   ///< from the drawn set that the error is predicted from; 0: it was drawn
    bool is_planned = false;  ///< the cost is that of its own plan, not a sum
};

/// For every way to combine the structural terms the knapsack of all others, by the plans of that way. `allowed` says
/// of each term and option whether it may be chosen. The oracles are always among them.
[[nodiscard]] std::vector<Candidate> find_candidates(const FrontSubject& subject,
                                                     const std::vector<std::vector<bool>>& allowed);

/// Predicts errors anew where one of the drawn sets from number `first` on is nearer than what is known, and plans what
/// may be best.
void predict(const FrontSubject& subject, std::vector<Candidate>& candidates, std::size_t first = 0);

/// Those that no other beats, the least error first.
[[nodiscard]] std::vector<KnapsackChoice> front_of(const std::vector<Candidate>& candidates);

/// Draws sets, small, one by one: whichever adds most to what the drawn ones are worth up to an error of
/// `corner_error`, costs by their logarithms. At most `renders` of them.
void explore(const FrontSubject& subject, std::vector<Candidate>& candidates, int renders, double corner_error);

}  // namespace kreda::tools
