// Light from an image: the maps that a scene's environment is baked into, each only if something asks for it.
#pragma once

#include <optional>
#include <vector>

#include "lighting/environment/brdf_map.hpp"
#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/irradiance.hpp"
#include "lighting/environment/light_table.hpp"
#include "lighting/environment/prefilter.hpp"
#include "lighting/material.hpp"

namespace kreda::lighting {

/// How irradiance is kept: a cube map, or nine numbers of a polynomial.
enum class IrradianceForm { map, sh9 };

/// A pair of terms whose scale and bias are one BRDF map.
struct BrdfKind {
    Distribution distribution = Distribution::ggx;  ///< D
    Geometry geometry = Geometry::schlick_ggx;      ///< G

    /// Equal in every member.
    bool operator==(const BrdfKind&) const = default;
};

/// What a scene asks of its environment.
struct EnvironmentNeeds {
    bool mirror = false;   ///< radiance by direction: background, reference
    bool blurred = false;  ///< specular reflection by the split sum
    int first_level = 0;   ///< of the blurred levels, those that some roughness reads; see prefilter.hpp
    int last_level = kPrefilterLevels - 1;      ///< included
    bool irradiance = false;                    ///< diffuse reflection by the split sum
    IrradianceForm form = IrradianceForm::map;  ///< how that irradiance is kept
    std::vector<BrdfKind> brdf;                 ///< one for each kind of specular material, each once

    /// Is anything needed at all?
    [[nodiscard]] bool any() const {
        return mirror || blurred || irradiance;
    }
    /// Equal in every member.
    bool operator==(const EnvironmentNeeds&) const = default;
};

/// The maps. Empty: nothing asked for them.
struct EnvironmentMaps {
    CubeMap prefiltered;        ///< level 0 is the environment itself
    LightTable light;           ///< of level 0; only for environment.reference
    CubeMap irradiance;         ///< E, one level
    std::optional<Sh9> sh9;     ///< E as a polynomial, instead of the map
    std::vector<BrdfMap> brdf;  ///< A and B, one map a kind
};

/// The environment as it stands in the scene.
struct EnvironmentSetup {
    const EnvironmentMaps* maps = nullptr;  ///< nullptr: there is none
    float cos_rotation = 1.0f;              ///< of the environment about +y
    float sin_rotation = 0.0f;              ///< of the same angle
    float intensity = 1.0f;                 ///< multiplies its radiance, >= 0
    int reference_samples = 0;              ///< 0: the split sum; else samples a point of the integral itself
};

/// Bake what is asked for. `radiance` has all its mip levels; it may be empty where only BRDF maps are asked for.
/// `samples`: of the roughest level (PrefilterSettings).
[[nodiscard]] EnvironmentMaps bake_environment(const CubeMap& radiance, const EnvironmentNeeds& needs, int samples,
                                               const Progress& progress = {});

/// How the levels of the prefiltered map are baked for these needs.
[[nodiscard]] PrefilterSettings prefilter_settings(const EnvironmentNeeds& needs, int samples);

/// Do maps that were baked for some needs hold what others ask for?
[[nodiscard]] bool covers(const EnvironmentNeeds& baked, const EnvironmentNeeds& needs);

/// The map of a kind, or nullptr.
[[nodiscard]] const BrdfMap* find_brdf(const EnvironmentMaps& maps, const BrdfKind& kind);

}  // namespace kreda::lighting
