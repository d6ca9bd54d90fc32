// The text at the start of a Radiance picture (.hdr): what its numbers were multiplied by, and which way up it lies.
// OpenImageIO 2.4 tells only the last EXPOSURE, no COLORCORR, and takes "+X +Y" for "-X -Y" and the other way round.
//
// Source: G. Ward, "Radiance File Formats" (filefmts.pdf), section "Picture File Format".
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace kreda::scene {

struct RadianceHeader {
    int orientation = 0;                          ///< as EXIF counts, 1 to 8; 0: the header has no line of sizes
    std::array<float, 3> multiplier = {1, 1, 1};  ///< all lines EXPOSURE and COLORCORR; to be divided by
    bool is_xyz = false;                          ///< FORMAT=32-bit_rle_xyze
    std::vector<std::string> remarks;             ///< for people: "says EXPOSURE=2; its values are divided by it"
};

/// `text` begins with the file's first byte. Lines that are indented tell of the pictures that it was made from, and
/// are left out, as the format demands.
[[nodiscard]] RadianceHeader read_radiance_header(std::string_view text);

}  // namespace kreda::scene
