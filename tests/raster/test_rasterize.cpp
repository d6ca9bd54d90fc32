// Coverage by hand and by the published rule; the tiled rasterizer against the reference on random scenes.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "raster/overdraw.hpp"
#include "raster/rasterize_reference.hpp"
#include "raster/rasterize_tile.hpp"
#include "raster/tile_triangle.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

/// The samples that one triangle, given in samples, covers in an image, row by row.
std::vector<std::uint32_t> coverage(const Viewport& viewport, glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    Drawing drawing;
    drawing.viewport = viewport;
    drawing.clip_from_world = clip_from_pixels(viewport);
    add_triangle(drawing.mesh, glm::vec3(a, 0.5f), glm::vec3(b, 0.5f), glm::vec3(c, 0.5f));
    finish(drawing.mesh);
    const Drawn drawn = set_up(drawing);
    return count_overdraw(drawn.streams, drawn.set, viewport);
}

/// Which samples of row y are covered, as a picture: '#' covered, '.' not.
std::string row_of(const std::vector<std::uint32_t>& covered, const Viewport& viewport, int y) {
    std::string row;
    for (int x = 0; x < viewport.width; ++x)
        row += covered[static_cast<std::size_t>(y * viewport.width + x)] ? '#' : '.';
    return row;
}

/// The rule as Microsoft publishes it for Direct3D ("Rasterization Rules", top-left rule), word for word and without
/// edge directions: a centre on an edge is inside if the edge is exactly horizontal and above the others (top edge), or
/// not exactly horizontal and on the left side of the triangle (left edge). Coordinates are small integers.
struct Point {
    int x, y;
};

long cross(Point a, Point b, Point p) {
    return long{b.x - a.x} * (p.y - a.y) - long{b.y - a.y} * (p.x - a.x);
}

bool is_top_edge(Point a, Point b, Point third) {
    return a.y == b.y && third.y > a.y;
}

/// Left: at the third corner's height, the line through the edge passes left of that corner.
bool is_left_edge(Point a, Point b, Point third) {
    if (a.y == b.y) return false;
    // x on the line at third.y is a.x + (b.x - a.x)(third.y - a.y)/(b.y - a.y); times (b.y - a.y), whose sign may turn
    // the <.
    const long line = long{b.x - a.x} * (third.y - a.y);
    const long corner = long{third.x - a.x} * (b.y - a.y);
    return b.y > a.y ? line < corner : line > corner;
}

bool direct3d_covers(Point a, Point b, Point c, Point p) {
    const long area = cross(a, b, c);
    if (area == 0) return false;
    const Point corner[3] = {a, b, c};
    for (int i = 0; i < 3; ++i) {
        const Point from = corner[i], to = corner[(i + 1) % 3], third = corner[(i + 2) % 3];
        const long side = cross(from, to, p) * (area > 0 ? 1 : -1);
        if (side < 0) return false;
        if (side == 0 && !is_top_edge(from, to, third) && !is_left_edge(from, to, third)) return false;
    }
    return true;
}

/// Number of samples whose depth bits or triangle differ.
int differences(const VisibilityBuffer& a, const VisibilityBuffer& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        count += std::memcmp(&a.depth[i], &b.depth[i], sizeof(float)) != 0 || a.triangle[i] != b.triangle[i];
    }
    return count;
}

/// The same for tiles that hold depth alone.
int differences_of_depth(const VisibilityBuffer& expected, const Drawn& drawn, const Viewport& viewport) {
    int count = 0;
    for (int t = 0; t < drawn.set.grid.columns * drawn.set.grid.rows; ++t) {
        TileDepth tile;
        const TileArea area = tile_area(drawn.set.grid, viewport, t);
        rasterize_tile(drawn.streams, drawn.set, area, tile);
        for (int y = 0; y < area.height; ++y) {
            for (int x = 0; x < area.width; ++x) {
                const std::size_t at = static_cast<std::size_t>(area.y + y) * viewport.width + area.x + x;
                count += std::memcmp(&expected.depth[at], &tile.depth[y * kTileSide + x], sizeof(float)) != 0;
            }
        }
    }
    return count;
}

/// Samples in which the tiled rasterizer differs from the reference, with triangles or without.
int differences_from(const VisibilityBuffer& expected, const Drawn& drawn, const Viewport& viewport) {
    return differences(expected, rasterize_tiled(drawn.streams, drawn.set, viewport)) +
           differences_of_depth(expected, drawn, viewport);
}

int differences_from_reference(const Drawn& drawn, const Viewport& viewport) {
    return differences_from(rasterize_reference(drawn.streams, drawn.set, viewport), drawn, viewport);
}

void check_scenes(std::uint32_t first, std::uint32_t count) {
    const OneThread one_thread;
    int wrong_scenes = 0;
    std::uint64_t covered = 0, clipped = 0;
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        const Drawing drawing = random_scene(seed);
        const Drawn drawn = set_up(drawing);
        const VisibilityBuffer expected = rasterize_reference(drawn.streams, drawn.set, drawing.viewport);
        const int wrong = differences_from(expected, drawn, drawing.viewport);
        if (wrong != 0) {
            ++wrong_scenes;
            MESSAGE("scene " << seed << " differs in " << wrong << " samples");
        }
        for (const std::uint32_t id : expected.triangle) covered += id != kNoTriangle ? 1 : 0;
        clipped += drawn.counts.clipped;
    }
    CHECK(wrong_scenes == 0);
    CHECK(covered > 500ull * count);  // the scenes are not empty: half of them show more than this
    CHECK(clipped > count / 4);
}

}  // namespace

TEST_CASE("Triangle with its corners on pixel centres: top and left edge in and hypotenuse out") {
    const Viewport viewport{6, 6};
    const auto covered = coverage(viewport, {0.5f, 0.5f}, {4.5f, 0.5f}, {0.5f, 4.5f});
    const char* const rows[] = {"####..", "###...", "##....", "#.....", "......", "......"};
    for (int y = 0; y < 6; ++y) CHECK(row_of(covered, viewport, y) == rows[y]);
}

TEST_CASE("Triangle below a diagonal through pixel centres: the diagonal is its left edge and in") {
    const Viewport viewport{6, 6};
    const auto covered = coverage(viewport, {4.5f, 4.5f}, {4.5f, 0.5f}, {0.5f, 4.5f});
    const char* const rows[] = {"......", "...#..", "..##..", ".###..", "......", "......"};
    for (int y = 0; y < 6; ++y) CHECK(row_of(covered, viewport, y) == rows[y]);
}

TEST_CASE("Right and bottom edges through sample centres are not drawn") {
    const Viewport viewport{4, 4};
    for (const bool flip : {false, true}) {
        CAPTURE(flip);
        // The rectangle from centre (0.5, 0.5) to centre (2.5, 2.5), cut along either diagonal: 2 x 2 samples.
        const glm::vec2 a(0.5f, 0.5f), b(2.5f, 0.5f), c(2.5f, 2.5f), d(0.5f, 2.5f);
        const auto first = flip ? coverage(viewport, a, b, d) : coverage(viewport, a, b, c);
        const auto second = flip ? coverage(viewport, b, c, d) : coverage(viewport, a, c, d);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const auto i = static_cast<std::size_t>(4 * y + x);
                CHECK(first[i] + second[i] == (x < 2 && y < 2 ? 1 : 0));
            }
        }
    }
}

TEST_CASE("Triangle between sample centres covers nothing and around one centre covers it") {
    const Viewport viewport{3, 3};
    const auto nothing = coverage(viewport, {1.51f, 1.51f}, {2.4f, 1.6f}, {1.7f, 2.4f});
    CHECK(std::count(nothing.begin(), nothing.end(), 1u) == 0);
    const auto one = coverage(viewport, {1.4f, 1.4f}, {1.9f, 1.45f}, {1.45f, 1.9f});
    CHECK(std::count(one.begin(), one.end(), 1u) == 1);
    CHECK(one[4] == 1);
}

TEST_CASE("Every triangle with corners among 5 x 5 pixel centres is covered as Direct3D's published rule says") {
    const OneThread one_thread;
    const Viewport viewport{6, 6};
    int wrong = 0;
    for (int code = 0; code < 25 * 25 * 25; ++code) {
        const Point a{code % 5, code / 5 % 5}, b{code / 25 % 5, code / 125 % 5}, c{code / 625 % 5, code / 3125};
        const auto centre = [](Point p) { return glm::vec2(p.x, p.y) + 0.5f; };
        const auto covered = coverage(viewport, centre(a), centre(b), centre(c));
        for (int y = 0; y < 6; ++y) {
            for (int x = 0; x < 6; ++x) {
                const bool is_in = covered[static_cast<std::size_t>(6 * y + x)] == 1;
                wrong += is_in != direct3d_covers(a, b, c, {x, y}) ? 1 : 0;
            }
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("Culling: counter-clockwise seen by the camera is the front") {
    Drawing drawing;
    drawing.viewport = {8, 8};
    const auto drawn_with = [&](CullMode cull) {
        drawing.cull = cull;
        return set_up(drawing).counts;
    };
    add_triangle(drawing.mesh, {-0.5f, -0.5f, 0.0f}, {0.5f, -0.5f, 0.0f},
                 {0.0f, 0.5f, 0.0f});  // y up: counter-clockwise
    finish(drawing.mesh);
    CHECK(drawn_with(CullMode::none).drawn == 1);
    CHECK(drawn_with(CullMode::back).drawn == 1);
    CHECK(drawn_with(CullMode::front).drawn == 0);
    CHECK(drawn_with(CullMode::front).culled == 1);
    std::swap(drawing.mesh.indices[1], drawing.mesh.indices[2]);
    CHECK(drawn_with(CullMode::none).drawn == 1);
    CHECK(drawn_with(CullMode::back).culled == 1);
    CHECK(drawn_with(CullMode::front).drawn == 1);
}

TEST_CASE("Each input triangle is counted once: drawn culled outside degenerate or not finite") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Drawing drawing;
    drawing.viewport = {8, 8};
    drawing.cull = CullMode::back;
    Mesh& mesh = drawing.mesh;
    add_triangle(mesh, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, 0.5f, 0});  // drawn
    add_triangle(mesh, {-0.5f, -0.5f, 0}, {0, 0.5f, 0}, {0.5f, -0.5f, 0});  // culled
    add_triangle(mesh, {2, 2, 0}, {3, 2, 0}, {2, 3, 0});                    // outside, within the guard band
    add_triangle(mesh, {0, 0, 2}, {1, 0, 2}, {0, 1, 2});                    // outside, beyond the far plane
    add_triangle(mesh, {-0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {0, 0, 0});      // degenerate: on a line
    add_triangle(mesh, {nan, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_triangle(mesh, {0, 0, 0}, {inf, 0, 0}, {0, 1, 0});
    add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 0, -inf});
    finish(mesh);
    const TriangleCounts counts = set_up(drawing).counts;
    CHECK(counts.input == 8);
    CHECK(counts.drawn == 1);
    CHECK(counts.culled == 1);
    CHECK(counts.outside == 2);
    CHECK(counts.degenerate == 1);
    CHECK(counts.non_finite == 3);
    CHECK(counts.clipped == 0);
}

TEST_CASE("Equal depths: the triangle drawn first stays") {
    Drawing drawing;
    drawing.viewport = {70, 70};
    drawing.clip_from_world = clip_from_pixels(drawing.viewport);
    const glm::vec3 a(3, 2, 0.25f), b(60, 10, 0.25f), c(20, 66, 0.25f);
    add_triangle(drawing.mesh, a, b, c);
    add_triangle(drawing.mesh, b, c, a);
    add_triangle(drawing.mesh, a, c, b);
    finish(drawing.mesh);
    const Drawn drawn = set_up(drawing);
    CHECK(drawn.counts.drawn == 3);
    int first = 0;
    for (const VisibilityBuffer& buffer : {rasterize_reference(drawn.streams, drawn.set, drawing.viewport),
                                           rasterize_tiled(drawn.streams, drawn.set, drawing.viewport)}) {
        for (const std::uint32_t id : buffer.triangle) {
            CHECK((id == kNoTriangle || id == triangle_id(0, 0)));
            first += id == triangle_id(0, 0) ? 1 : 0;
        }
    }
    CHECK(first > 2 * 1000);
}

TEST_CASE("Nearer triangle wins whatever the order") {
    for (const bool near_first : {false, true}) {
        Drawing drawing;
        drawing.viewport = {20, 20};
        drawing.clip_from_world = clip_from_pixels(drawing.viewport);
        const float z[2] = {near_first ? 0.25f : 0.75f, near_first ? 0.75f : 0.25f};
        for (const float depth : z) add_triangle(drawing.mesh, {-40, -40, depth}, {80, -40, depth}, {-40, 80, depth});
        finish(drawing.mesh);
        const Drawn drawn = set_up(drawing);
        const VisibilityBuffer buffer = rasterize_tiled(drawn.streams, drawn.set, drawing.viewport);
        CHECK(buffer.depth[210] == 0.25f);
        CHECK(buffer.triangle[210] == triangle_id(0, near_first ? 0 : 1));
    }
}

TEST_CASE("Tiles: sides are the largest multiple of the samples up to 64 and cover the image") {
    const int side[9] = {0, 64, 64, 63, 64, 60, 60, 63, 64};
    for (int samples = 1; samples <= 8; ++samples) {
        const Viewport viewport{200 * samples, 75 * samples};
        const TileGrid grid = make_tile_grid(viewport, samples);
        CHECK(grid.tile_side == side[samples]);
        int covered = 0;
        for (int t = 0; t < grid.columns * grid.rows; ++t) {
            const TileArea area = tile_area(grid, viewport, t);
            CHECK((area.width > 0 && area.height > 0 && area.width <= kTileSide && area.height <= kTileSide));
            CHECK(area.x % samples == 0);
            CHECK(area.width % samples == 0);
            covered += area.width * area.height;
        }
        CHECK(covered == viewport.width * viewport.height);
    }
}

TEST_CASE("Tile of a sample: the multiplication gives what a division would for every sample and tile side") {
    for (int samples = 1; samples <= kTileSide; ++samples) {
        const TileGrid grid = make_tile_grid({kMaxImageSide, kMaxImageSide}, samples);
        int wrong = 0;
        for (int sample = 0; sample < kMaxImageSide; ++sample) wrong += grid.tile_of(sample) != sample / grid.tile_side;
        CHECK(wrong == 0);
    }
}

TEST_CASE("Rows inside an edge: those of a tile in which it is not negative, no others") {
    std::mt19937 random{11};
    int kept = 0, wrong = 0;
    for (int k = 0; k < 20000; ++k) {
        const auto step = static_cast<std::int32_t>(random() % 2001) - 1000;
        const auto most = static_cast<std::int32_t>(random() % 60001) - 30000;
        const RowRange rows = rows_inside(most, step, {0, kTileSide - 1});
        for (std::int32_t y = 0; y < kTileSide; ++y) {
            const bool is_in_range = rows.first <= y && y <= rows.last;
            wrong += is_in_range != (most + step * y >= 0);
            kept += is_in_range;
        }
    }
    CHECK(wrong == 0);
    CHECK(kept > 20000);
}

TEST_CASE("Tiled rasterizer gives the reference's visibility buffer to the last bit: 10800 random scenes") {
    check_scenes(0, 10800);
}

TEST_CASE("Tiled rasterizer gives the reference's bits on a mesh of many chunks") {
    // 20000 triangles: five chunks, in tiles of every kind.
    Drawing drawing;
    drawing.viewport = {150, 130};
    drawing.clip_from_world = clip_from_pixels(drawing.viewport);
    Random random(77);
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 a = random_pixel_point(random, drawing.viewport);
        const glm::vec3 b = random.in_box(12.0f), c = random.in_box(12.0f);
        add_triangle(drawing.mesh, a, a + glm::vec3(b.x, b.y, 0.01f * b.z), a + glm::vec3(c.x, c.y, 0.01f * c.z));
    }
    finish(drawing.mesh);
    const Drawn drawn = set_up(drawing);
    CHECK(drawn.set.chunks.size() == 5);
    CHECK(differences_from_reference(drawn, drawing.viewport) == 0);
}

TEST_CASE("Tiled rasterizer gives the reference's bits where large triangles hide each other: layers in any order") {
    // 80 pairs of triangles over the whole picture, level or slanted and crossing, some as deep as one before.
    for (const Viewport viewport : {Viewport{64, 64}, Viewport{150, 130}, Viewport{63, 40}}) {
        Drawing drawing;
        drawing.viewport = viewport;
        drawing.clip_from_world = clip_from_pixels(viewport);
        Random random(9);
        for (int i = 0; i < 80; ++i) {
            const float z = 0.01f * static_cast<float>(95 - i + 2 * random.integer(0, 4));  // ever nearer, mostly
            const float tilt = i % 3 == 0 ? random.real(-0.05f, 0.05f) : 0.0f;
            const glm::vec3 a(-10, -10, z), b(170, -10, z + tilt), c(170, 150, z - tilt), d(-10, 150, z);
            add_triangle(drawing.mesh, a, b, c);
            if (i % 4 > 0) add_triangle(drawing.mesh, a, c, d);
        }
        finish(drawing.mesh);
        const Drawn drawn = set_up(drawing);
        CHECK(differences_from_reference(drawn, viewport) == 0);
    }
}

TEST_CASE("A triangle that fills tiles is drawn up to the far plane, and none on it") {
    for (const float z : {0.5f, std::nextafter(1.0f, 0.0f), 1.0f}) {
        Drawing drawing;
        drawing.viewport = {150, 130};
        drawing.clip_from_world = clip_from_pixels(drawing.viewport);
        add_triangle(drawing.mesh, {-40, -40, z}, {400, -40, z}, {-40, 400, z});
        add_triangle(drawing.mesh, {10, 20, 0.25f}, {90, 30, 0.25f}, {40, 120, 0.25f});
        finish(drawing.mesh);
        const Drawn drawn = set_up(drawing);
        const VisibilityBuffer buffer = rasterize_tiled(drawn.streams, drawn.set, drawing.viewport);
        CHECK(differences_from_reference(drawn, drawing.viewport) == 0);
        CHECK(buffer.triangle[0] == (z < 1.0f ? triangle_id(0, 0) : kNoTriangle));
    }
}

TEST_CASE("Tiled rasterizer gives the reference's bits on the largest images: triangles over the whole guard band") {
    // 16384 samples a side make the longest edge steps; a strip of them is enough.
    for (const Viewport viewport : {Viewport{16384, 40}, Viewport{40, 16384}}) {
        Drawing drawing;
        drawing.viewport = viewport;
        drawing.clip_from_world = clip_from_pixels(viewport);
        Random random(5);
        for (int i = 0; i < 6; ++i) {
            const auto corner = [&] {
                const float x = random.real(-30000, 40000), y = random.real(-30000, 40000);
                return glm::vec3(x, y, random.real(0.1f, 0.9f));
            };
            const glm::vec3 a = corner(), b = corner(), c = corner();
            add_triangle(drawing.mesh, a, b, c);
        }
        finish(drawing.mesh);
        const Drawn drawn = set_up(drawing);
        CHECK(drawn.counts.drawn > 0);
        CHECK(differences_from_reference(drawn, viewport) == 0);
    }
}
