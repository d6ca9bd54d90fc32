// Emission maps and height maps from scene files and MTL files to pixels.
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/map_scenes.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;

namespace {

constexpr const char* kModels[] = {"unlit", "lambert",         "phong",        "blinn_phong",
                                   "ward",  "heidrich_seidel", "cook_torrance"};

/// Four texels, red growing to the right and green downwards.
std::string four_texels() {
    return "P3\n2 2\n255\n51 0 255  204 0 255\n51 255 255  204 255 255\n";
}

/// The light of the sRGB byte 51 and of 204, worked by hand from IEC 61966-2-1: 0.2 and 0.8 are above 0.04045, so
/// ((0.2 + 0.055) / 1.055)^2.4 = 0.0331048 and ((0.8 + 0.055) / 1.055)^2.4 = 0.603827.
constexpr double kLightOf51 = 0.0331048, kLightOf204 = 0.603827;

/// The wall with its lamp switched off: what is seen is emitted. unlit shows m_D, too: it is black.
std::string dark_wall(const std::string& model, const std::string& keys, const std::string& more = "") {
    std::string text = wall("model = '" + model + "'\ndiffuse = [0, 0, 0]\ntexture_filter = 'nearest'\n" + keys, more);
    return text.replace(text.find("[[light]]\n"), 10, "[[light]]\non = false\n");
}

/// A height picture of `width` columns: one step of grey from column to column.
std::string ramp(int width, int step) {
    std::string text = "P2\n" + std::to_string(width) + " 1\n255\n";
    for (int x = 0; x < width; ++x) text += std::to_string(x * step) + " ";
    return text + "\n";
}

}  // namespace

TEST_CASE("emission_map: a wall without any light shows the map times emission texel by texel") {
    const TempFolder folder;
    folder.write("glow.ppm", four_texels());
    for (const char* model : kModels) {
        CAPTURE(model);
        const raster::Image plain = render(read_in(folder, dark_wall(model, "emission_map = 'glow.ppm'\n")));
        const raster::Image scaled =
            render(read_in(folder, dark_wall(model, "emission_map = 'glow.ppm'\nemission = [3, 2, 0.5]\n")));
        for (int y = 0; y < 32; y += 5) {
            for (int x = 0; x < 32; x += 5) {  // row 0 of the file is on top
                const double red = x < 16 ? kLightOf51 : kLightOf204, green = y < 16 ? 0.0 : 1.0;
                REQUIRE(plain.at(0, x, y) == doctest::Approx(red).epsilon(1e-5));  // seven digits of a float
                REQUIRE(plain.at(1, x, y) == green);
                REQUIRE(plain.at(2, x, y) == 1.0f);
                REQUIRE(scaled.at(0, x, y) == doctest::Approx(3.0 * red).epsilon(1e-5));
                REQUIRE(scaled.at(1, x, y) == 2.0 * green);
                REQUIRE(scaled.at(2, x, y) == 0.5f);
            }
        }
    }
}

TEST_CASE("emission_map: an even map is the constant bit by bit at every frequency, lit or not") {
    const TempFolder folder;
    raster::Image image = raster::make_image(1, 1, 3);
    image.values = {0.25f, 8.0f, 1.5f};  // floats are light of any strength
    write_exr(folder.file("e.exr"), image);
    for (const char* frequency : {"flat", "gouraud", "phong"}) {
        for (const char* model : kModels) {
            CAPTURE(frequency);
            CAPTURE(model);
            const std::string head = "model = '" + std::string(model) + "'\n";
            const std::string shading = "[shading]\nfrequency = '" + std::string(frequency) + "'\n";
            const Scene mapped = read_in(folder, wall(head + "emission_map = 'e.exr'\n", shading));
            CHECK(mapped.warnings.empty());
            const Scene constant = read_in(folder, wall(head + "emission = [0.25, 8, 1.5]\n", shading));
            CHECK(worst_difference(render(mapped), render(constant)) == 0.0f);
        }
    }
}

TEST_CASE("emission_map: the view, the plan and a map of an unlit surface beside it") {
    const TempFolder folder;
    folder.write("e.ppm", even_ppm(255, 0, 51));
    folder.write("d.ppm", even_ppm(0, 255, 0));
    const Scene scene =
        read_in(folder, wall("model = 'unlit'\ndiffuse_map = 'd.ppm'\nemission_map = 'e.ppm'\nemission = [2, 2, 2]\n"));
    const glm::vec3 seen = render(scene).rgb(9, 9), of_map = view_of(scene, "emission_map").rgb(9, 9);
    CHECK(seen.x == 2.0f);
    CHECK(seen.y == 1.0f);
    CHECK(seen.z == doctest::Approx(2.0 * kLightOf51).epsilon(1e-5));
    CHECK(of_map.x == 1.0f);
    CHECK(of_map.z == doctest::Approx(kLightOf51).epsilon(1e-5));
    CHECK(has(describe(make_plan(scene), true), "maps of m: diffuse_map, emission_map read at every sample"));
}

TEST_CASE("emission_map: negative light is clamped with a word, and a mesh without uv does not glow") {
    const TempFolder folder;
    raster::Image image = raster::make_image(2, 1, 3);
    image.values = {-1.0f, 2.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    write_exr(folder.file("e.exr"), image);
    const Scene scene = read_in(folder, wall("emission_map = 'e.exr'\n"));
    CHECK(warns(scene, "e.exr: 1 values are below 0 or above 1e9 and were clamped: a map of emission holds light"));
    CHECK(scene.materials[0].maps.emission.texture->texels[3] == 2.0f);
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene bare =
        read_in(folder, wall("emission_map = 'e.exr'\n") + "[[object]]\nmesh = 't.obj'\nmaterial = 'm'\n");
    const auto drawn_with = static_cast<std::size_t>(bare.objects[1].part_material[0]);
    CHECK(bare.materials[drawn_with].phong.emission == glm::vec3(0.0f));
}

TEST_CASE("map_Ke: multiplied by Ke, by 1 where Ke is absent or black, and found in a folder of maps") {
    const TempFolder folder;
    folder.write("glow.ppm", even_ppm(255, 0, 51));
    folder.write("a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    const auto emission_beside = [&](const std::string& Ke) {
        folder.write("a.mtl", "newmtl m\nKd 0 0 0\n" + Ke + "map_Ke glow.ppm\n");
        const Scene scene = read_in(folder, "[[object]]\nmesh = 'a.obj'\n");
        CHECK(scene.warnings.empty());
        REQUIRE(scene.materials[0].maps.emission.texture);
        CHECK(scene.materials[0].maps.emission.texture->texels[0] == 1.0f);
        return scene.materials[0].phong.emission;
    };
    CHECK(emission_beside("") == glm::vec3(1.0f));
    CHECK(emission_beside("Ke 0 0 0\n") == glm::vec3(1.0f));
    CHECK(emission_beside("Ke 2 3 4\n") == glm::vec3(2.0f, 3.0f, 4.0f));
    folder.write("set/lamp_Emissive.ppm", even_ppm(0, 255, 0));
    const Scene set = read_in(folder, wall("maps = 'set'\n"));
    CHECK(set.materials[0].maps.emission.texture->texels[1] == 1.0f);
    CHECK(set.materials[0].phong.emission == glm::vec3(1.0f));
}

TEST_CASE("bump_map: an even slope tilts the wall by the angle of its heights") {
    // Grey grows by 8 / 255 from column to column, white stands bump_scale = 0.5 pictures above black, and the picture
    // is 16 columns wide: a rise of 0.5 * 8 / 255 on a run of 1 / 16 is a slope of 64 / 255. n = (-slope, 1) / length.
    const TempFolder folder;
    folder.write("h.pgm", ramp(16, 8));
    const std::string keys =
        "model = 'lambert'\nbump_map = 'h.pgm'\ntexture_wrap = 'clamp'\ntexture_filter = 'nearest'\n";
    const double slope = 64.0 / 255.0, length = std::sqrt(1.0 + slope * slope);
    const auto normal = [&](const std::string& scale) {
        return view_of(read_in(folder, wall(keys + scale)), "normal").rgb(16, 16);
    };
    const glm::vec3 half = normal("bump_scale = 0.5\n");
    CHECK(half.x == doctest::Approx(-slope / length).epsilon(1e-5));
    CHECK(half.y == doctest::Approx(1.0 / length).epsilon(1e-5));
    CHECK(half.z == 0.0f);
    CHECK(normal("bump_scale = -0.5\n").x == doctest::Approx(slope / length).epsilon(1e-5));  // down instead of up
    CHECK(normal("").x == normal("bump_scale = 0.02\n").x);
    const Scene scene = read_in(folder, wall(keys + "bump_scale = 0.5\n"));
    CHECK(render(scene).at(0, 16, 16) == doctest::Approx(0.7 / length).epsilon(1e-5));  // m_D (n.l), l straight up
}

TEST_CASE("bump_map: what contradicts it is named with the remedy, and it wins over a folder's normal map") {
    const TempFolder folder;
    folder.write("h.pgm", ramp(16, 8));
    folder.write("set/a_NormalDX.ppm", even_ppm(128, 128, 255));
    const auto complaint = [&](const std::string& keys) { return complaint_in(folder, "[[material]]\n" + keys); };
    CHECK(complaint("bump_scale = 1\n") ==
          "s.toml:2:14: 'bump_scale' in [[material]] needs 'bump_map', the heights that it scales");
    CHECK(has(complaint("bump_map = 'h.pgm'\nnormal_map = 'h.pgm'\n"),
              "s.toml:3:14: 'normal_map' and 'bump_map' in [[material]] exclude each other"));
    CHECK(has(complaint("bump_map = 'h.pgm'\nnormal_map_y = 'down'\n"), "s.toml:3:16: 'normal_map_y' and 'bump_map'"));
    CHECK(has(complaint("bump_map = 'x.pgm'\n"), "is not there; did you mean 'h.pgm'?"));
    CHECK(warns(read_in(folder, wall("model = 'unlit'\nbump_map = 'h.pgm'\n")),
                "'bump_map' is not read by model = \"unlit\""));
    const Scene scene = read_in(folder, wall("maps = 'set'\nbump_map = 'h.pgm'\n"));
    CHECK(scene.materials[0].maps.normal_from_height);
    CHECK(scene.materials[0].maps.normal_y == lighting::NormalMapY::up);
}
