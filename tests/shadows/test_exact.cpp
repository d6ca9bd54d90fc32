// The tree of boxes against every triangle; the exact shadow against shapes whose shadow is a formula.
#include <cmath>

#include <doctest/doctest.h>

#include <glm/trigonometric.hpp>

#include "shadow_scene.hpp"
#include "shadows/exact.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

/// Does the way from p to the light pass through the ball of radius r around c?  (exact, in double)
bool ball_blocks(const glm::dvec3& c, double r, const glm::dvec4& light, const glm::dvec3& p) {
    const glm::dvec3 d = toward_light(light, p);
    double t = glm::dot(c - p, d) / glm::dot(d, d);
    if (light.w != 0.0) t = std::clamp(t, 0.0, 1.0);
    return t > 0.0 && glm::length(p + t * d - c) < r;
}

ShadowLight random_light(Random& random) {
    switch (random.integer(0, 3)) {
        case 0: return directional_light(random.in_box(1.0f) + glm::vec3(0.001f));
        case 1: {  // along an axis: rays in the faces of boxes
            glm::vec3 direction(0.0f);
            direction[random.integer(0, 2)] = random.integer(0, 1) ? 1.0f : -1.0f;
            return directional_light(direction);
        }
        case 2: return point_light(glm::round(random.in_box(4.0f)));
        default: return point_light(random.in_box(3.0f));
    }
}

}  // namespace

TEST_CASE("exact: the tree answers as asking every triangle does") {
    Random random(3);
    int shadowed = 0, asked = 0;
    for (int round = 0; round < 120; ++round) {
        std::vector<Triangle> triangles;
        const float reach = random.integer(0, 1) ? 3.0f : 0.4f;
        const int count = random.integer(0, 400);
        for (int i = 0; i < count; ++i) {
            const glm::vec3 a = random.in_box(2.0f);
            Triangle t{a, a + random.in_box(reach), a + random.in_box(reach)};
            if (random.integer(0, 3) == 0) t = {glm::round(t.a), glm::round(t.b), glm::round(t.c)};  // flat boxes
            if (random.integer(0, 30) == 0) t.c = t.b;
            triangles.push_back(t);
        }
        const Bvh bvh = build_bvh(triangles);
        CHECK(bvh.triangles.size() == triangles.size());
        for (int i = 0; i < 60; ++i) {
            const glm::dvec4 light = homogeneous(random_light(random));
            glm::vec3 p = random.in_box(3.0f);
            if (random.integer(0, 2) == 0) p = glm::round(p);
            if (count > 0 && random.integer(0, 3) == 0) p = triangles[0].b;
            const bool expected = any_shadow(std::span<const Triangle>(triangles), light, p);
            CHECK(any_shadow(bvh, light, p) == expected);
            shadowed += expected;
            ++asked;
        }
    }
    CHECK(shadowed > asked / 5);
    CHECK(shadowed < asked * 4 / 5);
}

TEST_CASE("exact: the shadow of a fine ball is that of the ball") {
    constexpr int kDetail = 96;
    ShadowScene scene;
    scene.add("plane", 3, {0.0f, -1.3f, 0.0f}, glm::vec3(6.0f));
    scene.add("sphere", kDetail, {0.2f, 0.1f, -0.3f});
    scene.camera.position = {1.0f, 3.0f, 5.0f};
    scene.draw();
    const glm::dvec3 centre(0.2f, 0.1f, -0.3f);
    const double inner = std::pow(std::cos(glm::radians(180.0 / kDetail)), 2);  // the mesh lies between the two balls
    for (const ShadowLight& light : {directional_light({-1, -2, -0.5f}), point_light({-1.0f, 2.5f, 1.0f})}) {
        const ExactShadow exact = build_exact_shadow(scene.occluders, light);
        std::vector<float> shadow(scene.sample_count(), 0.5f);
        exact_shadow(exact, scene.frame.samples(), shadow);
        int dark = 0, lit = 0;
        for (std::size_t i = 0; i < shadow.size(); ++i) {
            const glm::dvec3 p = scene.frame.position[i];
            if (!scene.is_seen(i) || p.y > -1.29) continue;  // the floor
            if (ball_blocks(centre, inner, exact.light, p)) dark += shadow[i] == 0.0f;
            if (ball_blocks(centre, inner, exact.light, p)) CHECK(shadow[i] == 0.0f);
            if (!ball_blocks(centre, 1.0, exact.light, p)) CHECK(shadow[i] == 1.0f);
            lit += shadow[i] == 1.0f;
        }
        CHECK(dark > 300);
        CHECK(lit > 1000);
    }
}

TEST_CASE("exact: a batch of points is answered like a frame of samples") {
    ShadowScene scene;
    scene.add("plane", 1, {0.0f, -1.0f, 0.0f}, glm::vec3(4.0f));
    scene.add("torus", 24);
    scene.draw();
    const ExactShadow exact = build_exact_shadow(scene.occluders, directional_light({-1, -2, -1}));
    std::vector<float> shadow(scene.sample_count(), 1.0f);
    exact_shadow(exact, scene.frame.samples(), shadow);
    raster::Channel3 position;
    raster::Channel channel;
    for (std::size_t first = 0; first + 100 <= shadow.size(); first += 100) {
        for (int i = 0; i < 100; ++i) position.set(i, scene.frame.position[first + i]);
        shadow_factors(exact, position, 100, channel);
        for (int i = 0; i < 100; ++i) {
            if (scene.is_seen(first + i)) CHECK(channel.at(i) == shadow[first + i]);
        }
    }
}

TEST_CASE("exact: without occluders everything is lit and triangles that are not finite cast nothing") {
    const raster::Mesh broken = mesh_of({{0, 1, 0}, {1, 1, NAN}, {0, 1, 1}, {-1, 1, -1}, {INFINITY, 1, 0}, {0, 1, 1}});
    const Occluder occluder{broken.positions, broken.indices, false};
    CHECK(gather_triangles({&occluder, 1}).empty());
    const ExactShadow exact = build_exact_shadow({&occluder, 1}, directional_light({0, -1, 0}));
    CHECK_FALSE(any_shadow(exact.bvh, exact.light, {0, 0, 0}));
}
