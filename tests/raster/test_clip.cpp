// Homogeneous clipping: planes, weights, shared edges, and the area left, against an independent clipper.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "raster/clip.hpp"
#include "raster/screen.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

constexpr float kGuardX = 3.0f, kGuardY = 2.0f;

/// The six planes as the header states them: positive inside. Exact enough in long double to judge a float.
std::array<long double, 6> distances(const glm::vec4& p, long double guard_x, long double guard_y) {
    const long double x = p.x, y = p.y, z = p.z, w = p.w;
    return {z + w, w - z, guard_x * w + x, guard_x * w - x, guard_y * w + y, guard_y * w - y};
}

/// Area in normalized device coordinates (signed) of a polygon given as (x/w, y/w).
long double area_of(const std::vector<std::array<long double, 2>>& p) {
    long double twice = 0.0L;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto& a = p[i];
        const auto& b = p[(i + 1) % p.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5L * twice;
}

long double area_of(const ClipPolygon& polygon) {
    std::vector<std::array<long double, 2>> ndc;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::vec4& p = polygon.vertex[static_cast<std::size_t>(i)].position;
        ndc.push_back({static_cast<long double>(p.x) / p.w, static_cast<long double>(p.y) / p.w});
    }
    return area_of(ndc);
}

/// The independent clipper: long double, planes in the opposite order, the symmetric formula for the cut.
long double reference_area(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, float guard_x, float guard_y) {
    using Corner = std::array<long double, 4>;
    std::vector<Corner> polygon;
    for (const glm::vec4& p : {a, b, c}) polygon.push_back({p.x, p.y, p.z, p.w});
    for (int plane = 5; plane >= 0; --plane) {
        const auto distance = [&](const Corner& p) {
            const long double guard = plane < 2 ? 1.0L : plane < 4 ? static_cast<long double>(guard_x) : guard_y;
            const std::size_t axis = plane < 2 ? 2 : plane < 4 ? 0 : 1;
            return guard * p[3] + (plane % 2 == 0 ? p[axis] : -p[axis]);
        };
        std::vector<Corner> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Corner& p = polygon[i];
            const Corner& q = polygon[(i + 1) % polygon.size()];
            const long double d_p = distance(p), d_q = distance(q);
            if (d_p >= 0) kept.push_back(p);
            if ((d_p >= 0) == (d_q >= 0)) continue;
            Corner cut;
            for (std::size_t k = 0; k < 4; ++k) cut[k] = (p[k] * d_q - q[k] * d_p) / (d_q - d_p);
            kept.push_back(cut);
        }
        polygon = kept;
    }
    std::vector<std::array<long double, 2>> ndc;
    for (const Corner& p : polygon) ndc.push_back({p[0] / p[3], p[1] / p[3]});
    return area_of(ndc);
}

/// A point inside all planes, or outside `plane` alone by a good deal.
glm::vec4 point(Random& random, int outside_plane) {
    const float w = random.real(0.5f, 4.0f);
    glm::vec4 p{random.real(-0.9f, 0.9f) * kGuardX * w, random.real(-0.9f, 0.9f) * kGuardY * w,
                random.real(-0.9f, 0.9f) * w, w};
    const float beyond = random.real(1.1f, 5.0f) * w;
    switch (outside_plane) {
        case 0: p.z = -beyond; break;
        case 1: p.z = beyond; break;
        case 2: p.x = -kGuardX * beyond; break;
        case 3: p.x = kGuardX * beyond; break;
        case 4: p.y = -kGuardY * beyond; break;
        case 5: p.y = kGuardY * beyond; break;
        default: break;
    }
    return p;
}

bool same_bits(const glm::vec4& a, const glm::vec4& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_CASE("Clipping at one plane: 0 1 2 or 3 corners outside leave 3 4 3 or 0 corners") {
    Random random(1);
    for (int plane = 0; plane < 6; ++plane) {
        for (int outside = 0; outside < 8; ++outside) {
            CAPTURE(plane);
            CAPTURE(outside);
            glm::vec4 p[3];
            int out = 0;
            for (int i = 0; i < 3; ++i) {
                const bool is_out = (outside >> i & 1) != 0;
                p[i] = point(random, is_out ? plane : -1);
                out += is_out ? 1 : 0;
            }
            const int expected[] = {3, 4, 3, 0};
            CHECK(clip_triangle(p[0], p[1], p[2], kGuardX, kGuardY).count == expected[out]);
        }
    }
}

TEST_CASE("Triangle inside all planes comes back as it is") {
    Random random(2);
    const glm::vec4 a = point(random, -1), b = point(random, -1), c = point(random, -1);
    const ClipPolygon polygon = clip_triangle(a, b, c, kGuardX, kGuardY);
    REQUIRE(polygon.count == 3);
    CHECK(same_bits(polygon.vertex[0].position, a));
    CHECK(same_bits(polygon.vertex[1].position, b));
    CHECK(same_bits(polygon.vertex[2].position, c));
    CHECK(polygon.vertex[1].weights == glm::vec3(0, 1, 0));
}

TEST_CASE("Near plane cut by hand: halfway and a third of the way") {
    // a is inside (z + w = 1), b and c are outside (z + w = -1 and -2): the cuts lie at 1/2 of ab and 1/3 of ac.
    const glm::vec4 a(0, 0, 0, 1), b(1, 0, -2, 1), c(0, 3, -3, 1);
    const ClipPolygon polygon = clip_triangle(a, b, c, 100.0f, 100.0f);
    REQUIRE(polygon.count == 3);
    CHECK(polygon.vertex[0].position == a);
    CHECK(polygon.vertex[1].position == glm::vec4(0.5f, 0, -1, 1));
    CHECK(polygon.vertex[1].weights == glm::vec3(0.5f, 0.5f, 0));
    CHECK(polygon.vertex[2].position.y == doctest::Approx(1.0).epsilon(1e-6));  // 3 * float(1/3), rounded
    CHECK(polygon.vertex[2].weights.z == doctest::Approx(1.0 / 3.0).epsilon(1e-6));
}

TEST_CASE("Clipped corners lie inside all planes and their weights sum to 1 and give their positions") {
    Random random(3);
    int polygons = 0, most_corners = 0;
    for (int i = 0; i < 20000; ++i) {
        glm::vec4 p[3];
        for (glm::vec4& corner : p) {
            const float size = std::pow(10.0f, random.real(-1.0f, 3.0f));
            const glm::vec3 xyz = random.in_box(size);
            corner = {xyz, random.real(-0.3f, 1.0f) * size};
        }
        const ClipPolygon polygon = clip_triangle(p[0], p[1], p[2], kGuardX, kGuardY);
        polygons += polygon.count > 0 ? 1 : 0;
        most_corners = std::max(most_corners, polygon.count);
        const float reach = std::max({glm::length(p[0]), glm::length(p[1]), glm::length(p[2])});
        for (int k = 0; k < polygon.count; ++k) {
            const ClipVertex& v = polygon.vertex[static_cast<std::size_t>(k)];
            REQUIRE(inside_guard_band(v.position, kGuardX, kGuardY));
            // guard * w is rounded to float in there, not here: 2^-24 of 3 w.
            for (const long double d : distances(v.position, kGuardX, kGuardY)) REQUIRE(d >= -2e-7L * v.position.w);
            // Three weights, each rounded to 2^-25 at most.
            REQUIRE(std::abs(v.weights.x + v.weights.y + v.weights.z - 1.0f) <= 2e-7f);
            const glm::vec4 rebuilt = v.weights.x * p[0] + v.weights.y * p[1] + v.weights.z * p[2];
            // Rounding of the three weights, the products and the sums, each 2^-24 of the largest corner.
            REQUIRE(glm::length(rebuilt - v.position) <= 4e-7f * reach);
        }
    }
    CHECK(polygons > 5000);
    CHECK(most_corners >= 7);
}

TEST_CASE("Triangles sharing an edge get bit-identical new corners on it") {
    Random random(4);
    int shared = 0, unequal = 0;
    for (int i = 0; i < 40000; ++i) {
        glm::vec4 p[4];
        for (glm::vec4& corner : p) {
            // Every other time corners of very different size: then even a double's rounding shows in the float.
            const float size = i % 2 == 0 ? 1.0f : std::pow(10.0f, random.real(-2.0f, 12.0f));
            const glm::vec3 xyz = random.in_box(4.0f * size);
            corner = {xyz, random.real(-0.5f, 1.5f) * size};
        }
        // The edge p0 p1 runs forth in one triangle and back in the other.
        const ClipPolygon first = clip_triangle(p[0], p[1], p[2], kGuardX, kGuardY);
        const ClipPolygon second = clip_triangle(p[1], p[0], p[3], kGuardX, kGuardY);
        const auto on_edge = [](const ClipPolygon& polygon) {
            std::vector<glm::vec4> found;
            for (int k = 0; k < polygon.count; ++k) {
                const ClipVertex& v = polygon.vertex[static_cast<std::size_t>(k)];
                if (v.weights.z == 0.0f) found.push_back(v.position);
            }
            return found;
        };
        const std::vector<glm::vec4> a = on_edge(first), b = on_edge(second);
        if (a.size() != 2 || b.size() != 2) continue;  // the edge is outside, or a corner of both only
        ++shared;
        unequal += same_bits(a[0], b[1]) && same_bits(a[1], b[0]) ? 0 : 1;
    }
    CHECK(shared > 3000);
    CHECK(unequal == 0);
}

TEST_CASE("Area left by the clipper is that of an independent long double clipper") {
    Random random(5);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        glm::vec4 p[3];
        for (glm::vec4& corner : p) {
            const glm::vec3 xyz = random.in_box(5.0f);
            corner = {xyz, random.real(-1.0f, 3.0f)};
        }
        const long double expected = reference_area(p[0], p[1], p[2], kGuardX, kGuardY);
        const long double found = area_of(clip_triangle(p[0], p[1], p[2], kGuardX, kGuardY));
        worst = std::max(worst, static_cast<double>(std::abs(found - expected)));
    }
    // The band has area 24 and perimeter 20: corners rounded to 2^-24 of 3 move the border by 2e-7, so 4e-6 at most,
    // except where w is tiny beside the corners it was cut from.
    MESSAGE("largest difference of area: " << worst);
    CHECK(worst < 4e-6);
}

TEST_CASE("Near plane is met exactly enough when far corners are ten million times farther") {
    // A ground triangle from the camera's feet to far away: near plane 0.01, corners at 1e5.
    const float near = 0.01f, far = 1e6f;
    const float a = -(far + near) / (far - near), b = -2.0f * far * near / (far - near);
    const auto clip = [&](glm::vec3 view) { return glm::vec4(view.x, view.y, a * view.z + b, -view.z); };
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec4 p0 = clip({random.real(-1e5f, 1e5f), -1, random.real(1e4f, 1e5f)});
        const glm::vec4 p1 = clip({random.real(-1e5f, 1e5f), -1, random.real(-1e5f, -1e4f)});
        const glm::vec4 p2 = clip({random.real(-1e5f, 1e5f), -1, random.real(-1e5f, 1e5f)});
        const ClipPolygon polygon = clip_triangle(p0, p1, p2, 100.0f, 100.0f);
        for (int k = 0; k < polygon.count; ++k) {
            const glm::vec4& p = polygon.vertex[static_cast<std::size_t>(k)].position;
            REQUIRE(inside_guard_band(p, 100.0f, 100.0f));
            REQUIRE(p.w >= 0.5f * near);
        }
        const long double expected = reference_area(p0, p1, p2, 100.0f, 100.0f);
        CHECK(static_cast<double>(area_of(polygon)) == doctest::Approx(static_cast<double>(expected)).epsilon(1e-5));
    }
}

TEST_CASE("Nothing comes of corners that are not finite") {
    const glm::vec4 good(0, 0, 0, 1);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        for (int component = 0; component < 4; ++component) {
            glm::vec4 p = good;
            p[component] = bad;
            CHECK(clip_triangle(p, good, good, kGuardX, kGuardY).count == 0);
            CHECK(clip_triangle(good, p, good, kGuardX, kGuardY).count == 0);
            CHECK(clip_triangle(good, good, p, kGuardX, kGuardY).count == 0);
        }
    }
}

TEST_CASE("Coordinates up to the largest float: what is left lies on the screen or nothing is left") {
    Random random(7);
    int left = 0;
    const Viewport viewport{1, 1};  // the smallest image has the widest guard band
    const float guard = guard_band_ndc(1);
    for (int i = 0; i < 20000; ++i) {
        glm::vec4 p[3];
        for (glm::vec4& corner : p) {
            for (int k = 0; k < 4; ++k) {
                const float magnitude = std::pow(10.0f, random.real(-38.0f, 38.5f));
                corner[k] = random.integer(0, 1) == 0 ? magnitude : -magnitude;
            }
            if (random.integer(0, 3) == 0) corner.w = std::abs(corner.w);
        }
        const ClipPolygon polygon = clip_triangle(p[0], p[1], p[2], guard, guard);
        left += polygon.count > 0 ? 1 : 0;
        for (int k = 0; k < polygon.count; ++k) {
            const ClipVertex& v = polygon.vertex[static_cast<std::size_t>(k)];
            REQUIRE(inside_guard_band(v.position, guard, guard));
            const ScreenVertex screen = to_screen(v.position, viewport);
            REQUIRE(std::abs(screen.x) <= 16384 * kSubpixels);
            REQUIRE(std::abs(screen.y) <= 16384 * kSubpixels);
            REQUIRE((screen.z >= 0.0f && screen.z <= 1.0f));
            REQUIRE((screen.inv_w > 0.0f && screen.inv_w < std::numeric_limits<float>::infinity()));
        }
    }
    CHECK(left > 500);
}

TEST_CASE("Wall of 1e30 units is clipped to what is in view") {
    // A wall at distance 10 that reaches 1e30 to each side fills the image.
    Drawing drawing;
    drawing.viewport = {64, 48};
    Camera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    drawing.clip_from_world = clip_from_world(camera, 64.0f / 48.0f);
    add_triangle(drawing.mesh, {-1e30f, -1e30f, -10}, {1e30f, -1e30f, -10}, {0, 1e30f, -10});
    finish(drawing.mesh);
    const Drawn drawn = set_up(drawing);
    CHECK(drawn.counts.clipped == 1);
    CHECK(drawn.counts.drawn >= 1);
}
