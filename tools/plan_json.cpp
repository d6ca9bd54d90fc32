#include "tools/plan_json.hpp"

#include <nlohmann/json.hpp>

#include "scene/plan/left_out.hpp"
#include "scene/plan/plan_cost.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;

const char* word_for(scene::PassScope scope) {
    switch (scope) {
        case scene::PassScope::once: return "once";
        case scene::PassScope::frame: return "frame";
        case scene::PassScope::tile: return "tile";
        case scene::PassScope::batch: return "batch";
        case scene::PassScope::points: return "points";
    }
    return "";
}

Json json_of(const scene::PlannedPass& pass) {
    Json json = {{"name", pass.name}, {"reason", pass.reason}, {"runs", word_for(pass.scope)}};
    json["buffers"] = Json::array();
    for (const scene::PlannedBuffer& buffer : pass.buffers) {
        json["buffers"].push_back({{"name", buffer.name}, {"bytes", buffer.bytes}});
    }
    if (!pass.cost.items.empty()) {
        json["cost"] = {{"items", pass.cost.items},
                        {"count", pass.cost.count},
                        {"operations_each", pass.cost.operations_each},
                        {"operations", pass.cost.operations()}};
    }
    if (!pass.bound.empty()) json["bound"] = pass.bound;
    return json;
}

/// The first step: what is seen, found from the meshes alone, and the materials whose maps are read for it.
Json json_of_seen(const scene::Scene& scene, const scene::RenderPlan& plan) {
    Json json = {{"samples", plan.seen->covered}};
    json["objects"] = Json::array();
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::SeenObject& object = plan.seen->objects[o];
        json["objects"].push_back({{"name", name_of_object(scene, o)},
                                   {"samples", object.samples},
                                   {"triangles", object.triangles.input},
                                   {"drawn", object.triangles.drawn}});
        if (object.samples == 0)
            json["objects"].back()["why_unseen"] = scene::why_unseen(scene.objects[o], object.triangles);
    }
    json["materials"] = Json::array();
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        json["materials"].push_back({{"name", scene.materials[m].name},
                                     {"samples", plan.seen->of_material[m]},
                                     {"maps_read", plan.lighting.maps[m] == true}});
    }
    return json;
}

}  // namespace

std::string plan_json(const scene::Scene& scene, const scene::RenderPlan& plan) {
    Json json;
    if (plan.seen) json["seen"] = json_of_seen(scene, plan);
    json["passes"] = Json::array();
    for (const scene::PlannedPass& pass : plan.passes) json["passes"].push_back(json_of(pass));
    json["left_out"] = Json::array();
    for (const scene::LeftOutPass& pass : plan.left_out) {
        json["left_out"].push_back({{"name", pass.name}, {"why", pass.why_not}});
    }
    json["operations"] = total_operations(plan);
    json["baking_operations"] = baking_operations(plan);
    json["bytes"] = total_bytes(plan);
    json["notes"] = plan.notes;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kreda::tools
