// Random scenes for the tests of the plan: everything that a plan decides about, seen and unseen, on and off.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace kreda::tests {

/// Scene number `seed`: the same on every machine.
[[nodiscard]] scene::Scene random_plan_scene(std::uint32_t seed);

}  // namespace kreda::tests
