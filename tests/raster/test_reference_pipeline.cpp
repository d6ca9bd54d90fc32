// The pipeline of one page against the fast one: the same samples, triangles, depths and attributes, to the last bit.
#include <doctest/doctest.h>

#include <bit>
#include <cstring>

#include "random_scenes.hpp"
#include "raster/fragment_loop.hpp"
#include "raster/reference_pipeline.hpp"
#include "raster/shapes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// What either pipeline says of one sample, as bits.
struct SeenBits {
    std::uint32_t source = 0;
    std::array<float, 9> numbers{};  ///< depth, position, normal, uv

    bool operator==(const SeenBits& other) const {
        return source == other.source && std::memcmp(numbers.data(), other.numbers.data(), sizeof numbers) == 0;
    }
};
constexpr std::uint32_t kNothing = 0xffffffffu;

struct Placed {
    std::vector<raster::MeshInstance> instances;
    glm::mat4 clip_from_world{1.0f};
    raster::Viewport viewport;
    raster::CullMode cull = raster::CullMode::none;
    int samples = 1;
};

SeenBits bits_of(std::uint32_t source, float depth, const glm::vec3& p, const glm::vec3& n, const glm::vec2& uv) {
    return {source, {depth, p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y}};
}

std::size_t sample_count(const raster::Viewport& viewport) {
    return static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height);
}

std::vector<SeenBits> by_reference(const Placed& scene) {
    std::vector<SeenBits> seen(sample_count(scene.viewport), {kNothing, {}});
    draw_reference(scene.instances, scene.clip_from_world, scene.viewport, scene.cull,
                   [&](const raster::ReferenceSample& s) {
                       seen[static_cast<std::size_t>(s.y) * scene.viewport.width + s.x] =
                           bits_of(s.source, s.depth, s.attributes.position, s.attributes.normal, s.attributes.uv);
                   });
    return seen;
}

std::vector<SeenBits> by_fast_pipeline(Placed scene) {
    raster::VertexStreams streams;
    raster::TriangleSet set;
    const raster::VertexNeeds vertex{.position_world = true, .normal_world = true, .uv = true};
    lay_out_vertices(scene.instances, vertex, streams);
    transform_vertices(scene.instances, scene.clip_from_world, scene.viewport, streams);
    setup_triangles(scene.instances, scene.clip_from_world, scene.viewport, scene.cull, scene.samples, streams, set);
    const raster::VisibilityBuffer nearest = rasterize_tiled(streams, set, scene.viewport);
    std::vector<SeenBits> seen(sample_count(scene.viewport), {kNothing, {}});
    for_each_fragment(streams, set, scene.viewport, {.position = true, .normal = true, .uv = true},
                      raster::AttributeInterpolation::perspective,
                      [&](int x, int y, const raster::Fragments& f, int i) {
                          const std::size_t at = static_cast<std::size_t>(y) * scene.viewport.width + x;
                          seen[at] = bits_of(set.triangle(nearest.triangle[at]).source, nearest.depth[at],
                                             f.position.at(i), f.normal.at(i), {f.u.at(i), f.v.at(i)});
                      });
    return seen;
}

void add_random_attributes(Random& random, raster::Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals.push_back(random.in_box(1.0f));
        mesh.uvs.push_back({random.real(-2.0f, 3.0f), random.real(-2.0f, 3.0f)});
    }
}

/// Samples at which the two differ.
int count_differences(const Placed& scene, int& covered) {
    const std::vector<SeenBits> slow = by_reference(scene), fast = by_fast_pipeline(scene);
    int wrong = 0;
    for (std::size_t i = 0; i < slow.size(); ++i) {
        wrong += !(slow[i] == fast[i]);
        covered += slow[i].source != kNothing;
    }
    return wrong;
}

}  // namespace

TEST_CASE("Pipeline of one page: samples, triangles, depths and attributes of the fast one in 1800 random scenes") {
    const OneThread one_thread;
    int wrong = 0, covered = 0;
    for (std::uint32_t seed = 0; seed < 1800; ++seed) {
        Drawing drawing = random_scene(seed);
        Random random(seed + 77);
        add_random_attributes(random, drawing.mesh);
        Placed scene{{}, drawing.clip_from_world, drawing.viewport, drawing.cull, drawing.samples};
        scene.instances.resize(1 + seed % 2);
        for (raster::MeshInstance& instance : scene.instances) {
            instance.mesh = &drawing.mesh;
            instance.part_material.assign(1, 0);
        }
        if (seed % 2 == 1) scene.instances[1].world_from_object[0][0] = -0.75f;  // mirrored: turns front and back
        wrong += count_differences(scene, covered);
    }
    CHECK(wrong == 0);
    CHECK(covered > 1000000);
}

TEST_CASE("Pipeline of one page: hidden parts are not drawn and later triangles keep their numbers") {
    const raster::Mesh mesh = raster::make_shape("teapot", 6).value();
    Placed scene{{}, glm::mat4(1.0f), {160, 120}, raster::CullMode::back, 1};
    scene.clip_from_world = clip_from_world({}, 160.0f / 120.0f);
    scene.instances.resize(2);
    for (raster::MeshInstance& instance : scene.instances) {
        instance.mesh = &mesh;
        instance.part_material.assign(mesh.parts.size(), 0);
    }
    scene.instances[0].part_hidden.assign(mesh.parts.size(), false);
    scene.instances[0].part_hidden[0] = true;
    scene.instances[1].world_from_object[3] = {0.9f, 0.2f, -0.5f, 1.0f};
    int covered = 0;
    CHECK(count_differences(scene, covered) == 0);
    CHECK(covered > 1000);
}
