// The scene that `kreda render SCENE.glb` makes of a glTF file.
#include <doctest/doctest.h>

#include <glm/vec3.hpp>

#include "scene/files/image_file.hpp"
#include "tests/scene/gltf_maker.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/mesh_scene.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("render takes a glTF file with its camera and its lights") {
    const TempFolder folder;
    GltfMaker maker;
    maker.add(std::vector<float>{-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0}, kFloat, 3);
    // A white wall that fills the view, lit by 31,400 candela from 10 away: 314 lux, radiance 100.
    folder.write("wall.glb", maker.glb(one_mesh(
                                 kPosition0 + ",\"mode\":5,\"material\":0",
                                 ",\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0}}],\"cameras\":[{"
                                 "\"type\":\"orthographic\","
                                 "\"orthographic\":{\"xmag\":1,\"ymag\":0.5,\"znear\":0.1,\"zfar\":10}}],"
                                 "\"extensions\":{\"KHR_lights_punctual\":"
                                 "{\"lights\":[{\"type\":\"point\",\"intensity\":31415.9265}]}}",
                                 "\"mesh\":0,\"children\":[1,2]},{\"camera\":0,\"translation\":[0,0,5]},"
                                 "{\"translation\":[0,0,10],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}")));
    const scene::Scene scene = tools::read_scene_around_mesh(folder.file("wall.glb"), {});
    CHECK(scene.image.width == 640);  // xmag : ymag is 2 : 1
    CHECK(scene.image.height == 320);
    CHECK(scene.camera.projection == raster::Projection::orthographic);
    CHECK(scene.camera.height == 1.0f);
    CHECK(glm::dvec3(scene.camera.position) + scene.origin == glm::dvec3(0, 0, 5));
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].type == lighting::LightType::point);
    CHECK(scene.image.exposure == doctest::Approx(0.01));
    const Outcome outcome =
        run_kreda({"render", "wall.glb", "--size", "32x16", "-o", "wall.exr"}, folder.path.string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    // Straight ahead the body gives back (1 - F0) of it, F0 = 0.04, and roughness 1 adds little.
    const float middle = scene::read_image(folder.file("wall.exr")).rgb(16, 8).y;
    CHECK(middle > 95.0f);
    CHECK(middle < 102.0f);
}
