// One stream of zlib, made in strips that threads take side by side.                      as pigz does, Mark Adler 2007
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kreda::scene {

/// The parts of a zlib stream (RFC 1950) of these bytes, to be put one behind the other. The strips have a fixed size,
/// so the stream does not depend on threads; each may refer to the end of the one before, so it is hardly longer than
/// that of one go. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::vector<unsigned char>> deflate_strips(std::span<const unsigned char> bytes);

}  // namespace kreda::scene
