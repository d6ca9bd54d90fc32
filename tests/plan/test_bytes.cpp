// Bytes as promised: what a frame keeps is what the plan lists, pass by pass. The sanitizers count memory themselves.
#if !defined(KREDA_SANITIZED)

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "raster/shapes.hpp"
#include "scene/render/render.hpp"
#include "tests/plan/bytes_by_pass.hpp"
#include "tests/plan/counted_memory.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

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

bool is_for_a_while(const scene::PlannedBuffer& buffer) {
    return buffer.name.find(", while ") != std::string::npos;
}

bool is_bound(const scene::PlannedBuffer& buffer) {
    return buffer.name.find(", at most") != std::string::npos;
}

/// Textures were there before the frame: the scene holds them.
bool is_of_scene(const scene::PlannedPass& pass, const scene::PlannedBuffer& buffer) {
    return pass.name.starts_with("maps of ") && buffer.name.find(", a thread") == std::string::npos;
}

/// The bytes of a pass's buffers that are counted with it.
struct ListedBytes {
    std::int64_t kept = 0, bound = 0, for_a_while = 0;
};

ListedBytes listed_bytes(const scene::PlannedPass& pass) {
    ListedBytes listed;
    for (const scene::PlannedBuffer& buffer : pass.buffers) {
        if (is_of_scene(pass, buffer)) continue;
        std::int64_t& sum = is_for_a_while(buffer) ? listed.for_a_while : is_bound(buffer) ? listed.bound : listed.kept;
        sum += static_cast<std::int64_t>(buffer.bytes);
    }
    return listed;
}

/// 5 % or 64 KB, as the plan promises.
std::int64_t slack(std::int64_t bytes) {
    return std::max<std::int64_t>(65536, bytes / 20);
}

/// Every pass keeps what it lists; nothing is kept that no pass lists; and what is in use at once never exceeds what is
/// listed.
void check_bytes(const scene::Scene& scene, const scene::PlanRequest& request = {}) {
    const scene::RenderPlan plan = make_plan_for(scene, request);
    const std::string text = describe(plan, false);
    CAPTURE(text);
    const std::int64_t before = bytes_in_use();
    scene::RenderBuffers buffers;
    (void)most_bytes_since();
    render(scene, plan, buffers, 1);
    const std::int64_t most = most_bytes_since() - before;
    const std::vector<std::int64_t> kept = give_back_by_pass(plan, buffers);
    std::int64_t all = 0;
    for (std::size_t p = 0; p < kept.size(); ++p) {
        const ListedBytes listed = listed_bytes(plan.passes[p]);
        CAPTURE(plan.passes[p].name);
        CHECK(kept[p] >= listed.kept - slack(listed.kept));
        CHECK(kept[p] <= listed.kept + listed.bound + slack(listed.kept + listed.bound));
        all += listed.kept + listed.bound + listed.for_a_while;
    }
    CHECK(most <= all + slack(all));
    CHECK(bytes_in_use() - before <= slack(0));
}

}  // namespace

TEST_CASE("a frame keeps the bytes that its plan lists: where each pass in turn needs most of them") {
    using scene::ShadingFrequency;
    for (const ShadingFrequency frequency :
         {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong}) {
        check_bytes(scene_of("sphere", 300, frequency));  // vertices, triangles
        check_bytes(scene_of("cube", 1, frequency));      // film and one thread's memory
    }
    scene::Scene fog = scene_of("sphere", 200, ShadingFrequency::phong);
    fog.fog.mode = lighting::FogMode::exp;
    fog.fog.frequency = lighting::FogFrequency::vertex;
    check_bytes(fog);
}

TEST_CASE("a shadow takes the bytes that its plan lists: few casters and many") {
    using shadows::ShadowMethod;
    for (const int detail : {12, 150}) {
        CAPTURE(detail);
        scene::Scene scene = scene_of("torus", detail, scene::ShadingFrequency::phong);
        scene.shading.cull = raster::CullMode::none;
        scene.lights[0].shadow = true;
        for (const ShadowMethod method :
             {ShadowMethod::map, ShadowMethod::exact, ShadowMethod::volume, ShadowMethod::irregular}) {
            CAPTURE(static_cast<int>(method));
            scene.shadow.method = method;
            check_bytes(scene);
        }
    }
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
