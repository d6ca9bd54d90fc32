// What each pass of a plan leaves in memory, counted as it is given back.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/render/render.hpp"

namespace kreda::tests {

/// Bytes that each pass of the plan left in these buffers, by its number in plan.passes: what belongs to it is given
/// back, and counted_memory.hpp tells how much that was. What is left in the buffers belongs to none.
[[nodiscard]] std::vector<std::int64_t> give_back_by_pass(const scene::RenderPlan& plan, scene::RenderBuffers& buffers);

}  // namespace kreda::tests
