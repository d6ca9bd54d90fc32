// Scale and bias of the split sum against quadrature, and the closed form against its stated error.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <doctest/doctest.h>

#include "lighting/environment/brdf_map.hpp"

using namespace kreda::lighting;

namespace {

/// By quadrature in double: A and B of GGX with Smith's correlated G, and with Schlick-GGX, k = alpha / 2.
struct Row {
    float roughness, n_dot_v, A, B, A_schlick, B_schlick;
};

constexpr Row kQuadrature[] = {
    {0.10f, 0.05f, 0.24259f, 0.73367f, 0.20835f, 0.62415f}, {0.10f, 0.10f, 0.41581f, 0.57836f, 0.38300f, 0.53142f},
    {0.10f, 0.25f, 0.76297f, 0.23617f, 0.74110f, 0.22931f}, {0.10f, 0.50f, 0.96837f, 0.03140f, 0.95887f, 0.03109f},
    {0.10f, 0.75f, 0.99897f, 0.00101f, 0.99567f, 0.00100f}, {0.10f, 1.00f, 1.00000f, 0.00000f, 0.99999f, 0.00000f},
    {0.25f, 0.05f, 0.44918f, 0.44484f, 0.33482f, 0.31005f}, {0.25f, 0.10f, 0.50517f, 0.39162f, 0.39128f, 0.29109f},
    {0.25f, 0.25f, 0.75811f, 0.20354f, 0.65739f, 0.17335f}, {0.25f, 0.50f, 0.95577f, 0.03264f, 0.90241f, 0.03047f},
    {0.25f, 0.75f, 0.99226f, 0.00150f, 0.97170f, 0.00144f}, {0.25f, 1.00f, 0.99578f, 0.00000f, 0.99440f, 0.00000f},
    {0.50f, 0.05f, 0.76881f, 0.16431f, 0.62074f, 0.11505f}, {0.50f, 0.10f, 0.75193f, 0.13969f, 0.59018f, 0.09837f},
    {0.50f, 0.25f, 0.75925f, 0.08083f, 0.60941f, 0.06088f}, {0.50f, 0.50f, 0.83492f, 0.02235f, 0.72853f, 0.01855f},
    {0.50f, 0.75f, 0.88881f, 0.00272f, 0.82754f, 0.00238f}, {0.50f, 1.00f, 0.91579f, 0.00003f, 0.89504f, 0.00002f},
    {0.75f, 0.05f, 0.83981f, 0.06512f, 0.66893f, 0.04170f}, {0.75f, 0.10f, 0.79577f, 0.05258f, 0.64088f, 0.03526f},
    {0.75f, 0.25f, 0.71651f, 0.02795f, 0.59347f, 0.02063f}, {0.75f, 0.50f, 0.65469f, 0.00848f, 0.57301f, 0.00697f},
    {0.75f, 0.75f, 0.63124f, 0.00164f, 0.58205f, 0.00145f}, {0.75f, 1.00f, 0.62684f, 0.00005f, 0.60357f, 0.00004f},
    {1.00f, 0.05f, 0.81568f, 0.03209f, 0.56810f, 0.01638f}, {1.00f, 0.10f, 0.73634f, 0.02387f, 0.54436f, 0.01355f},
    {1.00f, 0.25f, 0.58676f, 0.01088f, 0.48348f, 0.00748f}, {1.00f, 0.50f, 0.44771f, 0.00299f, 0.40668f, 0.00246f},
    {1.00f, 0.75f, 0.36389f, 0.00063f, 0.35011f, 0.00058f}, {1.00f, 1.00f, 0.30682f, 0.00003f, 0.30682f, 0.00003f},
};

/// Bilinear interpolation of 64 x 64 nodes at the root of n.v: 1.4e-3 at worst; 4096 samples: 5e-4; the table: 3e-4.
constexpr double kMapError = 2.2e-3;

}  // namespace

TEST_CASE("BRDF map: scale and bias are those of quadrature") {
    const BrdfMap correlated = compute_brdf_map(Distribution::ggx, Geometry::smith_correlated, 4096);
    const BrdfMap schlick = compute_brdf_map(Distribution::ggx, Geometry::schlick_ggx, 4096);
    for (const Row& row : kQuadrature) {
        CAPTURE(row.roughness);
        CAPTURE(row.n_dot_v);
        const BrdfTerms got = look_up_brdf(correlated, row.n_dot_v, row.roughness);
        CHECK(std::abs(got.scale - row.A) < kMapError);
        CHECK(std::abs(got.bias - row.B) < kMapError);
        const BrdfTerms with_schlick = look_up_brdf(schlick, row.n_dot_v, row.roughness);
        CHECK(std::abs(with_schlick.scale - row.A_schlick) < kMapError);
        CHECK(std::abs(with_schlick.bias - row.B_schlick) < kMapError);
    }
}

TEST_CASE("BRDF map: the default number of samples stays within its error") {
    const BrdfMap map = compute_brdf_map(Distribution::ggx, Geometry::smith_correlated);
    for (const Row& row : kQuadrature) {
        const BrdfTerms got = look_up_brdf(map, row.n_dot_v, row.roughness);
        CHECK(std::abs(got.scale + got.bias - row.A - row.B) < 1.9e-3 + kMapError);  // 1024 visible facets: 1.9e-3
    }
}

TEST_CASE("BRDF map: a node is exact where no interpolation stands between") {
    const BrdfMap map = compute_brdf_map(Distribution::ggx, Geometry::smith_correlated, 4096);
    const BrdfTerms got = look_up_brdf(map, 1.0f, 1.0f);  // quadrature: 0.30682 and 0.00003
    CHECK(std::abs(got.scale - 0.30682) < 5e-4);
    CHECK(std::abs(got.bias - 0.00003) < 2e-5);
}

TEST_CASE("BRDF map: nothing reflects more than it receives") {
    for (const Geometry geometry : {Geometry::smith_correlated, Geometry::smith, Geometry::schlick_ggx}) {
        const BrdfMap map = compute_brdf_map(Distribution::ggx, geometry, 256);
        for (std::size_t i = 0; i < map.texels.size(); i += 4) {
            CHECK(map.texels[i] >= 0.0f);
            CHECK(map.texels[i + 1] >= 0.0f);
            CHECK(map.texels[i] + map.texels[i + 1] <= 1.00001f);
            CHECK(map.texels[i + 2] <= 1.00001f);
        }
    }
}

TEST_CASE("BRDF map: a mirror's mean energy is 1 and every other the integral of its row") {
    const BrdfMap map = compute_brdf_map(Distribution::ggx, Geometry::smith_correlated, 1024);
    CHECK(map.texels[2] == doctest::Approx(1.0).epsilon(3e-5));  // roughness 0 is a mirror but for alpha's least value
    for (int j = 0; j < kBrdfMapSize; ++j) {
        CAPTURE(j);
        const float* row = &map.texels[static_cast<std::size_t>(4 * kBrdfMapSize * j)];
        // The broken line through the nodes, integrated exactly: 4 s^3 over a step, and times the way along it.
        double integral = 0.0;
        for (int i = 0; i < kBrdfMapSize - 1; ++i) {
            const double a = i / 63.0, b = (i + 1) / 63.0;
            const double E_a = double(row[4 * i]) + double(row[4 * i + 1]);
            const double E_b = double(row[4 * i + 4]) + double(row[4 * i + 5]);
            const double all = std::pow(b, 4) - std::pow(a, 4);
            const double first_moment = 0.8 * (std::pow(b, 5) - std::pow(a, 5));
            integral += E_a * all + (E_b - E_a) / (b - a) * (first_moment - a * all);
        }
        CHECK(row[2] == doctest::Approx(integral).epsilon(6e-5));  // the nodes bend by E'' h^2 / 12 between them
    }
}

TEST_CASE("BRDF fit: scale and bias are those of quadrature within the stated error") {
    double sum = 0.0;
    for (const Row& row : kQuadrature) {
        CAPTURE(row.roughness);
        CAPTURE(row.n_dot_v);
        const BrdfTerms fit = brdf_fit(row.n_dot_v, row.roughness);
        CHECK(std::abs(fit.scale - row.A) < 0.05);
        CHECK(std::abs(fit.bias - row.B) < 0.04);
        const double error = std::abs(fit.scale + fit.bias - row.A - row.B);
        CHECK(error < 0.067);
        sum += error;
    }
    CHECK(sum / std::size(kQuadrature) < 0.015);  // half of the rows are at grazing angles
    CHECK(sum > 0.0);
}

TEST_CASE("BRDF fit: no pole and no more than all light") {
    for (int i = 0; i <= 200; ++i) {
        for (int j = 0; j <= 200; ++j) {
            const BrdfTerms fit = brdf_fit(static_cast<float>(i) / 200.0f, static_cast<float>(j) / 200.0f);
            REQUIRE(fit.scale >= 0.0f);
            REQUIRE(fit.bias >= 0.0f);
            REQUIRE(fit.scale + fit.bias <= 1.01f);
        }
    }
}
