// Triangles beside the picture cover the samples that the rasterizer would give them.
#include <doctest/doctest.h>

#include "raster/depth.hpp"
#include "raster/overdraw.hpp"
#include "shadow_scene.hpp"
#include "shadows/projected_triangles.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

shadows::ProjectedTriangle random_triangle(Random& random) {
    const auto corner = [&] {
        raster::ScreenVertex v;
        const int reach = random.integer(0, 3) == 0 ? 4'000'000 : 20 * 256;
        v.x = random.integer(-reach, reach);
        v.y = random.integer(-reach, reach);
        if (random.integer(0, 2) == 0) v.x = v.x / 256 * 256 + 128;  // through sample centres
        if (random.integer(0, 2) == 0) v.y = v.y / 256 * 256 + 128;
        return v;
    };
    shadows::ProjectedTriangle t{corner(), corner(), corner()};
    if (raster::edge_function(t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y) < 0) std::swap(t.b, t.c);
    return t;
}

/// Perspective, with corners on all sides of the camera.
raster::Mesh scattered(Random& random) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 90; ++i) corners.push_back(random.in_box(random.integer(0, 2) == 0 ? 40.0f : 3.0f));
    return mesh_of(corners);
}

}  // namespace

TEST_CASE("screen triangles: the span of a row holds the samples that the edge functions cover") {
    Random random(1);
    int covered = 0;
    for (int round = 0; round < 3000; ++round) {
        const shadows::ProjectedTriangle t = random_triangle(random);
        for (int y = 0; y < 16; ++y) {
            const shadows::SampleSpan span = covered_in_row(t, y, 16);
            for (int x = 0; x < 16; ++x) {
                const bool expected = raster::covers_sample(t.a, t.b, t.c, x, y);
                covered += expected;
                if ((x >= span.first && x <= span.last) != expected) FAIL("row ", y, " column ", x, " round ", round);
            }
        }
    }
    CHECK(covered > 30000);
}

TEST_CASE("screen triangles: before the far plane they cover what the rasterizer draws - sample by sample") {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Random random(seed);
        ShadowScene scene;
        scene.viewport = {40, 30};
        scene.cull = raster::CullMode::none;
        scene.camera.far = 20.0f;
        scene.add(scattered(random));
        scene.draw();
        std::vector<shadows::ProjectedTriangle> triangles;
        const raster::Mesh& mesh = scene.meshes[0];
        const auto clip = [&](std::uint32_t v) { return scene.clip_from_world() * glm::vec4(mesh.positions[v], 1.0f); };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            append_on_screen(clip(mesh.indices[i]), clip(mesh.indices[i + 1]), clip(mesh.indices[i + 2]),
                             scene.viewport, triangles);
        }
        std::vector<std::uint32_t> covered(40 * 30, 0);
        raster::AlignedVector<float> nearest(40 * 30, raster::kClearDepth);
        for (const shadows::ProjectedTriangle& t : triangles) {
            const raster::DepthPlane plane =
                raster::depth_plane(t.a, t.b, t.c, raster::edge_function(t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y));
            for (int y = 0; y < 30; ++y) {
                const shadows::SampleSpan span = covered_in_row(t, y, 40);
                for (int x = span.first; x <= span.last; ++x) {
                    const float z = depth_at(plane, depth_of_row(plane, y), x);
                    if (plane.z_min >= 1.0f) continue;  // beyond
                    ++covered[y * 40 + x];
                    nearest[y * 40 + x] = std::min(nearest[y * 40 + x], z);
                }
            }
        }
        CHECK(covered == raster::count_overdraw(scene.streams, scene.set, scene.viewport));
        CHECK(nearest == scene.frame.depth);  // the same bits: what lies on a surface has the surface's depth
    }
}

TEST_CASE("screen triangles: beyond the far plane nothing is lost and nothing is covered twice") {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Random random(seed);
        ShadowScene scene;
        scene.viewport = {40, 30};
        scene.add(scattered(random));
        const auto coverage = [&](float far) {
            scene.camera.far = far;
            std::vector<std::uint32_t> covered(40 * 30, 0);
            std::vector<shadows::ProjectedTriangle> triangles;
            for (std::size_t i = 0; i < 90; i += 3) {
                glm::vec4 c[3];
                for (int k = 0; k < 3; ++k)
                    c[k] = scene.clip_from_world() * glm::vec4(scene.meshes[0].positions[i + k], 1.0f);
                append_on_screen(c[0], c[1], c[2], scene.viewport, triangles);
            }
            for (const shadows::ProjectedTriangle& t : triangles) {
                for (int y = 0; y < 30; ++y) {
                    const shadows::SampleSpan span = covered_in_row(t, y, 40);
                    for (int x = span.first; x <= span.last; ++x) ++covered[y * 40 + x];
                }
            }
            return covered;
        };
        const std::vector<std::uint32_t> cut = coverage(10.0f), whole = coverage(200.0f);
        int different = 0;
        for (std::size_t i = 0; i < cut.size(); ++i) different += cut[i] != whole[i];
        CHECK(different <= 2);  // cut edges snap to 1/256 sample: now and then one passes a centre on the other side
    }
}
