// 44_materials: the committed maps are what the formula draws, and the pictures obey what maps mean.
#include <cmath>
#include <cstdlib>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/tile_maps.hpp"
#include "golden.hpp"
#include "lighting/normal_map.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr int kSide = 128;
const std::string kFolder = KREDA_SOURCE_DIR "/examples/44_materials/";

raster::Image stored(const std::string& map) {
    return scene::read_image(kFolder + "tiles/" + map + ".png");
}

}  // namespace

TEST_CASE("44_materials: the files of the maps are what the formula draws") {
    for (const examples::TileMap& map : examples::tile_maps(kSide)) {
        CAPTURE(map.name);
        const std::string file = kFolder + "tiles/" + std::string(map.name) + ".png";
        if (std::getenv("KREDA_RENEW_GOLDEN")) scene::write_png(file, map.stored);
        const raster::Image image = scene::read_image(file);
        REQUIRE(image.channels == map.stored.channels);
        const tools::Comparison difference = compare_bytes(image, map.stored);
        CHECK(difference.worst.steps <= 1.0);  // sin() may round otherwise on another machine
        CHECK(difference.differing < kSide);
    }
}

TEST_CASE("44_materials: a height that starts over rises as much as it falls: the mean slope is 0") {
    const raster::Image normal = stored("normal");
    double slope_x = 0.0, slope_y = 0.0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const glm::vec3 m(lighting::normal_component(normal.at(0, x, y), 8),
                              lighting::normal_component(normal.at(1, x, y), 8),
                              lighting::normal_component(normal.at(2, x, y), 8));
            CHECK(std::abs(glm::length(m) - 1.0f) < 0.01f);  // half a byte of 127 in each component
            slope_x += double{m.x / m.z};
            slope_y += double{m.y / m.z};
        }
    }
    CHECK(std::abs(slope_x) / (kSide * kSide) < 0.002);
    CHECK(std::abs(slope_y) / (kSide * kSide) < 0.002);
}

TEST_CASE("44_materials: gold has no diffuse part and its F0 is its albedo and glaze has 0.04") {
    scene::Scene scene = scene::read_scene(kFolder + "tiles.toml");
    scene.image.width = 160;
    scene.image.height = 90;
    scene.image.samples = 1;
    scene::RenderBuffers buffers;
    render(scene,
           make_plan(scene, {scene::find_view("metallic"), scene::find_view("diffuse"), scene::find_view("f0"),
                             scene::find_view("albedo"), scene::find_view("roughness")}),
           buffers);
    int gold = 0, glaze = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            const glm::vec3 albedo = buffers.views[3].rgb(x, y);
            if (albedo == glm::vec3(0.0f)) continue;  // nothing seen
            const float metallic = buffers.views[0].at(0, x, y);
            if (metallic == 1.0f) {
                ++gold;
                CHECK(buffers.views[1].rgb(x, y) == glm::vec3(0.0f));
                CHECK(glm::distance(buffers.views[2].rgb(x, y), albedo) < 1e-6f);
                CHECK(buffers.views[4].at(0, x, y) ==
                      doctest::Approx(documented_number("44_materials", "roughness")).epsilon(0.01));
            }
            if (metallic == 0.0f) {
                ++glaze;
                CHECK(glm::distance(buffers.views[2].rgb(x, y), glm::vec3(0.04f)) < 1e-6f);
            }
        }
    }
    CHECK(gold > 500);
    CHECK(glaze > 1000);
}

TEST_CASE("44_materials: away from the highlights metal is darker than the same colour as paint") {
    const glm::vec3 paint = linear_panel("44_materials/materials", 3, 2, 1).rgb(42, 63);
    const glm::vec3 metal = linear_panel("44_materials/materials", 3, 2, 2).rgb(42, 63);
    CHECK(paint.x > paint.z);  // a gold tile
    CHECK(metal.x < 0.5f * paint.x);
}
