// Shading at a lower rate than the samples': which sample of a block is lit for which.
#include <doctest/doctest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "raster/shading_points.hpp"

using namespace kreda::raster;

namespace {

struct RandomTile {
    std::unique_ptr<TileVisibility> tile = std::make_unique<TileVisibility>();
    TileArea area;
    TriangleSet set;
};

/// Patches of a few triangles and holes, `patch` samples wide.
RandomTile random_tile(std::uint32_t seed, int width, int height, int patch) {
    std::mt19937 random(seed);
    RandomTile result;
    result.area.width = width;
    result.area.height = height;
    TriangleChunk chunk;
    chunk.triangles.resize(5);
    result.set.chunks.push_back(std::move(chunk));
    std::vector<std::uint32_t> of_patch(kTileSide * kTileSide);
    for (std::uint32_t& seen : of_patch) {
        const auto index = static_cast<std::uint32_t>(random() % 6);
        seen = index == 5 ? kNoTriangle : triangle_id(0, index);
    }
    for (int y = 0; y < kTileSide; ++y) {
        for (int x = 0; x < kTileSide; ++x) {
            result.tile->triangle[y * kTileSide + x] =
                of_patch[static_cast<std::size_t>(y / patch * kTileSide + x / patch)];
        }
    }
    return result;
}

/// Twice the distance of a sample to the middle of its block, squared.
int distance2(int sample, int rate) {
    const int x = 2 * (sample % kTileSide % rate) - (rate - 1), y = 2 * (sample / kTileSide % rate) - (rate - 1);
    return x * x + y * y;
}

int block_of(int sample, int rate) {
    return sample / kTileSide / rate * kTileSide + sample % kTileSide / rate;
}

}  // namespace

TEST_CASE("shading points: each sample is lit at the one of its block and triangle that is nearest to the middle") {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const int rate = 1 + static_cast<int>(seed) % kLargestShadingRate;
        const RandomTile t = random_tile(seed, seed % 3 == 0 ? kTileSide : 50, seed % 2 == 0 ? kTileSide : 37,
                                         1 + static_cast<int>(seed) / 4);
        CAPTURE(seed);
        ShadingPoints points;
        std::vector<Run> runs(kTileSide * kTileSide);
        const int count = collect_shading_points(*t.tile, t.area, t.set, rate, runs.data(), points);

        std::multiset<int> of_runs;
        for (int r = 0; r < count; ++r) {
            for (int i = 0; i < runs[r].count; ++i) {
                const int sample = runs[r].y * kTileSide + runs[r].x + i * runs[r].step;
                REQUIRE(t.tile->triangle[sample] == runs[r].triangle);
                of_runs.insert(sample);
            }
        }
        std::set<int> asked;
        int wrong = 0;
        for (int y = 0; y < t.area.height; ++y) {
            for (int x = 0; x < t.area.width; ++x) {
                const int sample = y * kTileSide + x, point = points.of[sample];
                if (t.tile->triangle[sample] == kNoTriangle) {
                    wrong += point != sample;
                    continue;
                }
                asked.insert(point);
                wrong += t.tile->triangle[point] != t.tile->triangle[sample];
                wrong += block_of(point, rate) != block_of(sample, rate) || point % kTileSide >= t.area.width;
                wrong += distance2(point, rate) > distance2(sample, rate) || points.of[point] != point;
            }
        }
        CHECK(wrong == 0);
        CHECK(of_runs == std::multiset<int>(asked.begin(), asked.end()));
    }
}

TEST_CASE("shading points: a triangle that fills a tile is one run a row of blocks") {
    RandomTile t = random_tile(1, kTileSide, kTileSide, 1);
    for (std::uint32_t& seen : t.tile->triangle) seen = triangle_id(0, 2);
    ShadingPoints points;
    std::vector<Run> runs(kTileSide * kTileSide);
    const int count = collect_shading_points(*t.tile, t.area, t.set, 4, runs.data(), points);
    REQUIRE(count == 16);
    for (int r = 0; r < count; ++r) {
        CHECK(runs[r].x == 1);  // of (1, 1), (2, 1), (1, 2), (2, 2), which are as near, the first
        CHECK(runs[r].y == 4 * r + 1);
        CHECK(runs[r].count == 16);
        CHECK(runs[r].step == 4);
    }
}
