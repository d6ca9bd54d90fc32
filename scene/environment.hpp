// The scene's environment: where its light comes from, and the maps that a plan needs of it.
#pragma once

#include <memory>
#include <string>

#include "lighting/environment.hpp"
#include "lighting/environment_passes.hpp"
#include "lighting/sky.hpp"
#include "raster/image.hpp"

namespace kreda::scene {

/// The [environment] table of a scene.
struct EnvironmentSettings {
    bool on = false;                                 ///< there is one
    std::string file;                                ///< as the scene names it; empty: a sky
    std::shared_ptr<const raster::Image> image;      ///< equirectangular, repaired; nullptr: a sky
    lighting::Sky sky = lighting::Sky::studio;
    float rotation_deg = 0.0f;                       ///< about +y, counter-clockwise seen from above
    float intensity = 1.0f;
    lighting::IrradianceForm irradiance = lighting::IrradianceForm::map;
    int samples = 2048;                              ///< of the roughest level of the prefiltered map
    int reference = 0;                               ///< 0: the split sum; else samples a point of the integral itself
};

/// Maps and what they were made for.
struct PreparedEnvironment {
    std::shared_ptr<const raster::Image> image;
    lighting::Sky sky = lighting::Sky::studio;
    int samples = 0;
    lighting::EnvironmentNeeds needs;
    lighting::EnvironmentMaps maps;
};

/// The environment as a cube map with all its mip levels: what everything else is baked from.
[[nodiscard]] lighting::CubeMap environment_cube(const EnvironmentSettings& settings);

/// Bake what is needed. Takes a second or so for a large image; `progress` is told how far it is.
[[nodiscard]] PreparedEnvironment prepare_environment(const EnvironmentSettings& settings,
                                                      const lighting::EnvironmentNeeds& needs,
                                                      const lighting::Progress& progress = {});

/// Were these maps made for this environment and these needs?
[[nodiscard]] bool serves(const PreparedEnvironment& prepared, const EnvironmentSettings& settings,
                          const lighting::EnvironmentNeeds& needs);

/// For the lighting passes; `prepared` outlives it.
[[nodiscard]] lighting::EnvironmentSetup environment_setup(const EnvironmentSettings& settings,
                                                           const PreparedEnvironment& prepared);

}  // namespace kreda::scene
