// Bytes as promised: what a frame keeps is what the plan lists, pass by pass.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "raster/shapes.hpp"
#include "scene/render/render.hpp"
#include "tests/plan/counted_memory.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Bytes that the frame keeps in its buffers, counted.
std::int64_t bytes_kept(const scene::Scene& scene, const scene::RenderPlan& plan) {
    const std::int64_t before = bytes_in_use();
    scene::RenderBuffers buffers;
    render(scene, plan, buffers, 1);
    return bytes_in_use() - before;
}

scene::Scene scene_of(const char* shape, int detail, scene::ShadingFrequency frequency) {
    scene::Scene scene;
    scene.image.width = 320;
    scene.image.height = 240;
    scene.shading.frequency = frequency;
    scene.camera.position = {0.0f, 1.2f, 2.8f};
    scene.lights.resize(1);
    scene.lights[0].direction = {-0.3f, -1.0f, -0.5f};
    scene.materials.resize(1);
    scene.materials[0].name = "m";
    scene.materials[0].model = lighting::ReflectionModel::phong;
    scene::Object object;
    object.mesh_name = shape;
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(shape, detail).value());
    object.part_material.assign(object.mesh->parts.size(), 0);
    object.part_hidden.assign(object.mesh->parts.size(), false);
    scene.objects = {object};
    return scene;
}

/// What is listed and kept: what a pass needs while it bakes or runs is gone afterwards.
std::int64_t bytes_listed(const scene::RenderPlan& plan) {
    std::uint64_t sum = 0;
    for (const scene::PlannedPass& pass : plan.passes) {
        for (const scene::PlannedBuffer& buffer : pass.buffers) {
            if (buffer.name.find(", while ") == std::string::npos) sum += buffer.bytes;
        }
    }
    return static_cast<std::int64_t>(sum);
}

/// 5 % or 64 KB.
void check_bytes(const scene::Scene& scene, const scene::PlanRequest& request = {}) {
    const scene::RenderPlan plan = make_plan_for(scene, request);
    std::string text = describe(plan, false);
    CAPTURE(text);
    const std::int64_t kept = bytes_kept(scene, plan), listed = bytes_listed(plan);
    CAPTURE(kept);
    CAPTURE(listed);
    CHECK(std::abs(kept - listed) <= std::max<std::int64_t>(65536, listed / 20));
}

}  // namespace

#if !defined(KREDA_SANITIZED)

TEST_CASE("a frame keeps the bytes that its plan lists: where each pass in turn needs most of them") {
    using scene::ShadingFrequency;
    for (const ShadingFrequency frequency :
         {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong}) {
        check_bytes(scene_of("sphere", 300, frequency));  // vertices, triangles
        check_bytes(scene_of("cube", 1, frequency));      // film and one thread's memory
    }
    scene::Scene shadow = scene_of("torus", 40, ShadingFrequency::phong);
    shadow.shading.cull = raster::CullMode::none;
    shadow.lights[0].shadow = true;
    check_bytes(shadow);
    for (const shadows::ShadowMethod method : {shadows::ShadowMethod::volume, shadows::ShadowMethod::irregular}) {
        shadow.shadow.method = method;
        check_bytes(shadow);
    }
    scene::Scene fog = scene_of("sphere", 200, ShadingFrequency::phong);
    fog.fog.mode = lighting::FogMode::exp;
    fog.fog.frequency = lighting::FogFrequency::vertex;
    check_bytes(fog);
}

TEST_CASE("a view keeps the bytes that its plan lists, and depth those of no light") {
    const scene::Scene scene = scene_of("sphere", 60, scene::ShadingFrequency::phong);
    for (const char* name : {"depth", "normal", "diffuse"}) {
        check_bytes(scene, {.views = {scene::find_view(name)}, .film = false});
    }
}

TEST_CASE("a frame keeps the bytes that its plan lists: 100 random scenes") {
    for (std::uint32_t seed = 4000; seed < 4100; ++seed) {
        CAPTURE(seed);
        check_bytes(random_plan_scene(seed));
    }
}

#endif
