// kreda plan: what a scene requires, and why.
#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/plan/origin_words.hpp"
#include "scene/plan/plan.hpp"
#include "tools/commands.hpp"
#include "tools/plan_json.hpp"
#include "tools/render_output.hpp"
#include "tools/scene_options.hpp"

namespace kreda::tools {

namespace {

struct PlanOptions {
    SceneOptions scene;
    bool why_not = false;
    bool json = false;
};

/// The first step, before maps are read: what is seen.
std::string seen_text(const scene::RenderPlan& plan) {
    const auto count = [](const auto& list, auto test) {
        return std::to_string(std::count_if(list.begin(), list.end(), test)) + " of " + std::to_string(list.size());
    };
    const auto is_true = [](bool flag) { return flag; };
    return "seen, found from the meshes alone: " +
           count(plan.seen->objects, [](const scene::SeenObject& object) { return object.samples > 0; }) +
           " objects, " + count(plan.seen->of_material, [](std::uint64_t samples) { return samples > 0; }) +
           " materials; the maps of " +
           std::to_string(std::count_if(plan.lighting.maps.begin(), plan.lighting.maps.end(), is_true)) +
           " of them are read; for what is seen:\n";
}

}  // namespace

void add_plan_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("plan", "Print the passes that a scene requires, each with its reason and its memory");
    const auto options = std::make_shared<PlanOptions>();
    add_scene_options(*command, options->scene);
    command->add_flag("--why-not", options->why_not,
                      "Also list the passes that are left out, and what would need them");
    command->add_flag("--json", options->json, "Print the plan, and what is left out, as JSON");
    command->footer(
        "\nTwo steps: which objects, materials and maps are seen is found from the meshes; then the passes are chosen "
        "for "
        "it.\n"
        "A pass that nothing requires is not run and allocates nothing. Costs are estimated from counts before "
        "anything is\n"
        "drawn: an operation is one +, -, *, /, root or comparison of one number, pow counts 60, exp 25; every sample "
        "counts as\n"
        "covered. Buffers of a tile or batch exist once a thread. kreda render --time measures.");
    command->callback([options] {
        const auto [scene, plan] = load_and_plan(options->scene, png_request());
        if (options->json) {
            std::cout << plan_json(scene, plan);
            return;
        }
        if (scene::is_far_from_zero(scene)) std::cout << scene::origin_sentence(scene) << "\n";
        if (plan.seen && !scene.objects.empty()) std::cout << seen_text(plan);
        std::cout << describe(plan, options->why_not);
    });
}

}  // namespace kreda::tools
