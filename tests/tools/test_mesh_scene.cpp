// The scene that `kreda render MESH.obj` makes around a mesh.
#include <cstdio>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "raster/camera.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/mesh_scene.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("A mesh file is known by its ending whatever the case") {
    CHECK(tools::is_mesh_file("a/bunny.obj"));
    CHECK(tools::is_mesh_file("BUNNY.OBJ"));
    CHECK_FALSE(tools::is_mesh_file("bunny.toml"));
    CHECK_FALSE(tools::is_mesh_file("obj"));
}

TEST_CASE("A scene around a mesh reads the mesh once") {
    const TempFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    scene::LoadedFiles files;
    scene::ReadOptions read;
    read.files = &files;
    CHECK(tools::read_scene_around_mesh(folder.file("a.obj"), read).objects[0].mesh->triangle_count() == 1);
    CHECK(files.reads == 1);
}

TEST_CASE("The camera around a mesh sees all of it between its near and far plane at any size of the mesh") {
    for (const double size : {1e-20, 1e-8, 1e-3, 1.0, 40.0, 1e5, 1e30}) {
        CAPTURE(size);
        const TempFolder folder;
        std::string obj;
        for (int i = 0; i < 8; ++i) {  // the corners of a box far from the origin
            const auto coordinate = [&](int bit) {
                char number[40];
                std::snprintf(number, sizeof number, "%.17g", size * (3.0 + ((i >> bit & 1) ? 1.0 : 0.0)));
                return std::string(number);
            };
            obj += "v " + coordinate(0) + " " + coordinate(1) + " " + coordinate(2) + "\n";
        }
        folder.write("box.obj", obj + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
        const scene::Scene scene = tools::read_scene_around_mesh(folder.file("box.obj"), {});
        const glm::mat4 clip_from_world = raster::clip_from_world(scene.camera, 640.0f / 360.0f);
        for (const glm::vec3& corner : scene.objects.at(0).mesh->positions) {
            const glm::vec4 clip = clip_from_world * scene.objects[0].world_from_object * glm::vec4(corner, 1.0f);
            CHECK(std::abs(clip.x) < clip.w);
            CHECK(std::abs(clip.y) < clip.w);
            CHECK(std::abs(clip.z) < clip.w);
        }
    }
}

TEST_CASE("render takes a mesh and names the picture after it") {
    const TempFolder folder;
    folder.write("one triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome = run_kreda({"render", "one triangle.obj", "--size", "32x18"}, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const raster::Image picture = scene::read_image(folder.file("one triangle.png"));
    CHECK(picture.width == 32);
    const glm::vec3 background = picture.rgb(0, 0);
    CHECK(glm::distance(picture.rgb(15, 10), background) > 0.05f);  // left of and below the middle of the hypotenuse
}
