// Cube maps: directions and texels map to each other, solid angles are exact, mips keep the light, no seams.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/cube_map.hpp"

using namespace kreda::lighting;
using glm::vec3;
using std::numbers::pi;

namespace {

/// Level 0 random in [0, 1], borders filled, all mip levels made.
CubeMap random_map(int size) {
    CubeMap map = make_cube_map(mip_sizes(size));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) map.set_texel(0, face, x, y, {value(random), value(random), value(random)});
        }
    }
    fill_border(map, 0);
    fill_mip_levels(map);
    return map;
}

/// The light of a level from all directions together.
glm::dvec3 total_light(const CubeMap& map, int level) {
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    glm::dvec3 sum(0.0);
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x)
                sum += glm::dvec3(map.texel(level, face, x, y)) * texel_solid_angle(size, x, y);
        }
    }
    return sum;
}

double largest_difference(const vec3& a, const vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

TEST_CASE("cube map: the axes look at the middles of their faces") {
    const vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < kCubeFaces; ++face) {
        const CubePoint point = cube_point(axes[face] * 3.0f);
        CHECK(point.face == face);
        CHECK(point.u == 0.5f);
        CHECK(point.v == 0.5f);
    }
}

TEST_CASE("cube map: every texel's direction leads back to the texel") {
    for (const int size : {1, 2, 64}) {
        for (int i = 0; i < kCubeFaces * size * size; ++i) {
            const int face = i / (size * size), x = i % size, y = i / size % size;
            const CubePoint point = cube_point(glm::normalize(texel_direction(size, face, x, y)));
            CHECK(point.face == face);
            CHECK(static_cast<int>(point.u * static_cast<float>(size)) == x);
            CHECK(static_cast<int>(point.v * static_cast<float>(size)) == y);
        }
    }
}

TEST_CASE("cube map: the point of a direction leads back to the direction") {
    std::mt19937 random(3);
    std::normal_distribution<float> component;
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const vec3 d = glm::normalize(vec3(component(random), component(random), component(random)));
        worst = std::max(worst, largest_difference(glm::normalize(direction_of(cube_point(d))), d));
    }
    CHECK(worst < 4e-7);  // u and v near 1 step by 6e-8, s and t by twice that, and two normalizations round
}

TEST_CASE("cube map: the solid angles of all texels sum to 4 pi") {
    for (const int size : {1, 2, 3, 16, 128}) {
        CAPTURE(size);
        double sum = 0.0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) sum += texel_solid_angle(size, x, y);
        }
        CHECK(std::abs(6.0 * sum - 4.0 * pi) < 1e-11);  // 10^4 differences of numbers near 1, each right to 1e-16 or so
    }
    CHECK(texel_solid_angle(1, 0, 0) == doctest::Approx(4.0 * pi / 6.0).epsilon(1e-14));
}

TEST_CASE("cube map: a central texel covers 4 by N squared and a corner is 5.196 times smaller") {
    const int N = 1024;
    CHECK(texel_solid_angle(N, N / 2, N / 2) * N * N == doctest::Approx(4.0).epsilon(1e-5));               // O(1 / N^2)
    CHECK(texel_solid_angle(N, 0, 0) * N * N == doctest::Approx(4.0 / std::pow(3.0, 1.5)).epsilon(3e-3));  // O(1 / N)
    CHECK(texel_solid_angle(N, 0, 0) == doctest::Approx(texel_solid_angle(N, N - 1, N - 1)).epsilon(1e-8));
}

TEST_CASE("cube map: every mip level holds the light of the first") {
    const CubeMap map = random_map(64);
    const glm::dvec3 first = total_light(map, 0);
    REQUIRE(map.last_level() == 6);
    for (int level = 1; level <= map.last_level(); ++level) {
        CAPTURE(level);
        for (int c = 0; c < 3; ++c) CHECK(total_light(map, level)[c] == doctest::Approx(first[c]).epsilon(1e-6));
    }
}

TEST_CASE("cube map: filtering has no seam at the twelve edges") {
    const CubeMap map = random_map(16);
    constexpr float kStep = 1e-6f;
    double worst_step = 0.0;
    int other_faces = 0;
    for (int level = 0; level <= map.last_level(); ++level) {
        const double size = map.levels[static_cast<std::size_t>(level)].size;
        double worst = 0.0;
        for (int face = 0; face < kCubeFaces; ++face) {
            for (int side = 0; side < 4; ++side) {
                for (int i = 0; i <= 200; ++i) {
                    const float along = 1e-5f + 0.99998f * static_cast<float>(i) / 200.0f;
                    const float in = side & 1 ? 1.0f - kStep : kStep, out = side & 1 ? 1.0f + kStep : -kStep;
                    const CubePoint inside = side < 2 ? CubePoint{face, in, along} : CubePoint{face, along, in};
                    const CubePoint outside = side < 2 ? CubePoint{face, out, along} : CubePoint{face, along, out};
                    other_faces += cube_point(direction_of(outside)).face != face;
                    worst = std::max(worst, largest_difference(sample_level(map, level, direction_of(inside)),
                                                               sample_level(map, level, direction_of(outside))));
                }
            }
        }
        // Neighbours differ by at most 1, `size` texels a unit of u; u itself is rounded to 6e-8 on either side. Both
        // directions of the face can change: twice that.
        CHECK(worst <= 2.0 * size * (2.0 * kStep + 3e-7) + 1e-6);
        worst_step = std::max(worst_step, worst);
    }
    CHECK(other_faces == 5 * 6 * 4 * 201);
    CHECK(worst_step > 0.0);
}

TEST_CASE("cube map: filtering has no seam at the eight corners") {
    const CubeMap map = random_map(16);
    for (int level = 0; level <= map.last_level(); ++level) {
        const double size = map.levels[static_cast<std::size_t>(level)].size;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 d{corner & 1 ? -1.0f : 1.0f, corner & 2 ? -1.0f : 1.0f, corner & 4 ? -1.0f : 1.0f};
            const vec3 on_x = sample_level(map, level, d * vec3(1.000001f, 1.0f, 1.0f));
            const vec3 on_y = sample_level(map, level, d * vec3(1.0f, 1.000001f, 1.0f));
            const vec3 on_z = sample_level(map, level, d * vec3(1.0f, 1.0f, 1.000001f));
            CHECK(largest_difference(on_x, on_y) <= 4e-6 * size + 1e-6);
            CHECK(largest_difference(on_x, on_z) <= 4e-6 * size + 1e-6);
        }
    }
}

TEST_CASE("cube map: trilinear is the mean of two levels half way and clamps beyond the last") {
    const CubeMap map = random_map(16);
    const vec3 d{0.3f, -0.8f, 0.4f};
    const vec3 mean = 0.5f * (sample_level(map, 1, d) + sample_level(map, 2, d));
    CHECK(largest_difference(sample_trilinear(map, d, 1.5f), mean) < 1e-6);
    CHECK(sample_trilinear(map, d, -3.0f) == sample_level(map, 0, d));
    CHECK(largest_difference(sample_trilinear(map, d, 99.0f), sample_level(map, map.last_level(), d)) < 1e-6);
}

TEST_CASE("cube map: a batch with one lod for all has the bits of a lod each and the value of one point") {
    const CubeMap map = random_map(16);
    struct Batch {
        kreda::raster::Channel3 d, each, common;
        kreda::raster::Channel lod;
        TapScratch taps;
    };
    const auto batch = std::make_unique<Batch>();
    constexpr int kLanes = 64;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> component(-1.0f, 1.0f);
    for (int i = 0; i < kLanes; ++i) batch->d.set(i, {component(random), component(random), component(random)});
    for (const float lod : {-1.0f, 0.0f, 0.3f, 1.0f, 2.7f, 4.0f, 9.0f}) {
        for (int i = 0; i < kLanes; ++i) batch->lod.set(i, lod);
        sample_trilinear(map, kLanes, batch->d, batch->lod, batch->taps, batch->each);
        sample_trilinear(map, kLanes, batch->d, lod, batch->taps, batch->common);
        for (int i = 0; i < kLanes; ++i) {
            CHECK(batch->common.at(i) == batch->each.at(i));
            // texels in [0, 1]; the batch multiplies the levels' shares into its weights: a few roundings of 6e-8
            CHECK(largest_difference(batch->common.at(i), sample_trilinear(map, batch->d.at(i), lod)) < 1e-6);
        }
    }
}
