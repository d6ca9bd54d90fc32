// Skies at their edges: one texel, a texel of a million, a texel that is no number, 16384 columns.
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/irradiance.hpp"

using namespace kreda::lighting;
namespace raster = kreda::raster;
using glm::vec3;
using std::numbers::pi;

namespace {

raster::Image sky_of(int width, int height, const vec3& radiance) {
    raster::Image image = raster::make_image(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.set_rgb(x, y, radiance);
    }
    return image;
}

const vec3 kUpAndAside[] = {{0.0f, 1.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.6f, 0.0f, -0.8f}, {-1.0f, 0.0f, 0.0f}};

}  // namespace

TEST_CASE("skies: of one texel every direction has its light and every surface pi times that") {
    const vec3 L(1e6f, 1.0f, 0.0f);
    const CubeMap cube = cube_from_equirect(sky_of(1, 1, L), 16);
    const Sh9 nine = project_to_sh9(cube);
    for (int face = 0; face < 6; ++face) {  // a weighted mean of equal numbers, rounded some hundred times
        CHECK(cube.texel(0, face, 3, 15).x == doctest::Approx(1e6).epsilon(1e-6));
        CHECK(cube.texel(0, face, 3, 15).z == 0.0f);
    }
    for (const vec3& n : kUpAndAside) {
        for (const vec3& E : {irradiance_of_texels(cube, n), irradiance_of_sh9(nine, n)}) {
            CHECK(E.x == doctest::Approx(pi * 1e6).epsilon(2e-3));  // cosines of 16 x 16 texels a face
            CHECK(E.y == doctest::Approx(pi).epsilon(2e-3));
            CHECK(E.z == 0.0f);
        }
    }
}

TEST_CASE("skies: a texel of a million lights a surface by its solid angle and leaves nothing negative") {
    raster::Image sky = sky_of(32, 16, vec3(0.0f));
    sky.set_rgb(16, 8, vec3(1e6f));  // just beside +x
    CHECK(repair_environment(sky).total() == 0);
    const CubeMap cube = cube_from_equirect(sky, 64);
    const double light = 1e6 * equirect_solid_angle(32, 16, 8);
    // Filtering spreads the texel over twice its width of 11 degrees: the cosine there is 0.99 in the mean.
    CHECK(irradiance_of_texels(cube, {1.0f, 0.0f, 0.0f}).x == doctest::Approx(light).epsilon(0.02));
    CHECK(irradiance_of_texels(cube, {-1.0f, 0.0f, 0.0f}).x == 0.0f);
    const Sh9 nine = project_to_sh9(cube);
    for (const vec3& n : kUpAndAside) {
        const vec3 E = irradiance_of_sh9(nine, n);
        CHECK((E.x >= 0.0f && std::isfinite(E.x)));
    }
}

TEST_CASE("skies: a texel that is no number gets the light of those around it") {
    raster::Image sky = sky_of(8, 4, vec3(0.5f));
    sky.set_rgb(3, 1, vec3(std::numeric_limits<float>::quiet_NaN()));
    CHECK(repair_environment(sky).nan == 1);
    const CubeMap cube = cube_from_equirect(sky, 16);
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) CHECK(cube.texel(0, face, x, y).y == doctest::Approx(0.5).epsilon(1e-6));
        }
    }
}

TEST_CASE("skies: of 16384 columns each is found where it lies") {
    raster::Image sky = raster::make_image(16384, 2, 3);
    for (int x = 0; x < sky.width; ++x) {
        for (int y = 0; y < sky.height; ++y) sky.set_rgb(x, y, vec3(static_cast<float>(x), 1e6f, 0.0f));
    }
    const EquirectMap map = make_equirect_map(sky);
    double worst = 0.0;
    for (int x = 1; x < sky.width - 1; x += 31) {
        const float u = (static_cast<float>(x) + 0.5f) / 16384.0f;
        const vec3 found = sample_equirect(map, equirect_direction({u, 0.5f}));
        worst = std::max(worst, std::abs(double{found.x} - x));
        CHECK(found.y == doctest::Approx(1e6).epsilon(1e-6));
    }
    CHECK(worst < 0.01);  // 16384 columns times 2.5e-7 of a turn, and the rounding of the mean of two texels
}
