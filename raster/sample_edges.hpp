// Edge functions in whole samples: 32 bits are enough to ask many samples side by side whether a triangle covers them.
#pragma once

#include <cstdint>

namespace kreda::raster {

/// An edge function E, less least_inside(), at a sample centre, and its steps to the neighbours, all divided by 256 and
/// rounded down.
///
/// From one sample centre to the next E changes by a multiple of 256, so floor(E / 256) has the sign of E at every
/// centre and is all that the test needs. It is computed in three widths: in double where a tile's triangles may reach
/// far (tile_edge), in 32 bits where corners are near (near_edge), and solved for x in 64 bits where a whole row is
/// asked for at once (shadows/projected_triangles.cpp). One width for all would cost speed or digits.
struct SampleEdge {
    std::int32_t start = 0;   ///< at the first sample; >= 0 means inside
    std::int32_t step_x = 0;  ///< to the next sample of the row
    std::int32_t step_y = 0;  ///< to the next row
};

/// The three edges of a triangle.
struct SampleEdges {
    SampleEdge ab, bc, ca;  ///< from corner to corner
};

/// The edge function x samples to the right of the first and y below it.
inline std::int32_t edge_at(const SampleEdge& e, std::int32_t x, std::int32_t y) {
    return e.start + e.step_y * y + e.step_x * x;
}

/// Most triangles of a fine mesh lie within a block of 4 x 4 samples.
inline constexpr int kBlockSide = 4;

/// Bit i is set where the sample x + i of row y lies inside all three edges.
inline std::uint32_t covered_in_row(const SampleEdges& e, std::int32_t x, std::int32_t y) {
    const std::int32_t ab = edge_at(e.ab, x, y), bc = edge_at(e.bc, x, y), ca = edge_at(e.ca, x, y);
    const auto bit = [&](int i) {
        const std::int32_t inside = (ab + e.ab.step_x * i) | (bc + e.bc.step_x * i) | (ca + e.ca.step_x * i);
        return (~static_cast<std::uint32_t>(inside) >> 31) << i;
    };
    return bit(0) | bit(1) | bit(2) | bit(3);
}

/// The samples of the block from sample (x, y) on that lie inside all three edges: bit 4 row + column.
inline std::uint32_t covered_in_block(const SampleEdges& e, std::int32_t x, std::int32_t y) {
    return covered_in_row(e, x, y) | covered_in_row(e, x, y + 1) << 4 | covered_in_row(e, x, y + 2) << 8 |
           covered_in_row(e, x, y + 3) << 12;
}

}  // namespace kreda::raster
