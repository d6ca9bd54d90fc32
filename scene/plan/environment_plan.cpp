#include "scene/plan/environment_plan.hpp"

#include <algorithm>

#include "scene/map_meshes.hpp"
#include "scene/plan/pass_functions.hpp"

namespace kreda::scene {

namespace {

/// Is any visible material of this kind?
template <class Test>
bool any_visible(const Scene& scene, Test test) {
    const std::vector<bool> visible = visible_materials(scene);
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (visible[m] && test(scene.materials[m])) return true;
    }
    return false;
}

bool is_microfacet(const lighting::Material& material) {
    return material.model == lighting::ReflectionModel::cook_torrance;
}

/// Why the environment itself is needed as a cube map.
std::string why_cube(const Scene& scene, const lighting::EnvironmentNeeds& needs) {
    const std::string size = std::to_string(environment_size(scene.environment));
    const std::string cube = "a cube map of " + size + " texels a side";
    if (!needs.mirror) return cube + ", from which the others are baked";
    return cube + (scene.image.environment_background ? ": image.background = \"environment\""
                                                      : ": environment.reference asks for samples of it");
}

}  // namespace

lighting::EnvironmentNeeds environment_needs(const Scene& scene) {
    lighting::EnvironmentNeeds needs;
    if (!scene.environment.on) return needs;
    const bool lights = any_visible(scene, [](const auto& m) { return m.model != lighting::ReflectionModel::unlit; });
    const bool shines = any_visible(scene, is_microfacet);
    const bool split_sum = scene.environment.reference == 0;
    needs.mirror = scene.image.environment_background || (lights && !split_sum);
    needs.irradiance = lights && split_sum;
    needs.blurred = shines && split_sum;
    needs.form = needs.irradiance ? scene.environment.irradiance : lighting::IrradianceForm::map;
    if (!needs.blurred) return needs;
    const std::vector<bool> visible = visible_materials(scene);
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const lighting::CookTorranceMaterial& material = scene.materials[m].cook_torrance;
        const lighting::BrdfKind kind{material.distribution, material.geometry};
        const bool known = std::find(needs.brdf.begin(), needs.brdf.end(), kind) != needs.brdf.end();
        if (visible[m] && is_microfacet(scene.materials[m]) && !known) needs.brdf.push_back(kind);
    }
    return needs;
}

std::vector<PlannedPass> plan_baking(const Scene& scene, const lighting::EnvironmentNeeds& needs) {
    std::vector<PlannedPass> passes;
    if (!needs.any()) return passes;
    const int size = environment_size(scene.environment);
    const auto bake = [&](void (*run)(const PassWork&), const char* map, const std::string& reason, const char* buffer,
                          const char* items, const lighting::BakeCost& cost) {
        const PassCost pass_cost{items, cost.count, cost.operations_each};
        passes.push_back({std::string("bake ") + map, reason, {{buffer, cost.bytes}}, pass_cost, PassScope::once, run});
    };
    bake(bake_cube, "environment", why_cube(scene, needs), "cube map with its mip levels, while baking", "directions",
         environment_cost(scene.environment));
    lighting::PrefilterSettings prefilter;
    prefilter.samples = scene.environment.samples;
    prefilter.blurred = needs.blurred;
    if (needs.mirror && !needs.blurred) {
        passes.back().buffers.push_back({"cube map", lighting::prefilter_cost(size, prefilter).bytes});
    }
    if (scene.environment.reference > 0 && needs.mirror) {
        const std::uint64_t texels = std::uint64_t{6} * size * size;
        passes.back().buffers.push_back({"table of its light", (2 * texels + 6 * size) * sizeof(float)});
    }
    if (needs.blurred) {
        bake(bake_levels, "prefiltered levels",
             "a cook_torrance material reflects the environment, " + std::to_string(scene.environment.samples) +
                 " samples at roughness 1",
             "levels of a cube map", "samples of the texels", lighting::prefilter_cost(size, prefilter));
    }
    if (needs.irradiance) {
        const bool sh9 = needs.form == lighting::IrradianceForm::sh9;
        const char* const reason =
            sh9 ? "nine coefficients: environment.irradiance = \"sh9\"" : "a lit material gathers it from all sides";
        bake(bake_irradiance, "irradiance", reason, sh9 ? "coefficients" : "cube map",
             sh9 ? "texels" : "pairs of texels", lighting::irradiance_cost(size, needs.form));
    }
    if (!needs.brdf.empty()) {
        const std::size_t pairs = needs.brdf.size();
        bake(bake_brdf, "brdf map",
             std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") + " of distribution and geometry",
             "A, B and E_avg", "facets", lighting::brdf_cost(pairs));
    }
    return passes;
}

}  // namespace kreda::scene
