#include "scene/shadow_pass.hpp"

#include "scene/render.hpp"

namespace kreda::scene {

void prepare_shadows(const Frame& frame) {
    frame.buffers.shadows.resize(frame.plan.shadows.size());
    for (std::size_t i = 0; i < frame.plan.shadows.size(); ++i) {
        const PlannedShadow& planned = frame.plan.shadows[i];
        std::vector<raster::MeshInstance> casters;
        for (const int object : planned.casters) {
            casters.push_back(frame.buffers.instances[static_cast<std::size_t>(object)]);
        }
        ShadowMemory& memory = frame.buffers.shadows[i];
        draw_shadow_map(casters, planned.map, memory.drawing, memory.map);
    }
}

bool find_shadow(const Frame& frame, int light_that_is_on, const raster::Fragments& points,
                 lighting::LightingChannels& channels) {
    for (std::size_t i = 0; i < frame.plan.shadows.size(); ++i) {
        if (frame.plan.shadows[i].light_that_is_on != light_that_is_on) continue;
        const shadows::ShadowMap& map = frame.buffers.shadows[i].map;
        shadow_factors(map, points.position, points.face_normal, points.count, channels.shadow);
        if (frame.plan.shows_blockers) {
            shadow_blockers(map, points.position, points.face_normal, points.count, channels.blocker_distance,
                            channels.penumbra);
        }
        return true;
    }
    return false;
}

}  // namespace kreda::scene
