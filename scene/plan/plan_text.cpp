// The plan as text.
#include <algorithm>
#include <cstdio>

#include "scene/plan/plan.hpp"
#include "scene/plan/plan_cost.hpp"

namespace kreda::scene {

namespace {

/// "1.25 billion"
std::string short_count(double count) {
    const bool billions = count >= 1e9, millions = count >= 1e6;
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", billions ? count * 1e-9 : millions ? count * 1e-6 : count);
    return std::string(text) + (billions ? " billion" : millions ? " million" : "");
}

std::string cost_line(const PassCost& cost) {
    if (cost.items.empty()) return "";
    const bool upper_bound = cost.items == "samples";
    char each[32];
    std::snprintf(each, sizeof each, "%.0f", cost.operations_each);
    return std::string("     cost: ") + (upper_bound ? "at most " : "") + std::to_string(cost.count) + " " +
           cost.items + " x " + each + " operations = " + short_count(cost.operations()) + "\n";
}

}  // namespace

std::string describe(const RenderPlan& plan, bool with_left_out) {
    std::string text;
    int number = 1;
    for (const PlannedPass& pass : plan.passes) {
        text += std::to_string(number++) + ". " + pass.name + ": " + pass.reason + "\n";
        for (const PlannedBuffer& buffer : pass.buffers) {
            text += "     " + buffer.name + ": " + std::to_string(buffer.bytes) + " bytes\n";
        }
        text += cost_line(pass.cost);
    }
    const bool all_estimated = std::all_of(plan.passes.begin(), plan.passes.end(), [](const PlannedPass& pass) {
        return !pass.cost.items.empty() || pass.name.starts_with("view ");
    });
    const double bake_operations = baking_operations(plan);
    if (bake_operations > 0.0) { text += "baking, once and kept: " + short_count(bake_operations) + " operations\n"; }
    text += std::string(bake_operations > 0.0 ? "a frame" : "together") + ": at most " +
            short_count(total_operations(plan)) + " operations" +
            (all_estimated ? "" : " and those of the passes without an estimate") + ", " +
            std::to_string(total_bytes(plan)) + " bytes of buffers\n";
    if (with_left_out) {
        for (const LeftOutPass& pass : plan.left_out) text += "-  " + pass.name + ": left out, " + pass.why_not + "\n";
    }
    for (const std::string& note : plan.notes) text += "note: " + note + "\n";
    return text;
}

}  // namespace kreda::scene
