// Objects that lie beyond the view as a whole: what is said of them triangle by triangle.
#include <doctest/doctest.h>

#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "raster/camera.hpp"
#include "raster/outside_view.hpp"
#include "raster/shapes.hpp"
#include "raster/triangle_setup.hpp"

using namespace kreda::raster;

namespace {

/// What becomes of the instance's triangles when its mesh is not alone in its box: a far vertex that no triangle uses
/// makes the box so large that nothing is left out as a whole.
TriangleCounts counts_one_by_one(const MeshInstance& instance, const glm::mat4& clip_from_world, const Viewport& view) {
    Mesh mesh = *instance.mesh;
    for (const float far : {-1e6f, 1e6f}) {
        mesh.positions.insert(mesh.positions.end(), {glm::vec3(far, 0, 0), glm::vec3(0, far, 0), glm::vec3(0, 0, far)});
        mesh.normals.insert(mesh.normals.end(), 3, glm::vec3(0, 1, 0));
    }
    MeshInstance alone = instance;
    alone.mesh = &mesh;
    REQUIRE_FALSE(lies_outside(alone, clip_from_world, view));
    std::vector<MeshInstance> instances{alone};
    VertexStreams streams;
    TriangleSet set;
    lay_out_vertices(instances, {}, streams);
    transform_vertices(instances, clip_from_world, view, streams);
    return setup_triangles(instances, clip_from_world, view, CullMode::back, 1, streams, set);
}

}  // namespace

TEST_CASE("what lies outside as a whole is outside triangle by triangle: 400 random places") {
    const Mesh mesh = make_shape("torus", 6).value();
    std::mt19937 random(11);
    const auto real = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
    };
    int outside = 0;
    for (int i = 0; i < 400; ++i) {
        Camera camera;
        camera.position = {real(-2, 2), real(-2, 2), real(2, 6)};
        camera.far = real(8.0f, 60.0f);
        if (i % 3 == 0) camera.projection = Projection::orthographic;
        const Viewport view{48, 32};
        const glm::mat4 clip_from_world = kreda::raster::clip_from_world(camera, 1.5f);
        MeshInstance instance;
        instance.mesh = &mesh;
        const float reach = i % 2 ? 12.0f : 900.0f;
        const glm::vec3 place{real(-reach, reach), real(-reach, reach), real(-reach, reach)};
        instance.world_from_object = glm::translate(glm::mat4(1.0f), place);
        instance.part_material.assign(mesh.parts.size(), 0);
        if (!lies_outside(instance, clip_from_world, view)) continue;
        ++outside;
        const TriangleCounts counts = counts_one_by_one(instance, clip_from_world, view);
        CHECK(counts.outside == mesh.triangle_count());
        CHECK(counts.input == mesh.triangle_count());
    }
    CHECK(outside > 100);
}

TEST_CASE("a mesh with a coordinate that is not a number lies outside of nothing") {
    Mesh mesh = make_shape("cube", 1).value();
    MeshInstance instance;
    instance.mesh = &mesh;
    const glm::mat4 behind = clip_from_world(Camera{}, 1.0f) * glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 100.0f});
    CHECK(lies_outside(instance, behind, {32, 32}));
    mesh.positions.back().x = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(lies_outside(instance, behind, {32, 32}));
}
