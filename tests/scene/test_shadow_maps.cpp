// Shadow maps in a whole picture: a square that hovers over a floor casts a shadow whose edges are known by hand.
#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

/// A floor of half side 4 at height 0 and a square of half side 0.5 at height 1, seen from above.
Scene square_over_floor(const std::string& light, const std::string& more = "") {
    return read_scene_text(
        "[image]\nsize = [160, 120]\n[camera]\nposition = [0.3, 6, 5]\ntarget = [0, 0, 0]\n[[light]]\nshadow = true\n" +
            light +
            "\n[[object]]\nmesh = \"plane\"\nscale = 4\n"
            "[[object]]\nmesh = \"plane\"\nscale = 0.5\ntranslate = [0, 1, 0]\n" +
            more,
        "test", "");
}

struct ShadowPictures {
    raster::Image position, shadow;
};

ShadowPictures draw_with_shadow(const Scene& scene) {
    RenderBuffers buffers;
    const RenderPlan plan = make_plan(scene, {find_view("position"), find_view("shadow")});
    REQUIRE(plan.shadows.size() == 1);
    render(scene, plan, buffers);
    return {buffers.views[0], buffers.views[1]};
}

/// How far p, on the floor, is inside the shadow of the square; negative: outside.
float depth_in_shadow(const lighting::Light& light, const glm::vec3& p) {
    const glm::vec3 to_light = light.type == lighting::LightType::directional ? -light.direction : light.position - p;
    const glm::vec3 hit = p + to_light * (1.0f / to_light.y);  // at height 1
    return 0.5f - std::max(std::abs(hit.x), std::abs(hit.z));
}

/// Misclassified points farther than `tolerance` from the shadow's edge.
int wrong_points(const Scene& scene, float tolerance) {
    const ShadowPictures pictures = draw_with_shadow(scene);
    int wrong = 0, in_shadow = 0;
    for (int y = 0; y < pictures.shadow.height; ++y) {
        for (int x = 0; x < pictures.shadow.width; ++x) {
            const glm::vec3 p = pictures.position.rgb(x, y);
            if (p == glm::vec3(0.0f)) continue;  // background
            const float inside = p.y > 0.5f ? -1.0f : depth_in_shadow(scene.lights[0], p);
            if (std::abs(inside) < tolerance) continue;
            in_shadow += inside > 0.0f;
            wrong += pictures.shadow.at(0, x, y) != (inside > 0.0f ? 0.0f : 1.0f);
        }
    }
    CHECK(in_shadow > 100);
    return wrong;
}

const std::string kSun = "direction = [-0.7, -1, 0.4]";
const std::string kSpot = "type = \"spot\"\nposition = [0.5, 3, 0.8]\ndirection = [-0.15, -1, -0.25]\ncone = [40, 55]";
const std::string kLamp = "type = \"point\"\nposition = [0.5, 2.5, 0.8]";

}  // namespace

TEST_CASE("shadow map: a square's shadow lies where the rays put it for every kind of light") {
    for (const std::string& light : {kSun, kSpot, kLamp}) {
        for (const std::string bias : {"slope", "normal_offset"}) {
            CAPTURE(light);
            CAPTURE(bias);
            // 1024 texels over at most 8 units and the tangents' stretch: a texel is 0.02 on the floor at most.
            CHECK(wrong_points(square_over_floor(light, "[shadow]\nbias = \"" + bias + "\"\n"), 0.04f) == 0);
        }
    }
}

TEST_CASE("shadow map: a filter blurs the edge and nothing else") {
    const std::string pcf = "[shadow]\nfilter = \"pcf\"\nradius = 3\n";
    for (const std::string& light : {kSun, kSpot, kLamp}) {
        CAPTURE(light);
        CHECK(wrong_points(square_over_floor(light, pcf), 0.1f) == 0);
    }
}

TEST_CASE("shadow map: light from below the floor is stopped by the floor") {
    Scene scene = square_over_floor("direction = [0.2, 1, 0.1]");
    const ShadowPictures pictures = draw_with_shadow(scene);
    for (int y = 0; y < pictures.shadow.height; ++y) {
        for (int x = 0; x < pictures.shadow.width; ++x) {
            const glm::vec3 p = pictures.position.rgb(x, y);
            if (p.y > 0.5f) CHECK(pictures.shadow.at(0, x, y) == 0.0f);
        }
    }
}

TEST_CASE("shadow map: a caster outside the view casts into it") {
    // The square hovers behind the camera's back, and its shadow falls before the camera.
    const std::string scene =
        "[image]\nsize = [80, 60]\n[camera]\nposition = [0, 1, 0]\ntarget = [0, 0, -3]\n[[light]]\nshadow = true\n"
        "direction = [0, -1, -2]\n[[object]]\nmesh = \"plane\"\nscale = 8\n"
        "[[object]]\nmesh = \"plane\"\nscale = 0.5\ntranslate = [0, 3, 3]\n";
    const ShadowPictures pictures = draw_with_shadow(read_scene_text(scene, "test", ""));
    int dark = 0;
    for (std::size_t i = 0; i < pictures.shadow.plane_size(); ++i) {
        const glm::vec3 p(pictures.position.plane(0)[i], pictures.position.plane(1)[i], pictures.position.plane(2)[i]);
        if (p == glm::vec3(0.0f)) continue;
        const bool inside = std::abs(p.x) < 0.48f && std::abs(p.z + 3.0f) < 0.48f;
        dark += inside;
        if (inside) CHECK(pictures.shadow.plane(0)[i] == 0.0f);
    }
    CHECK(dark > 50);
}

TEST_CASE("shadow map: hard cases are finite and either lit or dark or between") {
    const std::string odd_lights[] = {
        "type = \"point\"\nposition = [0, 0.5, 0]",   // between square and floor: inside the scene
        "type = \"point\"\nposition = [0, 1, 0]",     // on the square itself
        "type = \"point\"\nposition = [0, -2, 0]",    // below the ground
        "type = \"point\"\nposition = [0.6, 9, 10]",  // behind the camera
        "type = \"spot\"\nposition = [0.6, 9, 10]\ndirection = [0, -1, -1]",
        "type = \"spot\"\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\ncone = [80, 90]",
        "type = \"spot\"\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\ncone = [0, 0.01]",
        "direction = [1, 0, 0]",  // along the floor
        "direction = [0, -1, 0]"};
    for (const std::string& light : odd_lights) {
        for (const std::string shadow :
             {"size = 1", "size = 1\nfilter = \"pcf\"\nradius = 2", "size = 1\nfilter = \"pcss\"",
              "size = 77\nfilter = \"pcss\"\nlight_size = 3", "size = 3\nbias = \"normal_offset\""}) {
            CAPTURE(light);
            CAPTURE(shadow);
            const Scene scene = square_over_floor(light, "[shadow]\n" + shadow + "\n");
            RenderBuffers buffers;
            render(scene, make_plan(scene, {find_view("shadow"), find_view("penumbra"), find_view("blocker_distance")}),
                   buffers);
            CHECK(count_non_finite(buffers.film) == 0);
            CHECK(count_non_finite(buffers.views[1]) == 0);
            CHECK(count_non_finite(buffers.views[2]) == 0);
            const auto& shadows = buffers.views[0].values;
            CHECK(std::all_of(shadows.begin(), shadows.end(), [](float s) { return s >= 0.0f && s <= 1.0f; }));
        }
    }
}

TEST_CASE("shadow plan: only what can cast onto something seen is drawn from the light") {
    const auto plan_of = [](const std::string& light, const std::string& more) {
        return make_plan(square_over_floor(light, more));
    };
    // A floor lies before nothing; the square casts onto it.
    const RenderPlan sun = plan_of(kSun, "");
    REQUIRE(sun.shadows.size() == 1);
    CHECK(sun.shadows[0].casters == std::vector<int>{1});
    CHECK(sun.shadows[0].map.views.size() == 1);
    CHECK(plan_of(kLamp, "").shadows.at(0).map.views.size() == 6);
    // From below no light comes to what is seen from above, and no shadow is asked for.
    CHECK(plan_of("direction = [0, 1, 0]", "").shadows.empty());
    // A square that casts nothing leaves nothing to be drawn.
    const RenderPlan none = plan_of(kSun, "casts_shadow = false\n");
    CHECK(none.shadows.empty());
    CHECK(describe(none, true).find("nothing can cast onto what is seen") != std::string::npos);
}

TEST_CASE("shadow plan: a light without shadow = true makes no map and needs no normal of the triangle") {
    Scene scene = square_over_floor(kSun);
    scene.lights[0].shadow = false;
    const RenderPlan plan = make_plan(scene);
    CHECK(plan.shadows.empty());
    CHECK_FALSE(plan.fragment.face_normal);
    CHECK(describe(plan, false).find("shadow") == std::string::npos);
}

TEST_CASE("shadow map: vertices and centroids ask the same map as pixels") {
    // The square casts onto a floor of 64 x 64 quads; a vertex or centroid deep inside the shadow is as dark as it is
    // where the light does not exist.
    for (const char* frequency : {"gouraud", "flat"}) {
        CAPTURE(frequency);
        const auto picture = [&](bool on) {
            Scene scene = read_scene_text(
                "[image]\nsize = [160, 120]\n[camera]\nposition = [0.3, 6, 5]\ntarget = [0, 0, "
                "0]\n[shading]\nfrequency = \"" +
                    std::string(frequency) +
                    "\"\n[[light]]\nshadow = true\ndirection = [-0.7, -1, 0.4]\n[[object]]\nmesh = \"plane\"\ndetail = "
                    "64\n"
                    "scale = 4\n[[object]]\nmesh = \"plane\"\nscale = 0.5\ntranslate = [0, 1, 0]\n",
                "test", "");
            scene.lights[0].on = on;
            RenderBuffers buffers;
            render(scene, make_plan(scene, {find_view("position")}), buffers);
            return std::pair{buffers.film, buffers.views[0]};
        };
        const auto [lit, position] = picture(true);
        const raster::Image unlit = picture(false).first;
        lighting::Light light;
        light.direction = {-0.7f, -1.0f, 0.4f};
        int dark = 0, bright = 0;
        for (int y = 0; y < lit.height; ++y) {
            for (int x = 0; x < lit.width; ++x) {
                const glm::vec3 p = position.rgb(x, y);
                if (p == glm::vec3(0.0f) || p.y > 0.5f) continue;
                const float inside = depth_in_shadow(light, p);
                if (std::abs(inside) < 0.2f) continue;  // a quad is 0.125 wide
                CHECK((lit.rgb(x, y) == unlit.rgb(x, y)) == (inside > 0.0f));
                (inside > 0.0f ? dark : bright) += 1;
            }
        }
        CHECK(dark > 20);
        CHECK(bright > 1000);
    }
}
