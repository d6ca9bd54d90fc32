// 90_what_a_scene_requires: the plan. Five scenes, and which passes each of them needs, with what they cost.
// Page docs/90_what_a_scene_requires.md | After 24_shading, 30_fog | New: make_plan(), PlannedPass, PassCost
// Break at: list_passes | Look at: plan.passes, plan.frequency, plan.vertex | Try: switch a lamp off, no fog
#include <cmath>
#include <cstdio>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

struct PlannedScene {
    const char* name;
    scene::Scene scene;
};

scene::Scene make_scene(glm::ivec2 size, lighting::ReflectionModel model, scene::ShadingFrequency frequency) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.6f, 1.1f, 3.4f};
    scene.camera.vertical_fov_deg = 40.0f;
    scene.shading.frequency = frequency;
    lighting::Material material = shiny(kBlue, 40.0f, model);
    material.cook_torrance.albedo = kOrange;
    material.cook_torrance.metallic = 1.0f;
    material.cook_torrance.roughness = 0.35f;
    add_shape(scene, "sphere", 24, glm::vec3(0.0f), material);
    add_shape(scene, "plane", 1, glm::vec3(0.0f, -1.0f, -1.0f), matte(kDust));
    scene.objects.back().world_from_object *= 3.0f;
    scene.objects.back().world_from_object[3] = {0.0f, -1.0f, -1.0f, 1.0f};
    scene.lights = {directional_light({-1.0f, -1.4f, -0.8f}), point_light({2.5f, 1.5f, 1.5f}, 0.8f)};
    return scene;
}

std::vector<PlannedScene> five_scenes(glm::ivec2 size) {
    using lighting::ReflectionModel;
    using scene::ShadingFrequency;
    std::vector<PlannedScene> scenes = {
        {"unlit", make_scene(size, ReflectionModel::unlit, ShadingFrequency::phong)},
        {"flat", make_scene(size, ReflectionModel::phong, ShadingFrequency::flat)},
        {"Gouraud", make_scene(size, ReflectionModel::phong, ShadingFrequency::gouraud)},
        {"fog", make_scene(size, ReflectionModel::phong, ShadingFrequency::phong)},
        {"shadow", make_scene(size, ReflectionModel::cook_torrance, ShadingFrequency::phong)}};
    scenes[0].scene.materials[1].model = ReflectionModel::unlit;  // the ground, too: no lamp matters
    scenes[3].scene.fog = {.mode = lighting::FogMode::exp, .color = kDust, .density = 0.12f};
    scenes[4].scene.lights[0].shadow = true;
    return scenes;
}

/// The passes that at least one of the scenes needs, in the order of the pipeline.
const std::vector<std::string> kPasses = {"vertices",        "shadow map", "light vertices", "triangles",
                                          "light triangles", "visibility", "interpolate",    "light pixels",
                                          "fog at pixels",   "film"};

/// The pass of that name in the plan, or nullptr: then nothing of it is computed or allocated.
const scene::PlannedPass* find_pass(const scene::RenderPlan& plan, const std::string& name) {
    for (const scene::PlannedPass& pass : plan.passes) {
        if (pass.name == name || (name == "shadow map" && pass.name.starts_with(name))) return &pass;
    }
    return nullptr;
}

/// A bar as long as the cost is high, from a thousand operations to a hundred million; a dot for a pass left out. What
/// a pass runs at every point that it lights counts with it.
void draw_cell(Image& picture, const scene::RenderPlan& plan, const scene::PlannedPass* pass, int left, int middle,
               int width, int height) {
    if (!pass) return draw_disc(picture, {left + 2, middle}, std::max(1.2f, 0.12f * height), kSlate);
    const double operations = operations_of(plan, pass->name);
    const double share = std::log10(std::max(operations, 1e3) / 1e3) / 5.0;
    const int length = std::max(3, static_cast<int>(width * std::min(share, 1.0)));
    fill_rectangle(picture, left, middle - height / 2, length, height, operations > 0.0 ? kOrange : kBlue);
}

/// A ball in front of the camera, and what nobody sees of it: a dear ball behind the camera, a lamp of intensity 0, one
/// that shines on backs alone, fog of density 0.
scene::Scene crowded_scene(glm::ivec2 size) {
    scene::Scene scene = make_scene(size, lighting::ReflectionModel::phong, scene::ShadingFrequency::phong);
    add_shape(scene, "sphere", 64, {0.0f, 1.0f, 9.0f}, microfacet(kOrange, 0.0f, 0.3f));
    scene.lights.insert(scene.lights.end(), {point_light({0, 2, 2}, 0.0f), directional_light({0.0f, 0.2f, 1.0f})});
    scene.lights[0].shadow = scene.lights[2].shadow = scene.lights[3].shadow = true;
    scene.fog = {.mode = lighting::FogMode::exp, .density = 0.0f};
    return scene;
}

/// The same picture by the plan that leaves nothing out and by the one that does, and what they take.
void draw_pruned(const Options& options) {
    const int scale = text_scale(options.height), half = options.width / 2, bottom = 44 * scale;
    const float type = caption_size(options.height);
    const scene::Scene scene = crowded_scene({half - 4, options.height - bottom});
    Panel panel = drawing_panel({options.width, options.height});
    for (const bool prune : {false, true}) {
        const scene::RenderPlan plan = make_plan_for(scene, scene::PlanRequest{.prune = prune});
        scene::RenderBuffers buffers;
        const double ms = render(scene, plan, buffers).times.total_ms;
        const int x = prune ? half + 2 : 2, y = options.height - bottom + 11 * scale;
        char line[3][64];
        std::snprintf(line[0], 64, "%s: %zu passes", prune ? "what is seen" : "everything", plan.passes.size());
        std::snprintf(line[1], 64, "%.1f million operations", 1e-6 * total_operations(plan));
        std::snprintf(line[2], 64, "%.1f MB", 1e-6 * double(total_bytes(plan)));
        for (int i = 0; i < 3; ++i) panel.labels.push_back({{x + 4, y + 12 * i * scale}, line[i], kChalk, type});
        paste_picture(buffers.film, {x, 0}, panel);
        std::printf("%s, %s, %s, %.2f ms\n", line[0], line[1], line[2], ms);
    }
    save_panel(options, "pruned", panel);
}

void draw(const Options& options) {
    const int scale = text_scale(options.height), left = 100 * options.width / 320, top = options.height * 5 / 18;
    const int column = (options.width - left) / 5, row = (options.height - top) / static_cast<int>(kPasses.size());
    const std::vector<PlannedScene> scenes = five_scenes({column - 4, top - 12 * scale});
    Panel panel = drawing_panel({options.width, options.height});
    int y = top + row / 2 + 3 * scale - row;
    for (const std::string& pass : kPasses)
        panel.labels.push_back({{4 * scale, y += row}, pass, kChalk, caption_size(options.height)});
    for (int c = 0; c < 5; ++c) {
        const auto& [name, scene] = scenes[static_cast<std::size_t>(c)];
        const scene::RenderPlan plan = make_plan(scene);
        const int x = left + c * column;
        paste_picture(scene::render(scene), {x, 0}, panel);
        panel.labels.push_back({{x, top - 3 * scale}, name, kYellow, caption_size(options.height)});
        for (int r = 0; r < static_cast<int>(kPasses.size()); ++r) {
            draw_cell(panel.image, plan, find_pass(plan, kPasses[static_cast<std::size_t>(r)]), x,
                      top + r * row + row / 2, column - 6, row * 3 / 5);
        }
        std::printf("%-8s %2zu passes, %5.1f million operations, %8llu bytes\n", name, plan.passes.size(),
                    1e-6 * total_operations(plan), static_cast<unsigned long long>(total_bytes(plan)));
    }
    save_panel(options, "plans", panel);
    draw_pruned(options);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "90_what_a_scene_requires", draw);
}
