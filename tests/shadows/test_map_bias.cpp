// The bias laws of shadow maps: closed forms for a flat receiver, met by the whole way from the rasterizer to the
// lookup.
#include <cmath>
#include <memory>
#include <random>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "drawn_map.hpp"
#include "shadows/map_point.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

/// A square of half side 8 around the origin with the given normal, as a mesh in world space.
raster::Mesh square(const glm::vec3& normal) {
    const glm::vec3 n = glm::normalize(normal);
    const glm::vec3 s = glm::normalize(glm::cross(n, glm::vec3(0.3f, 0.1f, 0.9f))) * 8.0f;
    const glm::vec3 t = glm::cross(n, s);
    raster::Mesh mesh;
    mesh.positions = {-s - t, s - t, s + t, t - s};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.parts = {{"square", 0, 2, -1}};
    return mesh;
}

/// A light straight down whose picture shows x and z in -1 .. 1.
LightView looking_down() {
    LightBounds seen;
    seen.least = {-1.0f, -1.0f, -20.0f};
    seen.greatest = {1.0f, 1.0f, 20.0f};
    seen.empty = false;
    return directional_view({0.0f, -1.0f, 0.0f}, seen, seen, 64, 0);
}

/// Mean shadow factor subtracted from 1 over random points of the plane through the origin, x and z in +-extent.
double share_in_shadow(const ShadowMap& map, const glm::vec3& normal, float extent) {
    const glm::vec3 n = glm::normalize(normal);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> inside(-extent, extent);
    const auto position = std::make_unique<raster::Channel3>();
    const auto normals = std::make_unique<raster::Channel3>();
    const auto shadow = std::make_unique<raster::Channel>();
    double dark = 0.0;
    constexpr int kBatches = 400;
    for (int batch = 0; batch < kBatches; ++batch) {
        for (int i = 0; i < raster::kBatchCapacity; ++i) {
            const float x = inside(random), z = inside(random);
            position->set(i, {x, -(n.x * x + n.z * z) / n.y, z});
            normals->set(i, n);
        }
        shadow_factors(map, *position, *normals, raster::kBatchCapacity, *shadow);
        for (int i = 0; i < raster::kBatchCapacity; ++i) dark += 1.0 - double{shadow->at(i)};
    }
    return dark / (kBatches * raster::kBatchCapacity);
}

ShadowSettings with_bias(ShadowBias bias, float slope_bias) {
    ShadowSettings settings;
    settings.size = 64;
    settings.bias = bias;
    settings.constant_bias = 0.0f;
    settings.slope_bias = slope_bias;
    return settings;
}

/// The rasterizer snaps corners to 1/256 texel, which may tilt the plane by that much: 1 % more than the law asks for.
constexpr float kSnap = 1.01f;

const glm::vec3 kAlongOneAxis(-0.7f, 1.0f, 0.0f);
const glm::vec3 kDiagonal(0.6f, 1.0f, 0.6f);
const glm::vec3 kAnywhere(0.9f, 1.0f, -0.35f);
const glm::vec3 kSteep(3.0f, 1.0f, 2.0f);

}  // namespace

TEST_CASE("bias: without any half of a tilted plane shadows itself") {
    for (const glm::vec3& normal : {kAlongOneAxis, kDiagonal, kAnywhere, kSteep}) {
        const raster::Mesh mesh = square(normal);
        const ShadowMap map = draw_map(mesh, looking_down(), with_bias(ShadowBias::none, 0.0f));
        CHECK(share_in_shadow(map, normal, 0.9f) == doctest::Approx(0.5).epsilon(0.01));  // 2e5 random points
    }
}

TEST_CASE("bias: a share k of the least bias leaves the share of a triangle's or a pyramid's tip in shadow") {
    // Depth errors are uniform in one direction: (1 - k) / 2 are left. In two equal ones they are the sum of two
    // uniform numbers: (1 - k)^2 / 2.
    for (const float k : {0.25f, 0.5f, 0.75f}) {
        CAPTURE(k);
        const raster::Mesh one = square(kAlongOneAxis);
        const ShadowMap map_one = draw_map(one, looking_down(), with_bias(ShadowBias::slope, k));
        CHECK(share_in_shadow(map_one, kAlongOneAxis, 0.9f) == doctest::Approx(0.5 * (1.0 - k)).epsilon(0.02));
        const raster::Mesh two = square(kDiagonal);
        const ShadowMap map_two = draw_map(two, looking_down(), with_bias(ShadowBias::slope, k));
        CHECK(share_in_shadow(map_two, kDiagonal, 0.9f) == doctest::Approx(0.5 * (1.0 - k) * (1.0 - k)).epsilon(0.05));
    }
}

TEST_CASE("bias: the least bias leaves nothing in shadow and the least normal offset neither") {
    for (const glm::vec3& normal : {kAlongOneAxis, kDiagonal, kAnywhere, kSteep}) {
        const raster::Mesh mesh = square(normal);
        for (const ShadowBias bias : {ShadowBias::slope, ShadowBias::normal_offset}) {
            CHECK(share_in_shadow(draw_map(mesh, looking_down(), with_bias(bias, kSnap)), normal, 0.9f) == 0.0);
            CHECK(share_in_shadow(draw_map(mesh, looking_down(), with_bias(bias, 0.9f)), normal, 0.9f) > 0.0);
        }
    }
}

TEST_CASE("bias: a filter of three by three with one depth needs three times as much") {
    for (const glm::vec3& normal : {kAlongOneAxis, kDiagonal}) {
        const raster::Mesh mesh = square(normal);
        const LightView view = looking_down();
        ShadowSettings settings = with_bias(ShadowBias::constant, 0.0f);
        settings.filter = ShadowFilter::pcf;
        const float texel = 2.0f * view.half_size.x / 64.0f;
        const glm::vec3 n = glm::normalize(normal);
        const float least = 0.5f * texel * (std::abs(n.x) + std::abs(n.z)) / n.y;
        settings.constant_bias = kSnap * least / (view.far - view.near);
        const double share = share_in_shadow(draw_map(mesh, view, settings), normal, 0.9f);
        CHECK(share > 0.2);  // measured for the design: 22 to 33 %
        CHECK(share < 0.34);
        settings.constant_bias *= 3.0f;
        CHECK(share_in_shadow(draw_map(mesh, view, settings), normal, 0.9f) == 0.0);
    }
}

TEST_CASE("bias: taps that follow the plane need no more than one of them") {
    for (const int radius : {1, 3, 6}) {
        for (const glm::vec3& normal : {kAlongOneAxis, kDiagonal, kAnywhere, kSteep}) {
            const raster::Mesh mesh = square(normal);
            ShadowSettings settings = with_bias(ShadowBias::slope, kSnap);
            settings.filter = ShadowFilter::pcf;
            settings.radius = radius;
            CHECK(share_in_shadow(draw_map(mesh, looking_down(), settings), normal, 0.75f) == 0.0);
        }
    }
}

TEST_CASE("bias: the least normal offset is at most half a diagonal of a texel times the sine") {
    std::mt19937 random(3);
    std::normal_distribution<float> gauss;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n = glm::normalize(glm::vec3(gauss(random), gauss(random), gauss(random)));
        const float sine = std::sqrt(n.x * n.x + n.y * n.y);
        CHECK(least_normal_offset(n, glm::vec2(0.1f)) <= 0.1f * std::sqrt(0.5f) * sine * 1.000001f);
    }
}

TEST_CASE("bias: shifting along the normal gains what the slope bias takes off") {
    // B cos(theta) = delta, for parallel rays and for rays from a point, wherever the point lies in the picture.
    const glm::vec2 texel(0.02f, 0.03f);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> side(-1.0f, 1.0f);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 q(side(random), side(random), -1.5f - side(random));
        const glm::vec3 n = glm::normalize(glm::vec3(side(random), side(random), 1.2f));
        const float distance = -q.z;
        CHECK(least_bias(slope_parallel(n, texel)) * n.z == doctest::Approx(least_normal_offset(n, texel)));
        const float cosine = -glm::dot(n, q) / distance;
        if (cosine < 0.02f) continue;  // where the slope is limited
        CHECK(least_bias(slope_perspective(n, q, distance, texel)) * cosine ==
              doctest::Approx(least_normal_offset(n, texel * distance)));
    }
}

TEST_CASE("bias: the slope of a plane is the change of its distance from texel to texel") {
    // By differences of two rays, in double: distance(X) = c / (n_x X + n_y Y - n_z).
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.4, -0.3, 0.8));
    const glm::dvec3 q(0.5, 0.2, -2.0);
    const double c = glm::dot(n, q), h = 1e-6, x = q.x / 2.0, y = q.y / 2.0;
    const auto distance = [&](double tangent_x, double tangent_y) {
        return c / (n.x * tangent_x + n.y * tangent_y - n.z);
    };
    const DepthSlope slope = slope_perspective(glm::vec3(n), glm::vec3(q), 2.0f, {0.01f, 0.01f});
    CHECK(slope.u == doctest::Approx(0.01 * (distance(x + h, y) - distance(x - h, y)) / (2.0 * h)));
    CHECK(slope.v == doctest::Approx(-0.01 * (distance(x, y + h) - distance(x, y - h)) / (2.0 * h)));
}
