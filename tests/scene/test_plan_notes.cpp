// What the plan says of a scene beside its passes.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/plan_warnings.hpp"
#include "scene/render/render.hpp"

using namespace kreda;

namespace {

/// A wall before an orthographic camera, in a light from the camera: n . l = n . v = 1, nothing ambient.
std::string facing_wall(const std::string& model) {
    return "[image]\nsize = [8, 8]\n[camera]\nprojection = \"orthographic\"\nheight = 1\nposition = [0, 0, 4]\n"
           "[ambient]\ncolor = [0, 0, 0]\n[[light]]\ndirection = [0, 0, -1]\n[[material]]\nname = "
           "\"wall\"\nmodel = "
           "\"" +
           model +
           "\"\ndiffuse = [0.5, 0.5, 0.5]\nalbedo = [0.5, 0.5, 0.5]\nfresnel = \"none\"\n"
           "[[object]]\nmesh = \"plane\"\nmaterial = \"wall\"\nrotate = [90, 0, 0]\nscale = 10\n";
}

scene::RenderPlan plan_of(const std::string& text) {
    return scene::make_plan(scene::read_scene_text(text, "test", ""));
}

}  // namespace

TEST_CASE("plan: a lamp's light on both kinds of model is noted and on one kind is not") {
    const std::string ball = "[[material]]\nname = \"ball\"\nmodel = \"phong\"\n";
    const std::string seen = ball + "[[object]]\nmesh = \"sphere\"\nscale = 0.2\nmaterial = \"ball\"\n";
    CHECK(plan_of(facing_wall("cook_torrance")).notes.empty());
    CHECK(plan_of(facing_wall("lambert") + seen).notes.empty());
    CHECK(plan_of(facing_wall("cook_torrance") + ball).notes.empty());  // no object is made of it
    CHECK(plan_of(facing_wall("unlit") + seen).notes.empty());
    const scene::RenderPlan plan = plan_of(facing_wall("cook_torrance") + seen);
    REQUIRE(plan.notes.size() == 1);
    CHECK(plan.notes[0].find("\"wall\" is cook_torrance") != std::string::npos);
    CHECK(plan.notes[0].find("\"ball\" reflects diffuse") != std::string::npos);
    CHECK(scene::describe(plan, false).find("note: \"wall\"") != std::string::npos);
}

TEST_CASE("plan: the same number in albedo and in diffuse is pi times as dark in a lamp's light") {
    const auto middle = [](const std::string& model) {
        const scene::Scene scene = scene::read_scene_text(facing_wall(model), "test", "");
        scene::RenderBuffers buffers;
        render(scene, scene::make_plan(scene, {scene::find_view("diffuse")}), buffers);
        return static_cast<double>(buffers.views[0].values[4 * 8 + 4]);
    };
    CHECK(middle("lambert") == doctest::Approx(0.5));
    CHECK(middle("cook_torrance") <= 0.5 / 3.14159265);
    CHECK(middle("cook_torrance") >= 0.95 * 0.5 / 3.14159265);  // less the 4 % that a smooth surface mirrors
}

TEST_CASE("plan: an object that is off is not read and leaves the picture that the scene without it has") {
    const std::string absent =
        "[[material]]\nname = \"jade\"\nmodel = \"phong\"\n[[object]]\nmesh = \"no_such_file.obj\"\nmaterial = "
        "\"jade\"\n"
        "hide = [\"lid\"]\non = ";
    const scene::Scene off = scene::read_scene_text(facing_wall("phong") + absent + "false\n", "test", "");
    const scene::Scene without = scene::read_scene_text(facing_wall("phong"), "test", "");
    CHECK_THROWS_AS((void)scene::read_scene_text(facing_wall("phong") + absent + "true\n", "test", ""),
                    scene::UserError);
    const scene::RenderPlan plan = scene::make_plan(off);
    const std::string text = scene::describe(plan, true);
    CHECK(text.find("object 1 (no_such_file.obj)") != std::string::npos);
    CHECK(text.find("on = false, so its mesh was not read") != std::string::npos);
    CHECK(plan_warnings(off, plan).empty());
    CHECK(plan.passes.size() == scene::make_plan(without).passes.size());
    scene::RenderBuffers with_it, without_it;
    render(off, plan, with_it);
    render(without, scene::make_plan(without), without_it);
    CHECK(with_it.film.values == without_it.film.values);
}
