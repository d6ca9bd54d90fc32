// Every method of finding shadows in a whole picture, against rays; and what a scene file may and may not ask of them.
#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

/// A floor, a ball and a pot; a lamp and the sun. `more` is appended.
std::string room(const std::string& method, const std::string& more = "") {
    return "[image]\nsize = [150, 100]\n[camera]\nposition = [0.5, 2, 4]\ntarget = [0, 0.2, 0]\n"
           "[[light]]\nshadow = true\ntype = \"point\"\nposition = [1.5, 3, 1]\n"
           "[[light]]\nshadow = true\ndirection = [-1, -2, 0.3]\n"
           "[shadow]\nmethod = \"" +
           method +
           "\"\n"
           "[[object]]\nmesh = \"plane\"\nscale = 4\n"
           "[[object]]\nmesh = \"sphere\"\nscale = 0.5\ntranslate = [0.9, 0.6, 0.2]\n"
           "[[object]]\nmesh = \"torus\"\nscale = 0.7\ntranslate = [-0.7, 0.8, 0]\nrotate = [50, 0, 0]\n" +
           more;
}

struct ShadowedPicture {
    raster::Image film, shadow, position;
};

ShadowedPicture draw_shadowed(const Scene& scene, int threads = 0) {
    RenderBuffers buffers;
    const RenderPlan plan = make_plan(scene, {find_view("shadow"), find_view("position")});
    render(scene, plan, buffers, threads);
    return {buffers.film, buffers.views[0], buffers.views[1]};
}

ShadowedPicture draw_shadowed(const std::string& text, int threads = 0) {
    return draw_shadowed(read_scene_text(text, "test", ""), threads);
}

/// How many pixels differ between two pictures of the shadow factor; `counts` says which are looked at.
template <class Counts>
int different(const ShadowedPicture& a, const ShadowedPicture& b, Counts counts) {
    int count = 0;
    for (int y = 0; y < a.shadow.height; ++y) {
        for (int x = 0; x < a.shadow.width; ++x) {
            count += counts(a.position.rgb(x, y)) && a.shadow.at(0, x, y) != b.shadow.at(0, x, y);
        }
    }
    return count;
}

std::string refusal_of(const std::string& text) {
    try {
        static_cast<void>(read_scene_text(text, "test", ""));
    } catch (const UserError& error) { return error.what(); }
    return "";
}

}  // namespace

TEST_CASE("shadow methods: volume and irregular draw the picture that rays draw") {
    const ShadowedPicture exact = draw_shadowed(room("exact"));
    const auto everywhere = [](const glm::vec3&) { return true; };
    CHECK(different(exact, draw_shadowed(room("irregular")), everywhere) == 0);
    CHECK(draw_shadowed(room("irregular")).film.values == exact.film.values);
    CHECK(different(exact, draw_shadowed(room("volume")), everywhere) <= 3);  // of 15000, each next to an edge
    const auto dark = std::count(exact.shadow.values.begin(), exact.shadow.values.end(), 0.0f);
    CHECK(dark > 1000);
}

TEST_CASE("shadow methods: planar agrees with rays on the floor and shadows nothing else") {
    const ShadowedPicture exact = draw_shadowed(room("exact")), planar = draw_shadowed(room("planar"));
    CHECK(different(exact, planar, [](const glm::vec3& p) { return p.y == 0.0f; }) <= 5);  // next to edges
    ShadowedPicture lit = planar;
    std::fill(lit.shadow.values.begin(), lit.shadow.values.end(), 1.0f);
    CHECK(different(lit, planar, [](const glm::vec3& p) { return p.y > 0.01f; }) == 0);
    CHECK(different(lit, planar, [](const glm::vec3& p) { return p.y == 0.0f; }) > 1000);
}

TEST_CASE("shadow methods: the same bits with one thread and with four") {
    for (const std::string method : {"planar", "volume", "irregular", "exact"}) {
        CAPTURE(method);
        CHECK(draw_shadowed(room(method), 1).film.values == draw_shadowed(room(method), 4).film.values);
    }
}

TEST_CASE("shadow methods: supersampled pictures are the mean of the samples' shadows") {
    for (const std::string method : {"volume", "irregular"}) {
        Scene scene = read_scene_text(room(method), "test", "");
        scene.image.samples = 3;
        Scene exact = scene;
        exact.shadow.method = shadows::ShadowMethod::exact;
        const ShadowedPicture a = draw_shadowed(scene), b = draw_shadowed(exact);
        CAPTURE(method);
        CHECK(different(a, b, [](const glm::vec3&) { return true; }) <= 12);  // of 135000 samples
    }
}

TEST_CASE("shadow methods: what casts no shadow and what is hidden does not") {
    for (const std::string method : {"planar", "volume", "irregular", "exact"}) {
        Scene scene = read_scene_text(room(method), "test", "");
        scene.objects[1].part_hidden.assign(scene.objects[1].part_hidden.size(), true);
        scene.objects[2].casts_shadow = false;
        RenderBuffers buffers;
        const RenderPlan plan = make_plan(scene);
        render(scene, plan, buffers);
        Scene unshadowed = scene;
        for (lighting::Light& light : unshadowed.lights) light.shadow = false;
        CAPTURE(method);
        CHECK(buffers.film.values == render(unshadowed).values);
    }
}

TEST_CASE("shadow methods: rays answer at vertices and centroids - the others say that they cannot") {
    for (const std::string frequency : {"gouraud", "flat"}) {
        const std::string shading = "[shading]\nfrequency = \"" + frequency + "\"\n";
        const Scene shadowed = read_scene_text(shading + room("exact"), "test", "");
        Scene unshadowed = shadowed;
        for (lighting::Light& light : unshadowed.lights) light.shadow = false;
        CHECK(render(shadowed).values != render(unshadowed).values);
        for (const std::string method : {"planar", "volume", "irregular"}) {
            const std::string message = refusal_of(shading + room(method));
            CAPTURE(message);
            CHECK(message.starts_with("test:16:10: shadow.method = \"" + method + "\" finds shadows at the pixels"));
            CHECK(message.find("\"exact\"") != std::string::npos);
        }
    }
}

TEST_CASE("shadow methods: open casters of volumes and planar shadows without a plane are warned about") {
    const std::string pot = "[[object]]\nmesh = \"teapot\"\n";
    const std::vector<std::string> open = read_scene_text(room("volume", pot), "test", "").warnings;
    REQUIRE(open.size() == 1);
    CHECK(open[0].starts_with("test: object 3 (teapot) is not closed"));
    CHECK(read_scene_text(room("volume"), "test", "").warnings.empty());
    CHECK(read_scene_text(room("exact", pot), "test", "").warnings.empty());
    const std::string ball = "[[light]]\nshadow = true\n[shadow]\nmethod = \"planar\"\n[[object]]\nmesh = \"sphere\"\n";
    const std::vector<std::string> no_plane = read_scene_text(ball, "test", "").warnings;
    REQUIRE(no_plane.size() == 1);
    CHECK(no_plane[0].find("no object is flat") != std::string::npos);
}

TEST_CASE("shadow methods: the plan names the method and what it keeps") {
    for (const auto& [method, pass] : {std::pair{"exact", "shadow rays of light 0"},
                                       {"planar", "planar shadow of light 0"},
                                       {"volume", "shadow volumes of light 0"},
                                       {"irregular", "irregular z-buffer of light 0"}}) {
        const std::string method_name = method, pass_name = pass;
        const RenderPlan plan = make_plan(read_scene_text(room(method), "test", ""));
        const auto is_it = [&](const PlannedPass& planned) { return planned.name == pass_name; };
        CAPTURE(method_name);
        CHECK(std::any_of(plan.passes.begin(), plan.passes.end(), is_it));
    }
}

TEST_CASE("shadow methods: the plan says what each costs and more for more casters and wider filters") {
    const auto cost = [](const std::string& method, const std::string& more = "") {
        const RenderPlan plan = make_plan(read_scene_text(room(method, more), "test", ""));
        CHECK(describe(plan, false).find("without an estimate") == std::string::npos);
        return total_operations(plan);
    };
    const std::string ball = "[[object]]\nmesh = \"sphere\"\nscale = 0.2\ntranslate = [0, 1, 1]\n";
    const std::string unseen = "casts_shadow = false\n";
    for (const std::string method : {"map", "exact", "planar", "volume", "irregular"}) {
        CAPTURE(method);
        CHECK(cost(method) > 0.0);
        const double with = cost(method, ball), without = cost(method, ball + unseen);
        if (method != "map") CHECK(with > without);  // a map is as large whatever it shows
    }
    const auto light_pixels = [](const std::string& filter) {
        Scene scene = read_scene_text(room("map"), "test", "");
        scene.shadow.filter = filter == "pcf" ? shadows::ShadowFilter::pcf : shadows::ShadowFilter::pcss;
        scene.shadow.radius = filter == "pcf" ? 1 : 0;
        return total_operations(make_plan(scene));
    };
    CHECK(cost("map") < light_pixels("pcf"));
    CHECK(light_pixels("pcf") < light_pixels("pcss"));
}
