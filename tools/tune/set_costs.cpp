#include "tools/tune/set_costs.hpp"

#include <algorithm>

#include "scene/error.hpp"
#include "scene/plan/plan_cost.hpp"

namespace kreda::tools {

namespace {

std::string key_of(const scene::PlannedPass& pass) {
    return pass.name + ", " + pass.cost.items;
}

/// Operations, or items where the plan counts none: moving is work, too.
double work_of(const scene::PlannedPass& pass) {
    return pass.cost.operations_each > 0.0 ? pass.cost.operations() : static_cast<double>(pass.cost.count);
}

bool is_film(const scene::PlannedPass& pass) {
    return pass.cost.items == "pixels";
}

bool is_of_samples(const scene::PlannedPass& pass) {
    return pass.cost.items == "samples" || pass.cost.items.starts_with("points");  // one for a block of samples
}

/// At every sample, or wherever light is computed.
bool is_at_points(const scene::PlannedPass& pass) {
    return is_of_samples(pass) || pass.scope == scene::PassScope::points || pass.name.starts_with("light ");
}

/// Of one pixel; it takes time even where nothing is added up.
double film_operations(int samples, CostBy by) {
    scene::RenderPlan plan;
    plan.samples = samples;
    scene::PlanCounts counts;
    counts.pixels = 1;
    const double operations = film_cost(plan, counts).operations();
    return by == CostBy::plan ? operations : std::max(operations, 1.0);
}

/// Is the term's cost what the plan says of it? Samples multiply; and a time of what is computed at lit points is as it
/// was measured: the plan counts the dearest material at all of them.
bool is_planned(const Term& term, CostBy by) {
    if (is_samples(term)) return false;
    const bool moves_passes =
        term.kind == TermKind::structural || term.options.front().settings.front().table == "shadow";
    return by == CostBy::plan || moves_passes;
}

double rate_of(const SetCosts& costs, const scene::PlannedPass& pass) {
    const auto found = costs.rates.find(key_of(pass));
    return found == costs.rates.end() ? costs.usual_rate : found->second;
}

double cost_of_pass(const SetCosts& costs, const scene::PlannedPass& pass) {
    return costs.by == CostBy::plan ? 1e-6 * pass.cost.operations() : rate_of(costs, pass) * work_of(pass);
}

double lit_points(const scene::PlanCounts& counts, const scene::RenderPlan& plan) {
    const double block = static_cast<double>(plan.shading_rate) * plan.shading_rate;
    switch (plan.frequency) {
        case scene::ShadingFrequency::phong: return static_cast<double>(counts.samples) / block;
        case scene::ShadingFrequency::gouraud: return static_cast<double>(counts.vertices);
        case scene::ShadingFrequency::flat: return static_cast<double>(counts.triangles);
    }
    return 0.0;
}

SetCost cost_of_scene(const scene::Scene& scene, const SetCosts& costs) {
    const scene::RenderPlan plan = make_plan(scene);
    SetCost cost;
    cost.lit = std::max(1.0, lit_points(count(scene, plan), plan));
    cost.lit_at_samples = plan.frequency == scene::ShadingFrequency::phong;
    cost.samples = scene.image.samples;
    cost.bake = 1e-6 * baking_operations(plan);
    for (const scene::PlannedPass& pass : plan.passes) {
        if (pass.scope == scene::PassScope::once) continue;
        if (is_film(pass)) {
            const double rate = costs.by == CostBy::plan ? 1e-6 : rate_of(costs, pass);
            cost.film += rate * static_cast<double>(pass.cost.count);
        } else {
            const double takes = cost_of_pass(costs, pass);
            (is_of_samples(pass) ? cost.of_samples : cost.of_picture) += takes;
            (is_at_points(pass) ? cost.parts.at_points : cost.parts.rest) += takes;
        }
    }
    return cost;
}

}  // namespace

FrameParts parts_of(const scene::RenderPlan& plan, const scene::StageTimes& times) {
    FrameParts parts;
    for (const auto& [name, ms] : times.stages) {
        const auto pass =
            std::find_if(plan.passes.begin(), plan.passes.end(),
                         [&, named = std::string_view(name)](const auto& one) { return one.name == named; });
        if (pass == plan.passes.end() || pass->scope == scene::PassScope::once) continue;  // baked before the frame
        (is_at_points(*pass) ? parts.at_points : parts.rest) += ms;
    }
    return parts;
}

void add_rates(const scene::RenderPlan& plan, const scene::StageTimes& times, PassTimes& rates) {
    for (const scene::PlannedPass& pass : plan.passes) {
        if (pass.scope == scene::PassScope::once) continue;
        const auto found = std::find_if(times.stages.begin(), times.stages.end(),
                                        [&](const auto& stage) { return stage.first == pass.name; });
        const double work = work_of(pass);
        if (found != times.stages.end() && work > 0.0) rates[key_of(pass)].push_back(found->second / work);
    }
}

void set_rates(const PassTimes& measured, SetCosts& costs) {
    std::vector<double> medians;
    for (const auto& [key, some] : measured) {
        std::vector<double> rates = some;
        const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
        std::nth_element(rates.begin(), middle, rates.end());
        costs.rates[key] = *middle;
        medians.push_back(*middle);
    }
    if (medians.empty()) return;
    const auto middle = medians.begin() + static_cast<std::ptrdiff_t>(medians.size() / 2);
    std::nth_element(medians.begin(), middle, medians.end());
    costs.usual_rate = *middle;
}

void scale_times(SetCosts& costs, double factor) {
    for (auto& [key, rate] : costs.rates) rate *= factor;
    costs.usual_rate *= factor;
    for (std::vector<FrameParts>& options : costs.beyond) {
        for (FrameParts& beyond : options) beyond = {factor * beyond.at_points, factor * beyond.rest};
    }
    costs.known.clear();
}

int samples_of(const std::vector<Term>& terms, const std::vector<int>& chosen) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
        if (is_samples(terms[t])) return std::stoi(terms[t].options[static_cast<std::size_t>(chosen[t])].name);
    }
    return 0;
}

const SetCost& planned_cost(const CostSubject& subject, SetCosts& costs, std::vector<int> chosen) {
    for (std::size_t t = 0; t < subject.terms.size(); ++t) {
        if (!is_planned(subject.terms[t], costs.by)) chosen[t] = subject.terms[t].base;
    }
    const auto found = costs.known.find(chosen);
    if (found != costs.known.end()) return found->second;
    SetCost cost;
    try {
        std::vector<Setting> settings = settings_of(subject.terms, chosen);
        settings.push_back(subject.size);
        cost = cost_of_scene(read_with(subject.source, settings), costs);
    } catch (const scene::UserError&) { cost.is_possible = false; }
    return costs.known.emplace(std::move(chosen), cost).first->second;
}

PictureCost picture_cost(const CostSubject& subject, SetCosts& costs, const std::vector<int>& chosen,
                         double pixels_of_probe) {
    const int n = samples_of(subject.terms, chosen), n_base = samples_of(subject.terms, bases(subject.terms));
    const double scale = pixels_of_probe * (n > 0 ? static_cast<double>(n) * n / (n_base * n_base) : 1.0);
    const SetCost& cost = planned_cost(subject, costs, chosen);
    const double film = film_operations(n > 0 ? n : cost.samples, costs.by);
    PictureCost whole{scale * cost.of_samples + cost.of_picture + pixels_of_probe * film * cost.film, cost.bake};
    if (costs.by == CostBy::plan) return whole;
    constexpr double kLeast = 0.1;  // of what the plan says: savings that were measured one by one may exceed it
    const double least = kLeast * whole.frame;
    whole.bake = 0.0;
    const double lit = cost.lit / costs.base_lit * (cost.lit_at_samples ? scale : 1.0);
    for (std::size_t t = 0; t < chosen.size(); ++t) {
        const auto o = static_cast<std::size_t>(chosen[t]);
        whole.frame += lit * costs.beyond[t][o].at_points + costs.beyond[t][o].rest;
        whole.bake += costs.bake_more[t][o];
    }
    whole.frame = std::max(whole.frame, least);
    return whole;
}

}  // namespace kreda::tools
