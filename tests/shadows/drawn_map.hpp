// A shadow map of one mesh in world space.
#pragma once

#include <vector>

#include "raster/mesh.hpp"
#include "shadows/shadow_map.hpp"

namespace kreda::tests {

inline shadows::ShadowMap draw_map(const raster::Mesh& mesh, const shadows::LightView& view,
                                   const shadows::ShadowSettings& settings) {
    raster::MeshInstance instance;
    instance.mesh = &mesh;
    instance.part_material = {0};
    std::vector<raster::MeshInstance> casters{instance};
    shadows::ShadowMapBuffers buffers;
    shadows::ShadowMap map;
    draw_shadow_map(casters, {settings, {view}}, buffers, map);
    return map;
}

}  // namespace kreda::tests
