// Files as programs and people write them: one odd line costs a warning with its place, not the mesh.
#include "scene/files/mesh_file.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "tests/scene/mesh_text.hpp"

using namespace kreda::tests;
using kreda::scene::load_mesh_file;
using kreda::scene::other_format;
using kreda::scene::UserError;

namespace {

std::string only_warning(const LoadedText& result) {
    REQUIRE(result.warnings.size() == 1);
    return result.warnings[0];
}

}  // namespace

TEST_CASE("mesh habits: an odd line of an OBJ costs one warning, and the triangle is drawn") {
    for (const OddText& odd :
         {OddText{"s on\nf 1 2 3\n", "a.obj:4:3: 'on'", "group 1"},
          OddText{"vt 0 0\nf 1/1/0 2/1 3/1\n", "a.obj:5:3: '1/1/0'", "0 is taken for no normal"},
          OddText{"f 1/0 2 3\n", "a.obj:4:3: '1/0'", "0 is taken for no texture coordinate"},
          OddText{"f 1 2\nf 1 2 3\n", "a.obj:4:1: a face of 2 corners", "left out"},
          OddText{"f 1\nf 1 2 3\n", "a.obj:4:1: a face of 1 corner ", "left out"},
          OddText{"f\nf 1 2 3\n", "a.obj:4:1: a face of 0 corners", "left out"},
          OddText{"vn 0 0 1\nf 1//1 2//2 3//1\n", "a.obj:5:8: '2//2'", "no such normal: the file has 1 (vn)"},
          OddText{"vn 0 0 1\nf 1//1 2//-2 3//1\n", "a.obj:5:8: '2//-2'", "no such normal: there are 1 before"},
          OddText{"vn 0 0 1\nf 1//1 2//99999999999 3//1\n", "a.obj:5:8: '2//9", "no such normal"},
          OddText{"vt nan nan\nf 1/1 2/1 3/1\n", "a.obj:4:8: 'nan'", "0 is used instead"},
          OddText{"vt inf\nf 1/1 2/1 3/1\n", "a.obj:4:4: 'inf'", "0 is used instead"},
          OddText{"vt 0 -1.#IND\nf 1/1 2/1 3/1\n", "a.obj:4:6: '-1.#IND'", "0 is used instead"},
          OddText{"v 1 1 1 1 0 0\nf 1 2 3\n", "a.obj:4:1: 'v' with a colour", "1 vertices have one"}}) {
        CAPTURE(odd.text);
        const LoadedText result = load_text(kVertices + odd.text);
        check_says(only_warning(result), odd);
        CHECK(result.loaded.mesh.triangle_count() == 1);
        for (const glm::vec3& normal : result.loaded.mesh.normals) CHECK(normal == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("mesh habits: indices of normals and texture coordinates in a file without any are left out") {
    const LoadedText result = load_text(kVertices + "f 1/1/1 2/2/1 3/3/1\n");
    REQUIRE(result.warnings.size() == 6);  // three a kind
    CHECK(result.loaded.mesh.uvs.empty());
    CHECK(result.loaded.mesh.normals[0] == glm::vec3(0, 0, 1));
}

TEST_CASE("mesh habits: # is part of a number behind its point and starts a comment elsewhere") {
    const LoadedText result = load_text(kVertices + "vn -1.#IND 0 0\nf 1//1 2//1 3//1#c\n");
    CHECK(has(only_warning(result), "normals have no length"));
    CHECK(result.loaded.mesh.normals[0] == glm::vec3(0, 0, 1));
}

TEST_CASE("mesh habits: a backslash at the end of a comment joins nothing to it") {
    CHECK(load_text("# C:\\art\\\n" + kVertices + "v 0 0 1\nf 1 2 3 # c \\\nf 3 2 1#c\\\nf 1 3 4\n")
              .loaded.mesh.triangle_count() == 3);
    CHECK(load_text(kVertices + "l 1 2 # c \\\nf 1 2 3\n").loaded.mesh.triangle_count() == 1);
    CHECK(load_text(kVertices + "f 1 2 \\\n3\n").loaded.mesh.triangle_count() == 1);
}

TEST_CASE("mesh habits: of many warnings of a kind ten are shown, and how many more there are") {
    std::string text = kVertices + "f 1 2 3\n";
    for (int i = 0; i < 25; ++i) text += "f 1 2\n";
    const LoadedText result = load_text(text + "s on\n");
    REQUIRE(result.warnings.size() == 12);
    CHECK(result.warnings[9].starts_with("a.obj:14:1: "));
    CHECK(result.warnings[10] == "a.obj: and 15 more: faces (f) of fewer than 3 corners");
    CHECK(has(result.warnings[11], "'on'"));
}

TEST_CASE("mesh habits: of five thousand odd lines of an MTL ten are shown, and how many more there are") {
    std::string mtl = "newmtl m\n";
    for (int i = 0; i < 5000; ++i) mtl += "map_Kd absent.png\n";
    const LoadedText result = load_text("mtllib a.mtl\n" + kVertices + "usemtl m\nf 1 2 3\n", mtl);
    REQUIRE(result.warnings.size() == 11);
    CHECK(result.warnings[9].starts_with("a.mtl:11:1: no such image file"));
    CHECK(result.warnings[10] == "a.mtl: and 4990 more: image files that are not there");
}

TEST_CASE("mesh habits: an odd line of an MTL costs one warning, and the rest counts") {
    const std::string obj = "mtllib a.mtl\n" + kVertices + "usemtl m\nf 1 2 3\n";
    for (const OddText& odd :
         {OddText{"map_Kd\n", "a.mtl:3:1: 'map_Kd' names no image file", "ignored"},
          OddText{"map_Kd C:\\art\\wood.png\n", "a.mtl:3:1: no such image file: 'C:\\art\\wood.png'", "without it"},
          OddText{"map_Kd ..\\maps\\wood.png\n", "a.mtl:3:1: no such image file", "wood.png'"},
          OddText{"map_Kd /art/wood.png\n", "a.mtl:3:1: no such image file: '/art/wood.png'", ""},
          OddText{"newmtl\nKd 1 1 1\n", "a.mtl:3:1: this newmtl has no name", "up to the next newmtl"},
          OddText{"d 0.3\n", "a.mtl:3:1: 'd': this material is transparent", "drawn opaque"},
          OddText{"Tr 0.7\n", "a.mtl:3:1: 'Tr': this material is transparent", "drawn opaque"},
          OddText{"d -halo 0.3\n", "a.mtl:3:1: 'd'", "drawn opaque"},
          OddText{"Kd 1 0\n", "a.mtl:3:7: the line ends", "r g b; the statement is ignored"},
          OddText{"Kd\n", "a.mtl:3:3: the line ends", "ignored"},
          OddText{"Kd 1 nan 0\n", "a.mtl:3:6: 'nan'", "finite"},
          OddText{"Kd 0,5\n", "a.mtl:3:4: '0,5'", "decimals with a point"},
          OddText{"Pm x\n", "a.mtl:3:4: 'x'", "a number"},
          OddText{"d x\n", "a.mtl:3:3: 'x'", "an opacity"},
          OddText{"Ks 0 0 0 1\n", "a.mtl:3:10: '1': a colour has 3 numbers", "the rest is ignored"},
          OddText{"Ks 0 255 0\n", "a.mtl:3:6: '255': Ks reflects more light than arrives", "divided by 255"},
          OddText{"Ka -1 0 0\n", "a.mtl:3:4: '-1': Ka is less than no light", ""},
          OddText{"map_Kd .\n", "a.mtl:3:1: no such image file: '.'", "without it"},
          OddText{"Ns -1\n", "a.mtl:3:4: '-1': Ns is the specular exponent", "0 is used"},
          OddText{"Pr 1.5\n", "a.mtl:3:4: '1.5': Pr is the roughness", "1 is used"}}) {
        CAPTURE(odd.text);
        const LoadedText result = load_text(obj, "newmtl m\nKd 0.25 0.5 0.75\n" + odd.text);
        check_says(only_warning(result), odd);
        REQUIRE(result.loaded.materials.size() == 1);
        CHECK(result.loaded.materials[0].phong.diffuse == glm::vec3(0.25f, 0.5f, 0.75f));
    }
    CHECK(load_text(obj, "newmtl m\nd 1\nTr 1\nTr 0\n").warnings.empty());  // d holds where both are there
}

TEST_CASE("mesh habits: a path of somebody else's disk leads to the file of that name beside the mesh") {
    const TempFolder folder;
    folder.write("wood.png", "x");
    folder.write("a.mtl", "newmtl m\nmap_Kd D:\\art\\wood.png\n");
    folder.write("a.obj", "mtllib /home/somebody/a.mtl\n" + kVertices + "usemtl m\nf 1 2 3\n");
    const LoadedText result = load(folder, "a.obj");
    REQUIRE(result.warnings.size() == 2);
    CHECK(has(result.warnings[0], "a.obj:1:1: '/home/somebody/a.mtl' is not there; "));
    CHECK(has(result.warnings[1], "a.mtl:2:1: 'D:\\art\\wood.png' is not there; "));
    REQUIRE(result.loaded.materials.size() == 1);
    CHECK(has(result.loaded.materials[0].maps.diffuse.file, "wood.png"));
}

TEST_CASE("mesh habits: of a long path the end is shown") {
    const std::string path = "C:\\" + std::string(200, 'x') + "\\the_file.png";
    const LoadedText result = load_text("mtllib a.mtl\n" + kVertices + "f 1 2 3\n", "newmtl m\nmap_Kd " + path + "\n");
    CHECK(has(only_warning(result), "xxx\\the_file.png'"));
    CHECK(has(only_warning(result), "'...xxx"));
}

TEST_CASE("mesh habits: maps of an MTL go where they belong, options and capitals or not") {
    const TempFolder folder;
    for (const char* name : {"kd.png", "ke.png", "bump it.png", "norm.png"}) folder.write(name, "x");
    const std::string face = kVertices + "usemtl m\nf 1 2 3\n";
    folder.write("a.obj", "mtllib a.mtl\n" + face);
    folder.write("a.mtl", "newmtl m\nmap_Kd kd.png\nmap_Bump -bm 0.5 bump it.png\nbump -bm 0.5 bump it.png\n");
    LoadedText result = load(folder, "a.obj");
    CHECK(result.warnings.empty());
    const kreda::lighting::MaterialMaps maps = result.loaded.materials[0].maps;
    CHECK(maps.albedo.file == folder.file("kd.png"));
    CHECK(maps.diffuse.file == folder.file("kd.png"));
    CHECK(maps.normal.file == folder.file("bump it.png"));
    CHECK(maps.normal_from_height);
    CHECK(maps.bump_scale == doctest::Approx(0.5 * 0.02));
    folder.write("a.mtl", "newmtl m\nnorm norm.png\nmap_bump bump it.png\n");
    result = load(folder, "a.obj");
    CHECK(result.loaded.materials[0].maps.normal.file == folder.file("norm.png"));
    CHECK_FALSE(result.loaded.materials[0].maps.normal_from_height);
}

TEST_CASE("mesh habits: a material's name in quotes, with a comment or in other capitals is found") {
    for (const std::string used : {"wood", "Wood", "\"wood\"", "wood # oak"}) {
        for (const std::string defined : {"wood", "WOOD", "wood # oak", "\"wood\""}) {
            if (used == defined) continue;
            CAPTURE(used);
            CAPTURE(defined);
            const LoadedText result = load_text("mtllib a.mtl\n" + kVertices + "usemtl " + used + "\nf 1 2 3\n",
                                                "newmtl " + defined + "\nKd 1 0 0\n");
            CHECK(only_warning(result) ==
                  "a.obj:5:1: the material '" + used + "' is in no MTL file; '" + defined + "' is used instead");
            CHECK(result.loaded.mesh.parts.at(0).material == 0);
        }
    }
    const LoadedText misspelt = load_text("mtllib a.mtl\n" + kVertices + "usemtl woood\nf 1 2 3\n", "newmtl wood\n");
    CHECK(has(only_warning(misspelt), "'woood' is in no MTL file; did you mean 'wood'?"));
    CHECK(misspelt.loaded.mesh.parts.at(0).material == -1);
    const TempFolder folder;
    folder.write("wood.png", "x");
    folder.write("wood #2.png", "x");
    folder.write("a.mtl", "newmtl a\nmap_Kd wood.png # oak\nnewmtl b\nmap_Kd wood #2.png\n");
    folder.write("a.obj", "mtllib a.mtl # mine\n" + kVertices + "usemtl a\nf 1 2 3\n");
    const LoadedText maps = load(folder, "a.obj");
    CHECK(maps.warnings.empty());
    CHECK(maps.loaded.materials.at(0).maps.diffuse.file == folder.file("wood.png"));
    CHECK(maps.loaded.materials.at(1).maps.diffuse.file == folder.file("wood #2.png"));
}

TEST_CASE("mesh habits: form feeds are blanks, and any number is a smoothing group") {
    CHECK(load_text("v\f0 0 0\nv 1 0 0\v\nv 0 1 0\n\ff 1 2 3\n").warnings.empty());
    for (const char* group : {"4294967296", "-1", "4294967297"}) {
        CAPTURE(group);
        const LoadedText result = load_text(kVertices + "s " + group + "\nf 1 2 3\n");
        CHECK(result.warnings.empty());
        CHECK(result.loaded.mesh.triangle_count() == 1);
    }
}

TEST_CASE("mesh habits: a path that differs in capitals is found, and a name misspelt gets its neighbour's") {
    const TempFolder folder;
    folder.write("Textures/Wood.PNG", "x");
    folder.write("Stone.mtl", "newmtl m\nmap_Kd textures\\wood.png\n");
    folder.write("a.obj", "mtllib stone.MTL\n" + kVertices + "usemtl m\nf 1 2 3\n");
    const LoadedText found = load(folder, "a.obj");
    CHECK(found.loaded.materials.at(0).maps.diffuse.file == folder.file("Textures/Wood.PNG"));
    REQUIRE(found.warnings.size() == 2);
    CHECK(found.warnings[0].starts_with("a.obj:1:1: 'stone.MTL' is not there; '"));
    CHECK(has(found.warnings[0], "Stone.mtl' is used instead"));
    CHECK(has(found.warnings[1], "Textures/Wood.PNG' is used instead"));
    folder.write("Stone.mtl", "newmtl m\nmap_Kd Textures/Woood.PNG\n");
    folder.write("a.obj", "mtllib Stome.mtl\n" + kVertices + "f 1 2 3\n");
    CHECK(has(load(folder, "a.obj").warnings.at(0), "no such material file: 'Stome.mtl'; did you mean 'Stone.mtl'?"));
    folder.write("a.obj", "mtllib Stone.mtl\n" + kVertices + "usemtl m\nf 1 2 3\n");
    CHECK(has(load(folder, "a.obj").warnings.at(0),
              "no such image file: 'Textures/Woood.PNG'; drawn without it; did you mean 'Wood.PNG'?"));
}

TEST_CASE("mesh habits: other formats are called by their names, with the way to one that is read") {
    CHECK(has(other_format("a/b.PLY"), "is a PLY mesh; Kreda reads meshes as OBJ or glTF"));
    CHECK(has(other_format("a/b.stl"), "`assimp export b.stl b.obj`"));
    CHECK(other_format("b.glb").empty());
    CHECK(has(other_format("b.fbx"), "Blender"));
    CHECK(has(other_format("b.mtl"), "give the OBJ file itself"));
    CHECK(has(other_format("b.png"), "is an image"));
    CHECK(has(other_format("b.zip"), "unpack"));
    CHECK(other_format("b.obj").empty());
    CHECK(other_format("b.toml").empty());
    CHECK(other_format("b").empty());
    const TempFolder folder;
    CHECK_THROWS_AS((void)load_mesh_file(folder.write("a.stl", "solid a\n")), UserError);
}
