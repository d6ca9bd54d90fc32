#include "shadows/exact.hpp"

#include "raster/visibility.hpp"

namespace kreda::shadows {

ExactShadow build_exact_shadow(std::span<const Occluder> occluders, const ShadowLight& light) {
    return {homogeneous(light), build_bvh(gather_triangles(occluders))};
}

void shadow_factors(const ExactShadow& exact, const raster::Channel3& position, int count, raster::Channel& shadow) {
    for (int i = 0; i < count; ++i) { shadow.set(i, any_shadow(exact.bvh, exact.light, position.at(i)) ? 0.0f : 1.0f); }
    for (int i = count; i < raster::lanes_for(count); ++i) shadow.set(i, 1.0f);
}

void shadow_blockers(const ExactShadow& exact, const raster::Channel3& position, int count,
                     raster::Channel& blocker_distance) {
    for (int i = 0; i < count; ++i) {
        const double distance = distance_to_last_blocker(exact.bvh, exact.light, position.at(i));
        blocker_distance.set(i, static_cast<float>(distance));
    }
}

void exact_shadow(const ExactShadow& exact, const VisibleSamples& samples, std::span<float> shadow) {
    const int width = samples.viewport.width, height = samples.viewport.height;
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            if (samples.depth[i] >= raster::kClearDepth) continue;
            shadow[i] = any_shadow(exact.bvh, exact.light, samples.position[i]) ? 0.0f : 1.0f;
        }
    }
}

}  // namespace kreda::shadows
