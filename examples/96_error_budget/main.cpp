// 96_error_budget: the cheapest settings within an error budget: measured, chosen by a knapsack, verified.
// Page docs/96_error_budget.md | After 90_what_a_scene_requires, 92_shading_frequency | New: pareto_front, BudgetTerm
// Break at: cheapest_within | Look at: budget, front.size() | Try: budgets 0.01 and 3, a roughness of 0.1
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "examples/error_budget.hpp"
#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "raster/film.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

constexpr std::array<double, 2> kBudgets = {0.1, 1.0};  // codes
constexpr glm::ivec2 kMeasured{320, 180};

Image linear_of(Image encoded) {
    for (float& value : encoded.values) value = raster::linear_from_srgb(value);
    return encoded;
}

void print_ways(const std::vector<BudgetTerm>& terms) {
    std::printf("term       way                  cost alone [%%]  error alone [codes]\n");
    for (const BudgetTerm& term : terms) {
        for (const Way& way : term.ways) {
            std::printf("%-10s %-20s %12.1f %12.3f\n", term.name.c_str(), way.name.c_str(), 100.0 * way.cost,
                        way.error);
        }
    }
}

std::string words_of(const std::vector<BudgetTerm>& terms, const std::vector<int>& chosen) {
    std::string words;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        words += (t > 0 ? ", " : "") + terms[t].ways[static_cast<std::size_t>(chosen[t])].name;
    }
    return words;
}

/// A set that was tried, as a picture.
struct Shown {
    std::vector<int> chosen;
    std::string name;
};

/// The exact picture, then those that were tried; and how far these are off.
void save_choices(const Options& options, const std::vector<BudgetTerm>& terms, const std::vector<Shown>& shown) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const BudgetSet exact = draw_set(terms, std::vector<int>(terms.size(), 0), size, nullptr);
    std::vector<Panel> pictures = {{linear_of(exact.picture), "exact"}}, errors;
    for (const Shown& one : shown) {
        const BudgetSet set = draw_set(terms, one.chosen, size, &exact);
        pictures.emplace_back(linear_of(set.picture), one.name);
        errors.emplace_back(difference_picture(set.picture, exact.picture, 16.0f), one.name + ": error, 16 times");
    }
    save_panels(options, "choices", 2, pictures);
    save_panels(options, "errors", 2, errors);
}

/// What was predicted, what became of it, and all sets there are.
void save_front(const Options& options, const std::vector<BudgetTerm>& terms, const std::vector<KnapsackChoice>& front,
                const BudgetSet& exact) {
    Plot plot = empty_plot("operations [% of the exact picture's]", "mean error [codes]", false, true);
    plot.series = {{"every set, drawn", {}}, {"predicted", {}}, {"the same, drawn", {}}};
    plot.series[0].joined = false;
    for (const std::vector<int>& chosen : all_sets(terms)) {
        const BudgetSet set = draw_set(terms, chosen, kMeasured, &exact);
        plot.series[0].points.emplace_back(100.0 * set.cost, set.error.mean);
    }
    for (const KnapsackChoice& choice : front) {
        const BudgetSet set = draw_set(terms, choice.chosen, kMeasured, &exact);
        plot.series[1].points.emplace_back(100.0 * choice.cost, choice.error);
        plot.series[2].points.emplace_back(100.0 * set.cost, set.error.mean);
    }
    save_plot(options, "front", "", plot);
}

void draw(const Options& options) {
    std::vector<BudgetTerm> terms = terms_of_lesson();
    const BudgetSet exact = draw_set(terms, std::vector<int>(terms.size(), 0), kMeasured, nullptr);
    measure_ways(terms, kMeasured, exact);
    print_ways(terms);
    const std::vector<KnapsackChoice> front = budget_front(terms);
    std::printf("\nbudget  predicted  achieved  cost [%%]  set\n");
    std::vector<Shown> shown;
    for (const double budget : kBudgets) {
        const std::vector<BudgetTrial> trials = keep_budget(terms, front, budget, kMeasured, exact);
        for (const BudgetTrial& trial : trials) {
            const double missed = trial.drawn.error.mean;
            std::printf("%6.2f %10.3f %9.3f %9.1f  %s\n", budget, trial.predicted.error, missed,
                        100.0 * trial.drawn.cost, words_of(terms, trial.predicted.chosen).c_str());
            const bool is_first = &trial == &trials.front(), is_last = &trial == &trials.back();
            if (!is_last && (!is_first || budget < 1.0)) continue;
            shown.push_back({trial.predicted.chosen, "budget " + std::string(budget < 1.0 ? "0.1" : "1") +
                                                         (missed <= budget ? ", kept" : ", broken")});
        }
    }
    save_choices(options, terms, shown);
    save_front(options, terms, front, exact);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "96_error_budget", draw);
}
