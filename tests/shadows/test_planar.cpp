// Planar shadows: Blinn's identities, no shadow on the wrong side of the light, and the rays' shadow on the plane.
#include <cmath>
#include <utility>

#include <doctest/doctest.h>

#include "hard_cases.hpp"
#include "shadows/compare.hpp"
#include "shadows/exact.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/planar.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

glm::dvec4 random_plane(Random& random) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(random.in_box(1.0f)) + glm::dvec3(0.001));
    return {n, double{random.real(-2.0f, 2.0f)}};
}

double largest(const glm::dmat4& m) {
    double value = 0.0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) value = std::max(value, std::abs(m[i][j]));
    }
    return value;
}

/// The scene's planar shadow on its first object, and the exact one there; what else is seen does not count.
ShadowError error_on_floor(const ShadowScene& scene) {
    const VisibleSamples samples = scene.frame.samples();
    auto depth = scene.depth_without_edge_on_surfaces();
    const std::uint32_t floor_triangles = scene.instances[0].mesh->triangle_count();
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (!scene.is_seen(i) || scene.set.triangle(scene.frame.triangle[i]).source >= floor_triangles) {
            depth[i] = raster::kClearDepth;
        }
    }
    std::vector<float> exact(scene.sample_count(), 1.0f), planar(scene.sample_count());
    exact_shadow(build_exact_shadow(scene.occluders, scene.light), samples, exact);
    planar_shadow(scene.occluders, plane_of(scene.occluders[0]).value(), scene.light, samples, planar);
    return compare_shadows({samples.viewport, samples.clip_from_world, depth, samples.position}, exact, planar, 1);
}

}  // namespace

TEST_CASE("planar shadows: images lie in the plane and projecting twice is projecting once") {
    Random random(1);
    for (int round = 0; round < 500; ++round) {
        const glm::dvec4 P = random_plane(random);
        const glm::dvec4 L(glm::dvec3(random.in_box(5.0f)), round % 2);
        const glm::dmat4 M = planar_projection(P, L);
        const glm::dvec4 q(glm::dvec3(random.in_box(3.0f)), 1.0);
        const double scale = largest(M) * 20.0;
        CHECK(std::abs(glm::dot(P, M * q)) <= 1e-14 * scale);
        CHECK(largest(M * M - glm::dot(P, L) * M) <= 1e-14 * scale * largest(M));
        CHECK(glm::length(M * L) <= 1e-14 * scale);  // the light itself has no image
    }
}

TEST_CASE("planar shadows: onto the ground as worked by hand") {
    const glm::dvec4 ground(0, 1, 0, 0);
    const glm::dvec4 sun = planar_projection(ground, {1, 2, 0, 0}) * glm::dvec4(3, 4, 5, 1);
    CHECK(glm::dvec3(sun) / sun.w == glm::dvec3(1, 0, 5));  // 4 down is 2 to the left
    const glm::dvec4 lamp = planar_projection(ground, {0, 2, 0, 1}) * glm::dvec4(1, 1, 0, 1);
    CHECK(glm::dvec3(lamp) / lamp.w == glm::dvec3(2, 0, 0));  // half as high as the lamp: twice as far
    const glm::dvec4 above = planar_projection(ground, {0, 2, 0, 1}) * glm::dvec4(1, 3, 0, 1);
    CHECK(above.w < 0.0);  // higher than the lamp: an anti-shadow, if it were drawn
}

TEST_CASE("planar shadows: only what lies between plane and light is projected") {
    const glm::dvec4 ground(0, 1, 0, 0), lamp(0, 2, 0, 1);
    CHECK(between_plane_and_light(ground, lamp, {0, 3, 0}, {1, 4, 0}, {0, 3, 1}).count == 0);
    CHECK(between_plane_and_light(ground, lamp, {0, -3, 0}, {1, -1, 0}, {0, 0, 1}).count == 0);
    CHECK(between_plane_and_light(ground, lamp, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}).count == 0);  // in the plane
    CHECK(between_plane_and_light(ground, lamp, {0, 1, 0}, {1, 1, 0}, {0, 1, 1}).count == 3);
    const auto cut = between_plane_and_light(ground, lamp, {0, 1, 0}, {1, 3, 0}, {0, -1, 1});
    CHECK(cut.count == 5);
    for (int i = 0; i < cut.count; ++i) {
        CHECK(cut.corner[i].y > 0.0);
        CHECK(cut.corner[i].y < 2.0);
    }
}

TEST_CASE("planar shadows: a flat object has a plane and a bent one has none") {
    ShadowScene scene;
    scene.add(raster::make_plane(9),
              glm::rotate(glm::translate(glm::mat4(1.0f), {3, -2, 1}), 0.7f, glm::normalize(glm::vec3(1, 2, 3))));
    scene.add("cube", 1);
    scene.add(mesh_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
    scene.draw();
    const std::optional<glm::dvec4> plane = plane_of(scene.occluders[0]);
    REQUIRE(plane.has_value());
    const glm::dvec3 up = glm::normalize(glm::dmat3(scene.instances[0].world_from_object) * glm::dvec3(0, 1, 0));
    CHECK(glm::length(glm::dvec3(*plane) - up) < 1e-6);
    CHECK(std::abs(glm::dot(*plane, glm::dvec4(3, -2, 1, 1))) < 1e-6);
    CHECK_FALSE(plane_of(scene.occluders[1]).has_value());
    CHECK_FALSE(plane_of(scene.occluders[2]).has_value());
}

TEST_CASE("planar shadows: on the plane as the rays say but next to an edge - in every hard case") {
    int with_shadow = 0;
    for (const HardCase& hard_case : hard_cases()) {
        ShadowScene scene;
        hard_case.build(scene);
        scene.draw();
        const ShadowError error = error_on_floor(scene);
        with_shadow += error.edge_length > 10.0;
        CAPTURE(hard_case.name);
        CHECK(error.acne + error.leaks == 0);
        CHECK(error.misclassified() <= error.visible / 2000 + 1);
    }
    CHECK(with_shadow >= 15);
}

TEST_CASE("planar shadows: the order of triangles does not matter") {
    ShadowScene scene;
    add_room(scene);
    scene.light = point_light({2, 3, 2});
    scene.draw();
    const glm::dvec4 plane = plane_of(scene.occluders[0]).value();
    std::vector<float> forward(scene.sample_count()), backward(scene.sample_count());
    planar_shadow(scene.occluders, plane, scene.light, scene.frame.samples(), forward);
    std::vector<Occluder> reversed(scene.occluders.rbegin(), scene.occluders.rend());
    std::vector<std::uint32_t> indices(reversed[0].indices.rbegin(), reversed[0].indices.rend());
    reversed[0].indices = indices;
    planar_shadow(reversed, plane, scene.light, scene.frame.samples(), backward);
    CHECK(forward == backward);
    CHECK(std::count(forward.begin(), forward.end(), 0.0f) > 500);
}
