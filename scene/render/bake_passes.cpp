// Passes that are run once: what is baked from the environment. They do nothing where the maps are there already, kept
// from the frame before or baked beforehand (EnvironmentSettings::prepared).
#include <memory>

#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

namespace {

/// Does the frame have to bake? Then this is where, and from what.
Baking* baking_of(const PassWork& work) {
    return work.frame.buffers.baking.get();
}

/// The same for what is made from the cube.
Baking* baking_from_cube(const PassWork& work) {
    Baking* const baking = baking_of(work);
    return baking && !baking->radiance.empty() ? baking : nullptr;
}

/// The maps of these needs alone, made from the cube.
lighting::EnvironmentMaps bake_some(const PassWork& work, const lighting::EnvironmentNeeds& needs) {
    return bake_environment(baking_of(work)->radiance, needs, work.frame.scene.environment.samples);
}

}  // namespace

void bake_cube(const PassWork& work) {
    Baking* const baking = baking_of(work);
    if (!baking) return;
    const lighting::EnvironmentNeeds& needs = work.frame.plan.environment;
    baking->radiance = environment_cube(work.frame.scene.environment);
    if (!needs.mirror || needs.blurred) return;
    lighting::EnvironmentNeeds mirror;
    mirror.mirror = true;
    baking->prepared->maps.prefiltered = bake_some(work, mirror).prefiltered;
}

void bake_levels(const PassWork& work) {
    if (!baking_from_cube(work)) return;
    lighting::EnvironmentNeeds blurred = work.frame.plan.environment;
    blurred.irradiance = false;
    blurred.brdf.clear();
    baking_of(work)->prepared->maps.prefiltered = bake_some(work, blurred).prefiltered;
}

void bake_irradiance(const PassWork& work) {
    if (!baking_from_cube(work)) return;
    lighting::EnvironmentNeeds irradiance;
    irradiance.irradiance = true;
    irradiance.form = work.frame.plan.environment.form;
    lighting::EnvironmentMaps maps = bake_some(work, irradiance);
    baking_of(work)->prepared->maps.irradiance = std::move(maps.irradiance);
    baking_of(work)->prepared->maps.sh9 = maps.sh9;
}

void bake_brdf(const PassWork& work) {
    if (!baking_of(work)) return;
    lighting::EnvironmentNeeds brdf;
    brdf.brdf = work.frame.plan.environment.brdf;
    baking_of(work)->prepared->maps.brdf = bake_some(work, brdf).brdf;
}

}  // namespace kreda::scene
