#include "scene/environment.hpp"

#include "lighting/environment_image.hpp"
#include "raster/trigonometry.hpp"

namespace kreda::scene {

namespace {

/// Texels a side of a cube made from a sky, and the largest made from an image.
constexpr int kSkySize = 256;
constexpr int kLargestSize = 1024;

}  // namespace

lighting::CubeMap environment_cube(const EnvironmentSettings& settings) {
    if (!settings.image) return lighting::cube_from_sky(settings.sky, kSkySize);
    return lighting::cube_from_equirect(*settings.image, lighting::cube_size_for(settings.image->width, kLargestSize));
}

PreparedEnvironment prepare_environment(const EnvironmentSettings& settings, const lighting::EnvironmentNeeds& needs,
                                        const lighting::Progress& progress) {
    PreparedEnvironment prepared;
    prepared.image = settings.image;
    prepared.sky = settings.sky;
    prepared.samples = settings.samples;
    prepared.needs = needs;
    prepared.maps = lighting::bake_environment(environment_cube(settings), needs, settings.samples, progress);
    return prepared;
}

bool serves(const PreparedEnvironment& prepared, const EnvironmentSettings& settings,
            const lighting::EnvironmentNeeds& needs) {
    const bool same_sky = settings.image || prepared.sky == settings.sky;
    return prepared.image == settings.image && same_sky && prepared.samples == settings.samples && prepared.needs == needs;
}

lighting::EnvironmentSetup environment_setup(const EnvironmentSettings& settings, const PreparedEnvironment& prepared) {
    const raster::SinCos rotation = raster::sin_cos_of_turns(settings.rotation_deg / 360.0f);
    return {&prepared.maps, rotation.cos, rotation.sin, settings.intensity, settings.reference};
}

}  // namespace kreda::scene
