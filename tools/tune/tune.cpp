// Step 4 of tune.hpp: the choice as a whole, verified and mended.
#include "tools/tune/tune.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "scene/error.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/plan/plan_cost.hpp"
#include "tools/measure/finding.hpp"
#include "tools/tune/front.hpp"

namespace kreda::tools {

namespace {

constexpr int kMostTrials = 4;  // sets that are tried before a term is raised, or because much of the budget is left
constexpr double kMuchLeft = 0.85;     // of the budget is spent: more is not asked for
constexpr double kUsualError = 8.0;    // codes: worse is no choice, where no budget of error is given
constexpr double kTimeReserve = 0.95;  // of a budget of time may be taken: the next measurement is another one
constexpr double kLongMs = 3000.0;     // what takes seconds is measured once

// Shares of the whole, for the progress; the rest is measuring the costs.
constexpr double kMeasured = 0.3, kExplored = 0.2, kOracle = 0.2, kVerified = 0.2;
constexpr double kBefore = kMeasured + kExplored + kOracle;

using Sets = std::set<std::vector<int>>;

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
    std::vector<std::vector<bool>> allowed = {};
    std::vector<Candidate> candidates = {};
    double pixels_of_probe = 1.0;

    [[nodiscard]] const std::vector<Term>& terms() const {
        return tuned.found.terms;
    }
    [[nodiscard]] FrontSubject subject() const {
        return {source, terms(), options, tuned.drawn, tuned.measured, pixels_of_probe};
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

Verified verify(const Search& search, const KnapsackChoice& choice) {
    Verified verified{choice, {}, {}};
    verified.picture = search.picture_with(choice.chosen).encoded;
    verified.error = code_error(verified.picture, search.tuned.oracle_picture);
    ++search.tuned.renders;
    search.tuned.trials.push_back({choice, verified.error, ""});
    const double trials = static_cast<double>(search.tuned.trials.size());
    search.show_progress(kBefore + kVerified * trials / (trials + 2.0));
    return verified;
}

/// The cheapest that is predicted to miss no more than `asked`, of those that were not refused.
const KnapsackChoice* cheapest_within(const Search& search, double asked, const Sets& refused) {
    const KnapsackChoice* best = nullptr;
    for (const Candidate& candidate : search.candidates) {
        const KnapsackChoice& choice = candidate.choice;
        if (choice.error > asked || (best && choice.cost >= best->cost) || refused.contains(choice.chosen)) continue;
        best = &choice;
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
    search.candidates = find_candidates(search.subject(), search.allowed);
    predict(search.subject(), search.candidates);
}

/// Choose, verify, ask for less or raise a term, until the budget is kept; the oracles themselves keep every budget.
Verified keep_error(Search& search, double budget, double& asked, Sets& refused) {
    const std::vector<int> exact = oracles(search.terms());
    for (int trial = 1;; ++trial) {
        const KnapsackChoice* choice = cheapest_within(search, asked, refused);
        if (!choice || choice->chosen == exact) {
            return {{predicted_cost(search.subject(), exact), 0.0, exact}, {}, search.tuned.oracle_picture};
        }
        Verified verified = verify(search, *choice);
        const double missed = budget_of(verified.error);
        if (missed <= budget) return verified;
        refused.insert(verified.choice.chosen);
        asked = std::min(asked, verified.choice.error) * std::max(0.5, 0.98 * budget / missed);
        if (trial >= kMostTrials) raise_term(search, verified.choice);
    }
}

/// Large pictures miss less than small ones, which have more edges: where much is left, more is asked for.
Verified spend_the_rest(Search& search, double budget, double asked, Sets& refused, Verified best) {
    double least_broken = 1e30;  // what was asked for where the budget was broken
    for (int trial = 0; trial < kMostTrials; ++trial) {
        const double spent = budget_of(best.error);
        if (spent > kMuchLeft * budget) break;
        const double more = asked * (spent > 0.0 ? std::min(budget / spent, 3.0) : 3.0);
        asked = more < least_broken ? more : 0.5 * (asked + least_broken);
        const KnapsackChoice* choice = cheapest_within(search, asked, refused);
        if (!choice || choice->cost >= best.choice.cost) break;
        Verified next = verify(search, *choice);
        if (budget_of(next.error) <= budget) {
            best = std::move(next);
            continue;
        }
        refused.insert(next.choice.chosen);
        least_broken = asked;
        asked = best.choice.error;
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

/// Of three turns.
double median_cost_of(const Search& search, const std::vector<int>& chosen) {
    std::array<double, 3> costs{};
    for (double& cost : costs) cost = cost_of(search, chosen);
    std::sort(costs.begin(), costs.end());
    return costs[1];
}

/// The most accurate set that is predicted to cost no more; or, if there is none, the cheapest.
const KnapsackChoice& most_accurate_within(const Search& search, double cost) {
    const KnapsackChoice* best = nullptr;
    const KnapsackChoice* cheapest = &search.candidates.front().choice;
    for (const Candidate& candidate : search.candidates) {
        const KnapsackChoice& choice = candidate.choice;
        if (choice.cost < cheapest->cost) cheapest = &choice;
        if (choice.cost > cost) continue;
        if (!best || std::pair(choice.error, choice.cost) < std::pair(best->error, best->cost)) best = &choice;
    }
    return best ? *best : *cheapest;
}

/// The most accurate set that a picture of this cost can have.
Verified keep_time(Search& search, double budget_ms) {
    double asked = budget_ms;
    for (int trial = 0; trial < 2 * kMostTrials; ++trial) {
        const KnapsackChoice& choice = most_accurate_within(search, asked);
        const double cost = median_cost_of(search, choice.chosen);
        if (cost <= kTimeReserve * budget_ms) return verify(search, choice);
        if (choice.cost > asked) break;
        asked = 0.95 * std::min(asked, choice.cost) * std::max(0.5, budget_ms / cost);
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
            search.show_progress(kBefore + kVerified + (1.0 - kBefore - kVerified) * share);
        }
    }
    for (std::array<double, 3>& cost : costs) std::sort(cost.begin(), cost.end());
    search.tuned.chosen_cost = costs[0][1];
    search.tuned.own_cost = costs[1][1];
    search.tuned.oracle_cost = costs[2][1];
}

/// "saves 3.1 ms, costs 0.2 codes (was phong)": beside the same set with the scene's own way.
std::string comment_of(const Search& search, std::size_t t, const std::vector<int>& chosen, const std::string& was) {
    const MeasuredOption& mine = search.tuned.measured.options[t][static_cast<std::size_t>(chosen[t])];
    std::vector<int> own = chosen;
    own[t] = search.terms()[t].own;
    const double saved = predicted_cost(search.subject(), own) - predicted_cost(search.subject(), chosen);
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
            if (was != setting.value) changes.push_back({setting, comment_of(search, t, chosen, was)});
        }
    }
    return changes;
}

/// Times that were predicted and measured are of one machine at one load: what the scene's own set takes is right.
void scale_rates(Search& search) {
    if (search.options.cost_by == CostBy::plan) return;
    const std::vector<int> own = owns(search.terms());
    const double measured = search.picture_with(own).frame_ms;
    const CostSubject subject{search.source, search.terms(), search.tuned.measured.size};
    const double predicted = picture_cost(subject, search.tuned.measured.costs, own, search.pixels_of_probe).frame;
    if (measured > 0.0 && predicted > 0.0) scale_times(search.tuned.measured.costs, measured / predicted);
}

/// Steps 2 and 3 of tune.hpp.
void find_front(Search& search) {
    Tuned& tuned = search.tuned;
    TuneOptions measuring = search.options;
    if (search.options.progress) measuring.progress = [&](double share) { search.show_progress(kMeasured * share); };
    tuned.measured = measure_terms(search.source, tuned.found.terms, measuring, tuned.drawn);
    for (const Term& term : search.terms()) search.allowed.emplace_back(term.options.size(), true);
    const scene::ImageSettings image = read_with(search.source, {}).image;
    search.pixels_of_probe =
        static_cast<double>(image.width) * image.height / static_cast<double>(tuned.measured.exact.plane_size());
    scale_rates(search);
    search.candidates = find_candidates(search.subject(), search.allowed);
    predict(search.subject(), search.candidates);
    const int rest = std::max(search.options.renders - tuned.measured.renders, kLeastExplored);
    const double corner = search.options.max_error ? 2.0 * *search.options.max_error : kUsualError;
    explore(search.subject(), search.candidates, rest, corner);
    tuned.front = front_of(search.candidates);
    tuned.renders = tuned.measured.renders;
}

}  // namespace

Tuned tune(const SceneSource& source, const std::set<std::string>& kept, const TuneOptions& options) {
    Tuned tuned;
    scene::LoadedFiles files;
    SceneSource kept_source = source;  // the scene is read a thousand times: its files and shapes once
    if (!kept_source.read.files) kept_source.read.files = &files;
    tuned.found = terms_of(kept_source, kept);
    limit_oracle(kept_source, tuned.found.terms, options, tuned.drawn);
    Search search{kept_source, options, tuned};
    find_front(search);
    search.show_progress(kMeasured + kExplored);
    tuned.oracle_picture = search.picture_with(oracles(search.terms())).encoded;
    tuned.own_error = code_error(search.picture_with(owns(search.terms())).encoded, tuned.oracle_picture);
    tuned.renders += 2;
    search.show_progress(kBefore);

    Verified best;
    if (options.max_error) {
        tuned.promised = *options.max_error;
        Sets refused;
        double asked = tuned.promised;
        best = keep_error(search, tuned.promised, asked, refused);
        best = spend_the_rest(search, tuned.promised, asked, refused, std::move(best));
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

}  // namespace kreda::tools
