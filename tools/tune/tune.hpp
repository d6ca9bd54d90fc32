// The cheapest settings of a scene whose picture errs by no more than a budget: measured, chosen, and verified.
//
//   1. terms_of() says what can be chosen, and what cannot matter here (terms.hpp).
//   2. Every option of every term is rendered alone, the rest as the scene has it, and compared with the term's oracle.
//   3. The cheapest set whose errors add up to the budget is found exactly (knapsack.hpp). Mean errors of pictures add
//      up at most; what is larger than that shows in 4.
//   4. The set is rendered as a whole and compared with all oracles together. Where the budget is broken, the term that
//      spent the most is raised; where much of it is left, the errors are scaled and it is chosen again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lighting/environment/progress.hpp"
#include "raster/image.hpp"
#include "tools/measure/picture.hpp"
#include "tools/tune/drawn_sets.hpp"
#include "tools/tune/knapsack.hpp"
#include "tools/tune/terms.hpp"

namespace kreda::tools {

/// What an option costs: milliseconds as measured, or the plan's estimate in millions of operations, which is the same
/// on every machine.
enum class CostBy { time, plan };

struct TuneOptions {
    std::optional<double> max_error;  ///< codes: see budget_of
    std::optional<double> budget_ms;  ///< of a picture, with its share of baking
    int frames = 1;                   ///< that baking is shared among
    int probe_pixels = 16'000;        ///< of the pictures that single options are measured on
    double oracle_seconds = 10.0;     ///< that the truth may take at most, about: fewer samples are taken if need be
    int rounds = 3;                   ///< that an option is timed
    int threads = 0;
    CostBy cost_by = CostBy::time;
    lighting::Progress progress;  ///< of tune() as a whole
};

/// One number of a picture's error: the mean, or a quarter of what 99 of 100 pixels stay below, whichever is more. A
/// budget of 2 allows a mean of 2 codes and a 99th percentile of 8.
[[nodiscard]] double budget_of(const CodeError& error);

/// What an option costs and misses, alone.
struct MeasuredOption {
    double frame = 0.0;  ///< of a probe picture
    double bake = 0.0;   ///< before the first
    CodeError error;     ///< against the term's oracle
};

struct MeasuredTerms {
    std::vector<std::vector<MeasuredOption>> options;  ///< of each term
    MeasuredOption base;                               ///< all terms at their base
    int renders = 0;                                   ///< pictures of different settings
};

/// Takes the greatest numbers of samples out of the terms, so that a picture by all oracles takes no longer than
/// options.oracle_seconds: measured on a small one.
void limit_oracle(const SceneSource& source, std::vector<Term>& terms, const TuneOptions& options);

[[nodiscard]] MeasuredTerms measure_terms(const SceneSource& source, const std::vector<Term>& terms,
                                          const TuneOptions& options);

/// All sets of options that no other beats by these measurements, the least error first; `allowed` says of each term
/// and option whether it may be chosen. frame_scale: a frame of the picture / of a probe.
[[nodiscard]] std::vector<KnapsackChoice> best_choices(const std::vector<Term>& terms, const MeasuredTerms& measured,
                                                       const std::vector<std::vector<bool>>& allowed, int frames,
                                                       double frame_scale);

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
inline constexpr int kAttributedPixels = 130'000;
[[nodiscard]] Attribution attribution(const SceneSource& source, const Tuned& tuned, const TuneOptions& options);

/// The size of a picture of so many pixels at most, as wide for its height as the scene's.
[[nodiscard]] Setting probe_size(const scene::ImageSettings& image, int pixels);

}  // namespace kreda::tools
