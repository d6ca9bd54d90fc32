#include "scene/shade.hpp"

namespace kreda::scene {

void shade_points(const Frame& frame, const raster::Fragments& points, std::uint32_t material,
                  lighting::LightingChannels& channels) {
    const lighting::MaterialSetup& surface = frame.plan.materials[material];
    start_lighting(points, surface, frame.lighting, channels);
    if (surface.material.model != lighting::ReflectionModel::unlit) {
        for (const lighting::LightSetup& light : frame.lighting.lights) {
            sample_light(points, light, channels);
            add_reflection(points.count, surface, channels);
        }
    }
    sum_terms(points.count, channels);
}

}  // namespace kreda::scene
