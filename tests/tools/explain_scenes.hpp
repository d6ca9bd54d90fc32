// Small scenes that together go through every path of a render: what `kreda explain` and `kreda stages` are tried on.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::tests {

struct NamedScene {
    std::string name;
    scene::Scene scene;
};

/// Every reflection model, shading frequency, fog, environment, clipping, culling, several samples, both projections;
/// 24 x 16 pixels. Read once, with what is baked for them.
[[nodiscard]] const std::vector<NamedScene>& scenes_to_explain();

}  // namespace kreda::tests
