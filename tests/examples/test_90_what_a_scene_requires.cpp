// 90_what_a_scene_requires: what its picture and page say of the plan.
#include <algorithm>
#include <array>

#include <doctest/doctest.h>

#include "course.hpp"
#include "examples/lit_scene.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

scene::Scene ball(lighting::ReflectionModel model, scene::ShadingFrequency frequency) {
    scene::Scene scene = examples::empty_scene({32, 18});
    scene.image.samples = 1;
    scene.shading.frequency = frequency;
    examples::add_shape(scene, "sphere", 16, glm::vec3(0.0f), examples::shiny(examples::kRed, 40.0f, model));
    scene.lights = {examples::directional_light({-1.0f, -1.0f, -1.0f}), examples::point_light({2.0f, 2.0f, 2.0f})};
    return scene;
}

bool holds(const scene::RenderPlan& plan, const std::string& name) {
    return std::any_of(plan.passes.begin(), plan.passes.end(), [&](const auto& pass) { return pass.name == name; });
}

}  // namespace

TEST_CASE("90_what_a_scene_requires: the picture has a bar where a scene needs a pass and none where it does not") {
    // By hand, from the settings of the five scenes: unlit, flat, Gouraud, Phong in fog, microfacets with a shadow.
    const std::array<const char*, 10> needed = {
        "xxxxx",   // vertices
        "....x",   // shadow map
        "..x..",   // light vertices
        "xxxxx",   // triangles
        ".x...",   // light triangles
        "xxxxx",   // visibility
        "..xxx",   // interpolate: a flat triangle has one colour, an unlit surface too
        "x..xx",   // light pixels: unlit surfaces are "lit" at pixels by their own colour
        "...x.",   // fog at pixels
        "xxxxx"};  // film
    const raster::Image picture = golden("90_what_a_scene_requires/plans.png");
    const int left = 100, column = 44, top = 50, row = 13;
    for (int r = 0; r < 10; ++r) {
        for (int c = 0; c < 5; ++c) {
            CAPTURE(r);
            CAPTURE(c);
            // The third pixel of the cell: within the shortest bar, and right of a dot's core.
            const glm::vec3 color = picture.rgb(left + c * column + 2, top + r * row + row / 2 - 2);
            const bool bar = std::max({color.x, color.y, color.z}) > 0.6f;
            CHECK(bar == (needed[static_cast<std::size_t>(r)][c] == 'x'));
        }
    }
}

TEST_CASE("90_what_a_scene_requires: a pass that was left out would not have changed a bit") {
    using lighting::ReflectionModel;
    const scene::Scene clear = ball(ReflectionModel::phong, scene::ShadingFrequency::phong);
    scene::Scene thin = clear;
    thin.fog.mode = lighting::FogMode::exp;
    thin.fog.density = 0.0f;
    CHECK_FALSE(holds(make_plan(thin), "fog at pixels"));
    CHECK_FALSE(holds(make_plan(clear), "fog at pixels"));
    CHECK(scene::render(thin).values == scene::render(clear).values);

    scene::Scene off = clear, dark = clear;
    off.lights[1].on = false;
    dark.lights[1].intensity = 0.0f;
    CHECK(scene::render(off).values == scene::render(dark).values);
    CHECK(total_operations(make_plan(off)) == total_operations(make_plan(dark)));
    CHECK(total_operations(make_plan(off)) < total_operations(make_plan(clear)));
}

TEST_CASE("90_what_a_scene_requires: pruned and not pruned the picture is the same") {
    const raster::Image picture = golden("90_what_a_scene_requires/pruned.png");
    int differ = 0;
    for (int y = 0; y < 136; ++y) {
        for (int x = 2; x < 158; ++x) differ += picture.rgb(x, y) != picture.rgb(x + 160, y) ? 1 : 0;
    }
    CHECK(differ == 0);
}

TEST_CASE("90_what_a_scene_requires: light is computed in one place only") {
    using lighting::ReflectionModel;
    using scene::ShadingFrequency;
    for (const ShadingFrequency frequency :
         {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong}) {
        const scene::RenderPlan plan = make_plan(ball(ReflectionModel::phong, frequency));
        CHECK(holds(plan, "light triangles") == (frequency == ShadingFrequency::flat));
        CHECK(holds(plan, "light vertices") == (frequency == ShadingFrequency::gouraud));
        CHECK(holds(plan, "light pixels") == (frequency == ShadingFrequency::phong));
    }
}

TEST_CASE("90_what_a_scene_requires: the numbers of the page") {
    // As the function is written: n.l 6, m_D 3, r 5 + 1 + 3 + 3, v.r 6, the power 60, facing the light 6, m_S 1 + 3,
    // and s times both, added to the sums: 12.
    const double by_hand = 6 + 3 + 12 + 6 + 60 + 6 + 4 + 12;
    lighting::Material phong;
    phong.model = lighting::ReflectionModel::phong;
    CHECK(scene::reflection_operations(phong) == by_hand);
    CHECK(documented_number("90_what_a_scene_requires", "phong") == by_hand);
    // Blinn's h instead of r: l + v 3, its unit vector 11, n.h 6. The same everywhere: n.h alone.
    lighting::Material blinn;
    blinn.model = lighting::ReflectionModel::blinn_phong;
    CHECK(scene::reflection_operations(blinn) == by_hand - (12 + 6) + (3 + 11 + 6));
    CHECK(scene::reflection_operations(blinn, true) == by_hand - (12 + 6) + 6);
    CHECK(320 * 180 * 3 * 4 == documented_number("90_what_a_scene_requires", "film"));
}

TEST_CASE("90_what_a_scene_requires: the estimate grows with lights and samples and dearer models as it must") {
    using lighting::ReflectionModel;
    using scene::ShadingFrequency;
    const auto light_pixels = [](const scene::Scene& scene) { return operations_of(make_plan(scene), "light pixels"); };
    scene::Scene one = ball(ReflectionModel::phong, ShadingFrequency::phong);
    one.lights.resize(1);
    scene::Scene two = one, three = one, four_samples = one;
    two.lights.resize(2, one.lights[0]);
    three.lights.resize(3, one.lights[0]);
    four_samples.image.samples = 2;
    CHECK(light_pixels(three) - light_pixels(two) == doctest::Approx(light_pixels(two) - light_pixels(one)));
    CHECK(light_pixels(four_samples) == doctest::Approx(4.0 * light_pixels(one)));
    CHECK(light_pixels(ball(ReflectionModel::lambert, ShadingFrequency::phong)) <
          light_pixels(ball(ReflectionModel::phong, ShadingFrequency::phong)));
    CHECK(light_pixels(ball(ReflectionModel::unlit, ShadingFrequency::phong)) <
          light_pixels(ball(ReflectionModel::lambert, ShadingFrequency::phong)));
}
