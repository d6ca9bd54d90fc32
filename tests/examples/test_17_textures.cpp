// The pictures of 17_textures: mip maps against many samples, the horizon against the mean, the level against geometry.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/lit_scene.hpp"
#include "raster/camera.hpp"
#include "raster/shapes.hpp"
#include "raster/texture.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr int kFirstRow = 25, kLastRow = 34;  // far ground, below the horizon

double mean_error(const raster::Image& a, const raster::Image& truth) {
    double sum = 0.0;
    for (int y = kFirstRow; y < kLastRow; ++y) {
        for (int x = 0; x < a.width; ++x) sum += double{glm::distance(a.rgb(x, y), truth.rgb(x, y))};
    }
    return sum / (a.width * (kLastRow - kFirstRow));
}

}  // namespace

TEST_CASE("17_textures: mip maps come nearer to 64 samples a pixel than one texel or four") {
    const raster::Image truth = linear_panel("17_textures/filters", 2, 2, 3);
    const double nearest = mean_error(linear_panel("17_textures/filters", 2, 2, 0), truth);
    const double bilinear = mean_error(linear_panel("17_textures/filters", 2, 2, 1), truth);
    const double trilinear = mean_error(linear_panel("17_textures/filters", 2, 2, 2), truth);
    CHECK(trilinear < 0.8 * bilinear);
    CHECK(trilinear < 0.8 * nearest);
}

TEST_CASE("17_textures: at the horizon mip maps show the mean of the texture") {
    // 4 of 64 columns orange, the others half chalk and half blue.
    const glm::vec3 mean =
        examples::kOrange * (4.0f / 64.0f) + 0.5f * (examples::kChalk + 0.35f * examples::kBlue) * (60.0f / 64.0f);
    const raster::Image panel = linear_panel("17_textures/filters", 2, 2, 2);
    int row = 0;
    while (glm::distance(panel.rgb(80, row), examples::kBoard) < 0.02f) ++row;
    CHECK(row > 10);
    CHECK(glm::distance(panel.rgb(80, row + 1), mean) < 0.03f);  // one code of 255 is 0.008 here
}

TEST_CASE("17_textures: the level is log2 of the distance between rays of neighbouring pixels on the ground") {
    scene::Scene scene = examples::empty_scene({64, 48});
    scene.image.samples = 1;
    scene.camera.position = {0.0f, 1.5f, 4.0f};
    scene.camera.target = {0.0f, 0.0f, -2.0f};
    lighting::Material material;
    material.model = lighting::ReflectionModel::unlit;
    material.maps.diffuse.texture =
        std::make_shared<raster::Texture>(raster::make_texture(examples::make_board(512, 512)));
    const int ground = examples::add_shape(scene, "plane", 3, {0.0f, 0.0f, 0.0f}, material);
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = 20.0f;
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("level")}), buffers);

    // Where the ray through a pixel's centre meets the ground, in texels: 512 over 40 units.
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(raster::clip_from_world(scene.camera, 64.0f / 48.0f)));
    const auto texel_at = [&](double x, double y) {
        const auto at_depth = [&](double z) {
            const glm::dvec4 p = world_from_clip * glm::dvec4(2.0 * x / 64.0 - 1.0, 1.0 - 2.0 * y / 48.0, z, 1.0);
            return glm::dvec3(p) / p.w;
        };
        const glm::dvec3 near = at_depth(-1.0), far = at_depth(0.9);
        const glm::dvec3 p = near + (far - near) * (near.y / (near.y - far.y));
        return glm::dvec2(p.x, p.z) * (512.0 / 40.0);
    };
    int seen = 0;
    for (int y = 30; y < 47; ++y) {
        for (int x = 2; x < 62; ++x) {
            const glm::dvec2 here = texel_at(x + 0.5, y + 0.5);
            const double right = glm::length(texel_at(x + 1.5, y + 0.5) - here);
            const double down = glm::length(texel_at(x + 0.5, y + 1.5) - here);
            const double level = std::max(std::log2(std::max(right, down)), 0.0);
            // Corners are snapped to 1/256 sample and the ground is some 20 samples away from the horizon: 1e-3.
            REQUIRE(double{buffers.views[0].at(0, x, y)} == doctest::Approx(level).epsilon(0.01));
            seen += level > 0.5 ? 1 : 0;
        }
    }
    CHECK(seen > 300);
}

TEST_CASE("17_textures: the page's numbers") {
    CHECK(raster::level_of_detail({8.0f / 64, 0.0f}, {0.0f, 0.0f}, 64, 64) ==
          documented_number("17_textures", "level"));
    const raster::Texture texture = raster::make_texture(examples::make_board(256, 256));
    const double ratio = double(texture.texels.size()) / (3.0 * 256 * 256);
    CHECK(ratio == doctest::Approx(documented_number("17_textures", "pyramid")).epsilon(1e-3));
}
