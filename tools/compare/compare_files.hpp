// Two files become a comparison: what a file adds to its pixels is compared as well.
#pragma once

#include <string>

#include "scene/files/image_file.hpp"
#include "tools/compare/compare.hpp"

namespace kreda::tools {

struct ComparedFiles {
    scene::StoredImage actual, expected;
    Numbers numbers;  ///< of the expected picture
    Comparison result;
};

/// Any files that OpenImageIO reads. Beside the checks of compare(): the same kind of numbers (8 or 16 bits, floating
/// point), the same encoding of light, the same names of the channels. `mask` is a file, or empty. Throws UserError for
/// a file that cannot be read.
[[nodiscard]] ComparedFiles compare_files(const std::string& actual, const std::string& expected,
                                          const std::string& mask, const CompareLimits& limits);

/// "8 bits, sRGB", "floating point, linear"
[[nodiscard]] std::string numbers_text(const scene::StoredImage& image);

}  // namespace kreda::tools
