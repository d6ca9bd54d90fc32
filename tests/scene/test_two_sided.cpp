// Surfaces seen from behind take the light of the side that is seen.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <doctest/doctest.h>

#include "raster/tangents.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "scene/sides.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

const std::string kTurnedModels[] = {"lambert", "phong", "blinn_phong", "ward", "heidrich_seidel", "cook_torrance"};
const std::string kFrequencies[] = {"flat", "gouraud", "phong"};

/// A square whose front looks up (+y), seen from below: a red lamp on the camera's side, a green one behind.
Scene square(const std::string& model, const std::string& shading, const std::string& more = "",
             const std::string& object = "") {
    const std::string shadow = more.empty() ? "" : "shadow = true\n";
    return read_scene_text(
        "[image]\nsize = [32, 32]\n[camera]\nposition = [0.2, -3, 0.4]\nup = [0, 0, 1]\n[ambient]\n"
        "color = [0, 0, 0]\n[shading]\n" +
            shading + "[[light]]\ntype = \"point\"\nposition = [0.5, -4, 0.3]\ncolor = [1, 0, 0]\n" + shadow +
            "[[light]]\ntype = \"point\"\nposition = [0.5, 4, 0.3]\ncolor = [0, 1, 0]\n" + shadow + more +
            "[[object]]\nmesh = \"plane\"\nmaterial = \"m\"\n" + object + "[[material]]\nname = \"m\"\nmodel = \"" +
            model + "\"\n",
        "test", "");
}

std::string shading(const std::string& frequency, const std::string& cull = "none", const std::string& more = "") {
    return "frequency = \"" + frequency + "\"\ncull = \"" + cull + "\"\n" + more;
}

/// The middle shows red light and no green.
void check_red(const Scene& scene, float least = 0.02f) {
    const glm::vec3 seen = render(scene).rgb(16, 16);
    CHECK(seen.x > least);
    CHECK(seen.y == 0.0f);
}

/// The object's mesh with its triangles wound the other way, and its normals reversed if asked for.
void reverse(Object& object, bool normals_too) {
    raster::Mesh mesh = *object.mesh;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (glm::vec3& n : mesh.normals) n = normals_too ? -n : n;
    object.mesh = std::make_shared<raster::Mesh>(mesh);
}

/// The largest. Flat: the centroid of three corners, summed in another order, rounds otherwise.
float difference(const raster::Image& a, const raster::Image& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.values.size(); ++i) largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
    return largest;
}

raster::Image normals_of(const Scene& scene) {
    RenderBuffers buffers;
    render(scene, make_plan(scene, {find_view("normal")}), buffers);
    return buffers.views[0];
}

}  // namespace

TEST_CASE("Two-sided: a square seen from behind shows the light of the lamp on the viewer's side") {
    for (const std::string& model : kTurnedModels) {
        for (const std::string& frequency : kFrequencies) {
            for (const std::string cull : {"none", "front"}) {
                CAPTURE(model);
                CAPTURE(frequency);
                CAPTURE(cull);
                check_red(square(model, shading(frequency, cull)));
                const Scene one_sided = square(model, shading(frequency, cull, "two_sided = false\n"));
                CHECK(render(one_sided).rgb(16, 16).x == 0.0f);  // as it was: the light of the far side
            }
        }
    }
}

TEST_CASE("Two-sided: shadows of every method leave the seen side lit and are cast onto it") {
    const std::string disc = "[[object]]\nmesh = \"sphere\"\nscale = 0.15\ntranslate = [0.5, -1, 0.3]\n";
    for (const std::string method : {"map", "exact", "planar", "volume", "irregular"}) {
        for (const std::string& frequency : kFrequencies) {
            if (frequency != "phong" && method != "map" && method != "exact") continue;
            CAPTURE(method);
            CAPTURE(frequency);
            const std::string settings = "[shadow]\nmethod = \"" + method + "\"\n";
            check_red(square("lambert", shading(frequency), settings));
            if (frequency != "phong") continue;
            const raster::Image lit = render(square("lambert", shading(frequency), settings));
            const raster::Image dark = render(square("lambert", shading(frequency), settings + disc));
            int darker = 0;
            for (int y = 0; y < 32; ++y) {
                for (int x = 0; x < 32; ++x) darker += dark.at(0, x, y) == 0.0f && lit.at(0, x, y) > 0.0f;
            }
            CHECK(darker > 4);
        }
    }
}

TEST_CASE("Two-sided: every way to bias a shadow map leaves the seen side lit") {
    for (const std::string bias : {"constant", "slope", "normal_offset"}) {
        CAPTURE(bias);
        check_red(square("lambert", shading("phong"), "[shadow]\nbias = \"" + bias + "\"\n"));
    }
}

TEST_CASE("Two-sided: mirrored objects are lit on the side that is seen") {
    for (const std::string scale : {"[-1, 1, 1]", "[1, -1, 1]", "[1, 1, -1]", "[-1, -1, -1]"}) {
        for (const std::string& frequency : kFrequencies) {
            CAPTURE(scale);
            CAPTURE(frequency);
            check_red(square("phong", shading(frequency), "", "scale = " + scale + "\n"));
        }
    }
}

TEST_CASE("Two-sided: a square from behind is bit for bit the reversed square from the front") {
    for (const std::string& model : kTurnedModels) {
        for (const std::string& frequency : kFrequencies) {
            CAPTURE(model);
            CAPTURE(frequency);
            const Scene scene = square(model, shading(frequency));
            Scene reversed = scene;
            reverse(reversed.objects[0], true);
            CHECK(render(scene).values == render(reversed).values);
            reversed.shading.cull = raster::CullMode::back;
            CHECK(render(scene).values == render(reversed).values);
        }
    }
}

TEST_CASE("Two-sided: a square that passes beside the eye is lit on the seen side where it is clipped") {
    for (const std::string& frequency : kFrequencies) {
        CAPTURE(frequency);
        check_red(square("lambert", shading(frequency), "", "scale = 4000\n"), 1e-4f);  // lit from far aside
    }
}

TEST_CASE("Two-sided: a ball wound inwards looks like the ball with or without normals that know better") {
    for (const std::string& frequency : kFrequencies) {
        for (const bool normals_too : {false, true}) {
            CAPTURE(frequency);
            CAPTURE(normals_too);
            const std::string text = "[image]\nsize = [64, 64]\n[camera]\nposition = [0, 0, 3]\n[shading]\n" +
                                     shading(frequency) + "[[light]]\ndirection = [-1, -1, 0.2]\n" +
                                     "[[object]]\nmesh = \"sphere\"\ndetail = 24\n";
            const Scene scene = read_scene_text(text, "test", "");
            Scene inwards = scene;
            reverse(inwards.objects[0], normals_too);
            CHECK(difference(render(scene), render(inwards)) < (frequency == "flat" ? 1e-6f : 1e-30f));
            Scene culled = scene;
            culled.shading.cull = raster::CullMode::back;
            CHECK(render(scene).values == render(culled).values);
        }
    }
}

TEST_CASE("Two-sided: a bent normal is turned as a whole") {
    Scene scene = square("lambert", shading("phong"));
    raster::Mesh mesh = *scene.objects[0].mesh;
    raster::make_tangents(mesh);
    scene.objects[0].mesh = std::make_shared<raster::Mesh>(mesh);
    raster::Image bump = raster::make_image(1, 1, 3);
    bump.set_rgb(0, 0, {0.36f, 0.48f, 0.8f});
    scene.materials[0].maps.normal.texture = std::make_shared<raster::Texture>(raster::make_texture(bump));
    const raster::Image turned = normals_of(scene);
    scene.shading.two_sided = false;
    const raster::Image as_they_are = normals_of(scene);
    CHECK(turned.rgb(16, 16).y < -0.5f);
    CHECK(turned.rgb(16, 16) == -as_they_are.rgb(16, 16));
    CHECK(glm::abs(turned.rgb(16, 16).x) > 0.3f);
}

TEST_CASE("Two-sided: the winding decides unless the normals contradict it") {
    const glm::vec3 up(0.0f, 1.0f, 0.0f), leaning(0.99f, -0.1f, 0.0f), eye(0.0f, 1.0f, 0.0f);
    CHECK_FALSE(seen_from_behind(false, up, up, eye));
    CHECK(seen_from_behind(true, up, up, -eye));
    CHECK_FALSE(seen_from_behind(false, up, {1.0f, 0.1f, 0.0f}, {-1.0f, 0.2f, 0.0f}));  // an outline: n.v < 0
    CHECK_FALSE(seen_from_behind(true, up, -up, -eye));                                 // wound inwards, right normals
    CHECK(seen_from_behind(false, up, -up, eye));                                       // the right winding, wrong ones
    CHECK_FALSE(seen_from_behind(true, up, leaning, {1.0f, -0.1f, 0.0f}));              // a sliver folded over
}

TEST_CASE("Two-sided: nothing changes and nothing is planned where backs are culled") {
    for (const std::string& frequency : kFrequencies) {
        Scene scene = square("phong", shading(frequency, "back"), "", "rotate = [180, 0, 0]\n");
        const raster::Image film = render(scene);
        CHECK(film.rgb(16, 16).x > 0.0f);
        CHECK_FALSE(make_plan(scene).two_sided);
        CHECK_FALSE(make_plan(scene).vertex.color_behind);
        scene.shading.two_sided = false;
        CHECK(render(scene).values == film.values);
    }
}
