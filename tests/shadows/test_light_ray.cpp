// Laws of the ray to the light: it never slips through a closed surface, and no surface shadows itself by rounding.
#include <cmath>

#include <doctest/doctest.h>

#include "shadow_scene.hpp"
#include "shadows/bvh.hpp"
#include "shadows/light_ray.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

/// One triangle across the y axis at height 1.
constexpr Triangle kRoof{{-1.0f, 1.0f, -1.0f}, {1.0f, 1.0f, -1.0f}, {0.0f, 1.0f, 1.0f}};

bool roof_shadows(const ShadowLight& light, const glm::vec3& p) {
    return shadows_point(light_ray(homogeneous(light), p), kRoof, homogeneous(light), p);
}

/// Height of p over the plane of a triangle, in roundings of the largest coordinate.
double height_in_roundings(const Triangle& t, const glm::vec3& p) {
    const glm::dvec3 a(t.a);
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a));
    const double size = std::max({largest_coordinate(t.a), largest_coordinate(t.b), largest_coordinate(t.c)});
    return std::abs(glm::dot(normal, glm::dvec3(p) - a)) / (0x1p-24 * size);
}

}  // namespace

TEST_CASE("light ray: a triangle shadows what lies on its far side and nothing else") {
    CHECK(roof_shadows(directional_light({0, -1, 0}), {0, 0, 0}));
    CHECK(roof_shadows(point_light({0, 2, 0}), {0, 0, 0}));
    CHECK_FALSE(roof_shadows(point_light({0, 0.5f, 0}), {0, 0, 0}));         // the light is below the roof
    CHECK_FALSE(roof_shadows(directional_light({0, -1, 0}), {0, 1.5f, 0}));  // the point is above it
    CHECK_FALSE(roof_shadows(directional_light({0, 1, 0}), {0, 0, 0}));      // light from below
    CHECK(roof_shadows(directional_light({0, 1, 0}), {0, 2, 0}));
    CHECK_FALSE(roof_shadows(directional_light({0, -1, 0}), {2, 0, 0}));  // beside it
    CHECK_FALSE(roof_shadows(directional_light({1, 0, 0}), {-2, 1, 0}));  // light in its plane
    CHECK_FALSE(roof_shadows(point_light({0, 0, 0}), {0, 0, 0}));         // at the light there is no ray
}

TEST_CASE("light ray: points of the triangle itself are never shadowed by it") {
    for (const ShadowLight& light : {directional_light({0.3f, -1, 0.2f}), directional_light({0.3f, 1, 0.2f}),
                                     directional_light({1, -1e-6f, 0}), point_light({0.1f, 1.5f, 0})}) {
        CHECK_FALSE(roof_shadows(light, kRoof.a));
        CHECK_FALSE(roof_shadows(light, {0.0f, 1.0f, 0.0f}));
        CHECK_FALSE(roof_shadows(light, {0.0f, std::nextafter(1.0f, 0.0f), 0.0f}));
    }
}

TEST_CASE("light ray: degenerate triangles shadow nothing") {
    const glm::vec3 p(0.0f);
    const glm::dvec4 light = homogeneous(directional_light({0, -1, 0}));
    const LightRay ray = light_ray(light, p);
    CHECK_FALSE(shadows_point(ray, {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}, light, p));
    CHECK_FALSE(shadows_point(ray, {{-1, 1, 0}, {0, 1, 0}, {1, 1, 0}}, light, p));
    CHECK_FALSE(shadows_point(ray, {{0, 1, 0}, {0, 2, 0}, {0, 3, 0}}, light, p));
}

TEST_CASE("light ray: from inside a closed surface no ray escapes - not even through a vertex or along an edge") {
    Random random(1);
    for (const char* shape : {"cube", "sphere", "torus", "torus_knot"}) {
        const raster::Mesh mesh = raster::make_shape(shape, 24).value();
        std::vector<Triangle> triangles;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            triangles.push_back({mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                                 mesh.positions[mesh.indices[i + 2]]});
        }
        // The ball and the cube are star-shaped around 0. Tori have the centre of the tube.
        const glm::vec3 inside = shape[0] == 't' ? (shape[5] == '_' ? mesh.positions[0] - 0.1f * mesh.normals[0]
                                                                    : glm::vec3(0.0f, 0.0f, 1.0f))
                                                 : glm::vec3(0.013f, -0.02f, 0.007f);
        const Bvh bvh = build_bvh(triangles);
        int escaped = 0;
        for (const Triangle& t : triangles) {
            const float s = random.real(0.0f, 1.0f);
            for (const glm::vec3& target : {t.a, 0.5f * t.a + 0.5f * t.b, t.a + s * (t.b - t.a)}) {
                const glm::vec3 beyond = inside + 100.0f * (target - inside);
                escaped += !any_shadow(bvh, homogeneous(point_light(beyond)), inside);
                escaped += !any_shadow(bvh, homogeneous(directional_light(inside - target)), inside);
            }
        }
        CAPTURE(shape);
        CHECK(escaped == 0);
    }
}

TEST_CASE("light ray: interpolated points lie within the bound of their triangle's plane") {
    Random random(2);
    double worst = 0.0;
    for (int round = 0; round < 60; ++round) {
        ShadowScene scene;
        scene.cull = raster::CullMode::none;
        scene.viewport = {64, 64};
        scene.camera.position = random.in_box(5.0f);
        scene.camera.target = random.in_box(1.0f);
        const float size = std::exp2(random.real(-6.0f, 12.0f));  // large triangles are clipped
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 30; ++i) corners.push_back(random.in_box(size));
        scene.add(mesh_of(corners));
        scene.draw();
        for (std::size_t i = 0; i < scene.sample_count(); ++i) {
            if (!scene.is_seen(i)) continue;
            const std::uint32_t source = scene.set.triangle(scene.frame.triangle[i]).source;
            const Triangle t{corners[3 * source], corners[3 * source + 1], corners[3 * source + 2]};
            worst = std::max(worst, height_in_roundings(t, scene.frame.position[i]));
        }
    }
    MESSAGE("largest height: ", worst, " roundings");
    CHECK(worst > 0.2);  // it does happen
    CHECK(worst < 0.5 * kInterpolationRoundings);
}

TEST_CASE("light ray: no point of a tilted plane is shadowed by the plane - however low the light") {
    ShadowScene scene;
    scene.camera.position = {0.5f, 3.0f, 5.0f};
    scene.add(raster::make_plane(40), glm::rotate(glm::scale(glm::mat4(1.0f), glm::vec3(7.3f)), 0.35f,
                                                  glm::normalize(glm::vec3(0.7f, 0.1f, 0.4f))));
    scene.draw();
    const glm::vec3 normal = glm::normalize(glm::mat3(scene.instances[0].world_from_object) * glm::vec3(0, 1, 0));
    const glm::vec3 along = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 0.2f, 1.0f)));
    const Bvh bvh = build_bvh(gather_triangles(scene.occluders));
    for (const float elevation : {1.0f, 0.1f, 0.01f, 1e-3f, 1e-5f}) {
        const glm::dvec4 light = homogeneous(directional_light(-(along + elevation * normal)));
        int shadowed = 0, seen = 0;
        for (std::size_t i = 0; i < scene.sample_count(); ++i) {
            seen += scene.is_seen(i);
            shadowed += scene.is_seen(i) && any_shadow(bvh, light, scene.frame.position[i]);
        }
        CAPTURE(elevation);
        CHECK(seen > 4000);
        CHECK(shadowed == 0);
    }
}
