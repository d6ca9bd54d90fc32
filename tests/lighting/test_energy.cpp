// The directional albedo tables and the compensation of what a single bounce loses.
#include <array>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "lighting/cook_torrance.hpp"
#include "lighting/energy.hpp"

using namespace kreda::lighting;

namespace {

/// E(mu) of GGX with height-correlated Smith, roughness 0.1 to 1: a program of its own, 512 x 512 points, error 5e-4.
struct AlbedoRow {
    float mu;
    std::array<double, 10> E;
};
constexpr std::array<AlbedoRow, 6> kSmithCorrelated = {{
    {0.10f, {0.99417, 0.92895, 0.88429, 0.88832, 0.89162, 0.88241, 0.86191, 0.83306, 0.79845, 0.76021}},
    {0.20f, {0.99863, 0.97510, 0.91406, 0.86979, 0.84816, 0.82576, 0.79272, 0.74890, 0.69739, 0.64165}},
    {0.30f, {0.99941, 0.98836, 0.94589, 0.88610, 0.83791, 0.79627, 0.74900, 0.69216, 0.62783, 0.56010}},
    {0.50f, {0.99977, 0.99545, 0.97505, 0.92644, 0.85726, 0.78212, 0.70397, 0.62122, 0.53534, 0.45069}},
    {0.80f, {0.99999, 0.99785, 0.98769, 0.95807, 0.89727, 0.80441, 0.69055, 0.56989, 0.45411, 0.35126}},
    {1.00f, {1.00000, 0.99802, 0.99070, 0.96768, 0.91581, 0.82452, 0.69775, 0.55517, 0.41997, 0.30685}},
}};
constexpr std::array<double, 10> kSmithCorrelatedAverage = {0.99962, 0.99473, 0.97669, 0.94041, 0.88232,
                                                            0.80293, 0.70743, 0.60421, 0.50236, 0.40914};
constexpr std::array<double, 10> kSchlickAverage = {0.82328, 0.79818, 0.76680, 0.72762, 0.67985,
                                                    0.62446, 0.56367, 0.50028, 0.43713, 0.37663};
constexpr std::array<double, 10> kGroovesAverage = {0.99977, 0.99476, 0.97995, 0.95094, 0.90627,
                                                    0.84741, 0.77798, 0.70269, 0.62618, 0.55228};

}  // namespace

TEST_CASE("Energy: the table holds the known albedo of GGX") {
    const EnergyTable table = compute_energy_table(Distribution::ggx, Geometry::smith_correlated);
    for (int j = 0; j < 10; ++j) {
        const float roughness = static_cast<float>(j + 1) * 0.1f;
        CAPTURE(roughness);
        for (const AlbedoRow& row : kSmithCorrelated) {
            CAPTURE(row.mu);
            const double E = directional_albedo(table, row.mu, roughness);
            CHECK(std::abs(E - row.E[static_cast<std::size_t>(j)]) < 2e-3);  // 384 points a cell, linear between cells
        }
        CHECK(std::abs(average_albedo(table, roughness) - kSmithCorrelatedAverage[static_cast<std::size_t>(j)]) < 1e-3);
    }
}

TEST_CASE("Energy: the geometry for direct light loses a sixth already on a smooth surface") {
    const EnergyTable table = compute_energy_table(Distribution::ggx, Geometry::schlick_ggx);
    for (int j = 0; j < 10; ++j) {
        const float roughness = static_cast<float>(j + 1) * 0.1f;
        CAPTURE(roughness);
        CHECK(std::abs(average_albedo(table, roughness) - kSchlickAverage[static_cast<std::size_t>(j)]) < 1e-3);
    }
}

TEST_CASE("Energy: the grooves of Cook and Torrance lose as much as known") {
    const EnergyTable table = compute_energy_table(Distribution::ggx, Geometry::cook_torrance);
    for (int j = 0; j < 10; ++j) {
        const float roughness = static_cast<float>(j + 1) * 0.1f;
        CAPTURE(roughness);
        CHECK(std::abs(average_albedo(table, roughness) - kGroovesAverage[static_cast<std::size_t>(j)]) < 1e-3);
    }
}

TEST_CASE("Energy: every pair of D and G has a table between 0 and 1 that falls with roughness") {
    for (const Distribution D :
         {Distribution::ggx, Distribution::beckmann, Distribution::blinn_phong, Distribution::gaussian}) {
        for (const Geometry G : {Geometry::schlick_ggx, Geometry::smith, Geometry::smith_correlated, Geometry::implicit,
                                 Geometry::cook_torrance}) {
            CAPTURE(static_cast<int>(D));
            CAPTURE(static_cast<int>(G));
            const EnergyTable table = compute_energy_table(D, G);
            for (const float E : table.E) {
                REQUIRE(E >= 0.0f);
                REQUIRE(E <= 1.0f);
            }
            CHECK(table.E_avg.back() < table.E_avg.front());
            CHECK(table.E_avg.back() > 0.1f);
        }
    }
}

TEST_CASE("Energy: with the second lobe a white surface reflects all light") {
    for (const Geometry G : {Geometry::smith_correlated, Geometry::smith, Geometry::schlick_ggx}) {
        const EnergyTable table = compute_energy_table(Distribution::ggx, G);
        for (const float roughness : {0.1f, 0.3f, 0.5f, 0.75f, 1.0f}) {
            const float E_avg = average_albedo(table, roughness);
            for (const float mu_v : {0.05f, 0.3f, 0.7f, 1.0f}) {
                CAPTURE(roughness);
                CAPTURE(mu_v);
                const float E_v = directional_albedo(table, mu_v, roughness);
                double second = 0.0;
                constexpr int kSteps = 2000;
                for (int i = 0; i < kSteps; ++i) {  // int f_ms (n.l) dl = 2 pi int f_ms mu dmu
                    const float mu = (static_cast<float>(i) + 0.5f) / kSteps;
                    const float E_l = directional_albedo(table, mu, roughness);
                    second += multiple_scattering(E_l, E_v, E_avg) * 2.0 * 3.14159265 * mu / kSteps;
                }
                CHECK(std::abs(E_v + second * multiple_scattering_color(1.0f, E_avg) - 1.0) <
                      1e-3);  // Simpson against linear
            }
        }
    }
}

TEST_CASE("Energy: averages of Schlick by quadrature") {
    for (const float f0 : {0.0f, 0.04f, 0.5f, 1.0f}) {
        double sum = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const float mu = (static_cast<float>(i) + 0.5f) / 2000.0f;
            sum += 2.0 * fresnel_schlick(mu, f0) * mu / 2000.0;
        }
        CHECK(average_schlick(f0) == doctest::Approx(sum).epsilon(2e-5));  // midpoints
    }
    CHECK(average_schlick(0.04f) == doctest::Approx(0.0857143).epsilon(1e-6));
}

TEST_CASE("Energy: the colour of the second lobe sums the further bounces") {
    // Bounce after bounce: F_avg E_avg leaves, F_avg (1 - E_avg) goes on; the first of them multiplies by F_avg.
    const double F = 0.6, E = 0.7;
    double sum = 0.0, on_the_way = F;
    for (int bounce = 0; bounce < 100; ++bounce) {
        sum += on_the_way * F * E;
        on_the_way *= F * (1.0 - E);
    }
    CHECK(multiple_scattering_color(0.6f, 0.7f) == doctest::Approx(sum).epsilon(1e-6));
    CHECK(multiple_scattering_color(1.0f, 0.3f) == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("Energy: the lookup is exact at nodes and stays inside") {
    const EnergyTable table = compute_energy_table(Distribution::ggx, Geometry::smith);
    CHECK(directional_albedo(table, 1.0f, 1.0f) == table.E.back());
    CHECK(directional_albedo(table, 0.0f, 0.0f) == table.E.front());
    CHECK(directional_albedo(table, -1.0f, -1.0f) == table.E.front());
    CHECK(directional_albedo(table, 2.0f, 2.0f) == table.E.back());
    CHECK(average_albedo(table, 1.0f) == table.E_avg.back());
}
