#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <glm/vec4.hpp>

#include "scene/files/read_objects.hpp"
#include "scene/files/read_scene.hpp"

using namespace kreda::scene;

namespace {

/// A folder that is there while the test runs, with a mesh of three parts: one bare, two with materials of the file.
struct MeshFolder {
    // Tests run as processes side by side: each has its own folder.
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("kreda_read_objects_" + std::to_string(getpid()));

    MeshFolder() {
        std::filesystem::create_directories(path);
        write("parts.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
        write("parts.obj",
              "mtllib parts.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
              "g bare\nf 1 2 3\ng body\nusemtl red\nf 1 2 3\ng lid\nusemtl blue\nf 2 4 3\n");
        write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    ~MeshFolder() {
        std::filesystem::remove_all(path);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
    }
    [[nodiscard]] Scene read(const std::string& text) const {
        return read_scene_text(text, "s.toml", path.string());
    }
    [[nodiscard]] std::string complaint(const std::string& text) const {
        try {
            const Scene scene = read(text);
        } catch (const UserError& error) { return error.what(); }
        return "no complaint";
    }
};

glm::vec3 moved(const Object& object, glm::vec3 p) {
    return object.world_from_object * glm::vec4(p, 1.0f);
}

void check_near(glm::vec3 actual, glm::vec3 expected) {
    for (int i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(actual[i] == doctest::Approx(expected[i]).epsilon(1e-6));  // cos(90 degrees) is 6e-17 in double
    }
}

}  // namespace

TEST_CASE("An object is scaled first then turned about x then y then z then moved") {
    const MeshFolder folder;
    const std::string cube = "[[object]]\nmesh = 'cube'\n";
    // (0,1,0) turned by 90 degrees about x is (0,0,1); that about y is (1,0,0); that about z is (0,1,0).
    check_near(moved(folder.read(cube + "rotate = [90, 0, 0]").objects[0], {0, 1, 0}), {0, 0, 1});
    check_near(moved(folder.read(cube + "rotate = [90, 90, 0]").objects[0], {0, 1, 0}), {1, 0, 0});
    check_near(moved(folder.read(cube + "rotate = [90, 90, 90]").objects[0], {0, 1, 0}), {0, 1, 0});
    // Scaled to (0,2,0), turned to (0,0,2), moved to (5,6,9).
    const std::string all = cube + "scale = [1, 2, 3]\nrotate = [90, 0, 0]\ntranslate = [5, 6, 7]\n";
    check_near(moved(folder.read(all).objects[0], {0, 1, 0}), {5, 6, 9});
}

TEST_CASE("One number scales all three directions") {
    const MeshFolder folder;
    const Scene scene = folder.read("[[object]]\nmesh = 'cube'\nscale = 2\n");
    CHECK(moved(scene.objects[0], {1, 2, 3}) == glm::vec3(2.0f, 4.0f, 6.0f));
}

TEST_CASE("An object that would be flattened is refused") {
    const MeshFolder folder;
    CHECK(folder.complaint("[[object]]\nmesh = 'cube'\nscale = 0\n").substr(0, 20) == "s.toml:3:9: 'scale' ");
    CHECK(folder.complaint("[[object]]\nmesh = 'cube'\nscale = [1, 0, 1]\n").substr(0, 20) == "s.toml:3:9: 'scale' ");
    CHECK(folder.complaint("[[object]]\nmesh = 'cube'\nscale = [1, -1, 1]\n") == "no complaint");  // a mirror image
}

TEST_CASE("Detail belongs to built-in meshes and has the range of the shape") {
    const MeshFolder folder;
    const auto triangles = [&](const std::string& lines) {
        return folder.read("[[object]]\n" + lines).objects[0].mesh->triangle_count();
    };
    CHECK(triangles("mesh = 'plane'\ndetail = 3\n") == 2 * 3 * 3);
    CHECK(triangles("mesh = 'plane'\n") == 2);  // each shape has its own default: a plane is one quad
    CHECK(triangles("mesh = 'terrain'\n") == 2 * 64 * 64);
    CHECK(folder.complaint("[[object]]\nmesh = 'sphere'\ndetail = 2\n").substr(0, 13) == "s.toml:3:10: ");
    CHECK(folder.complaint("[[object]]\nmesh = 'bare.obj'\ndetail = 2\n") ==
          "s.toml:3:1: 'detail' is for built-in meshes; 'bare.obj' is a file, its triangles are fixed");
}

TEST_CASE("A mesh that is not there is reported where it is named") {
    const MeshFolder folder;
    CHECK(folder.complaint("[[object]]\n") ==
          "s.toml:1:1: an [[object]] needs a mesh, e.g. mesh = \"teapot\" or mesh = \"model.obj\"");
    const std::string message = folder.complaint("[[object]]\nmesh = 'shpere'\n");
    CHECK(message.substr(0, 34) == "s.toml:2:8: there is no mesh file ");
    CHECK(message.find("did you mean 'sphere'?") != std::string::npos);
}

TEST_CASE("The material of an object covers all its parts") {
    const MeshFolder folder;
    const Scene scene = folder.read(
        "[[material]]\nname = 'a'\n[[material]]\nname = 'b'\n"
        "[[object]]\nmesh = 'parts.obj'\nmaterial = 'b'\n");
    CHECK(scene.objects[0].part_material == std::vector<int>{1, 1, 1});
}

TEST_CASE("Without a material the parts have those of the file or the default") {
    const MeshFolder folder;
    const Scene scene = folder.read("[[material]]\nname = 'a'\n[[object]]\nmesh = 'parts.obj'\n");
    const Object& object = scene.objects[0];
    REQUIRE(object.part_material.size() == 3);
    const auto material_of = [&](std::size_t part) {
        return scene.materials.at(static_cast<std::size_t>(object.part_material[part]));
    };
    CHECK(material_of(0).name == "default");
    CHECK(material_of(1).phong.diffuse == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(material_of(2).phong.diffuse == glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST_CASE("A material named default is the default") {
    const MeshFolder folder;
    const Scene scene = folder.read("[[material]]\nshininess = 7\n[[object]]\nmesh = 'cube'\n");
    CHECK(scene.materials.size() == 1);
    CHECK(scene.objects[0].part_material.at(0) == 0);
}

TEST_CASE("An unknown material is reported where it is named") {
    const MeshFolder folder;
    CHECK(folder.complaint("[[material]]\nname = 'gold'\n[[object]]\nmesh = 'cube'\nmaterial = 'glod'\n") ==
          "s.toml:5:12: there is no material 'glod'; did you mean 'gold'?");
    CHECK(folder.complaint("[[object]]\nmesh = 'cube'\nmaterial = 'gold'\n") ==
          "s.toml:3:12: there is no material 'gold'; the scene has no [[material]]");
}

TEST_CASE("Hidden parts are known parts") {
    const MeshFolder folder;
    const Scene scene = folder.read("[[object]]\nmesh = 'parts.obj'\nhide = ['lid', 'bare']\n");
    CHECK(scene.objects[0].part_hidden == std::vector<bool>{true, false, true});
    CHECK(folder.complaint("[[object]]\nmesh = 'parts.obj'\nhide = ['lid', 'boddy']\n") ==
          "s.toml:3:16: the mesh has no part 'boddy'; did you mean 'body'?");
}

TEST_CASE("Objects of the same mesh and settings share it") {
    const MeshFolder folder;
    const Scene scene = folder.read(
        "[[object]]\nmesh = 'parts.obj'\n[[object]]\nmesh = './parts.obj'\n"
        "[[object]]\nmesh = 'parts.obj'\nnormals = 'flat'\n"
        "[[object]]\nmesh = 'cube'\ndetail = 2\n[[object]]\nmesh = 'cube'\ndetail = 2\n"
        "[[object]]\nmesh = 'cube'\ndetail = 3\n");
    CHECK(scene.objects[0].mesh == scene.objects[1].mesh);
    CHECK(scene.objects[0].part_material == scene.objects[1].part_material);
    CHECK(scene.objects[0].mesh != scene.objects[2].mesh);
    CHECK(scene.objects[3].mesh == scene.objects[4].mesh);
    CHECK(scene.objects[3].mesh != scene.objects[5].mesh);
}

TEST_CASE("Flat normals of a built-in mesh are those of its triangles") {
    const MeshFolder folder;
    const Scene scene = folder.read("[[object]]\nmesh = 'sphere'\ndetail = 8\nnormals = 'flat'\n");
    const kreda::raster::Mesh& mesh = *scene.objects[0].mesh;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        CHECK(mesh.normals[mesh.indices[i]] == mesh.normals[mesh.indices[i + 1]]);
        CHECK(mesh.normals[mesh.indices[i]] == mesh.normals[mesh.indices[i + 2]]);
    }
}
