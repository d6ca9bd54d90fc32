// Step 4 of tune.hpp: the choice as a whole, verified and mended.
#include "tools/tune/tune.hpp"

#include <algorithm>

#include "scene/error.hpp"
#include "scene/plan/plan_cost.hpp"
#include "tools/measure/finding.hpp"

namespace kreda::tools {

namespace {

constexpr int kMostTrials = 4;          // sets that are tried because much of the budget is left
constexpr double kMuchLeft = 0.85;      // of the budget is spent: more is not asked for
constexpr double kTimeTolerance = 1.0;  // a promise of time is kept by the median
constexpr double kLongMs = 3000.0;      // what takes seconds is measured once

// Shares of the whole, for the progress; the rest is measuring the costs.
constexpr double kMeasured = 0.5, kOracle = 0.2, kVerified = 0.2;

/// A set of options and what became of it.
struct Verified {
    KnapsackChoice choice;
    CodeError error;
    raster::Image picture;
};

/// Everything that the search for one scene needs.
struct Search {
    const SceneSource& source;
    const TuneOptions& options;
    Tuned& tuned;
    std::vector<std::vector<bool>> allowed;
    double frame_scale = 1.0;

    [[nodiscard]] const std::vector<Term>& terms() const {
        return tuned.found.terms;
    }
    [[nodiscard]] std::vector<KnapsackChoice> front() const {
        return best_choices(terms(), tuned.measured, allowed, options.frames, frame_scale);
    }
    [[nodiscard]] scene::Scene scene_with(const std::vector<int>& chosen) const {
        return read_with(source, settings_of(terms(), chosen));
    }
    [[nodiscard]] const Picture& picture_with(const std::vector<int>& chosen) const {
        return picture_of_set(tuned.drawn, source, terms(), chosen, options.threads);
    }
    void show_progress(double share) const {
        if (options.progress) options.progress(share);
    }
};

std::vector<int> oracles(const std::vector<Term>& terms) {
    std::vector<int> chosen;
    for (const Term& term : terms) chosen.push_back(term.oracle);
    return chosen;
}

std::vector<int> owns(const std::vector<Term>& terms) {
    std::vector<int> chosen;
    for (const Term& term : terms) chosen.push_back(term.own);
    return chosen;
}

/// Like the registry's oracles alone, but of methods that do not go together the reader's refusal is an error of ours.
Verified verify(const Search& search, const KnapsackChoice& choice) {
    Verified verified{choice, {}, {}};
    verified.picture = search.picture_with(choice.chosen).encoded;
    verified.error = code_error(verified.picture, search.tuned.oracle_picture);
    ++search.tuned.renders;
    search.tuned.trials.push_back({choice, verified.error, ""});
    const double trials = static_cast<double>(search.tuned.trials.size());
    search.show_progress(kMeasured + kOracle + kVerified * trials / (trials + 2.0));
    return verified;
}

/// The dearest picture's error that a front offers within a budget, or nullptr.
const KnapsackChoice* cheapest_within(const std::vector<KnapsackChoice>& front, double budget) {
    const KnapsackChoice* best = nullptr;
    for (const KnapsackChoice& choice : front) {
        if (choice.error <= budget) best = &choice;  // costs fall along the front
    }
    return best;
}

/// The term that spent the most may no longer spend that much. Where no error was measured it must be exact.
void raise_term(Search& search, const KnapsackChoice& choice) {
    std::size_t most = search.terms().size();
    double spent = -1.0;
    for (std::size_t t = 0; t < search.terms().size(); ++t) {
        const auto o = static_cast<std::size_t>(choice.chosen[t]);
        const double error = budget_of(search.tuned.measured.options[t][o].error);
        if (choice.chosen[t] == search.terms()[t].oracle || error <= spent) continue;
        spent = error;
        most = t;
    }
    if (most == search.terms().size()) return;  // all are exact already
    for (std::size_t o = 0; o < search.allowed[most].size(); ++o) {
        const double error = budget_of(search.tuned.measured.options[most][o].error);
        const bool is_oracle = static_cast<int>(o) == search.terms()[most].oracle;
        if (!is_oracle && error >= spent) search.allowed[most][o] = false;
    }
    search.tuned.trials.back().raised = search.terms()[most].name;
}

/// Choose, verify, raise, until the budget is kept; the oracles themselves keep every budget.
Verified keep_error(Search& search, double budget, double asked) {
    for (;;) {
        const std::vector<KnapsackChoice> front = search.front();
        const KnapsackChoice* choice = cheapest_within(front, asked);
        if (!choice || choice->chosen == oracles(search.terms())) {
            KnapsackChoice exact{0.0, 0.0, oracles(search.terms())};
            for (const KnapsackChoice& one : front) {
                if (one.chosen == exact.chosen) exact.cost = one.cost;
            }
            return {exact, {}, search.tuned.oracle_picture};
        }
        Verified verified = verify(search, *choice);
        if (budget_of(verified.error) <= budget) return verified;
        raise_term(search, *choice);
    }
}

/// Errors of terms hide each other: where the whole misses less than its parts, more is asked of the front.
Verified spend_the_rest(Search& search, double budget, Verified best) {
    double asked = budget;
    for (int trial = 0; trial < kMostTrials; ++trial) {
        const double spent = budget_of(best.error);
        if (spent > kMuchLeft * budget) break;
        asked *= spent > 0.0 ? std::min(budget / spent, 3.0) : 3.0;
        const std::vector<KnapsackChoice> front = search.front();
        const KnapsackChoice* choice = cheapest_within(front, asked);
        if (!choice || choice->chosen == best.choice.chosen) break;
        Verified next = verify(search, *choice);
        if (budget_of(next.error) > budget) {
            asked = 0.5 * (asked + best.choice.error);  // too much: half of the way
            choice = cheapest_within(front, asked);
            if (!choice || choice->chosen == best.choice.chosen) break;
            next = verify(search, *choice);
            if (budget_of(next.error) <= budget) best = std::move(next);
            break;
        }
        best = std::move(next);
    }
    return best;
}

/// What a picture of the set costs, measured now; what takes seconds is as it was when it was drawn first.
double cost_of(const Search& search, const std::vector<int>& chosen) {
    const TuneOptions& options = search.options;
    if (options.cost_by == CostBy::plan) {
        const scene::RenderPlan plan = make_plan(search.scene_with(chosen));
        return 1e-6 * (total_operations(plan) + baking_operations(plan) / options.frames);
    }
    const Picture& first = search.picture_with(chosen);
    const bool is_long = first.frame_ms > kLongMs;
    const Picture now =
        is_long ? first : draw_with_baked(search.tuned.drawn, search.scene_with(chosen), options.threads);
    return now.bake_ms / options.frames + now.frame_ms;
}

/// The most accurate set that a picture of this cost can have.
Verified keep_time(Search& search, double budget_ms) {
    double asked = budget_ms;
    for (int trial = 0; trial < 6; ++trial) {
        const std::vector<KnapsackChoice> front = search.front();
        const auto first = std::find_if(front.begin(), front.end(), [&](const auto& c) { return c.cost <= asked; });
        const KnapsackChoice& choice = first != front.end() ? *first : front.back();
        const double cost = cost_of(search, choice.chosen);
        if (cost <= kTimeTolerance * budget_ms) return verify(search, choice);
        if (first == front.end()) break;
        asked *= 0.95 * budget_ms / cost;
    }
    throw scene::UserError(search.source.name + ": no choice of settings takes less than " + digits(budget_ms) +
                           " ms; allow more with --budget-ms, or make image.size smaller");
}

/// Costs of the whole pictures side by side, the median of three turns.
void measure_costs(const Search& search, const std::vector<int>& chosen) {
    const std::array<std::vector<int>, 3> sets = {chosen, owns(search.terms()), oracles(search.terms())};
    std::array<std::array<double, 3>, 3> costs{};
    for (std::size_t round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < 3; ++i) {
            costs[i][round] = cost_of(search, sets[i]);
            const double share = (3.0 * static_cast<double>(round) + static_cast<double>(i + 1)) / 9.0;
            search.show_progress(kMeasured + kOracle + kVerified + (1.0 - kMeasured - kOracle - kVerified) * share);
        }
    }
    for (std::array<double, 3>& cost : costs) std::sort(cost.begin(), cost.end());
    search.tuned.chosen_cost = costs[0][1];
    search.tuned.own_cost = costs[1][1];
    search.tuned.oracle_cost = costs[2][1];
}

/// "saves 3.1 ms, costs 0.2 codes (was phong)"
std::string comment_of(const Search& search, std::size_t t, int o, const std::string& was) {
    const std::vector<MeasuredOption>& measured = search.tuned.measured.options[t];
    const MeasuredOption& mine = measured[static_cast<std::size_t>(o)];
    const MeasuredOption& own = measured[static_cast<std::size_t>(search.terms()[t].own)];
    const double saved = search.frame_scale * (own.frame - mine.frame) + (own.bake - mine.bake) / search.options.frames;
    const std::string unit = search.options.cost_by == CostBy::plan ? " million operations" : " ms";
    return (saved >= 0.0 ? "saves " : "takes ") + digits(std::abs(saved)) + unit + (saved >= 0.0 ? "" : " more") +
           ", errs by " + fixed(mine.error.mean, 2) + " codes (was " + (was.empty() ? "not given" : was) + ")";
}

/// The keys whose values are not the scene's own.
std::vector<Change> changes_of(const Search& search, const std::vector<int>& chosen) {
    std::vector<Change> changes;
    for (std::size_t t = 0; t < search.terms().size(); ++t) {
        const Term& term = search.terms()[t];
        if (chosen[t] == term.own) continue;
        for (const Setting& setting : term.options[static_cast<std::size_t>(chosen[t])].settings) {
            const std::string was = value_in(search.source, setting.table, setting.which, setting.key);
            if (was != setting.value) changes.push_back({setting, comment_of(search, t, chosen[t], was)});
        }
    }
    return changes;
}

/// A frame of the whole picture / of a probe, both with the scene's own settings.
double frame_scale_of(const Search& search) {
    const MeasuredTerms& measured = search.tuned.measured;
    double probe = measured.base.frame;
    for (std::size_t t = 0; t < search.terms().size(); ++t) {
        const Term& term = search.terms()[t];
        if (term.cost == CostKind::added) continue;
        const double base = measured.options[t][static_cast<std::size_t>(term.base)].frame;
        if (base > 0.0) probe *= measured.options[t][static_cast<std::size_t>(term.own)].frame / base;
    }
    const double whole = cost_of(search, owns(search.terms()));
    const double frame = whole - measured.base.bake / search.options.frames;
    return probe > 0.0 && frame > 0.0 ? frame / probe : 1.0;
}

}  // namespace

Tuned tune(const SceneSource& source, const std::set<std::string>& kept, const TuneOptions& options) {
    Tuned tuned;
    tuned.found = terms_of(source, kept);
    limit_oracle(source, tuned.found.terms, options);
    TuneOptions measuring = options;
    if (options.progress) measuring.progress = [&](double share) { options.progress(kMeasured * share); };
    tuned.measured = measure_terms(source, tuned.found.terms, measuring);
    tuned.renders = tuned.measured.renders;
    Search search{source, options, tuned, {}};
    for (const Term& term : search.terms()) search.allowed.emplace_back(term.options.size(), true);
    search.frame_scale = frame_scale_of(search);
    tuned.front = search.front();
    tuned.oracle_picture = search.picture_with(oracles(search.terms())).encoded;
    tuned.renders += 2;
    search.show_progress(kMeasured + kOracle);

    Verified best;
    if (options.max_error) {
        tuned.promised = *options.max_error;
        best = keep_error(search, tuned.promised, tuned.promised);
        best = spend_the_rest(search, tuned.promised, std::move(best));
    } else {
        best = keep_time(search, options.budget_ms.value_or(0.0));
        tuned.promised = budget_of(best.error);
    }
    tuned.choice = best.choice;
    tuned.achieved = best.error;
    tuned.chosen_picture = best.picture;
    tuned.text = changed_text(source, changes_of(search, best.choice.chosen));
    measure_costs(search, best.choice.chosen);
    return tuned;
}

Attribution attribution(const SceneSource& source, const Tuned& tuned, const TuneOptions& options) {
    const std::vector<Term>& terms = tuned.found.terms;
    const Setting size = probe_size(read_with(source, {}).image, kAttributedPixels);
    DrawnSets drawn;
    const auto picture_with = [&](const std::vector<int>& chosen) {
        std::vector<Setting> settings = settings_of(terms, chosen);
        settings.push_back(size);
        return draw_with_baked(drawn, read_with(source, settings), options.threads).encoded;
    };
    const raster::Image chosen = picture_with(tuned.choice.chosen);
    Attribution attributed{chosen.width, chosen.height, {}};
    for (std::size_t t = 0; t < terms.size(); ++t) {
        attributed.codes.emplace_back();
        if (options.progress) options.progress(static_cast<double>(t) / static_cast<double>(terms.size()));
        if (tuned.choice.chosen[t] == terms[t].oracle) continue;
        std::vector<int> raised = tuned.choice.chosen;
        raised[t] = terms[t].oracle;
        try {
            attributed.codes.back() = code_differences(picture_with(raised), chosen);
        } catch (const scene::UserError&) {}  // a frequency that does not go with the chosen shadows, alone
    }
    return attributed;
}

}  // namespace kreda::tools
