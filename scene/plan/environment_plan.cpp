#include "scene/plan/environment_plan.hpp"

#include <algorithm>

#include "lighting/batch/maps.hpp"
#include "lighting/microfacet.hpp"
#include "scene/microfacet_material.hpp"
#include "scene/plan/pass_functions.hpp"

namespace kreda::scene {

namespace {

/// Metals reflect nothing diffusely, but for what bounces between their facets.
bool reflects_diffusely(const lighting::Material& material) {
    const lighting::CookTorranceMaterial& m = material.cook_torrance;
    return !is_microfacet(material) || m.metallic != 1.0f || is_given(material.maps.metallic) ||
           m.energy_compensation == lighting::EnergyCompensation::kulla_conty;
}

/// The levels of the prefiltered map that a material reads: two that follow each other, all where a map says how rough.
struct Levels {
    int first = 0, last = lighting::kPrefilterLevels - 1;
};
Levels levels_read(const lighting::Material& material) {
    if (is_given(material.maps.roughness)) return {};
    const float alpha = lighting::alpha_from_roughness(material.cook_torrance.roughness);
    const int level = static_cast<int>(lighting::level_of_alpha(alpha));
    return {level, std::min(level + 1, lighting::kPrefilterLevels - 1)};
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

lighting::EnvironmentNeeds environment_needs(const Scene& scene, const MaterialMask& lit, bool background,
                                             bool all_levels) {
    lighting::EnvironmentNeeds needs;
    const bool split_sum = scene.environment.reference == 0;
    needs.mirror = background || (any_of(lit) && !split_sum);
    if (!split_sum) return needs;
    int first = lighting::kPrefilterLevels, last = 0;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (!lit[m]) continue;
        const lighting::Material& material = scene.materials[m];
        needs.irradiance |= all_levels || reflects_diffusely(material);
        if (!is_microfacet(material)) continue;
        const Levels levels = levels_read(material);
        first = std::min(first, levels.first);
        last = std::max(last, levels.last);
        const lighting::BrdfKind kind{material.cook_torrance.distribution, material.cook_torrance.geometry};
        if (std::find(needs.brdf.begin(), needs.brdf.end(), kind) == needs.brdf.end()) needs.brdf.push_back(kind);
    }
    needs.blurred = !needs.brdf.empty();
    if (needs.blurred && !all_levels) {
        needs.first_level = first;
        needs.last_level = last;
    }
    needs.form = needs.irradiance ? scene.environment.irradiance : lighting::IrradianceForm::map;
    return needs;
}

lighting::EnvironmentNeeds environment_needs(const Scene& scene) {
    const LightingChoices all = choose_lighting(scene, nullptr, wanted_of({}));
    return environment_needs(scene, all.environment, scene.environment.on && scene.image.environment_background, true);
}

std::vector<PlannedPass> plan_baking(const Scene& scene, const lighting::EnvironmentNeeds& needs) {
    std::vector<PlannedPass> passes;
    if (!needs.any()) return passes;
    const int size = environment_size(scene.environment);
    const auto bake = [&](void (*run)(const PassWork&), const char* map, const std::string& reason, const char* buffer,
                          const char* items, const lighting::BakeCost& cost) {
        const PassCost pass_cost{items, cost.count, cost.operations_each};
        passes.push_back({std::string("bake ") + map, reason, {{buffer, cost.bytes}}, pass_cost, PassScope::once, run});
        if (cost.bytes_while_baking == 0) return;
        passes.back().buffers.push_back({"what it is made from, while baking", cost.bytes_while_baking});
    };
    bake(bake_cube, "environment", why_cube(scene, needs), "cube map with its mip levels, while baking", "directions",
         environment_cost(scene.environment));
    const lighting::PrefilterSettings prefilter = prefilter_settings(needs, scene.environment.samples);
    if (needs.mirror && !needs.blurred) {
        passes.back().buffers.push_back({"cube map", lighting::prefilter_cost(size, prefilter).bytes});
    }
    if (scene.environment.reference > 0 && needs.mirror) {
        const std::uint64_t texels = std::uint64_t{6} * size * size;
        passes.back().buffers.push_back({"table of its light", (2 * texels + 6 * size) * sizeof(float)});
    }
    if (needs.blurred) {
        bake(bake_levels, "prefiltered levels",
             "a cook_torrance material reflects the environment: levels " + std::to_string(needs.first_level) + " to " +
                 std::to_string(needs.last_level) + " of its roughness, " + std::to_string(scene.environment.samples) +
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
