// Well-formed OBJ and MTL files: what they become. What is wrong with a file is in test_mesh_errors.cpp.
#include "scene/files/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using scene::load_mesh_file;
using scene::LoadedMesh;
using scene::MeshFileOptions;
using scene::Normals;
using tests::TempFolder;

namespace {

LoadedMesh load_bare(const std::string& obj, Normals normals = Normals::file) {
    const TempFolder folder;
    MeshFileOptions options;
    options.normals = normals;
    return load_mesh_file(folder.write("a.obj", obj), options);
}

LoadedMesh load_with_mtl(const std::string& mtl, const std::string& used = "m") {
    const TempFolder folder;
    folder.write("a.mtl", mtl);
    return load_mesh_file(
        folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + used + "\nf 1 2 3\n"));
}

double area(const raster::Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[t]];
        sum += 0.5 * glm::length(
                         glm::cross(mesh.positions[mesh.indices[t + 1]] - a, mesh.positions[mesh.indices[t + 2]] - a));
    }
    return sum;
}

bool mentions(const std::vector<std::string>& warnings, const std::string& words) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const auto& w) { return w.find(words) != w.npos; });
}

const std::string kBareTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::vector<glm::vec3> kTrianglePositions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const glm::vec3 kUp{0, 0, 1};  // the normal of that triangle

}  // namespace

TEST_CASE("mesh file: positions are shared and kept in the order of first use") {
    const LoadedMesh loaded = load_bare("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 2 3 4\nf 4 3 5\n");
    CHECK(loaded.mesh.positions ==
          std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});  // 9 9 9 is unused
    CHECK(loaded.mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3});
    CHECK(loaded.mesh.uvs.empty());
    CHECK(loaded.warnings.empty());
}

TEST_CASE("mesh file: one position with two texture coordinates becomes two vertices") {
    const LoadedMesh loaded = load_bare(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt .5 .5\n"
        "f 1/1 2/2 3/3\nf 3/1 2/2 4/3\n");
    CHECK(loaded.mesh.positions.size() == 5);
    CHECK(loaded.mesh.uvs[2] == glm::vec2(.5, .5));
    CHECK(loaded.mesh.uvs[3] == glm::vec2(0, 0));
    CHECK(loaded.mesh.positions[2] == loaded.mesh.positions[3]);
}

TEST_CASE("mesh file: negative indices count back from their line") {
    const LoadedMesh loaded =
        load_bare("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvn 0 0 2\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nv 9 9 9\n");
    CHECK(loaded.mesh.positions == kTrianglePositions);
    CHECK(loaded.mesh.normals == std::vector<glm::vec3>(3, kUp));  // brought to unit length
    CHECK(loaded.mesh.uvs == std::vector<glm::vec2>(3, glm::vec2(0, 1)));
}

TEST_CASE("mesh file: faces may come before their vertices") {
    CHECK(load_bare("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").mesh.positions == kTrianglePositions);
}

TEST_CASE("mesh file: all ways to write one triangle are the same triangle") {
    for (const std::string& text : {std::string("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),  // byte-order mark
                                    std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"),      // CRLF
                                    std::string("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3"),  // CR, no end of line at the end
                                    std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 # comment\n"),
                                    std::string("# comment\nv 0 0 0# c\n\n  v\t1   0 0\nv 0 1 0\nf 1 2 3#c\n"),
                                    std::string("v 0 0 0\nv 1 0 \\\n 0\nv 0 1 0\nf 1 \\\r\n2 3\\"),  // continuations
                                    std::string("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0\nf 1 2 3\n"),         // weights
                                    std::string("v -0 +0 0.\nv 1e0 .0 0E-5\nv 0 10e-1 1e-999\nf 1// 2/ 3\n"),
                                    std::string("vt 0.5\nvt 1 2 3\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")}) {
        CAPTURE(text);
        const LoadedMesh loaded = load_bare(text);
        CHECK(loaded.mesh.positions == kTrianglePositions);
        CHECK(loaded.mesh.normals == std::vector<glm::vec3>(3, kUp));
        CHECK(loaded.warnings.empty());
    }
}

TEST_CASE("mesh file: concave polygons keep their area") {
    // The L of three unit squares, starting where a fan would leave it.
    const LoadedMesh loaded = load_bare("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 2 3 4 5 6 1\n");
    CHECK(loaded.mesh.triangle_count() == 4);
    CHECK(area(loaded.mesh) == 3.0);
    CHECK(loaded.warnings.empty());
}

TEST_CASE("mesh file: a polygon of 300 corners has 298 triangles") {
    // A staircase of 149 steps over (0,0) (149,0): its columns are 149, 148 ... 1 high. A byte would hold 300 - 256
    // corners.
    constexpr int kSteps = 149;
    std::string text = "v 0 0 0\nv " + std::to_string(kSteps) + " 0 0\n";
    for (int i = kSteps - 1; i >= 0; --i) {
        const std::string y = std::to_string(kSteps - i) + " 0\n";
        text.append("v ").append(std::to_string(i + 1)).append(" ").append(y);
        text.append("v ").append(std::to_string(i)).append(" ").append(y);
    }
    std::string face = "f";
    for (int corner = 1; corner <= 300; ++corner) face.append(" ").append(std::to_string((corner + 1) % 300 + 1));
    const LoadedMesh loaded = load_bare(text + face + "\n");
    CHECK(loaded.mesh.triangle_count() == 298);
    CHECK(area(loaded.mesh) == kSteps * (kSteps + 1) / 2);
    CHECK(loaded.warnings.empty());
}

TEST_CASE("mesh file: groups and objects are parts and a change of material splits them") {
    const std::string f = "f 1 2 3\n";
    const LoadedMesh loaded = load_bare("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + f + "o pot\n" + f + "f 3 2 1\n" +
                                        "g lid knob\n" + f + "g empty\ng\n" + f + "usemtl red\n" + f);
    const auto& parts = loaded.mesh.parts;
    REQUIRE(parts.size() == 5);
    const std::vector<std::string> names = {"", "pot", "lid knob", "default", "default"};
    const std::vector<std::uint32_t> counts = {1, 2, 1, 1, 1};
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        CAPTURE(i);
        CHECK(parts[i].name == names[i]);
        CHECK(parts[i].first_triangle == first);
        CHECK(parts[i].triangle_count == counts[i]);
        CHECK(parts[i].material == -1);
        first += parts[i].triangle_count;
    }
    CHECK(first == loaded.mesh.triangle_count());
    CHECK(mentions(loaded.warnings, "a.obj:13:1: the material 'red' is in no MTL file"));
}

TEST_CASE("mesh file: a triangle that uses a corner twice is left out and other degenerate ones stay") {
    const LoadedMesh loaded = load_bare("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 1 2\nf 1 2 3\n");
    CHECK(loaded.mesh.triangle_count() == 2);
}

TEST_CASE("mesh file: without normals smooth ones are made up to 60 degrees") {
    // Two squares that meet at the y axis, the second one tilted: by 45 degrees they share normals, by 90 they do not.
    const auto roof = [](const std::string& x, const std::string& z) {
        return load_bare("v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv " + x + " 0 " + z + "\nv " + x + " 1 " + z +
                         "\nf 1 2 3 4\nf 2 5 6 3\n")
            .mesh;
    };
    CHECK(roof("1", "-1").positions.size() == 6);
    CHECK(roof("0", "-1").positions.size() == 8);
}

TEST_CASE("mesh file: smoothing groups decide where the file has them") {
    const std::string v = "v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv 0 0 -1\nv 0 1 -1\n";
    CHECK(load_bare(v + "s 1\nf 1 2 3 4\nf 2 5 6 3\n").mesh.positions.size() == 6);
    CHECK(load_bare(v + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n").mesh.positions.size() == 8);
    CHECK(load_bare(v + "s off\nf 1 2 3 4\nf 2 5 6 3\n").mesh.positions.size() == 12);
}

TEST_CASE("mesh file: normals of no length are made and the others stay") {
    const LoadedMesh loaded =
        load_bare("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nvn 0 0 0\nvn nan nan -inf\nf 1//1 2//2 3//3\n");
    REQUIRE(loaded.mesh.normals.size() == 3);
    CHECK(loaded.mesh.normals[0] == glm::vec3(0.0f, 0.6f, 0.8f));
    CHECK(loaded.mesh.normals[1] == kUp);
    CHECK(loaded.mesh.normals[2] == kUp);
    CHECK(mentions(loaded.warnings, "2 normals have no length"));
}

TEST_CASE("mesh file: normals can be made anew smooth or flat") {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 1 0 0\nf 1//1 2//1 4//1 3//1\n";
    CHECK(load_bare(text).mesh.normals == std::vector<glm::vec3>(4, glm::vec3(1, 0, 0)));
    CHECK(load_bare(text, Normals::smooth).mesh.normals == std::vector<glm::vec3>(4, kUp));
    CHECK(load_bare(text, Normals::flat).mesh.normals == std::vector<glm::vec3>(6, kUp));
}

TEST_CASE("mesh file: MTL constants become a Blinn-Phong material") {
    const LoadedMesh loaded =
        load_with_mtl("newmtl m\nKa .1 .2 .3\nKd 0.5\nKs 1 .5 .25 # shiny\nKe 0 0 2\nNs 96\nillum 2\n");
    REQUIRE(loaded.materials.size() == 1);
    const lighting::Material& m = loaded.materials[0];
    CHECK(loaded.mesh.parts[0].material == 0);
    CHECK(m.name == "m");
    CHECK(m.model == lighting::ReflectionModel::blinn_phong);
    CHECK(m.phong.ambient == glm::vec3(.1f, .2f, .3f));
    CHECK(m.phong.diffuse == glm::vec3(.5f));  // one number is grey
    CHECK(m.phong.specular == glm::vec3(1, .5, .25));
    CHECK(m.phong.emission == glm::vec3(0, 0, 2));
    CHECK(m.phong.shininess == 96.0f);
}

TEST_CASE("mesh file: without highlight or with illum 1 the material is Lambert") {
    CHECK(load_with_mtl("newmtl m\nKd 1 0 0\n").materials[0].model == lighting::ReflectionModel::lambert);
    CHECK(load_with_mtl("newmtl m\nKs 1 1 1\nillum 1\n").materials[0].model == lighting::ReflectionModel::lambert);
    CHECK(load_with_mtl("newmtl m\n").materials[0].phong.diffuse == lighting::PhongMaterial{}.diffuse);
}

TEST_CASE("mesh file: the PBR extension becomes a Cook-Torrance material") {
    const lighting::Material m = load_with_mtl("newmtl m\nKd 1 .5 .25\nPr .25\nPm 1\n").materials[0];
    CHECK(m.model == lighting::ReflectionModel::cook_torrance);
    CHECK(m.cook_torrance.albedo == glm::vec3(1, .5, .25));
    CHECK(m.cook_torrance.roughness == .25f);
    CHECK(m.cook_torrance.metallic == 1.0f);
}

TEST_CASE("mesh file: maps are found beside their MTL and absent ones only warn") {
    const TempFolder folder;
    folder.write("textures/wood grain.png", "");
    folder.write("textures/r.png", "");
    folder.write("textures/a.mtl",
                 "newmtl m\nmap_Kd -s 1 1 -bm 0.5 wood grain.png\nmap_Pr r.png\nmap_Pm absent.png\n"
                 "norm ..\\textures\\r.png\ndisp r.png\n");
    const LoadedMesh loaded = load_mesh_file(folder.write("a.obj", "mtllib textures/a.mtl\n" + kBareTriangle));
    const lighting::MaterialMaps& maps = loaded.materials.at(0).maps;
    CHECK(std::filesystem::equivalent(maps.albedo.file, folder.file("textures/wood grain.png")));
    CHECK(maps.diffuse.file == maps.albedo.file);
    CHECK(std::filesystem::equivalent(maps.roughness.file, folder.file("textures/r.png")));
    CHECK(std::filesystem::equivalent(maps.normal.file, folder.file("textures/r.png")));
    CHECK(maps.metallic.file.empty());
    CHECK(loaded.materials[0].model == lighting::ReflectionModel::cook_torrance);
    CHECK(mentions(loaded.warnings, "a.mtl:4:1: no such image file"));
    CHECK(mentions(loaded.warnings, "a.mtl:6:1: 'disp' is ignored"));
}

TEST_CASE("mesh file: parts of different materials share no vertex") {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const LoadedMesh loaded = load_mesh_file(folder.write(
        "a.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"));
    REQUIRE(loaded.mesh.parts.size() == 2);
    CHECK(loaded.mesh.positions.size() == 6);
    CHECK(loaded.mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("mesh file: several materials in several files with blanks in their names") {
    const TempFolder folder;
    folder.write("red and blue.mtl", "newmtl dark red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    folder.write("b.mtl", "newmtl blue\nKd .9 .9 .9\nnewmtl Material #25\nKd 0 1 0\n");
    const LoadedMesh loaded = load_mesh_file(folder.write(
        "a.obj",
        "mtllib red and blue.mtl\nmtllib b.mtl absent.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Material #25\nf 1 2 3\n"
        "usemtl  dark red \nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl blue\nf 3 2 1\n"));
    REQUIRE(loaded.mesh.parts.size() == 3);
    const auto diffuse = [&](std::size_t part) {
        return loaded.materials.at(std::size_t(loaded.mesh.parts[part].material)).phong.diffuse;
    };
    CHECK(diffuse(0) == glm::vec3(0, 1, 0));
    CHECK(diffuse(1) == glm::vec3(1, 0, 0));
    CHECK(diffuse(2) == glm::vec3(0, 0, 1));  // the first of two with one name
    CHECK(mentions(loaded.warnings, "a.obj:2:1: no such material file"));
    CHECK(loaded.warnings.size() == 1);
}

TEST_CASE("mesh file: a missing MTL is a warning and lines and points are counted") {
    const LoadedMesh loaded = load_bare("mtllib none.mtl\nusemtl red\n" + kBareTriangle + "l 1 2\np 1\n");
    CHECK(loaded.mesh.triangle_count() == 1);
    CHECK(mentions(loaded.warnings, "a.obj:1:1: no such material file"));
    CHECK(mentions(loaded.warnings, "a.obj:7:1: 'l'"));
    CHECK(mentions(loaded.warnings, "2 statements"));
}

TEST_CASE("mesh file: real meshes have their known numbers of triangles") {
    const std::string data = tests::shared_data_folder();
    if (data.empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    const LoadedMesh bunny = load_mesh_file(data + "/bunny.obj");
    const LoadedMesh teapot = load_mesh_file(data + "/teapot.obj");
    const LoadedMesh spot = load_mesh_file(data + "/spot.obj");
    CHECK(bunny.mesh.triangle_count() == 3674);
    CHECK(teapot.mesh.triangle_count() == 992);
    CHECK(spot.mesh.triangle_count() == 2 * 2928);  // quads
    CHECK(spot.mesh.uvs.size() == spot.mesh.positions.size());
    const auto places = [](const LoadedMesh& loaded) {
        std::set<std::array<float, 3>> different;
        for (const glm::vec3& p : loaded.mesh.positions) different.insert({p.x, p.y, p.z});
        return different.size();
    };
    CHECK(places(bunny) == 1839);
    CHECK(places(teapot) <= 792);
    for (const LoadedMesh* loaded : {&bunny, &teapot, &spot}) {
        CHECK(loaded->warnings.empty());
        for (const glm::vec3& n : loaded->mesh.normals) CHECK(glm::length(n) == doctest::Approx(1.0).epsilon(1e-6));
    }
}
