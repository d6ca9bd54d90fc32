// Meshes of very many parts: those that are drawn alike become one.
#pragma once

#include "scene/scene.hpp"

namespace kreda::scene {

/// Every object's parts of one material become one part, named after the first, and hidden ones are kept apart. The
/// triangles of a part keep their order; objects that share a mesh and treat it alike go on sharing it.
void join_parts(Scene& scene);

}  // namespace kreda::scene
