// ICC colour profiles that images carry: what they call themselves, and whether they say sRGB.
#pragma once

#include <string>
#include <string_view>

namespace kreda::scene {

/// The name of a profile that differs from sRGB in its primaries or its curve, "" for sRGB itself and for bytes that
/// are no profile. Curves are compared where sRGB's 0.5 means 0.214 of the light: a power of 2.2 (0.218) passes, 1.8
/// (0.287) and linear (0.5) do not. ICC.1:2022, sections 7.2 (header), 7.3 (tags), 10.5 (curv), 10.15 (mluc), 10.18
/// (para).
[[nodiscard]] std::string profile_other_than_srgb(std::string_view profile);

}  // namespace kreda::scene
