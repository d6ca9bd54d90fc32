#include "examples/error_budget.hpp"

#include "scene/plan/plan_cost.hpp"

namespace kreda::examples {

namespace {

constexpr const char* kScene = R"(
[image]
samples = 2
background = [0.3, 0.34, 0.4]
[camera]
position = [0, 1, 5]
target = [0, 0.1, 0]
vertical_fov = 34
[[light]]
direction = [-1, -1.5, -0.6]
intensity = 2
[fog]
mode = "exp"
density = 0.2
color = [0.3, 0.34, 0.4]
[[material]]
name = "ball"
model = "cook_torrance"
albedo = [0.75, 0.3, 0.15]
roughness = 0.35
[[material]]
name = "floor"
model = "lambert"
[[object]]
mesh = "sphere"
translate = [0, 0.4, 0]
material = "ball"
[[object]]
mesh = "plane"
scale = [6, 1, 6]
translate = [0, -0.6, 0]
material = "floor"
)";

std::vector<std::string> details(const std::string& ball, const std::string& floor) {
    return {"object.0.detail=" + ball, "object.1.detail=" + floor};
}

scene::Scene scene_with(const std::vector<BudgetTerm>& terms, const std::vector<int>& chosen, glm::ivec2 size) {
    std::vector<std::string> settings = {"image.size=[" + std::to_string(size.x) + "," + std::to_string(size.y) + "]"};
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const std::vector<std::string>& more = terms[t].ways[static_cast<std::size_t>(chosen[t])].settings;
        settings.insert(settings.end(), more.begin(), more.end());
    }
    return tools::scene_of(kScene, settings);
}

}  // namespace

std::vector<BudgetTerm> terms_of_lesson() {
    return {{"Fresnel",
             {{"exact", {"material.0.fresnel=exact"}},
              {"Schlick", {"material.0.fresnel=schlick"}},
              {"F = F0", {"material.0.fresnel=none"}}}},
            {"masking",
             {{"Smith, correlated", {"material.0.geometry=smith_correlated"}},
              {"Schlick-GGX", {"material.0.geometry=schlick_ggx"}},
              {"implicit", {"material.0.geometry=implicit"}}}},
            {"fog", {{"at pixels", {"fog.frequency=pixel"}}, {"at vertices", {"fog.frequency=vertex"}}}},
            {"triangles", {{"128", details("128", "64")}, {"48", details("48", "16")}, {"16", details("16", "2")}}}};
}

BudgetSet draw_set(const std::vector<BudgetTerm>& terms, const std::vector<int>& chosen, glm::ivec2 size,
                   const BudgetSet* exact) {
    const scene::Scene scene = scene_with(terms, chosen, size);
    scene::RenderBuffers buffers;
    BudgetSet set{chosen, {}, total_operations(make_plan(scene)), tools::draw_picture(scene, buffers, 1).encoded};
    if (!exact) return set;
    const scene::Scene truth = scene_with(terms, exact->chosen, size);
    set.cost /= total_operations(make_plan(truth));
    set.error = tools::code_error(set.picture, exact->picture);
    return set;
}

void measure_ways(std::vector<BudgetTerm>& terms, glm::ivec2 size, const BudgetSet& exact) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
        for (std::size_t w = 0; w < terms[t].ways.size(); ++w) {
            std::vector<int> chosen(terms.size(), 0);
            chosen[t] = static_cast<int>(w);
            const BudgetSet set = draw_set(terms, chosen, size, &exact);
            terms[t].ways[w].cost = set.cost - 1.0;
            terms[t].ways[w].error = set.error.mean;
        }
    }
}

std::vector<tools::KnapsackChoice> budget_front(const std::vector<BudgetTerm>& terms) {
    std::vector<std::vector<tools::KnapsackOption>> classes;
    for (const BudgetTerm& term : terms) {
        classes.emplace_back();
        for (const Way& way : term.ways) classes.back().push_back({way.cost, way.error});
    }
    std::vector<tools::KnapsackChoice> front = tools::pareto_front(classes);
    for (tools::KnapsackChoice& choice : front) choice.cost += 1.0;  // beside the exact picture
    return front;
}

std::size_t cheapest_within(const std::vector<tools::KnapsackChoice>& front, double budget) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (front[i].error <= budget) best = i;  // costs fall along the front
    }
    return best;
}

std::vector<BudgetTrial> keep_budget(const std::vector<BudgetTerm>& terms,
                                     const std::vector<tools::KnapsackChoice>& front, double budget, glm::ivec2 size,
                                     const BudgetSet& exact) {
    std::vector<BudgetTrial> trials;
    for (std::size_t i = cheapest_within(front, budget) + 1; i-- > 0;) {
        trials.push_back({front[i], draw_set(terms, front[i].chosen, size, &exact)});
        if (trials.back().drawn.error.mean <= budget) break;  // the first of the front is exact
    }
    return trials;
}

std::vector<std::vector<int>> all_sets(const std::vector<BudgetTerm>& terms) {
    std::vector<std::vector<int>> sets = {{}};
    for (const BudgetTerm& term : terms) {
        std::vector<std::vector<int>> longer;
        for (const std::vector<int>& part : sets) {
            for (std::size_t w = 0; w < term.ways.size(); ++w) {
                longer.push_back(part);
                longer.back().push_back(static_cast<int>(w));
            }
        }
        sets = std::move(longer);
    }
    return sets;
}

}  // namespace kreda::examples
