// The hook for debuggers: it singles out one sample and changes no picture. The debugger itself: tests/debugger.
#include <algorithm>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "raster/shapes.hpp"
#include "scene/render/debug_pixel.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::scene;

namespace {

using raster::Run;

/// Which triangle every sample sees, in the order of shading.
std::vector<std::tuple<int, int, std::uint32_t>> samples_of(const Run* runs, int count) {
    std::vector<std::tuple<int, int, std::uint32_t>> samples;
    for (int r = 0; r < count; ++r) {
        for (int i = 0; i < runs[r].count; ++i) samples.emplace_back(runs[r].x + i, runs[r].y, runs[r].triangle);
    }
    return samples;
}

/// Asks for a pixel as a debugger does, until the end of the block.
class AskForPixel {
public:
    AskForPixel(int x, int y) {
        debug_pixel = {x, y};
    }
    ~AskForPixel() {
        debug_pixel = {};
    }
    AskForPixel(const AskForPixel&) = delete;
    AskForPixel& operator=(const AskForPixel&) = delete;
};

Scene two_objects(ShadingFrequency frequency, int samples) {
    Scene scene;
    scene.image.width = 150;
    scene.image.height = 70;
    scene.image.samples = samples;
    scene.shading.frequency = frequency;
    scene.fog.mode = frequency == ShadingFrequency::flat ? lighting::FogMode::none : lighting::FogMode::exp;
    scene.lights.resize(2);
    scene.lights[1].direction = {1.0f, -0.5f, -0.2f};
    scene.materials.resize(2);
    scene.materials[1].phong.diffuse = {0.1f, 0.5f, 0.9f};
    for (int i = 0; i < 2; ++i) {
        Object object;
        object.mesh = std::make_shared<raster::Mesh>(raster::make_shape("sphere", 12).value());
        object.world_from_object[3] = glm::vec4(i * 0.8f, 0.0f, i * 0.6f, 1.0f);
        object.part_material = {i};
        scene.objects.push_back(object);
    }
    return scene;
}

}  // namespace

TEST_CASE("debug pixel: cutting a sample out of its run leaves every sample and their order as they were") {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<Run> runs(raster::kTileSide * raster::kTileSide);
        int count = 0;
        for (int y = 0; y < 3; ++y) {
            for (int x = static_cast<int>(random() % 3); x < raster::kTileSide - 8;) {
                const int length = 1 + static_cast<int>(random() % 6);
                runs[count++] = {static_cast<std::uint16_t>(x),
                                 static_cast<std::uint16_t>(y),
                                 static_cast<std::uint16_t>(length),
                                 1,
                                 0,
                                 static_cast<std::uint32_t>(count)};
                x += length + static_cast<int>(random() % 2);
            }
        }
        const auto before = samples_of(runs.data(), count);
        const glm::ivec2 sample(random() % raster::kTileSide, random() % 4);
        const bool covered = std::any_of(before.begin(), before.end(), [&](const auto& s) {
            return std::get<0>(s) == sample.x && std::get<1>(s) == sample.y;
        });
        CAPTURE(sample.x);
        CAPTURE(sample.y);
        const int at = cut_out_sample(runs.data(), count, sample);
        CHECK(samples_of(runs.data(), count) == before);
        CHECK((at < count) == covered);
        if (at == count) continue;
        CHECK(runs[at].x == sample.x);
        CHECK(runs[at].y == sample.y);
        CHECK(runs[at].count == 1);
    }
}

TEST_CASE("debug pixel: a picture is the same to the last bit whichever pixel a debugger wants to see") {
    for (const auto& shading : {std::pair(ShadingFrequency::phong, 3), std::pair(ShadingFrequency::phong, 1),
                                std::pair(ShadingFrequency::gouraud, 2), std::pair(ShadingFrequency::flat, 1)}) {
        const ShadingFrequency frequency = shading.first;
        const int samples = shading.second;
        CAPTURE(static_cast<int>(frequency));
        CAPTURE(samples);
        const Scene scene = two_objects(frequency, samples);
        const raster::Image expected = render(scene);
        for (const glm::ivec2 pixel :
             {glm::ivec2(75, 35), glm::ivec2(0, 0), glm::ivec2(149, 69), glm::ivec2(90, 40), glm::ivec2(63, 30),
              glm::ivec2(64, 30), glm::ivec2(150, 70), glm::ivec2(5, 4000)}) {
            CAPTURE(pixel.x);
            CAPTURE(pixel.y);
            const AskForPixel ask(pixel.x, pixel.y);
            CHECK(render(scene).values == expected.values);
        }
    }
}

TEST_CASE("debug pixel: the middle sample stands for its pixel and each pixel lies in one tile") {
    const raster::Viewport viewport{150 * 3, 70 * 3};
    const raster::TileGrid grid = raster::make_tile_grid(viewport, 3);
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(20, 21), glm::ivec2(21, 20), glm::ivec2(149, 69)}) {
        const AskForPixel ask(pixel.x, pixel.y);
        int found = 0;
        for (int t = 0; t < grid.columns * grid.rows; ++t) {
            const raster::TileArea area = tile_area(grid, viewport, t);
            const glm::ivec2 sample = sample_to_debug(area, 3);
            if (sample.x < 0) continue;
            ++found;
            CHECK(glm::ivec2(area.x, area.y) + sample == 3 * pixel + 1);
        }
        CHECK(found == 1);
    }
}
