// Directions chosen where they matter: numbers worked by hand, and means over many of them against integrals in double.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/importance.hpp"

using namespace kreda::lighting;
using glm::vec2;
using glm::vec3;
using std::numbers::pi;

namespace {

constexpr int kPoints = 4096;

/// D of GGX in double.
double ggx(double cosine, double alpha) {
    const double s = cosine * cosine * (alpha * alpha - 1.0) + 1.0;
    return alpha * alpha / (pi * s * s);
}

/// Smith's G_1 of GGX.
double masking(double cosine, double alpha) {
    return 2.0 * cosine / (cosine + std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine));
}

/// The integral of f(h) over the upper hemisphere, h = (x, y, z), by the midpoint rule in theta and phi.
template <class Function>
double hemisphere(Function f) {
    constexpr int kThetas = 400, kPhis = 200;
    double sum = 0.0;
    for (int i = 0; i < kThetas; ++i) {
        // theta = (pi / 2) t^2: narrow lobes are met by many steps
        const double t = (i + 0.5) / kThetas;
        const double theta = 0.5 * pi * t * t, weight = std::sin(theta) * pi * t / kThetas * 2.0 * pi / kPhis;
        for (int j = 0; j < kPhis; ++j) {
            const double phi = 2.0 * pi * (j + 0.5) / kPhis;
            sum += weight * f(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        }
    }
    return sum;
}

/// The mean of f over directions made from Hammersley's points.
template <class Direction, class Function>
double mean(Direction direction, Function f) {
    double sum = 0.0;
    for (int k = 0; k < kPoints; ++k) sum += double(f(direction(hammersley(k, kPoints))));
    return sum / kPoints;
}

}  // namespace

TEST_CASE("importance: the radical inverse mirrors the bits at the point and stays below 1") {
    CHECK(radical_inverse(0) == 0.0f);
    CHECK(radical_inverse(1) == 0.5f);
    CHECK(radical_inverse(2) == 0.25f);
    CHECK(radical_inverse(3) == 0.75f);
    CHECK(radical_inverse(6) == 0.375f);          // 110 -> .011
    CHECK(radical_inverse(0x80000000u) == 0.0f);  // 2^-32: the last eight bits do not fit a float
    CHECK(radical_inverse(0xffffffffu) < 1.0f);
}

TEST_CASE("importance: four of Hammersley's points and one point a strip for any power of two") {
    const vec2 expected[] = {{0.125f, 0.125f}, {0.375f, 0.625f}, {0.625f, 0.375f}, {0.875f, 0.875f}};
    for (int i = 0; i < 4; ++i) CHECK(hammersley(i, 4) == expected[i]);
    for (const int n : {2, 64, 1024}) {
        std::vector<int> columns(static_cast<std::size_t>(n)), rows(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) {
            const vec2 p = hammersley(i, n);
            ++columns[static_cast<std::size_t>(p.x * static_cast<float>(n))];
            ++rows[static_cast<std::size_t>(p.y * static_cast<float>(n))];
        }
        CHECK(std::all_of(columns.begin(), columns.end(), [](int count) { return count == 1; }));
        CHECK(std::all_of(rows.begin(), rows.end(), [](int count) { return count == 1; }));
    }
}

TEST_CASE("importance: a frame is orthonormal and right-handed around any normal and there is a way back") {
    const vec3 normals[] = {{0, 0, 1},
                            {0, 0, -1},
                            {1, 0, 0},
                            {0, -1, 0},
                            {0.6f, 0, -0.8f},
                            glm::normalize(vec3(1e-4f, 2e-4f, -1.0f)),
                            glm::normalize(vec3(-3, 5, -7))};
    for (const vec3& n : normals) {
        CAPTURE(n.x);
        CAPTURE(n.z);
        const kreda::raster::OrthonormalFrame frame = frame_around(n);
        // Duff et al. state an error of some 1e-7 in float.
        CHECK(glm::dot(frame.t, frame.t) == doctest::Approx(1.0).epsilon(1e-6));
        CHECK(glm::dot(frame.b, frame.b) == doctest::Approx(1.0).epsilon(1e-6));
        CHECK(std::abs(glm::dot(frame.t, frame.b)) < 1e-6f);
        CHECK(std::abs(glm::dot(frame.t, n)) < 1e-6f);
        CHECK(glm::distance(glm::cross(frame.t, frame.b), n) < 1e-6f);
        const vec3 d{0.2f, -0.5f, 0.7f};
        CHECK(glm::distance(to_surface(frame, to_world(frame, d)), d) < 1e-6f);
        CHECK(glm::distance(to_world(frame, {0, 0, 1}), n) < 1e-6f);
    }
    CHECK(frame_around({0, 0, 1}).t == vec3(1, 0, 0));
    CHECK(frame_around({0, 0, -1}).b == vec3(0, -1, 0));
}

TEST_CASE("importance: a direction around the normal has its cosine and its azimuth") {
    const vec3 quarter = around_normal(0.6f, 0.25f);
    CHECK(glm::distance(quarter, vec3(0, 0.8f, 0.6f)) < 1e-6f);
    CHECK(glm::distance(around_normal(0.6f, 0.5f), vec3(-0.8f, 0, 0.6f)) < 1e-6f);
    CHECK(around_normal(1.0f, 0.3f) == vec3(0, 0, 1));
}

TEST_CASE("importance: cosine-weighted directions have the moments of their density") {
    // int z^k z / pi dl = 2 / (k + 2); nothing prefers a side.
    const double tolerance = 1e-3;  // 4096 points: some 1 / 4096
    CHECK(mean(cosine_direction, [](const vec3& l) { return l.z; }) == doctest::Approx(2.0 / 3.0).epsilon(tolerance));
    CHECK(mean(cosine_direction, [](const vec3& l) { return l.z * l.z; }) == doctest::Approx(0.5).epsilon(tolerance));
    CHECK(std::abs(mean(cosine_direction, [](const vec3& l) { return l.x; })) < tolerance);
    CHECK(std::abs(mean(cosine_direction, [](const vec3& l) { return l.x * l.y; })) < tolerance);
    CHECK(mean(cosine_direction, [](const vec3& l) { return glm::dot(l, l); }) == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("importance: GGX's half vectors are as dense as D n.h") {
    for (const float alpha : {0.05f, 0.3f, 1.0f}) {
        CAPTURE(alpha);
        const auto half = [&](const vec2& u) { return ggx_half_vector(u, alpha); };
        for (const int power : {1, 2, 6}) {
            CAPTURE(power);
            const double expected =
                hemisphere([&](double, double, double z) { return std::pow(z, power) * ggx(z, alpha) * z; });
            CHECK(mean(half, [&](const vec3& h) { return std::pow(h.z, power); }) ==
                  doctest::Approx(expected).epsilon(1e-3));
        }
    }
}

TEST_CASE("importance: visible half vectors are as dense as the facets that v sees") {
    for (const float alpha : {0.1f, 0.4f, 1.0f}) {
        for (const float n_dot_v : {0.1f, 0.5f, 1.0f}) {
            CAPTURE(alpha);
            CAPTURE(n_dot_v);
            const vec3 v{std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v};
            const auto half = [&](const vec2& u) { return visible_half_vector(u, v, alpha); };
            const auto density = [&](double x, double z) {
                const double v_dot_h = double(v.x) * x + double(v.z) * z;
                return v_dot_h > 0.0 ? masking(n_dot_v, alpha) * v_dot_h * ggx(z, alpha) / n_dot_v : 0.0;
            };
            CHECK(hemisphere([&](double x, double, double z) { return density(x, z); }) ==
                  doctest::Approx(1.0).epsilon(2e-3));
            const double tilt = hemisphere([&](double x, double, double z) { return x * density(x, z); });
            const double height = hemisphere([&](double x, double, double z) { return z * density(x, z); });
            CHECK(mean(half, [](const vec3& h) { return h.x; }) == doctest::Approx(tilt).epsilon(2e-3).scale(1.0));
            CHECK(mean(half, [](const vec3& h) { return h.z; }) == doctest::Approx(height).epsilon(2e-3));
            double least_z = 1.0, least_v = 1.0;
            for (int k = 0; k < kPoints; ++k) {
                const vec3 h = half(hammersley(k, kPoints));
                least_z = std::min(least_z, double(h.z));
                least_v = std::min(least_v, double(glm::dot(v, h)));
            }
            CHECK(least_z >= 0.0);
            CHECK(least_v >= -1e-5);  // a facet seen edge-on
        }
    }
}

TEST_CASE("importance: a mirrored direction makes the same angle on the other side") {
    const float s = std::sqrt(0.5f);
    CHECK(glm::distance(mirror_vector({s, 0, s}, {0, 0, 1}), vec3(1, 0, 0)) < 1e-6f);
    const vec3 v = glm::normalize(vec3(0.3f, -0.2f, 0.9f)), h = glm::normalize(vec3(-0.1f, 0.4f, 0.8f));
    const vec3 l = mirror_vector(h, v);
    CHECK(glm::dot(l, h) == doctest::Approx(double(glm::dot(v, h))).epsilon(1e-6));
    CHECK(glm::length(l) == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(glm::length(glm::cross(l + v, h)) < 1e-6f);
}
