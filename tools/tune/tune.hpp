// The cheapest settings of a scene whose picture errs by no more than a budget: measured, chosen, and verified.
//
//   1. terms_of() says what can be chosen, and what cannot matter here (terms.hpp).
//   2. Every option of every term is drawn small, the rest at its base (measure_terms.cpp).
//   3. From these pictures and the plans of sets their errors and costs are predicted (set_errors.hpp, set_costs.hpp);
//      the knapsack finds the sets that may be best, and the most promising ones are drawn, small, too (front.hpp).
//   4. The cheapest within the budget is rendered as a whole and compared with all oracles together. Where the budget
//   is
//      broken, the term that spent the most is raised; where much of it is left, more is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lighting/environment/progress.hpp"
#include "raster/image.hpp"
#include "tools/measure/picture.hpp"
#include "tools/tune/drawn_sets.hpp"
#include "tools/tune/knapsack.hpp"
#include "tools/tune/set_costs.hpp"
#include "tools/tune/set_errors.hpp"
#include "tools/tune/terms.hpp"

namespace kreda::tools {

struct TuneOptions {
    std::optional<double> max_error;  ///< codes: see budget_of
    std::optional<double> budget_ms;  ///< of a picture, with its share of baking
    int frames = 1;                   ///< that baking is shared among
    int probe_pixels = 8'000;         ///< of the small pictures
    int renders = 60;              ///< of them, as far as single options leave some; at least kLeastExplored are sets
    double oracle_seconds = 10.0;  ///< that the truth may take at most, about: fewer samples are taken if need be
    int rounds = 3;                ///< that an option is timed
    int threads = 0;
    CostBy cost_by = CostBy::time;
    lighting::Progress progress;  ///< of tune() as a whole
};

/// One number of a picture's error: the mean, or a quarter of what 99 of 100 pixels stay below, whichever is more. A
/// budget of 2 allows a mean of 2 codes and a 99th percentile of 8.
[[nodiscard]] double budget_of(const CodeError& error);

/// What an option costs beside the base, of a small picture, and misses, alone.
struct MeasuredOption {
    FrameParts frame;   ///< ms
    double bake = 0.0;  ///< ms, before the first
    CodeError error;    ///< against the term's oracle
};

struct MeasuredTerms {
    Setting size;                                      ///< of the small pictures
    std::vector<std::vector<MeasuredOption>> options;  ///< of each term
    raster::Image exact;                               ///< by all oracles
    SetErrors errors;
    SetCosts costs;
    int renders = 0;  ///< small pictures of different settings
};
inline constexpr int kLeastExplored = 12;

/// Takes the greatest numbers of samples out of the terms, so that a picture by all oracles takes no longer than
/// options.oracle_seconds: measured on a small one.
void limit_oracle(const SceneSource& source, std::vector<Term>& terms, const TuneOptions& options, DrawnSets& drawn);

[[nodiscard]] MeasuredTerms measure_terms(const SceneSource& source, const std::vector<Term>& terms,
                                          const TuneOptions& options, DrawnSets& drawn);

/// Draws one more set, small, for predictions. False: its options do not go together.
bool draw_probe(const SceneSource& source, const std::vector<Term>& terms, const std::vector<int>& chosen,
                const TuneOptions& options, DrawnSets& drawn, MeasuredTerms& measured);

/// A set that was rendered as a whole.
struct Trial {
    KnapsackChoice choice;  ///< its predicted cost and error
    CodeError error;        ///< what it really missed
    std::string raised;     ///< the term that was raised after it; empty: none was
};

struct Tuned {
    SceneTerms found;
    MeasuredTerms measured;
    std::vector<KnapsackChoice> front;                            ///< predicted
    KnapsackChoice choice;                                        ///< predicted
    CodeError achieved;                                           ///< of the choice, verified
    CodeError own_error;                                          ///< of the scene as it was
    double promised = 0.0;                                        ///< the budget
    double chosen_cost = 0.0, own_cost = 0.0, oracle_cost = 0.0;  ///< of the whole picture, measured side by side
    int renders = 0;                                              ///< pictures of different settings
    std::vector<Trial> trials;
    raster::Image chosen_picture, oracle_picture;
    std::string text;  ///< the scene file with the choice
    DrawnSets drawn;   ///< whole pictures that were drawn on the way
};

/// Requires one of the two budgets. Throws UserError where the scene cannot be read or written, or no choice keeps a
/// budget of time.
[[nodiscard]] Tuned tune(const SceneSource& source, const std::set<std::string>& kept, const TuneOptions& options);

/// What the picture would change if each chosen term alone were exact.
struct Attribution {
    int width = 0, height = 0;              ///< of a smaller picture, if the scene's has more than kAttributedPixels
    std::vector<std::vector<float>> codes;  ///< of each term, a pixel; nothing for those that are exact
};
inline constexpr int kAttributedPixels = 40'000;
[[nodiscard]] Attribution attribution(const SceneSource& source, const Tuned& tuned, const TuneOptions& options);

/// The size of a picture of so many pixels at most, as wide for its height as the scene's.
[[nodiscard]] Setting probe_size(const scene::ImageSettings& image, int pixels);

}  // namespace kreda::tools
