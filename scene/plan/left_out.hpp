// What a plan leaves out, and why.
#pragma once

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Fill plan.left_out, once everything else is decided.
void list_left_out(const Scene& scene, const std::vector<std::string>& no_shadows, RenderPlan& plan);

/// Why none of an object's triangles is seen, in a few words.
[[nodiscard]] std::string why_unseen(const Object& object, const raster::TriangleCounts& triangles);

/// "object 2 (teapot)"
[[nodiscard]] std::string name_of_object(const Scene& scene, std::size_t object);

}  // namespace kreda::scene
