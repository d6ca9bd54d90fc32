// Step 3 of tune.hpp: the knapsack of a scene's terms.
#include "scene/error.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

using Allowed = std::vector<std::vector<bool>>;

/// One option of each multiplied term, and by how much they multiply what a frame costs.
struct Structure {
    std::vector<int> chosen;  ///< of each term; -1: an added one
    double factor = 1.0;
    double error = 0.0;
};

std::vector<Structure> structures_of(const std::vector<Term>& terms, const MeasuredTerms& measured,
                                     const Allowed& allowed) {
    std::vector<Structure> all = {{}};
    for (std::size_t t = 0; t < terms.size(); ++t) {
        std::vector<Structure> longer;
        for (const Structure& part : all) {
            if (terms[t].cost == CostKind::added) {
                longer.push_back(part);
                longer.back().chosen.push_back(-1);
                continue;
            }
            const double base = measured.options[t][static_cast<std::size_t>(terms[t].base)].frame;
            for (std::size_t o = 0; o < terms[t].options.size(); ++o) {
                if (!allowed[t][o]) continue;
                longer.push_back(part);
                longer.back().chosen.push_back(static_cast<int>(o));
                longer.back().factor *= base > 0.0 ? measured.options[t][o].frame / base : 1.0;
                longer.back().error += budget_of(measured.options[t][o].error);
            }
        }
        all = std::move(longer);
    }
    return all;
}

/// Do the reader and these settings of two terms go together?
bool goes_with(const std::vector<Term>& terms, const Structure& structure, const TermOption& option) {
    std::vector<Setting> settings = option.settings;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        if (structure.chosen[t] < 0 || structure.chosen[t] == terms[t].own) continue;
        const std::vector<Setting>& more = terms[t].options[static_cast<std::size_t>(structure.chosen[t])].settings;
        if (more.front().table == "shading") settings.insert(settings.end(), more.begin(), more.end());
    }
    if (settings.size() == option.settings.size() || option.settings.front().table != "shadow") return true;
    try {
        (void)read_with({"", "tune", "", {}}, settings);  // what the reader refuses it refuses of an empty scene, too
        return true;
    } catch (const scene::UserError&) { return false; }
}

}  // namespace

std::vector<KnapsackChoice> best_choices(const std::vector<Term>& terms, const MeasuredTerms& measured,
                                         const Allowed& allowed, int frames, double frame_scale) {
    constexpr double kMostError = 64.0;  // codes: nobody asks for more
    std::vector<KnapsackChoice> all;
    for (const Structure& structure : structures_of(terms, measured, allowed)) {
        std::vector<std::vector<KnapsackOption>> classes;
        std::vector<std::vector<int>> options_of_class;
        std::vector<std::size_t> term_of_class;
        bool is_possible = true;
        for (std::size_t t = 0; t < terms.size(); ++t) {
            if (structure.chosen[t] >= 0) continue;
            const MeasuredOption& base = measured.options[t][static_cast<std::size_t>(terms[t].base)];
            classes.emplace_back();
            options_of_class.emplace_back();
            term_of_class.push_back(t);
            for (std::size_t o = 0; o < terms[t].options.size(); ++o) {
                if (!allowed[t][o] || !goes_with(terms, structure, terms[t].options[o])) continue;
                const MeasuredOption& option = measured.options[t][o];
                classes.back().push_back(
                    {structure.factor * frame_scale * (option.frame - base.frame) + (option.bake - base.bake) / frames,
                     budget_of(option.error)});
                options_of_class.back().push_back(static_cast<int>(o));
            }
            is_possible = is_possible && !classes.back().empty();
        }
        if (!is_possible) continue;
        for (const KnapsackChoice& inner : pareto_front(classes, kMostError)) {
            KnapsackChoice whole{
                inner.cost + structure.factor * frame_scale * measured.base.frame + measured.base.bake / frames,
                inner.error + structure.error, structure.chosen};
            for (std::size_t c = 0; c < classes.size(); ++c) {
                whole.chosen[term_of_class[c]] = options_of_class[c][static_cast<std::size_t>(inner.chosen[c])];
            }
            all.push_back(std::move(whole));
        }
    }
    return front_of(std::move(all));
}

}  // namespace kreda::tools
