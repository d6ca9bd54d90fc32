// The scene's environment: where its light comes from, and the maps that a plan needs of it.
#pragma once

#include <memory>
#include <string>

#include "lighting/environment/bake_cost.hpp"
#include "lighting/environment/environment.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/sky.hpp"
#include "raster/image.hpp"

namespace kreda::scene {

struct PreparedEnvironment;

/// The [environment] table of a scene.
struct EnvironmentSettings {
    bool on = false;                             ///< there is one
    std::string file;                            ///< as the scene names it; empty: a sky
    std::shared_ptr<const raster::Image> image;  ///< equirectangular, repaired; nullptr: a sky
    lighting::Sky sky = lighting::Sky::studio;
    float rotation_deg = 0.0f;  ///< about +y, counter-clockwise seen from above
    float intensity = 1.0f;
    lighting::IrradianceForm irradiance = lighting::IrradianceForm::map;
    int samples = 2048;  ///< of the roughest level of the prefiltered map
    int reference = 0;   ///< 0: the split sum; else samples a point of the integral itself
    std::shared_ptr<const PreparedEnvironment> prepared;  ///< baked already; nullptr: the first frame bakes
};

/// Maps and what they were made for.
struct PreparedEnvironment {
    std::shared_ptr<const raster::Image> image;
    lighting::Sky sky = lighting::Sky::studio;
    int samples = 0;
    lighting::EnvironmentNeeds needs;
    lighting::EnvironmentMaps maps;
};

/// Texels a side of an environment's cube map: a quarter of the image's width, 128 to 1024; 256 for a sky.
[[nodiscard]] int environment_size(const EnvironmentSettings& settings);

/// What it costs to make that cube map.
[[nodiscard]] lighting::BakeCost environment_cost(const EnvironmentSettings& settings);

/// The environment as a cube map with all its mip levels: what everything else is baked from. For rendering neither
/// turned nor brightened: the settings' rotation and intensity are applied where the maps are read.
[[nodiscard]] lighting::CubeMap environment_cube(const EnvironmentSettings& settings,
                                                 const lighting::Placement& placement = {},
                                                 const lighting::Progress& progress = {});

/// Rotation and intensity.
[[nodiscard]] lighting::Placement placement_of(const EnvironmentSettings& settings);

/// Bake what is needed. All maps of a 2048 x 1024 image take about 1.2 s on two cores; `progress` is told how far it
/// is.
[[nodiscard]] PreparedEnvironment prepare_environment(const EnvironmentSettings& settings,
                                                      const lighting::EnvironmentNeeds& needs,
                                                      const lighting::Progress& progress = {});

/// Where its light comes from, once level 0 is there, if environment.reference asks for it.
void add_light_table(const EnvironmentSettings& settings, lighting::EnvironmentMaps& maps);

/// Were these maps made for this environment, and do they hold what is needed?
[[nodiscard]] bool serves(const PreparedEnvironment& prepared, const EnvironmentSettings& settings,
                          const lighting::EnvironmentNeeds& needs);

/// For the lighting passes; `prepared` outlives it.
[[nodiscard]] lighting::EnvironmentSetup environment_setup(const EnvironmentSettings& settings,
                                                           const PreparedEnvironment& prepared);

}  // namespace kreda::scene
