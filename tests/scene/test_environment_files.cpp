// Real environments: the light that they throw on a white floor and a white ceiling, by exact integration over texels.
#include <string>

#include <doctest/doctest.h>

#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/irradiance.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using glm::vec3;

namespace {

/// E / pi for a normal straight up and straight down, computed outside this program.
struct Floor {
    const char* file;
    vec3 up, down;
};

constexpr float kInvPi = 0.318309886f;

}  // namespace

TEST_CASE("environment files: a white floor and a white ceiling are as bright as exact integration says") {
    const std::string data = kreda::tests::shared_data_folder();
    if (data.empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    const Floor floors[] = {
        {"dawn.hdr", {1.0680f, 0.90516f, 1.8325f}, {0.33098f, 0.20466f, 0.2305f}},
        {"studio.exr", {0.19227f, 0.21108f, 0.2147f}, {0.090045f, 0.1141f, 0.11823f}},
        {"city.exr", {1.2986f, 1.3312f, 1.5789f}, {0.14434f, 0.088509f, 0.085863f}},
    };
    for (const Floor& floor : floors) {
        CAPTURE(floor.file);
        raster::Image image = scene::read_image(data + "/" + floor.file);
        lighting::repair_environment(image);
        const lighting::CubeMap map = lighting::cube_from_equirect(image, lighting::cube_size_for(image.width, 1024));
        const vec3 up = lighting::irradiance_of_texels(map, {0.0f, 1.0f, 0.0f}) * kInvPi;
        const vec3 down = lighting::irradiance_of_texels(map, {0.0f, -1.0f, 0.0f}) * kInvPi;
        for (int c = 0; c < 3; ++c) {  // the cube of 64 texels a side that is summed smears the image over 1.4 degrees
            CHECK(up[c] == doctest::Approx(floor.up[c]).epsilon(2e-3));
            CHECK(down[c] == doctest::Approx(floor.down[c]).epsilon(2e-3));
        }
    }
}
