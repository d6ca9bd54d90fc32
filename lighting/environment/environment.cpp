#include "lighting/environment/environment.hpp"

#include "lighting/environment/bake_cost.hpp"

namespace kreda::lighting {

EnvironmentMaps bake_environment(const CubeMap& radiance, const EnvironmentNeeds& needs, int samples,
                                 const Progress& progress) {
    EnvironmentMaps maps;
    const int size = radiance.empty() ? 0 : radiance.levels[0].size;
    const std::vector<Progress> steps = progress_of_steps(progress, bake_work(size, needs, samples));
    if (needs.mirror || needs.blurred) {
        PrefilterSettings settings;
        settings.samples = samples;
        settings.blurred = needs.blurred;
        maps.prefiltered = prefilter(radiance, settings, steps[0]);
    }
    if (needs.irradiance && needs.form == IrradianceForm::sh9) maps.sh9 = project_to_sh9(radiance);
    if (needs.irradiance && needs.form == IrradianceForm::map) maps.irradiance = irradiance_map(radiance, {}, steps[1]);
    const std::vector<Progress> kinds = progress_of_steps(steps[2], std::vector<double>(needs.brdf.size(), 1.0));
    for (std::size_t k = 0; k < needs.brdf.size(); ++k) {
        const BrdfKind& kind = needs.brdf[k];
        maps.brdf.push_back(compute_brdf_map(kind.distribution, kind.geometry, kBrdfMapSamples, kinds[k]));
    }
    return maps;
}

const BrdfMap* find_brdf(const EnvironmentMaps& maps, const BrdfKind& kind) {
    for (const BrdfMap& map : maps.brdf) {
        if (map.distribution == kind.distribution && map.geometry == kind.geometry) return &map;
    }
    return nullptr;
}

}  // namespace kreda::lighting
