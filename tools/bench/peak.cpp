#include "tools/bench/peak.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include "lighting/batch/passes.hpp"
#include "raster/platform.hpp"
#include "scene/render/stopwatch.hpp"
#include "tools/bench/time_report.hpp"

namespace kreda::tools {

namespace {

constexpr int kRounds = 15;

/// Median milliseconds of one call, of `calls` calls a round: long enough for the clock.
template <class Work>
double median_ms(int calls, Work work) {
    std::vector<double> ms;
    for (int round = 0; round < kRounds; ++round) {
        scene::Stopwatch watch;
        for (int i = 0; i < calls; ++i) work();
        ms.push_back(watch.lap_ms() / calls);
    }
    return median(ms);
}

/// Eight multiplications and eight additions that wait for each other.
inline float eight_steps(float x) {
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    x = x * 0.9999f + 0.5f;
    return x * 0.9999f + 0.5f;
}

/// As many multiplications as additions, as our flags allow (-ffp-contract=off: never both in one instruction): in
/// every lane four chains that do not wait for each other.
constexpr int kOperationsALane = 4 * 16 + 6;
KREDA_BATCH_LOOP void multiply_and_add(float* __restrict x, int lanes) {
    for (int i = 0; i < lanes; ++i) {
        const float a = eight_steps(x[i]);
        const float b = eight_steps(x[i] + 1.0f);
        const float c = eight_steps(x[i] + 2.0f);
        const float d = eight_steps(x[i] + 3.0f);
        x[i] = (a + b) + (c + d);
    }
}

double peak_gflops() {
    constexpr int kLanes = 2048;
    alignas(64) std::array<float, kLanes> x{};
    const double ms = median_ms(500, [&] { multiply_and_add(x.data(), kLanes); });
    return static_cast<double>(kOperationsALane) * kLanes / ms * 1e-6;
}

/// Two arrays in, one out.                                                                      McCalpin 1995, "triad"
KREDA_BATCH_LOOP void triad(const float* __restrict a, const float* __restrict b, int lanes, float* __restrict out) {
    for (int i = 0; i < lanes; ++i) out[i] = a[i] + 0.5f * b[i];
}

/// GB/s read and written together, for three arrays of so many floats each.
double bandwidth_gbs(int floats, int calls) {
    std::vector<float> a(static_cast<std::size_t>(floats), 1.0f), b(a), out(a);
    const double ms = median_ms(calls, [&] { triad(a.data(), b.data(), floats, out.data()); });
    return 3.0 * sizeof(float) * floats / ms * 1e-6;
}

/// What the loops of a model compute and move for one point, counted in their source. +, -, *, /, sqrt, min, max, and
/// each selection count as one; an operation in double as two, for half as many fit into a register.
struct LoopCost {
    const char* name;
    lighting::ReflectionModel model;
    int lights;
    double operations, floats_moved;
};

// start_lighting 31 (two unit vectors, one difference), sum_terms 6, moving 30 floats where there are constants to
// fill, else 21: ambient is the same at every point.
constexpr double kStartAndSum = 37;
// Phong with a directional light: n.l and whether it is positive 7, mirror vector 7, v.r 6, whether it shines 4, pow 54
// (its logarithm 17 in float and 14 in double, product and rest 2 x 2, 2^x 21, choice 1), faces the light 2, colours 7,
// adding 12. Floats: 4 for the light, 8 for Sigma, 7 for its power, 8 for the terms, which are the first.
constexpr double kPhong = 99;
// Cook-Torrance with a point light: the light 30, angles 39, GGX 7, Schlick-GGX 11, Schlick 15, combining 25,
// adding 12. n.v, 7 operations and 7 floats, is the same for all lights. The first light reads no sums.
constexpr double kCookTorrance = 139;
constexpr LoopCost kLoops[] = {
    {"Phong, 1 directional light", lighting::ReflectionModel::phong, 1, kStartAndSum + kPhong, 21 + 27},
    {"Cook-Torrance, 4 point lights", lighting::ReflectionModel::cook_torrance, 4, kStartAndSum + 7 + 4 * kCookTorrance,
     30 + 7 + 4 * 67 - 6},
};

/// A full batch of points before the eye, their normals turned a little to and fro.
std::unique_ptr<raster::Fragments> make_points() {
    auto points = std::make_unique<raster::Fragments>();
    points->count = raster::kBatchCapacity;
    for (int i = 0; i < raster::kBatchCapacity; ++i) {
        const float t = static_cast<float>(i) / raster::kBatchCapacity;
        points->position.set(i, {t - 0.5f, 0.3f * t, -t});
        points->normal.set(i, {0.4f * t - 0.2f, 0.1f, 1.0f});
    }
    return points;
}

void print_loop(const LoopCost& cost, double peak, double cache) {
    lighting::Light light;
    light.type = cost.lights == 1 ? lighting::LightType::directional : lighting::LightType::point;
    light.direction = {-0.4f, -0.8f, -0.5f};
    const std::vector<lighting::LightSetup> lights(static_cast<std::size_t>(cost.lights), prepare(light));
    lighting::Material material;
    material.model = cost.model;
    const lighting::MaterialSetup setup = prepare(material);
    lighting::LightingSetup lighting;
    lighting.eye = {0.0f, 0.0f, 2.0f};
    lighting.lights = lights;
    const auto points = make_points();
    const auto channels = std::make_unique<lighting::LightingChannels>();
    const double ms = median_ms(200, [&] {
        start_lighting(*points, setup, lighting, *channels);
        for (const lighting::LightSetup& one : lights) {
            sample_light(*points, one, *channels);
            add_reflection(points->count, setup, lighting::LeaveChannels::only_of_batches, *channels);
        }
        sum_terms(points->count, *channels);
    });
    const double gflops = cost.operations * points->count / ms * 1e-6;
    const double gbs = sizeof(float) * cost.floats_moved * points->count / ms * 1e-6;
    std::printf("| %s | %.2f | %.0f | %.1f | %.0f %% | %.1f | %.0f %% |\n", cost.name, ms / points->count * 1e6,
                cost.operations, gflops, 100.0 * gflops / peak, gbs, 100.0 * gbs / cache);
}

}  // namespace

void measure_peak() {
    constexpr int kInCache = 8 * 1024, kInMemory = 32 * 1024 * 1024;
    const double peak = peak_gflops();
    const double cache = bandwidth_gbs(kInCache, 200);
    const double memory = bandwidth_gbs(kInMemory, 1);
    std::printf(
        "One core: %.1f Gflop/s (as many multiplications as additions), %.1f GB/s in the first two caches, %.1f GB/s "
        "in "
        "memory.\n\n",
        peak, cache, memory);
    std::printf(
        "| loops | ns a point | operations | Gflop/s | of the peak | GB/s between loops | of the cache's |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const LoopCost& cost : kLoops) print_loop(cost, peak, cache);
}

}  // namespace kreda::tools
