// Warnings about pictures that are empty, and about shadow maps that are too wide for what casts.
#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda::scene;

namespace {

std::vector<std::string> view_warnings_of(const std::string& text) {
    return read_scene_text(text, "s.toml", "").warnings;
}

bool warns(const std::string& text, const std::string& part) {
    const std::vector<std::string> warnings = view_warnings_of(text);
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

std::string ball_seen_from(const std::string& camera) {
    return "[camera]\n" + camera + "[[object]]\nmesh = 'sphere'\ntranslate = [3, 0, -1]\n";
}

/// A unit ball, half of it beneath the ground, and a low sun.
std::string sunk_ball(double ground, const std::string& of_ground = "", const std::string& more = "") {
    return "[camera]\nposition = [0, 3, 8]\nfar = 4000\n[[light]]\ntype = 'directional'\ndirection = [1, -0.2, 0]\n"
           "shadow = true\n" +
           more + "[[object]]\nmesh = 'sphere'\n[[object]]\nmesh = 'plane'\nscale = " + std::to_string(ground) + "\n" +
           of_ground;
}

}  // namespace

TEST_CASE("view warnings: what lies beside the picture is said, with the way to look at it") {
    const std::string beside =
        "everything lies beside what the camera sees: the picture is empty; its middle is at "
        "camera.target = [3, 0, -1]";
    for (const char* target : {"[0, 0, 0]", "[0, 5, 1]", "[-5, 0, -5]"}) {
        const std::string scene =
            ball_seen_from("position = [0, 0, 5]\nvertical_fov = 10\ntarget = " + std::string(target) + "\n");
        CAPTURE(scene);
        CHECK(warns(scene, beside));
    }
    CHECK(view_warnings_of(ball_seen_from("position = [0, 0, 5]\nvertical_fov = 10\ntarget = [3, 0, -1]\n"))
              .empty());  // as advised
    CHECK(view_warnings_of(ball_seen_from("position = [0, 0, 5]\nvertical_fov = 40\ntarget = [0, 0, -1]\n")).empty());
    CHECK(view_warnings_of(ball_seen_from("position = [3, 0, -1]\ntarget = [4, 0, 0]\n")).empty());  // from within
    const std::string orthographic = "position = [0, 0, 5]\ntarget = [0, 0, 0]\nprojection = 'orthographic'\nheight = ";
    CHECK(warns(ball_seen_from(orthographic + "2\n"), beside));
    CHECK(view_warnings_of(ball_seen_from(orthographic + "4\n")).empty());  // 16 : 9 of 4 reaches to x = 3.6
}

TEST_CASE("shadow warnings: a wide ground that casts leaves a few texels for the ball on it") {
    const std::string wide =
        "the shadow map of light 0 must hold all of object 1 (plane), in whose shadow something lies; "
        "the shadow of object 0 (sphere) is ";
    CHECK(warns(sunk_ball(2000), wide));
    CHECK_FALSE(warns(sunk_ball(10), wide));                                // a ball of 2 in a map of 20 or so
    CHECK_FALSE(warns(sunk_ball(2000, "casts_shadow = false\n"), wide));    // as advised
    CHECK_FALSE(warns(sunk_ball(2000, "translate = [0, -1, 0]\n"), wide));  // the ball stands on it
    CHECK_FALSE(warns(sunk_ball(2000, "", "[shadow]\nmethod = 'exact'\n"), wide));
}
