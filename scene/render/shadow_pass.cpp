#include "scene/render/shadow_pass.hpp"

#include "scene/plan/pass_functions.hpp"
#include "scene/render/frame_shadows.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

namespace {

void look_up(const RenderPlan& plan, const shadows::ShadowMap& map, const raster::Fragments& points,
             lighting::LightingChannels& channels) {
    shadow_factors(map, points.position, points.face_normal, points.count, channels.shadow);
    if (!plan.shows_blockers) return;
    shadow_blockers(map, points.position, points.face_normal, points.count, channels.blocker_distance,
                    channels.penumbra);
}

}  // namespace

void build_shadow(const PassWork& work) {
    const Frame& frame = work.frame;
    const PlannedShadow& planned = frame.plan.shadows[static_cast<std::size_t>(work.pass.index)];
    ShadowMemory& memory = frame.buffers.shadows[static_cast<std::size_t>(work.pass.index)];
    const bool is_kept = frame.buffers.keeps_results && !work.pass.inputs.empty() && memory.inputs == work.pass.inputs;
    if (is_kept) return;
    memory.inputs = work.pass.inputs;
    memory.meshes.clear();
    for (const int object : planned.casters) {
        memory.meshes.push_back(frame.scene.objects[static_cast<std::size_t>(object)].mesh);
    }
    if (planned.map.settings.method == shadows::ShadowMethod::exact) {
        memory.exact = build_exact_shadow(collect_occluders(frame, planned.casters).list, planned.source);
        memory.is_exact_ready = true;
        return;
    }
    std::vector<raster::MeshInstance> casters;
    for (const int object : planned.casters) {
        casters.push_back(frame.buffers.instances[static_cast<std::size_t>(object)]);
    }
    draw_shadow_map(casters, planned.map, frame.buffers.seen_by_light, memory.map);
}

namespace {

/// Did the pass run that finds this shadow?
bool is_prepared(const ShadowMemory& memory, shadows::ShadowMethod method) {
    switch (method) {
        case shadows::ShadowMethod::map: return !memory.map.distance.empty();
        case shadows::ShadowMethod::exact: return memory.is_exact_ready;
        default: return !memory.factor.empty();
    }
}

}  // namespace

bool set_shadow(const Frame& frame, int light_that_is_on, const raster::Fragments& points,
                lighting::LightingChannels& channels) {
    for (std::size_t i = 0; i < frame.plan.shadows.size(); ++i) {
        if (frame.plan.shadows[i].light_that_is_on != light_that_is_on) continue;
        const ShadowMemory& memory = frame.buffers.shadows[i];
        if (!is_prepared(memory, frame.plan.shadows[i].map.settings.method)) return false;
        switch (frame.plan.shadows[i].map.settings.method) {
            case shadows::ShadowMethod::map: look_up(frame.plan, memory.map, points, channels); break;
            case shadows::ShadowMethod::exact:
                shadow_factors(memory.exact, points.position, points.count, channels.shadow);
                if (!frame.plan.shows_blockers) break;
                shadow_blockers(memory.exact, points.position, points.count, channels.blocker_distance);
                for (int k = 0; k < points.count; ++k) channels.penumbra.set(k, 0.0f);  // its edges are hard
                break;
            default:  // found before, for all samples
                for (int k = 0; k < points.count; ++k) channels.shadow.set(k, memory.factor[points.sample[k]]);
        }
        return true;
    }
    return false;
}

}  // namespace kreda::scene
