#include "tools/tune/front.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace kreda::tools {

namespace {

constexpr std::size_t kMostOfStructure = 24;  // sets of each that are looked at, evenly along its front
constexpr double kMostError = 64.0;           // codes: nobody asks for more
constexpr double kUnknown = 1e-6;  // codes: what is not exact may err elsewhere, so at one price exact is taken
constexpr double kLittle = 0.002;  // of what all are worth: nothing that adds less is drawn

/// One option of each structural term, the others at their base.
std::vector<std::vector<int>> structures_of(const std::vector<Term>& terms,
                                            const std::vector<std::vector<bool>>& allowed) {
    std::vector<std::vector<int>> all = {bases(terms)};
    for (std::size_t t = 0; t < terms.size(); ++t) {
        if (terms[t].kind != TermKind::structural) continue;
        std::vector<std::vector<int>> longer;
        for (const std::vector<int>& part : all) {
            for (std::size_t o = 0; o < terms[t].options.size(); ++o) {
                if (!allowed[t][o]) continue;
                longer.push_back(part);
                longer.back()[t] = static_cast<int>(o);
            }
        }
        all = std::move(longer);
    }
    return all;
}

bool is_possible(const FrontSubject& subject, const std::vector<int>& chosen) {
    const CostSubject costs{subject.source, subject.terms, subject.measured.size};
    return planned_cost(costs, subject.measured.costs, chosen).is_possible;
}

/// The classes of the knapsack in one structure, by what each option adds to the cost there.
struct StructureClasses {
    std::vector<std::vector<KnapsackOption>> classes;
    std::vector<std::vector<int>> option;  ///< of each class, its number in the term
    std::vector<std::size_t> term;
};

StructureClasses classes_of(const FrontSubject& subject, const std::vector<int>& structure,
                            const std::vector<std::vector<bool>>& allowed) {
    StructureClasses made;
    const double base = predicted_cost(subject, structure);
    for (std::size_t t = 0; t < subject.terms.size(); ++t) {
        if (subject.terms[t].kind == TermKind::structural) continue;
        made.classes.emplace_back();
        made.option.emplace_back();
        made.term.push_back(t);
        for (std::size_t o = 0; o < subject.terms[t].options.size(); ++o) {
            std::vector<int> chosen = structure;
            chosen[t] = static_cast<int>(o);
            if (!allowed[t][o] || !is_possible(subject, chosen)) continue;
            const double unknown = static_cast<int>(o) == subject.terms[t].oracle ? 0.0 : kUnknown;
            made.classes.back().push_back(
                {predicted_cost(subject, chosen) - base, budget_of(subject.measured.options[t][o].error) + unknown});
            made.option.back().push_back(static_cast<int>(o));
        }
    }
    return made;
}

void add_structure(const FrontSubject& subject, const std::vector<int>& structure,
                   const std::vector<std::vector<bool>>& allowed, std::vector<Candidate>& candidates) {
    const StructureClasses made = classes_of(subject, structure, allowed);
    for (const auto& options : made.classes) {
        if (options.empty()) return;
    }
    const double base = predicted_cost(subject, structure);
    const std::vector<KnapsackChoice> front = pareto_front(made.classes, kMostError);
    const std::size_t count = std::min(front.size(), kMostOfStructure);
    for (std::size_t i = 0; i < count; ++i) {
        const KnapsackChoice& inner = front[count > 1 ? i * (front.size() - 1) / (count - 1) : 0];
        KnapsackChoice whole{base + inner.cost, inner.error, structure};
        for (std::size_t c = 0; c < made.classes.size(); ++c) {
            whole.chosen[made.term[c]] = made.option[c][static_cast<std::size_t>(inner.chosen[c])];
        }
        candidates.push_back({std::move(whole)});
    }
}

/// Plans what stands on the front until everything there is planned.
void plan_front(const FrontSubject& subject, std::vector<Candidate>& candidates) {
    for (bool changed = true; changed;) {
        changed = false;
        std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            return std::pair(a.choice.error, a.choice.cost) < std::pair(b.choice.error, b.choice.cost);
        });
        double least = 1e300;
        for (Candidate& candidate : candidates) {
            if (candidate.choice.cost >= least) continue;
            if (!candidate.is_planned) {
                const bool possible = is_possible(subject, candidate.choice.chosen);
                candidate.choice.cost = possible ? predicted_cost(subject, candidate.choice.chosen) : 1e300;
                candidate.is_planned = changed = true;
            }
            least = std::min(least, candidate.choice.cost);
        }
    }
}

/// With logarithms of costs, as far as a cost is a cost.
KnapsackChoice logarithmic(const KnapsackChoice& choice) {
    return {std::log(std::max(choice.cost, 1e-9)), choice.error, {}};
}

}  // namespace

double predicted_cost(const FrontSubject& subject, const std::vector<int>& chosen) {
    const CostSubject costs{subject.source, subject.terms, subject.measured.size};
    const PictureCost cost = picture_cost(costs, subject.measured.costs, chosen, subject.pixels_of_probe);
    return std::max(cost.frame, 0.0) + std::max(cost.bake, 0.0) / subject.options.frames;
}

std::vector<Candidate> find_candidates(const FrontSubject& subject, const std::vector<std::vector<bool>>& allowed) {
    std::vector<Candidate> candidates;
    for (const std::vector<int>& structure : structures_of(subject.terms, allowed)) {
        if (is_possible(subject, structure)) add_structure(subject, structure, allowed, candidates);
    }
    for (const DrawnProbe& drawn : subject.measured.errors.drawn) {
        bool may = is_possible(subject, drawn.chosen);
        for (std::size_t t = 0; t < subject.terms.size(); ++t) {
            may = may && allowed[t][static_cast<std::size_t>(drawn.chosen[t])];
        }
        if (may) candidates.push_back({{predicted_cost(subject, drawn.chosen), 0.0, drawn.chosen}, 1e30, true});
    }
    const std::vector<int> exact = oracles(subject.terms);
    if (is_possible(subject, exact)) candidates.push_back({{predicted_cost(subject, exact), 0.0, exact}, 0.0, true});
    return candidates;
}

void predict(const FrontSubject& subject, std::vector<Candidate>& candidates, std::size_t first) {
    const SetErrors& errors = subject.measured.errors;
    for (Candidate& candidate : candidates) {
        const DrawnProbe* nearest = nullptr;
        for (std::size_t i = first; i < errors.drawn.size(); ++i) {
            const double distance = distance_from(errors, errors.drawn[i], candidate.choice.chosen);
            if (distance >= candidate.distance) continue;
            candidate.distance = distance;
            nearest = &errors.drawn[i];
        }
        if (nearest) candidate.choice.error = budget_of(predicted_error(errors, *nearest, candidate.choice.chosen));
    }
    plan_front(subject, candidates);
}

std::vector<KnapsackChoice> front_of(const std::vector<Candidate>& candidates) {
    std::vector<KnapsackChoice> choices;
    for (const Candidate& candidate : candidates) {
        if (candidate.choice.cost < 1e300) choices.push_back(candidate.choice);
    }
    return front_of(std::move(choices));
}

void explore(const FrontSubject& subject, std::vector<Candidate>& candidates, int renders, double corner_error) {
    const double corner = std::log(std::max(predicted_cost(subject, oracles(subject.terms)), 1e-9));
    for (int render = 0; render < renders; ++render) {
        std::vector<KnapsackChoice> known;
        for (const Candidate& candidate : candidates) {
            if (candidate.distance == 0.0) known.push_back(logarithmic(candidate.choice));
        }
        known = front_of(std::move(known));
        const double worth = hypervolume(known, corner, corner_error);
        Candidate* best = nullptr;
        double most = kLittle * worth;
        for (Candidate& candidate : candidates) {
            if (candidate.distance == 0.0 || !candidate.is_planned) continue;
            known.push_back(logarithmic(candidate.choice));
            const double more = hypervolume(known, corner, corner_error) - worth;
            known.pop_back();
            if (more <= most) continue;
            most = more;
            best = &candidate;
        }
        if (!best) return;
        const std::size_t before = subject.measured.errors.drawn.size();
        const bool drawn = draw_probe(subject.source, subject.terms, best->choice.chosen, subject.options,
                                      subject.drawn, subject.measured);
        if (!drawn) best->choice.cost = 1e300;
        predict(subject, candidates, before);
    }
}

}  // namespace kreda::tools
