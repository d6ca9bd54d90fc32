#include "scene/environment.hpp"

#include <numeric>

#include "raster/trigonometry.hpp"

namespace kreda::scene {

namespace {

/// Texels a side of a cube made from a sky, and the largest made from an image.
constexpr int kSkySize = 256;
constexpr int kLargestSize = 1024;

}  // namespace

int environment_size(const EnvironmentSettings& settings) {
    return settings.image ? lighting::cube_size_for(settings.image->width, kLargestSize) : kSkySize;
}

lighting::BakeCost environment_cost(const EnvironmentSettings& settings) {
    const int size = environment_size(settings);
    if (!settings.image) return lighting::cube_cost(size, lighting::kSkyDirections);
    const int width = settings.image->width, height = settings.image->height;
    lighting::BakeCost cost = lighting::cube_cost(size, lighting::directions_for(width, height, size));
    cost.bytes_while_baking = lighting::bytes_of_equirect_map(width, height);
    return cost;
}

lighting::CubeMap environment_cube(const EnvironmentSettings& settings, const lighting::Placement& placement,
                                   const lighting::Progress& progress) {
    const int size = environment_size(settings);
    if (!settings.image) return lighting::cube_from_sky(settings.sky, size, placement, progress);
    return lighting::cube_from_equirect(*settings.image, size, placement, progress);
}

lighting::Placement placement_of(const EnvironmentSettings& settings) {
    const raster::SinCos rotation = raster::sin_cos_of_turns(settings.rotation_deg / 360.0f);
    return {rotation.cos, rotation.sin, settings.intensity};
}

void add_light_table(const EnvironmentSettings& settings, lighting::EnvironmentMaps& maps) {
    if (settings.reference > 0 && !maps.prefiltered.empty()) maps.light = lighting::make_light_table(maps.prefiltered);
}

PreparedEnvironment prepare_environment(const EnvironmentSettings& settings, const lighting::EnvironmentNeeds& needs,
                                        const lighting::Progress& progress) {
    const std::vector<double> bake = lighting::bake_work(environment_size(settings), needs, settings.samples);
    const double bake_work = std::accumulate(bake.begin(), bake.end(), 0.0);
    const std::vector<lighting::Progress> steps =
        lighting::progress_of_steps(progress, {needs.any() ? environment_cost(settings).operations() : 0.0, bake_work});
    PreparedEnvironment prepared;
    prepared.image = settings.image;
    prepared.sky = settings.sky;
    prepared.samples = settings.samples;
    prepared.needs = needs;
    const lighting::CubeMap radiance = needs.any() ? environment_cube(settings, {}, steps[0]) : lighting::CubeMap{};
    prepared.maps = lighting::bake_environment(radiance, needs, settings.samples, steps[1]);
    add_light_table(settings, prepared.maps);
    return prepared;
}

bool serves(const PreparedEnvironment& prepared, const EnvironmentSettings& settings,
            const lighting::EnvironmentNeeds& needs) {
    const bool lacks_table =
        settings.reference > 0 && !prepared.maps.prefiltered.empty() && prepared.maps.light.size == 0;
    const bool same_sky = settings.image || prepared.sky == settings.sky;
    return prepared.image == settings.image && same_sky && prepared.samples == settings.samples &&
           covers(prepared.needs, needs) && !lacks_table;
}

lighting::EnvironmentSetup environment_setup(const EnvironmentSettings& settings, const PreparedEnvironment& prepared) {
    const lighting::Placement placement = placement_of(settings);
    return {&prepared.maps, placement.cos_rotation, placement.sin_rotation, placement.intensity, settings.reference};
}

}  // namespace kreda::scene
