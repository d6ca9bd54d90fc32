// The picture of what a light sees: distances known by hand, for every kind of light.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/render/light_depth.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr int kSize = 64;

/// A floor, and things above it that cast onto it.
Scene over_a_floor(const std::string& light, const std::string& things) {
    return read_scene_text(
        "[image]\nsize = [80, 60]\n[camera]\nposition = [0.3, 6, 5]\n[shadow]\nsize = 64\n[[light]]\nshadow = true\n" +
            light + "\n[[object]]\nmesh = \"plane\"\nscale = 4\n" + things,
        "test", "");
}

std::string square(float height, const std::string& more = "") {
    return "[[object]]\nmesh = \"plane\"\nscale = 0.5\ntranslate = [0, " + std::to_string(height) + ", 0]\n" + more;
}

/// The light's picture of a scene.
raster::Image draw_depth(const Scene& scene) {
    RenderBuffers buffers;
    const RenderPlan plan = make_plan(scene);
    REQUIRE(can_show(plan, scene, light_depth_view()));
    render(scene, plan, buffers);
    return light_depth(buffers);
}

std::vector<float> of_casters(const raster::Image& distances) {
    std::vector<float> found;
    for (const float d : distances.values) {
        if (d < kNothing) found.push_back(d);
    }
    return found;
}

}  // namespace

TEST_CASE("light depth: parallel rays meet two squares a unit apart at distances a unit apart") {
    // The upper one covers a quarter of the lower one's picture.
    const raster::Image map =
        draw_depth(over_a_floor("direction = [0, -1, 0]",
                                square(1.0f) + "[[object]]\nmesh = \"plane\"\nscale = 0.25\ntranslate = [0, 2, 0]\n"));
    CHECK(map.width == kSize);
    CHECK(map.height == kSize);
    const std::vector<float> found = of_casters(map);
    const float least = *std::min_element(found.begin(), found.end());
    int upper = 0;
    for (const float d : found) {
        const float behind = d - least;
        upper += behind < 0.5f;
        CHECK((behind < 1e-5f || std::abs(behind - 1.0f) < 1e-5f));
    }
    CHECK(std::abs(std::sqrt(upper) - 0.5 * std::sqrt(found.size())) <= 1.0);  // half a texel on each side
}

TEST_CASE("light depth: a lamp two units above a square sees it at two on its lower face and nothing on the others") {
    const Scene scene = over_a_floor("type = \"point\"\nposition = [0, 3, 0]", square(1.0f));
    const raster::Image map = draw_depth(scene);
    CHECK(map.width == 6 * kSize);
    const float tangent = make_plan(scene).shadows.at(0).map.views.at(3).half_size.x;
    const double side = kSize * 0.25 / double{tangent};  // half a unit at distance 2
    int seen = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const float d = map.at(0, x, y);
            if (x / kSize != 3) CHECK(d == kNothing);
            if (d < kNothing) CHECK(d == doctest::Approx(2.0).epsilon(1e-5));
            seen += d < kNothing;
        }
    }
    CHECK(std::abs(std::sqrt(seen) - side) <= 1.0);
}

TEST_CASE("light depth: a spot sees a tilted square where its plane is") {
    // Turned by 30 degrees about z: y = 1 + x tan 30. A ray down from (0, 3, 0) with tangent X to the right is at
    // (d X, 3 - d, ..) and meets it at d = 2 / (1 + X tan 30). The light looks down, up is -z as far as it can be +y.
    const Scene scene = over_a_floor("type = \"spot\"\nposition = [0, 3, 0]\ndirection = [0, -1, 0]\ncone = [30, 40]",
                                     square(1.0f, "rotate = [0, 0, 30]\n"));
    const raster::Image map = draw_depth(scene);
    const shadows::LightView view = make_plan(scene).shadows.at(0).map.views.at(0);
    const glm::vec3 right(view.view_from_world[0].x, view.view_from_world[1].x, view.view_from_world[2].x);
    const glm::vec3 up(view.view_from_world[0].y, view.view_from_world[1].y, view.view_from_world[2].y);
    int seen = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            if (map.at(0, x, y) == kNothing) continue;
            const float u = ((x + 0.5f) / kSize * 2.0f - 1.0f) * view.half_size.x;
            const float v = (1.0f - (y + 0.5f) / kSize * 2.0f) * view.half_size.y;
            const double X = double{u * right.x + v * up.x};
            ++seen;
            CHECK(map.at(0, x, y) == doctest::Approx(2.0 / (1.0 + X * std::tan(std::acos(-1.0) / 6.0))).epsilon(2e-3));
        }
    }
    CHECK(seen > 50);
}

TEST_CASE("light depth: the picture runs from black to white and is white where nothing casts") {
    const Scene scene = over_a_floor("direction = [0, -1, 0]", square(1.0f, "rotate = [0, 0, 30]\n"));
    const raster::Image map = draw_depth(scene);
    const ViewPicture picture = picture_of(light_depth_view(), map, scene);
    const std::vector<float> found = of_casters(map);
    CHECK(picture.ranges.at(0).least == *std::min_element(found.begin(), found.end()));
    CHECK(picture.ranges.at(0).greatest == *std::max_element(found.begin(), found.end()));
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        if (map.values[i] == kNothing) CHECK(picture.encoded.values[i] == 1.0f);
        if (map.values[i] == picture.ranges[0].least) CHECK(picture.encoded.values[i] == 0.0f);
    }
}

TEST_CASE("light depth: other methods and lights without shadow have no map") {
    Scene scene = over_a_floor("direction = [0, -1, 0]", square(1.0f));
    CHECK(can_show(make_plan(scene), scene, light_depth_view()));
    scene.shadow.method = shadows::ShadowMethod::exact;
    CHECK_FALSE(can_show(make_plan(scene), scene, light_depth_view()));
    scene.shadow.method = shadows::ShadowMethod::map;
    scene.lights[0].shadow = false;
    CHECK_FALSE(can_show(make_plan(scene), scene, light_depth_view()));
}
