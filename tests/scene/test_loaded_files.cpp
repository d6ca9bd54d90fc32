// What is kept of files is what reading them anew gives; a file that changes is read again, and no other.
#include "scene/files/loaded_files.hpp"

#include <filesystem>

#include <doctest/doctest.h>

#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr const char* kTriangle = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n";

struct SceneFolder {
    TempFolder folder;
    scene::LoadedFiles files;

    SceneFolder() {
        folder.write("a.obj", std::string(kTriangle) + "f 1/1 2/2 3/3\n");
        folder.write("a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd squares.png\n");
        raster::Image squares = raster::make_image(4, 4, 3);
        squares.set_rgb(1, 1, glm::vec3(1.0f));
        scene::write_png(folder.file("squares.png"), squares);
        scene::write_png(folder.file("sky.png"), raster::make_image(8, 4, 3));
        folder.write("a.toml",
                     "[environment]\nfile = \"sky.png\"\n[[material]]\nname = \"n\"\nmodel = \"cook_torrance\"\n"
                     "normal_map = \"squares.png\"\n[[object]]\nmesh = \"a.obj\"\n[[object]]\nmesh = \"sphere\"\n"
                     "material = \"n\"\n");
        let_files_settle();
    }
    [[nodiscard]] scene::Scene read() {
        scene::ReadOptions options;
        options.files = &files;
        return scene::read_scene(folder.file("a.toml"), options);
    }
    [[nodiscard]] scene::Scene read_anew() const {
        return scene::read_scene(folder.file("a.toml"));
    }
};

void check_same(const scene::Scene& kept, const scene::Scene& anew) {
    CHECK(kept.warnings == anew.warnings);
    REQUIRE(kept.objects.size() == anew.objects.size());
    for (std::size_t i = 0; i < anew.objects.size(); ++i) {
        CHECK(kept.objects[i].mesh->positions == anew.objects[i].mesh->positions);
        CHECK(kept.objects[i].mesh->normals == anew.objects[i].mesh->normals);
        CHECK(kept.objects[i].mesh->tangents == anew.objects[i].mesh->tangents);
        CHECK(kept.objects[i].part_material == anew.objects[i].part_material);
    }
    REQUIRE(kept.materials.size() == anew.materials.size());
    for (std::size_t m = 0; m < anew.materials.size(); ++m) {
        CHECK(kept.materials[m].phong.diffuse == anew.materials[m].phong.diffuse);
        const auto& map = kept.materials[m].maps.diffuse.texture;
        const auto& expected = anew.materials[m].maps.diffuse.texture;
        REQUIRE((map != nullptr) == (expected != nullptr));
        if (map) CHECK(map->texels == expected->texels);
    }
    CHECK(kept.environment.image->values == anew.environment.image->values);
}

}  // namespace

TEST_CASE("loaded files: a scene that is read again reads no file but itself") {
    SceneFolder f;
    const scene::Scene first = f.read();
    const int reads = f.files.reads;
    CHECK(reads == 4);  // a.obj with its MTL, squares.png as a colour and as normals, sky.png
    const scene::Scene again = f.read();
    CHECK(f.files.reads == reads);
    CHECK(again.objects[0].mesh == first.objects[0].mesh);
    CHECK(again.objects[1].mesh == first.objects[1].mesh);
    CHECK(!again.objects[1].mesh->tangents.empty());
    CHECK(again.environment.image == first.environment.image);
    check_same(again, f.read_anew());
}

TEST_CASE("loaded files: what changes is read again and nothing else") {
    SceneFolder f;
    const scene::Scene first = f.read();
    const auto reads_after = [&](const char* name, const std::string& bytes) {
        f.folder.write(name, bytes);
        let_files_settle();
        const int before = f.files.reads;
        check_same(f.read(), f.read_anew());
        return f.files.reads - before;
    };
    CHECK(reads_after("a.mtl", "newmtl m\nKd 0 1 0\nmap_Kd squares.png\n") == 1);
    CHECK(reads_after("a.obj", std::string(kTriangle) + "f 1/1 3/3 2/2\n") == 1);
    CHECK(reads_after("a.mtl", "newmtl m\nKd 0 1 1\n") == 1);
    raster::Image other = raster::make_image(8, 4, 3);
    other.set_rgb(0, 0, glm::vec3(0.5f));
    scene::write_png(f.folder.file("sky.png"), other);
    CHECK(reads_after("unread.txt", "") == 1);
}

TEST_CASE("loaded files: a file that was missing is found when it comes") {
    SceneFolder f;
    std::filesystem::remove(f.folder.file("a.mtl"));
    let_files_settle();
    CHECK(f.read().warnings.size() == 2);  // no such file, no such material
    check_same(f.read(), f.read_anew());
    f.folder.write("a.mtl", "newmtl m\nKd 0 1 0\nmap_Kd other.png\n");
    check_same(f.read(), f.read_anew());
    std::filesystem::copy(f.folder.file("squares.png"), f.folder.file("other.png"));
    const scene::Scene found = f.read();
    check_same(found, f.read_anew());
    CHECK(found.warnings.empty());
}

TEST_CASE("loaded files: a change within one step of the clock is not missed") {
    SceneFolder f;
    for (int i = 0; i < 30; ++i) {
        f.folder.write("a.mtl", "newmtl m\nKd 0." + std::to_string(10 + i) + " 0 0\n");  // as long as before
        check_same(f.read(), f.read_anew());
    }
}

TEST_CASE("loaded files: what a scene no longer asks for is forgotten") {
    SceneFolder f;
    (void)f.read();
    forget_unused(f.files);
    f.folder.write("a.toml", "[[object]]\nmesh = \"cube\"\n");
    (void)f.read();
    forget_unused(f.files);
    CHECK(f.files.meshes.empty());
    CHECK(f.files.textures.empty());
    CHECK(f.files.environments.empty());
    CHECK(f.files.tangents.empty());
    CHECK(f.files.shapes.size() == 1);
}

TEST_CASE("loaded files: maps are decoded side by side, and the first error in the scene's order is told") {
    const TempFolder folder;
    std::string text;
    for (int i = 0; i < 6; ++i) {
        const std::string name = "m" + std::to_string(i);
        scene::write_png(folder.file(name + ".png"), raster::make_image(8 + i, 4, 3));
        text += "[[material]]\nname = \"" + name + "\"\ndiffuse_map = \"" + name +
                ".png\"\n[[object]]\nmesh = \"plane\"\n" + "material = \"" + name + "\"\n";
    }
    folder.write("a.toml", text);
    const scene::Scene scene = scene::read_scene(folder.file("a.toml"));
    for (int i = 0; i < 6; ++i) CHECK(scene.materials[std::size_t(i)].maps.diffuse.texture->width == 8 + i);
    folder.write("m4.png", "no picture");
    folder.write("m2.png", "none either");
    CHECK_THROWS_WITH((void)scene::read_scene(folder.file("a.toml")), doctest::Contains("m2.png: "));
}
