// What a reader of numbers must know where places are counted from another point than 0.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace kreda::scene {

[[nodiscard]] bool is_far_from_zero(const Scene& scene);

/// "World places are counted from [500000, 100, 4600000]: ..."
[[nodiscard]] std::string origin_sentence(const Scene& scene);

/// The same for the object space of a mesh; empty where the numbers are the file's.
[[nodiscard]] std::string mesh_origin_sentence(const raster::Mesh& mesh);

}  // namespace kreda::scene
