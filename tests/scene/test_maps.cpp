// Maps from files to pixels: places of complaints, decoding, sharing, what is loaded at all, every frequency.
#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/map_scenes.hpp"
#include "tests/scene/raw_png.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;
using kreda::lighting::MapKind;

TEST_CASE("maps: a folder is one material and the explicit key wins") {
    const TempFolder folder;
    folder.write("iron/iron_1K_Color.ppm", even_ppm(255, 0, 0));
    folder.write("iron/iron_1K_Roughness.ppm", even_ppm(51, 51, 51));
    folder.write("iron/iron_1K_Metalness.ppm", even_ppm(255, 255, 255));
    folder.write("iron/iron_1K_NormalDX.ppm", even_ppm(128, 128, 255));
    folder.write("iron/iron_1K_Height.ppm", even_ppm(0, 0, 0));
    folder.write("iron/readme.txt", "no map");
    folder.write("green.ppm", even_ppm(0, 255, 0));
    const Scene scene =
        read_in(folder, wall("model = 'cook_torrance'\nmaps = 'iron/*.ppm'\nalbedo_map = 'green.ppm'\n"));
    const lighting::MaterialMaps& maps = scene.materials[0].maps;
    REQUIRE(maps.albedo.texture);
    CHECK(maps.albedo.texture->texels[0] == 0.0f);
    CHECK(maps.albedo.texture->texels[1] == 1.0f);
    CHECK(maps.roughness.texture->texels[0] == doctest::Approx(0.2));
    CHECK(maps.roughness.texture->channels == 1);
    CHECK(maps.metallic.texture->texels[0] == 1.0f);
    CHECK(maps.normal_y == lighting::NormalMapY::down);
    CHECK_FALSE(maps.ao.texture);
    CHECK(warns(scene, "s.toml:18:8: 'maps' does not use iron_1K_Height.ppm"));
    const Scene whole =
        read_in(folder, wall("model = 'lambert'\nmaps = 'iron'\n"));  // a folder alone; its colour is m_D
    CHECK(whole.materials[0].maps.diffuse.texture);
    CHECK_FALSE(whole.materials[0].maps.roughness.texture);
}

TEST_CASE("maps: complaints name the place and what was expected") {
    const TempFolder folder;
    folder.write("rust_color.ppm", even_ppm(1, 2, 3));
    folder.write("two/a_albedo.ppm", even_ppm(1, 2, 3));
    folder.write("two/b_albedo.ppm", even_ppm(1, 2, 3));
    folder.write("none/x.ppm", even_ppm(1, 2, 3));
    const auto complaint = [&](const std::string& keys) { return complaint_in(folder, "[[material]]\n" + keys); };
    const std::string absent = complaint("model = 'lambert'\ndiffuse_map = 'rust_colour.ppm'\n");
    CHECK(has(absent, "s.toml:3:15: 'diffuse_map': "));
    CHECK(has(absent, "rust_colour.ppm' is not there; did you mean 'rust_color.ppm'?"));
    CHECK(has(complaint("diffuse_map = 'two'\n"), "s.toml:2:15: 'diffuse_map': "));
    CHECK(has(complaint("diffuse_map = 'two'\n"), "is a folder, not an image file"));
    CHECK(has(complaint("maps = 'nowhere/*.ppm'\n"), "s.toml:2:8: 'maps': there is no folder "));
    CHECK(has(complaint("maps = 'none/*.ppm'\n"), "expected files whose names end in albedo (or basecolor), emission"));
    CHECK(has(complaint("maps = 'none/*.ppm'\n"), "; found x.ppm"));
    CHECK(complaint("model = 'cook_torrance'\nmaps = 'two/*'\n") ==
          "s.toml:3:8: 'maps': 'a_albedo.ppm' and 'b_albedo.ppm' are both a map of albedo; choose one beside it, "
          "albedo_map = \"two/a_albedo.ppm\", or let the pattern of 'maps' match fewer files");
    CHECK(has(complaint("maps = 'two'\n"), "beside it, diffuse_map = \"two/a_albedo.ppm\", or"));  // as phong reads it
    CHECK(complaint("maps = 'two'\ndiffuse_map = 'two/a_albedo.ppm'\n") == "no complaint");        // the remedy helps
    CHECK(complaint("maps = 'two/a*'\n") == "no complaint");
    CHECK(has(complaint("texture_filter = 'cubic'\n"), "expected \"nearest\" | \"bilinear\" | \"trilinear\""));
    CHECK(has(complaint("texture_wrap = 'mirror'\n"), "expected \"repeat\" | \"clamp\""));
    CHECK(has(complaint("normal_map_y = 'left'\n"), "expected \"up\" | \"down\""));
}

TEST_CASE("maps: one that the model does not read is a warning and only what is seen is loaded") {
    const TempFolder folder;
    folder.write("bad.png", "no picture");
    const Scene scene = read_in(folder, wall("model = 'phong'\nalbedo_map = 'bad.png'\n"));
    CHECK(warns(scene, "s.toml:18:14: 'albedo_map' is not read by model = \"phong\"; its colour is diffuse_map"));
    const std::string unused = wall("model = 'phong'\n") + "[[material]]\nname = 'other'\ndiffuse_map = 'bad.png'\n";
    CHECK(complaint_in(folder, unused) == "no complaint");
    CHECK(has(complaint_in(folder, wall("diffuse_map = 'bad.png'\n")), "bad.png: cannot be read as an image"));
}

TEST_CASE("maps: one file is loaded once however it is written and for each meaning") {
    const TempFolder folder;
    folder.write("a.ppm", even_ppm(100, 100, 100));
    const Scene scene =
        read_in(folder, wall("model = 'cook_torrance'\nalbedo_map = 'a.ppm'\nroughness_map = './a.ppm'\n"
                             "metallic_map = 'a.ppm'\n") +
                            "[[material]]\nname = 'n'\nmodel = 'cook_torrance'\nalbedo_map = '../" +
                            folder.path.filename().string() +
                            "/a.ppm'\ntexture_filter = 'nearest'\n[[object]]\nmesh = 'cube'\nmaterial = 'n'\n");
    const lighting::MaterialMaps &m = scene.materials[0].maps, &n = scene.materials[1].maps;
    CHECK(m.albedo.texture == n.albedo.texture);
    CHECK(m.roughness.texture == m.metallic.texture);
    CHECK(m.roughness.texture != m.albedo.texture);
    CHECK(m.albedo.texture->level_count == 2);  // 2 x 2: somebody reads it trilinear
}

TEST_CASE("maps: colours are decoded from sRGB and values are not, with 8 and 16 bits, grey for three") {
    const TempFolder folder;
    std::vector<std::string> warnings;
    const auto first = [&](const std::string& path, MapKind kind) {
        return load_texture(path, kind, false, warnings)->texels[0];
    };
    const std::string eight = folder.write("8.ppm", even_ppm(188, 0, 0));
    const std::string sixteen = folder.write("16.png", one_pixel_png(16, 0, "\xbc\xbd"));
    const std::string faint = folder.write("faint.png", one_pixel_png(8, 4, "\xbc\x01"));  // grey, alpha 1 / 255
    CHECK(first(eight, MapKind::color) == raster::linear_from_srgb(188.0f / 255.0f));
    CHECK(first(eight, MapKind::color) == doctest::Approx(0.5).epsilon(0.01));  // byte 188 is half the light
    CHECK(first(eight, MapKind::value) == 188.0f / 255.0f);
    CHECK(first(sixteen, MapKind::color) ==
          doctest::Approx(raster::linear_from_srgb(48317.0f / 65535.0f)).epsilon(1e-6));
    CHECK(first(faint, MapKind::color) == first(eight, MapKind::color));  // not multiplied by alpha
    const auto grey = load_texture(folder.write("grey.pgm", even_pgm(188)), MapKind::color, true, warnings);
    CHECK(grey->channels == 3);
    CHECK(grey->texels[2] == first(eight, MapKind::color));
    CHECK(warnings.empty());
}

TEST_CASE("maps: floating-point files are linear and what no map may hold is clamped and counted") {
    const TempFolder folder;
    raster::Image image = raster::make_image(2, 1, 3);
    image.values = {0.5f, 2.0f, -1.0f, 0.25f, std::nanf(""), 1.0f};
    write_exr(folder.file("a.exr"), image);
    std::vector<std::string> warnings;
    const auto texture = load_texture(folder.file("a.exr"), MapKind::color, false, warnings);
    CHECK(texture->texels == raster::AlignedVector<float>{0.5f, 0.0f, 0.0f, 1.0f, 0.25f, 1.0f});
    REQUIRE(warnings.size() == 2);
    CHECK(has(warnings[0], "1 values are NaN or infinite"));
    CHECK(has(warnings[1], "2 values are outside of 0..1"));
    raster::Image flat = raster::make_image(1, 1, 3);
    flat.values = {0.5f, 0.5f, 1.0f};
    write_exr(folder.file("n.exr"), flat);
    CHECK(load_texture(folder.file("n.exr"), MapKind::normal, false, warnings)->texels ==
          raster::AlignedVector<float>{0, 0, 1});
}

TEST_CASE("maps: an even map gives the picture of its constant at every frequency") {
    const TempFolder folder;
    folder.write("c.ppm", even_ppm(188, 100, 30));
    const std::string color = "[" + std::to_string(raster::linear_from_srgb(188.0f / 255.0f)) + ", " +
                              std::to_string(raster::linear_from_srgb(100.0f / 255.0f)) + ", " +
                              std::to_string(raster::linear_from_srgb(30.0f / 255.0f)) + "]\n";
    for (const char* frequency : {"flat", "gouraud", "phong"}) {
        for (const char* model : {"unlit", "lambert", "blinn_phong"}) {
            CAPTURE(frequency);
            CAPTURE(model);
            const std::string head = "model = '" + std::string(model) + "'\n";
            const std::string shading = "[shading]\nfrequency = '" + std::string(frequency) + "'\n";
            const raster::Image mapped = render(read_in(folder, wall(head + "diffuse_map = 'c.ppm'\n", shading)));
            const raster::Image constant = render(read_in(folder, wall(head + "diffuse = " + color, shading)));
            CHECK(worst_difference(mapped, constant) < 1e-6f);  // the constant is written with six digits
        }
    }
}

TEST_CASE("maps: nearest shows texel by texel the picture that the file holds") {
    const TempFolder folder;
    std::string text = "P3\n4 4\n255\n";
    for (int i = 0; i < 16; ++i) text += std::to_string(16 * i) + " " + std::to_string(255 - 16 * i) + " 7\n";
    folder.write("p.ppm", text);
    const Scene scene = read_in(folder, wall("model = 'unlit'\ndiffuse_map = 'p.ppm'\ntexture_filter = 'nearest'\n"));
    const raster::Image film = render(scene);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {  // row 0 of the file is on top of the picture, column 0 on its left
            const int i = y / 8 * 4 + x / 8;
            REQUIRE(film.at(0, x, y) == raster::linear_from_srgb(static_cast<float>(16 * i) / 255.0f));
            REQUIRE(film.at(2, x, y) == raster::linear_from_srgb(7.0f / 255.0f));
        }
    }
}

TEST_CASE("maps: a tilted normal map lights the wall as a tilted wall and down is up mirrored") {
    const TempFolder folder;
    // m = (0, 0.6, 0.8) towards growing v, which is up in the picture: -z of the world.
    const int y = 128 + static_cast<int>(std::lround(0.6 * 127)), z = 128 + static_cast<int>(std::lround(0.8 * 127));
    folder.write("tilt.ppm", even_ppm(128, y, z));
    const std::string keys = "model = 'lambert'\nnormal_map = 'tilt.ppm'\n";
    const Scene scene = read_in(folder, wall(keys));
    RenderBuffers buffers;
    render(scene, make_plan(scene, {find_view("normal")}), buffers);
    const glm::vec3 n = buffers.views[0].rgb(10, 20);
    CHECK(glm::length(n - glm::vec3(0.0f, 0.8f, -0.6f)) < 0.005f);  // half a byte of 127
    CHECK(buffers.film.at(0, 10, 20) == doctest::Approx(0.7 * double{n.y}));
    const Scene down = read_in(folder, wall(keys + "normal_map_y = 'down'\n"));
    render(down, make_plan(down, {find_view("normal")}), buffers);
    CHECK(glm::length(buffers.views[0].rgb(10, 20) - glm::vec3(n.x, n.y, -n.z)) < 1e-6f);
}

TEST_CASE("maps: a mesh without texture coordinates is drawn without maps and says so once") {
    const TempFolder folder;
    folder.write("c.ppm", even_ppm(255, 0, 0));
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string object = "[[object]]\nmesh = 't.obj'\nmaterial = 'm'\n";
    const Scene scene = read_in(folder, wall("model = 'lambert'\ndiffuse_map = 'c.ppm'\n") + object + object);
    CHECK(std::count_if(scene.warnings.begin(), scene.warnings.end(), [](const std::string& warning) {
              return has(warning, "t.obj: has no texture coordinates (vt); drawn without the maps of 'm'");
          }) == 1);
    const auto material_of = [&](std::size_t i) {
        return scene.materials[static_cast<std::size_t>(scene.objects[i].part_material[0])];
    };
    CHECK(material_of(0).maps.diffuse.texture);
    CHECK_FALSE(material_of(1).maps.diffuse.texture);
    CHECK(material_of(2).phong.diffuse == material_of(0).phong.diffuse);
}

TEST_CASE("maps: textures of an MTL are read and a normal map gives its mesh tangents") {
    const TempFolder folder;
    folder.write("wood.ppm", even_ppm(255, 0, 0));
    folder.write("flat.ppm", even_ppm(128, 128, 255));
    folder.write("a.mtl", "newmtl wood\nKd 1 1 1\nmap_Kd wood.ppm\nnorm flat.ppm\n");
    folder.write("a.obj",
                 "mtllib a.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    const Scene scene = read_in(folder, "[[object]]\nmesh = 'a.obj'\n");
    CHECK(scene.warnings.empty());
    REQUIRE(scene.materials[0].maps.diffuse.texture);
    CHECK(scene.materials[0].maps.diffuse.texture->texels[1] == 0.0f);
    CHECK(scene.objects[0].mesh->tangents.size() == 3);
    CHECK(scene.objects[0].mesh->tangents[0] == glm::vec4(1, 0, 0, 1));
}

TEST_CASE("maps: the plan asks for uv and tangents only where somebody reads them") {
    const TempFolder folder;
    folder.write("c.ppm", even_ppm(255, 0, 0));
    folder.write("n.ppm", even_ppm(128, 128, 255));
    const auto plan_of = [&](const std::string& keys) { return make_plan(read_in(folder, wall(keys))); };
    const RenderPlan plain = plan_of("");
    CHECK_FALSE(plain.vertex.uv);
    CHECK_FALSE(plain.fragment_of_material[0].uv);
    const RenderPlan nearest = plan_of("diffuse_map = 'c.ppm'\ntexture_filter = 'nearest'\n");
    CHECK(nearest.fragment_of_material[0].uv);
    CHECK_FALSE(nearest.fragment_of_material[0].uv_steps);
    CHECK_FALSE(nearest.vertex.tangent_world);
    const RenderPlan trilinear = plan_of("diffuse_map = 'c.ppm'\nnormal_map = 'n.ppm'\n");
    CHECK(trilinear.fragment_of_material[0].uv_steps);
    CHECK(trilinear.vertex.tangent_world);
    CHECK(has(describe(trilinear, true), "maps of m: diffuse_map, normal_map read at every sample, trilinear"));
    CHECK(has(describe(plain, true), "maps: left out, no visible material has a map that its model reads"));
}
