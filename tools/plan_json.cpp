#include "tools/plan_json.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace

std::string plan_json(const scene::RenderPlan& plan) {
    Json json;
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
