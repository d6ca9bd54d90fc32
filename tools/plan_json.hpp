// A plan as JSON: for grading, measuring and pages.
#pragma once

#include <string>

#include "scene/plan/plan.hpp"

namespace kreda::tools {

/// {"seen": {"samples", "objects": [{"name", "samples", "triangles", "drawn", "why_unseen"}], "materials": [{"name",
/// "samples", "maps_read"}]}, "passes": [{"name", "reason", "runs", "buffers": [{"name", "bytes"}], "cost": {"items",
/// "count", "operations_each", "operations"}}], "left_out": [{"name", "why"}], "operations", "baking_operations",
/// "bytes", "notes"}. `runs` is how often: once, frame, tile, batch or points; a pass without an estimate has no cost;
/// "bound" says why a pass may change nothing.
[[nodiscard]] std::string plan_json(const scene::Scene& scene, const scene::RenderPlan& plan);

}  // namespace kreda::tools
