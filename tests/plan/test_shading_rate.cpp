// shading.rate: a picture in which a block shares points shows at every sample what the full picture shows somewhere in
// its block, and nothing else.
#include <doctest/doctest.h>

#include "raster/tile_grid.hpp"
#include "scene/render/render.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;

namespace {

/// One sample a pixel and no mip maps, whose level is chosen by the distance to the next point.
scene::Scene plain_scene(std::uint32_t seed) {
    scene::Scene scene = tests::random_plan_scene(seed);
    scene.image.samples = 1;
    scene.shading.frequency = scene::ShadingFrequency::phong;
    for (lighting::Material& material : scene.materials) material.maps.filter = lighting::TextureFilter::bilinear;
    return scene;
}

bool same_color(const raster::Image& a, int x, int y, const raster::Image& b, int u, int v) {
    return a.rgb(x, y) == b.rgb(u, v);
}

/// Does the full picture have this pixel's colour in its block? Blocks begin at the corner of each tile.
bool is_of_block(const raster::Image& coarse, const raster::Image& full, int x, int y, int rate) {
    const auto begin = [&](int i) { return i - i % raster::kTileSide % rate; };
    const auto end = [&](int i, int size) {
        return std::min({begin(i) + rate, (i / raster::kTileSide + 1) * raster::kTileSide, size});
    };
    for (int v = begin(y); v < end(y, full.height); ++v) {
        for (int u = begin(x); u < end(x, full.width); ++u) {
            if (same_color(coarse, x, y, full, u, v)) return true;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("shading rate: every pixel has a colour of its block in the full picture: 40 random scenes") {
    int coarser = 0;
    for (std::uint32_t seed = 5000; seed < 5040; ++seed) {
        CAPTURE(seed);
        scene::Scene scene = plain_scene(seed);
        scene.shading.rate = 1;
        scene::RenderBuffers all, some;
        const scene::RenderPlan every = make_plan(scene);
        const auto of_all = render(scene, every, all, 2);
        scene.shading.rate = 2 + static_cast<int>(seed) % 3;
        const scene::RenderPlan plan = make_plan(scene);
        const auto of_some = render(scene, plan, some, 2);
        int strange = 0;
        for (int y = 0; y < all.film.height; ++y) {
            for (int x = 0; x < all.film.width; ++x) {
                strange += !is_of_block(some.film, all.film, x, y, scene.shading.rate);
            }
        }
        CHECK(strange == 0);
        CHECK(of_some.samples_shaded <= of_all.samples_shaded);
        coarser += of_some.samples_shaded < of_all.samples_shaded;
    }
    CHECK(coarser >= 20);  // most scenes show something that is lit
}

TEST_CASE("shading rate: light per triangle or vertex takes no notice of it") {
    for (std::uint32_t seed = 5100; seed < 5110; ++seed) {
        for (const auto frequency : {scene::ShadingFrequency::flat, scene::ShadingFrequency::gouraud}) {
            scene::Scene scene = plain_scene(seed);
            scene.shading.frequency = frequency;
            scene.shadow.method = shadows::ShadowMethod::map;
            scene.shading.rate = 1;
            const raster::Image one = scene::render(scene);
            scene.shading.rate = 4;
            CHECK(scene::render(scene).values == one.values);
        }
    }
}

TEST_CASE("shading rate: with as many samples a pixel, edges are smooth and each triangle is lit once a pixel") {
    scene::Scene scene = plain_scene(5001);
    scene.image.samples = scene.shading.rate = 3;
    scene.materials.assign(scene.materials.size(), lighting::Material{});
    for (lighting::Material& material : scene.materials) {
        material.model = lighting::ReflectionModel::unlit;
        material.phong.emission = {0.3f, 0.5f, 0.7f};
    }
    scene.fog.mode = lighting::FogMode::none;
    scene.environment.on = false;
    scene.image.environment_background = false;
    const raster::Image multisampled = scene::render(scene);
    scene.shading.rate = 1;
    CHECK(scene::render(scene).values == multisampled.values);  // one colour everywhere: only coverage is left
}
