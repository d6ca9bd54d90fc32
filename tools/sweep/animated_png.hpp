// An animated PNG from PNG files: every browser shows it, and programs that do not know it show the first frame.
#pragma once

#include <vector>

namespace kreda::tools {

/// The bytes of an animation that repeats for ever; every frame is a whole PNG file of the same size and form, as
/// scene::encode_png writes it, and is shown for `milliseconds` (1 .. 65535). APNG specification (W3C PNG 3rd edition,
/// 2025, 11.3.6).
[[nodiscard]] std::vector<unsigned char> animated_png(const std::vector<std::vector<unsigned char>>& frames,
                                                      int milliseconds);

}  // namespace kreda::tools
