// Frames that follow each other: what is kept of the frame before changes no bit of the next, whatever was edited.
#include <array>
#include <random>

#include <doctest/doctest.h>

#include "scene/plan/pass_inputs.hpp"
#include "scene/render/render.hpp"
#include "scene/render/shadow_pass.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Edits a scene: one thing becomes what another scene has, or is turned on or off.
class Editor {
public:
    explicit Editor(std::uint32_t seed) : random_(seed) {}

    void edit(scene::Scene& scene) {
        const scene::Scene other = random_plan_scene(random_());
        switch (below(10)) {
            case 0: scene.camera = other.camera; break;
            case 1: scene.shadow = other.shadow; break;
            case 2: scene.lights = other.lights; break;
            case 3: edit_light(scene); break;
            case 4: scene.environment = other.environment; break;
            case 5: scene.shading.cull = other.shading.cull; break;
            case 6: scene.fog = other.fog; break;
            case 7: scene.image = other.image; break;
            default: edit_object(scene);
        }
        // Only frames that are lit point by point know every method of shadows.
        if (scene.shading.frequency != scene::ShadingFrequency::phong && is_frame_by_frame(scene.shadow.method)) {
            scene.shadow.method = shadows::ShadowMethod::map;
        }
        if (!scene.environment.on) scene.image.environment_background = false;
    }

private:
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }

    void edit_light(scene::Scene& scene) {
        if (scene.lights.empty()) return;
        lighting::Light& light = scene.lights[below(scene.lights.size())];
        switch (below(4)) {
            case 0: light.on = !light.on; break;
            case 1: light.shadow = !light.shadow; break;
            case 2: light.color = glm::vec3(0.5f, 1.0f, 0.25f) * light.color; break;
            default: light.position += glm::vec3(0.1f, 0.0f, -0.2f);
        }
    }

    void edit_object(scene::Scene& scene) {
        if (scene.objects.empty()) return;
        scene::Object& object = scene.objects[below(scene.objects.size())];
        switch (below(4)) {
            case 0: object.casts_shadow = !object.casts_shadow; break;
            case 1: object.world_from_object[3] += glm::vec4(0.25f, 0.0f, 0.125f, 0.0f); break;
            case 2: object.part_hidden.assign(object.mesh->parts.size(), below(2) == 0); break;
            default: object.mesh = std::make_shared<raster::Mesh>(*object.mesh);
        }
    }

    std::mt19937 random_;
};

raster::Image drawn_anew(const scene::Scene& scene) {
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene), buffers, 1);
    return buffers.film;
}

/// One caster over a ground, one lamp.
scene::Scene simple_scene() {
    for (std::uint32_t seed = 0;; ++seed) {
        scene::Scene scene = random_plan_scene(seed);
        scene.shadow = {};
        if (!make_plan(scene).shadows.empty()) return scene;
    }
}

}  // namespace

TEST_CASE("kept frames: after any edit, and back again, a frame is what it is when it is drawn anew") {
    int kept = 0;
    for (std::uint32_t seed = 0; seed < 25; ++seed) {
        CAPTURE(seed);
        Editor editor(1000 + seed);
        scene::Scene scene = random_plan_scene(seed);
        for (lighting::Light& light : scene.lights) light.on = light.shadow = true;
        if (seed % 3 > 0)
            scene.shadow.method = seed % 3 == 1 ? shadows::ShadowMethod::map : shadows::ShadowMethod::exact;
        scene::RenderBuffers buffers;
        buffers.keeps_results = true;
        std::vector<std::string> before;
        for (int i = 0; i < 10; ++i) {
            const scene::Scene last = scene;
            if (i > 0) editor.edit(scene);
            for (const scene::Scene* now : std::array<const scene::Scene*, 3>{&scene, &last, &scene}) {
                const scene::RenderPlan plan = make_plan(*now);
                render(*now, plan, buffers, 1);
                const raster::Image expected = drawn_anew(*now);
                REQUIRE(buffers.film.values.size() == expected.values.size());
                CHECK(buffers.film.values == expected.values);
                std::vector<std::string> inputs;
                for (const scene::PlannedPass& pass : plan.passes) {
                    if (!pass.inputs.empty()) inputs.push_back(pass.inputs);
                }
                kept += !inputs.empty() && inputs == before ? 1 : 0;
                before = inputs;
            }
        }
    }
    CHECK(kept > 50);  // otherwise nothing was put to the test
}

TEST_CASE("kept frames: a shadow map is drawn again when its inputs change, and only then") {
    scene::Scene scene = simple_scene();
    scene::RenderBuffers buffers;
    buffers.keeps_results = true;
    render(scene, make_plan(scene), buffers, 1);
    buffers.shadows[0].map.distance[0] = -7.0f;  // a mark that drawing wipes away
    const auto is_kept = [&] {
        render(scene, make_plan(scene), buffers, 1);
        return !buffers.shadows.empty() && buffers.shadows[0].map.distance[0] == -7.0f;
    };
    CHECK(is_kept());
    scene.ambient *= 2.0f;
    scene.lights[0].intensity *= 0.5f;
    CHECK(is_kept());
    scene.shadow.size *= 2;
    CHECK_FALSE(is_kept());
}

TEST_CASE("kept frames: every single thing that a shadow is made from is among its inputs") {
    const scene::Scene scene = simple_scene();
    const scene::PlannedShadow shadow = make_plan(scene).shadows[0];
    const std::string inputs = shadow_inputs(scene, shadow);
    CHECK(shadow_inputs(scene::Scene(scene), shadow) == inputs);
    using Change = void (*)(scene::Object&, scene::PlannedShadow&);
    const Change changes[] = {
        [](scene::Object& o, scene::PlannedShadow&) { o.world_from_object[3].x += 1.0f; },
        [](scene::Object& o, scene::PlannedShadow&) { o.mesh = std::make_shared<raster::Mesh>(*o.mesh); },
        [](scene::Object& o, scene::PlannedShadow&) { o.part_hidden.assign(o.mesh->parts.size(), true); },
        [](scene::Object&, scene::PlannedShadow& s) { s.casters.push_back(s.casters[0]); },
        [](scene::Object&, scene::PlannedShadow& s) { s.source.kind = shadows::LightKind(2 - int(s.source.kind)); },
        [](scene::Object&, scene::PlannedShadow& s) { s.source.direction.x += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.source.position.x += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.source.outer_cone_deg += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views.push_back(s.map.views[0]); },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].view_from_world[1].y += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].origin.z += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].perspective ^= true; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].half_size.y += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].near += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.views[0].far += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.method = shadows::ShadowMethod::exact; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.size += 1; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.filter = shadows::ShadowFilter::pcss; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.radius += 1; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.light_size += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.bias = shadows::ShadowBias::none; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.constant_bias += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.slope_bias += 0.5f; },
        [](scene::Object&, scene::PlannedShadow& s) { s.map.settings.cull = raster::CullMode::front; },
    };
    int number = 0;
    for (const Change change : changes) {
        CAPTURE(number++);
        scene::Scene other = scene;
        scene::PlannedShadow planned = shadow;
        change(other.objects[static_cast<std::size_t>(planned.casters[0])], planned);
        CHECK(shadow_inputs(other, planned) != inputs);
    }
}
