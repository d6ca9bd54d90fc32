// Random scene files that say everything a scene may say, at the ends of what is allowed more often than not.
#pragma once

#include <cstdint>
#include <string>

namespace kreda::tests {

/// The text of a scene file; the same seed gives the same text on every machine. Sizes that cost time are kept small.
[[nodiscard]] std::string extreme_scene(std::uint32_t seed);

}  // namespace kreda::tests
