// Tangents: the direction of growing u, on planes by hand, on shapes by formula; mirrored, degenerate and clipped.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "raster/fragments.hpp"
#include "raster/rasterize_tile.hpp"
#include "raster/shapes.hpp"
#include "raster/tangents.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

/// The square [0,1]^2 of the xy plane, two triangles, facing +z, with the given uvs at its corners.
Mesh square(glm::vec2 uv00, glm::vec2 uv10, glm::vec2 uv11, glm::vec2 uv01) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.uvs = {uv00, uv10, uv11, uv01};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.parts = {{"square", 0, 2, -1}};
    return mesh;
}

float worst_difference(const Mesh& mesh, const glm::vec4& expected) {
    float worst = 0.0f;
    for (const glm::vec4& tangent : mesh.tangents) worst = std::max(worst, glm::length(tangent - expected));
    return worst;
}

}  // namespace

TEST_CASE("Tangent of a square is where u grows: turned with the picture and not changed by its scale") {
    Mesh straight = square({0, 0}, {1, 0}, {1, 1}, {0, 1});
    CHECK(make_tangents(straight).without_direction == 0);
    CHECK(worst_difference(straight, {1, 0, 0, 1}) == 0.0f);

    Mesh stretched = square({0, 0}, {7, 0}, {7, 0.01f}, {0, 0.01f});
    make_tangents(stretched);
    CHECK(worst_difference(stretched, {1, 0, 0, 1}) < 1e-6f);

    Mesh turned = square({0, 1}, {0, 0}, {1, 0}, {1, 1});  // u grows upwards
    make_tangents(turned);
    CHECK(worst_difference(turned, {0, 1, 0, 1}) < 1e-6f);
}

TEST_CASE("Mirrored picture has side -1 and the bitangent w (n x t) still points to growing v") {
    Mesh mirrored = square({1, 0}, {0, 0}, {0, 1}, {1, 1});  // u grows to the left
    const TangentReport report = make_tangents(mirrored);
    CHECK(worst_difference(mirrored, {-1, 0, 0, -1}) == 0.0f);
    CHECK(report.split_vertices == 0);
    const glm::vec3 bitangent =
        mirrored.tangents[0].w * glm::cross(mirrored.normals[0], glm::vec3(mirrored.tangents[0]));
    CHECK(bitangent.y == 1.0f);
}

TEST_CASE("Vertex where a mirrored and an unmirrored triangle meet is split") {
    Mesh mesh = square({0, 0}, {1, 0}, {1, 1}, {0, 1});
    mesh.uvs[3] = {2, 0};  // the second triangle folds back: u grows the other way there
    const TangentReport report = make_tangents(mesh);
    CHECK(report.split_vertices == 2);
    REQUIRE(mesh.positions.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        CAPTURE(i);
        const glm::vec4 tangent = mesh.tangents[mesh.indices[i]];
        CHECK(tangent.w == (i < 3 ? 1.0f : -1.0f));
        CHECK(glm::length(glm::vec3(tangent)) == doctest::Approx(1.0));
    }
    CHECK(mesh.positions[mesh.indices[3]] == glm::vec3(0, 0, 0));  // the copies stand where the originals do
    CHECK(mesh.uvs[mesh.indices[4]] == glm::vec2(1, 1));
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});  // no part among the vertices of another
}

TEST_CASE("Triangle whose uvs lie on a line says nothing and lonely vertices get a perpendicular") {
    Mesh half = square({0, 0}, {1, 0}, {1, 1}, {0, 0});  // the second triangle: two equal uvs
    const TangentReport some = make_tangents(half);
    CHECK(some.degenerate_triangles == 1);
    CHECK(some.without_direction == 1);
    Mesh none = square({3, 3}, {3, 3}, {3, 3}, {3, 3});
    const TangentReport all = make_tangents(none);
    CHECK(all.degenerate_triangles == 2);
    CHECK(all.without_direction == 4);
    for (const glm::vec4& tangent : none.tangents) {
        CHECK(glm::length(glm::vec3(tangent)) == doctest::Approx(1.0));
        CHECK(glm::dot(glm::vec3(tangent), glm::vec3(0, 0, 1)) == 0.0f);
        CHECK(tangent.w == 1.0f);
    }
}

TEST_CASE("Any perpendicular is unit and perpendicular for random directions and the axes") {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        glm::dvec3 n = glm::normalize(glm::dvec3(random.in_box(1.0f)));
        if (i < 6) n = glm::dvec3(i % 3 == 0, i % 3 == 1, i % 3 == 2) * (i < 3 ? 1.0 : -1.0);
        const glm::dvec3 t = any_perpendicular(n);
        CHECK(std::abs(glm::dot(t, n)) < 1e-15);
        CHECK(std::abs(glm::length(t) - 1.0) < 1e-15);
    }
    CHECK(any_perpendicular(glm::dvec3(0.0)) == glm::dvec3(1.0, 0.0, 0.0));
}

TEST_CASE("Tangents of the sphere are the derivative of its parametrization within a degree") {
    Mesh sphere = make_sphere(128);
    const std::size_t before = sphere.positions.size();
    const TangentReport report = make_tangents(sphere);
    CHECK(report.split_vertices == 0);
    CHECK(sphere.positions.size() == before);
    int seen = 0;
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        const glm::vec3 p = sphere.positions[i];
        if (std::abs(p.y) > 0.99f) continue;
        // u grows counter-clockwise around y, seen from above: dP/du is along (z, 0, -x).
        const glm::vec3 expected = glm::normalize(glm::vec3(p.z, 0.0f, -p.x));
        CHECK(glm::dot(glm::vec3(sphere.tangents[i]), expected) > std::cos(radians(1.5f)));  // 360 / 128 / 2 deg
        CHECK(sphere.tangents[i].w == 1.0f);
        ++seen;
    }
    CHECK(seen > 7000);
}

TEST_CASE("Every tangent of every built-in shape is unit and perpendicular to its normal and unmirrored") {
    for (const std::string_view name : shape_names()) {
        CAPTURE(name);
        Mesh mesh = make_shape(name, 32).value();
        make_tangents(mesh);
        REQUIRE(mesh.tangents.size() == mesh.positions.size());
        for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
            const glm::vec3 t(mesh.tangents[i]);
            REQUIRE(std::abs(glm::length(t) - 1.0f) < 1e-6f);
            REQUIRE(std::abs(glm::dot(t, mesh.normals[i])) < 1e-6f);
            REQUIRE(mesh.tangents[i].w == 1.0f);
        }
    }
}

TEST_CASE("World tangents follow the surface under any scale and a mirror swaps their side") {
    Mesh mesh = square({0, 0}, {1, 0}, {1, 1}, {0, 1});
    make_tangents(mesh);
    std::vector<MeshInstance> instances(1);
    instances[0].mesh = &mesh;
    instances[0].part_material = {0};
    instances[0].world_from_object =
        glm::mat4(glm::vec4(-2, 0, 0, 0), glm::vec4(0, 3, 0, 0), glm::vec4(0, 0, 5, 0), glm::vec4(9, 9, 9, 1));
    VertexNeeds needs;
    needs.tangent_world = true;
    VertexStreams streams;
    lay_out_vertices(instances, needs, streams);
    transform_vertices(instances, glm::mat4(1.0f), {64, 64}, streams);
    REQUIRE(streams.tangent_world.size() == 4);
    CHECK(streams.tangent_world[0] == glm::vec4(-2, 0, 0, -1));
}

TEST_CASE("Tangent and uv of a clipped triangle are those of its plane") {
    Drawing drawing;
    drawing.viewport = {64, 64};
    drawing.clip_from_world = glm::mat4(1.0f);
    drawing.clip_from_world[2] = {0, 0, 1, 1};  // w = z: the square below reaches behind the eye
    drawing.clip_from_world[3] = {0, 0, -0.2f, 0};
    drawing.mesh = square({0, 0}, {1, 0}, {1, 1}, {0, 1});
    drawing.mesh.positions = {{-1, -0.5f, -1}, {1, -0.5f, -1}, {1, -0.5f, 4}, {-1, -0.5f, 4}};
    drawing.mesh.normals.assign(4, glm::vec3(0, 1, 0));
    make_tangents(drawing.mesh);
    VertexNeeds needs;
    needs.uv = needs.tangent_world = true;
    const Drawn drawn = set_up(drawing, needs);
    REQUIRE(drawn.counts.clipped == 2);
    REQUIRE(drawn.streams.tangent_world.size() == drawn.streams.screen.size());
    for (std::size_t i = 4; i < drawn.streams.tangent_world.size(); ++i) {
        CHECK(glm::length(drawn.streams.tangent_world[i] - drawn.streams.tangent_world[0]) < 1e-6f);
    }
}
