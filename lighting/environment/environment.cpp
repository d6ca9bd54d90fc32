#include "lighting/environment/environment.hpp"

#include <algorithm>

#include "lighting/environment/bake_cost.hpp"

namespace kreda::lighting {

EnvironmentMaps bake_environment(const CubeMap& radiance, const EnvironmentNeeds& needs, int samples,
                                 const Progress& progress) {
    EnvironmentMaps maps;
    const int size = radiance.empty() ? 0 : radiance.levels[0].size;
    const std::vector<Progress> steps = progress_of_steps(progress, bake_work(size, needs, samples));
    if (needs.mirror || needs.blurred) {
        maps.prefiltered = prefilter(radiance, prefilter_settings(needs, samples), steps[0]);
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

PrefilterSettings prefilter_settings(const EnvironmentNeeds& needs, int samples) {
    PrefilterSettings settings;
    settings.samples = samples;
    settings.blurred = needs.blurred;
    settings.mirror = needs.mirror;
    settings.first_level = needs.first_level;
    settings.last_level = needs.last_level;
    return settings;
}

bool covers(const EnvironmentNeeds& baked, const EnvironmentNeeds& needs) {
    const bool mirror = baked.mirror || (baked.blurred && baked.first_level == 0);
    const bool first = baked.first_level <= needs.first_level && (needs.first_level > 0 || mirror);
    const bool levels = baked.blurred && first && needs.last_level <= baked.last_level;
    const bool irradiance = baked.irradiance && baked.form == needs.form;
    const auto has_brdf = [&](const BrdfKind& kind) {
        return std::find(baked.brdf.begin(), baked.brdf.end(), kind) != baked.brdf.end();
    };
    return (levels || !needs.blurred) && (mirror || !needs.mirror) && (irradiance || !needs.irradiance) &&
           std::all_of(needs.brdf.begin(), needs.brdf.end(), has_brdf);
}

const BrdfMap* find_brdf(const EnvironmentMaps& maps, const BrdfKind& kind) {
    for (const BrdfMap& map : maps.brdf) {
        if (map.distribution == kind.distribution && map.geometry == kind.geometry) return &map;
    }
    return nullptr;
}

}  // namespace kreda::lighting
