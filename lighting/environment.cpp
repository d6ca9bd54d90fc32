#include "lighting/environment.hpp"

namespace kreda::lighting {

EnvironmentMaps bake_environment(const CubeMap& radiance, const EnvironmentNeeds& needs, int samples,
                                 const Progress& progress) {
    EnvironmentMaps maps;
    if (needs.mirror || needs.blurred) {
        PrefilterSettings settings;
        settings.samples = samples;
        settings.blurred = needs.blurred;
        maps.prefiltered = prefilter(radiance, settings, progress);
    }
    if (needs.irradiance && needs.form == IrradianceForm::sh9) maps.sh9 = project_to_sh9(radiance);
    if (needs.irradiance && needs.form == IrradianceForm::map) maps.irradiance = irradiance_map(radiance, {});
    for (const BrdfKind& kind : needs.brdf) maps.brdf.push_back(compute_brdf_map(kind.distribution, kind.geometry));
    return maps;
}

const BrdfMap* find_brdf(const EnvironmentMaps& maps, const BrdfKind& kind) {
    for (const BrdfMap& map : maps.brdf) {
        if (map.distribution == kind.distribution && map.geometry == kind.geometry) return &map;
    }
    return nullptr;
}

}  // namespace kreda::lighting
