// Depth across a triangle: against long double, for slivers, and against distance.
#include <doctest/doctest.h>

#include <cmath>

#include "raster/depth.hpp"
#include "raster/depth_formats.hpp"
#include "raster/overdraw.hpp"
#include "raster/rasterize_reference.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

/// Window depth at a sample centre from the exact edge functions: z = sum E_i z_i / sum E_i, in long double.
long double exact_depth(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, int x, int y) {
    const std::int64_t p_x = x * kSubpixels + kPixelCentre, p_y = y * kSubpixels + kPixelCentre;
    const long double e_a = edge_function(b.x, b.y, c.x, c.y, p_x, p_y);
    const long double e_b = edge_function(c.x, c.y, a.x, a.y, p_x, p_y);
    const long double e_c = edge_function(a.x, a.y, b.x, b.y, p_x, p_y);
    return (e_a * a.z + e_b * b.z + e_c * c.z) / (e_a + e_b + e_c);
}

ScreenVertex random_vertex(Random& random, int side, float z_low, float z_high) {
    const std::int32_t x = random.integer(0, side * kSubpixels), y = random.integer(0, side * kSubpixels);
    return {x, y, random.real(z_low, z_high), 1.0f};
}

}  // namespace

TEST_CASE("Depth plane by hand: z = x/8 + y/4 over a right triangle") {
    // Corners at (0, 0), (4, 0), (0, 2) samples with depths 0, 1/2, 1/2.
    const ScreenVertex a{0, 0, 0.0f, 1.0f}, b{4 * 256, 0, 0.5f, 1.0f}, c{0, 2 * 256, 0.5f, 1.0f};
    const DepthPlane plane = depth_plane(a, b, c, edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    CHECK(plane.dz_dx == 0.125f);
    CHECK(plane.dz_dy == 0.25f);
    CHECK(depth_at(plane, depth_of_row(plane, 0), 0) == 0.0625f + 0.125f);  // centre (1/2, 1/2)
    CHECK(depth_at(plane, depth_of_row(plane, 1), 0) == 0.0625f + 0.375f);
    CHECK(depth_at(plane, depth_of_row(plane, 0), 2) == 0.3125f + 0.125f);
}

TEST_CASE("Depth is within 1e-6 of long double over triangles of a full image") {
    Random random(1);
    double worst = 0.0;
    for (int i = 0; i < 3000; ++i) {
        ScreenVertex a = random_vertex(random, 1920, 0, 1), b = random_vertex(random, 1920, 0, 1);
        const ScreenVertex c = random_vertex(random, 1920, 0, 1);
        std::int64_t area2 = edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
        if (area2 < 0) std::swap(a, b);
        area2 = std::abs(area2);
        // Slopes up to 1/50 a sample: rounding them to 2^-25 over 1920 samples is what makes the error.
        const double size = 1920.0 * 256.0;
        if (static_cast<double>(area2) < size * size / 40) continue;
        const DepthPlane plane = depth_plane(a, b, c, area2);
        for (int k = 0; k < 100; ++k) {
            const int x = random.integer(0, 1919), y = random.integer(0, 1919);
            if (!covers_sample(a, b, c, x, y)) continue;
            const float z = depth_at(plane, depth_of_row(plane, y), x);
            worst = std::max(worst, static_cast<double>(std::abs(z - exact_depth(a, b, c, x, y))));
        }
    }
    MESSAGE("largest depth error: " << worst);
    CHECK(worst < 1e-6);  // the two products may be a few times larger than z itself: 2^-24 of each; 4.2e-7 measured
}

TEST_CASE("Depth never leaves the range of the corners: not even for slivers of 1/256 sample") {
    Random random(2);
    int tested = 0, outside = 0;
    for (int i = 0; i < 20000; ++i) {
        const float low = random.real(0.0f, 0.9f), high = low + std::exp2(random.real(-20.0f, -4.0f));
        ScreenVertex a = random_vertex(random, 300, low, high), b = random_vertex(random, 300, low, high);
        const int t = random.integer(0, 256);
        ScreenVertex c{a.x + (b.x - a.x) * t / 256 + random.integer(-2, 2),
                       a.y + (b.y - a.y) * t / 256 + random.integer(-2, 2), random.real(low, high), 1.0f};
        const std::int64_t area2 = edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
        if (area2 == 0) continue;
        if (area2 < 0) std::swap(a, b);
        const DepthPlane plane = depth_plane(a, b, c, std::abs(area2));
        CHECK(plane.z_min == std::min({a.z, b.z, c.z}));
        CHECK(plane.z_max == std::max({a.z, b.z, c.z}));
        for (int y = 0; y < 300; y += 7) {
            for (int x = 0; x < 300; x += 7) {
                const float z = depth_at(plane, depth_of_row(plane, y), x);
                ++tested;
                outside += z >= plane.z_min && z <= plane.z_max ? 0 : 1;
            }
        }
    }
    CHECK(tested > 1000000);
    CHECK(outside == 0);
}

TEST_CASE("Level triangle has its depth exactly everywhere") {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const float z = random.real(0, 1);
        ScreenVertex a = random_vertex(random, 500, z, z), b = random_vertex(random, 500, z, z);
        const ScreenVertex c = random_vertex(random, 500, z, z);
        a.z = b.z;  // real(z, z) is z, whatever the rounding
        const DepthPlane plane = depth_plane(a, b, c, 1000000);
        CHECK(depth_at(plane, depth_of_row(plane, random.integer(0, 500)), random.integer(0, 500)) == z);
    }
}

TEST_CASE(
    "Depth grows with distance: 0 at the near plane and 1 at the far plane and z = f (d - n) / (d (f - n)) between") {
    Camera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.near = 0.5f;
    camera.far = 50.0f;
    const glm::mat4 clip = clip_from_world(camera, 1.0f);
    float before = -1.0f;
    for (int i = 0; i <= 1000; ++i) {
        const float distance = camera.near * std::pow(100.0f, static_cast<float>(i) / 1000.0f);
        const float z = to_screen(clip * glm::vec4(0, 0, -distance, 1), {64, 64}).z;
        const double expected = 50.0 * (double{distance} - 0.5) / (double{distance} * 49.5);
        CHECK(std::abs(z - expected) < 4e-7);  // matrix, product, 1/w, divide and shift: some 2^-24 of 1 each
        CHECK(z > before);
        before = z;
    }
}

TEST_CASE("Walls one behind the other: drawn in any order the nearest is seen at every sample") {
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        Drawing drawing;
        drawing.viewport = {40, 30};
        Camera camera;
        camera.position = {0, 0, 0};
        camera.target = {0.3f, 0.2f, -1};
        drawing.clip_from_world = clip_from_world(camera, 40.0f / 30.0f);
        int nearest = 0;
        float nearest_distance = 1e9f;
        const int count = random.integer(2, 12);
        for (int k = 0; k < count; ++k) {
            const float d = random.real(0.5f, 20.0f);
            add_triangle(drawing.mesh, {-900, -900, -d}, {900, -900, -d}, {0, 900, -d});
            if (d < nearest_distance) nearest = k;
            nearest_distance = std::min(d, nearest_distance);
        }
        finish(drawing.mesh);
        const Drawn drawn = set_up(drawing);
        const VisibilityBuffer buffer = rasterize_reference(drawn.streams, drawn.set, drawing.viewport);
        int wrong = 0;
        for (const std::uint32_t id : buffer.triangle) {
            wrong += id == kNoTriangle || drawn.set.triangle(id).source != static_cast<std::uint32_t>(nearest) ? 1 : 0;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("Depth formats: what is nearer hides, what is as far does not, and reversed depths grow toward the viewer") {
    for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32}) {
        CHECK(is_nearer(format, 0.25, 0.5));
        CHECK_FALSE(is_nearer(format, 0.5, 0.5));
        CHECK_FALSE(is_nearer(format, 0.5, 0.25));
    }
    CHECK(is_nearer(DepthFormat::reversed_float32, 0.5, 0.25));
    CHECK_FALSE(is_nearer(DepthFormat::reversed_float32, 0.5, 0.5));
    CHECK_FALSE(is_nearer(DepthFormat::reversed_float32, 0.25, 0.5));
}
