// Cook and Torrance's model as a whole: by hand, against double, its laws, and each choice against its formula.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/cook_torrance.hpp"

using namespace kreda::lighting;
using glm::dvec3;
using glm::vec3;
using std::numbers::pi;

namespace {

constexpr std::array kDistributions = {Distribution::ggx, Distribution::beckmann, Distribution::blinn_phong,
                                       Distribution::gaussian};
constexpr std::array kGeometries = {Geometry::schlick_ggx, Geometry::smith, Geometry::smith_correlated,
                                    Geometry::implicit, Geometry::cook_torrance};
/// All but corrected_schlick_as_printed, which falls below 0.
constexpr std::array kFresnelMethods = {FresnelMethod::schlick,
                                        FresnelMethod::exact,
                                        FresnelMethod::schlick_ior,
                                        FresnelMethod::rescaled_schlick,
                                        FresnelMethod::corrected_schlick,
                                        FresnelMethod::f82,
                                        FresnelMethod::table,
                                        FresnelMethod::nvidia,
                                        FresnelMethod::none};

const vec3 kN(0.0f, 0.0f, 1.0f);

vec3 direction(double theta, double phi) {
    return vec3(static_cast<float>(std::sin(theta) * std::cos(phi)),
                static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
}

CookTorranceMaterial gold_by_index() {
    CookTorranceMaterial m;
    m.metallic = 1.0f;
    m.ior = vec3(0.23f, 0.57f, 1.39f);
    m.extinction = vec3(3.94f, 2.18f, 1.72f);
    return m;
}

/// The thesis' specular term D V F (n.l), eq. (4) to (9), in double from the same vectors.
double specular_reference(const vec3& n_, const vec3& l_, const vec3& v_, double roughness, double f0) {
    const dvec3 n(n_), l(l_), v(v_), h = glm::normalize(l + v);
    const double n_l = std::max(glm::dot(n, l), 0.0), n_v = std::max(glm::dot(n, v), 0.0), v_h = glm::dot(v, h);
    const double alpha2 = std::pow(std::max(roughness * roughness, static_cast<double>(kMinAlpha)), 2);
    const double s2 = glm::dot(glm::cross(n, h), glm::cross(n, h)), c2 = glm::dot(n, h) * glm::dot(n, h);
    const double D = alpha2 / (pi * std::pow(s2 + c2 * alpha2, 2));
    const double k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    const double V = 0.25 / ((n_l * (1.0 - k) + k) * (n_v * (1.0 - k) + k));
    return D * V * (f0 + (1.0 - f0) * std::pow(1.0 - v_h, 5)) * n_l;
}

}  // namespace

TEST_CASE("Cook-Torrance: light and view from above on a rough surface by hand") {
    CookTorranceMaterial m;
    m.albedo = vec3(0.5f);
    m.roughness = 1.0f;
    const ReflectedTerms terms = cook_torrance(kN, kN, kN, prepare(m));
    // alpha 1: D = 1/pi.  k = 1/2, G = 1: V = 1/4.  F = 0.04.  k_d = 0.96.
    CHECK(terms.specular.x == doctest::Approx(0.04 / (4.0 * pi)).epsilon(1e-6));
    CHECK(terms.diffuse.x == doctest::Approx(0.96 * 0.5 / pi).epsilon(1e-6));
}

TEST_CASE("Cook-Torrance: a metal has no diffuse part and reflects in its colour") {
    CookTorranceMaterial m;
    m.albedo = vec3(1.0f, 0.7f, 0.3f);
    m.metallic = 1.0f;
    const CookTorranceSetup setup = prepare(m);
    const ReflectedTerms terms = cook_torrance(kN, direction(0.2, 0.0), direction(0.2, pi), setup);
    CHECK(terms.diffuse == vec3(0.0f));
    CHECK(terms.specular.y / terms.specular.x ==
          doctest::Approx(0.7).epsilon(1e-4));  // the fifth power adds little at 0.2
    CHECK(base_reflectivity(vec3(0.9f), 0.0f).x == 0.04f);
    CHECK(base_reflectivity(vec3(0.9f), 1.0f).x == 0.9f);
    CHECK(base_reflectivity(vec3(0.9f), 0.5f).x == doctest::Approx(0.47).epsilon(1e-6));
}

TEST_CASE("Cook-Torrance: float follows double from roughness 0 to 1 up to grazing") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const float roughness : {0.0f, 0.05f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f}) {
        CookTorranceMaterial m;
        m.roughness = roughness;
        const CookTorranceSetup setup = prepare(m);
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const double theta = 0.5 * pi * (i % 2 == 0 ? uniform(random) : 1.0 - 0.01 * uniform(random));
            const double phi = 2.0 * pi * uniform(random);
            const double alpha = setup.surface.alpha;
            const vec3 l = direction(theta, phi);
            // Around the mirror direction, and anywhere.
            const double off = i % 3 == 0 ? pi * uniform(random) : 4.0 * alpha * (uniform(random) - 0.5);
            const vec3 v = direction(std::min(std::abs(theta + off), 0.5 * pi), phi + pi + off);
            const double expected = specular_reference(kN, l, v, roughness, setup.surface.f0.x);
            if (expected < 1e-30) continue;
            // 3e-6: some twenty roundings. The rest: l and v are rounded by 6e-8, which turns h by 6e-8 / |l + v| and
            // so moves the angle within a narrow highlight. No formula in float can know better.
            const double bound = 3e-6 + 5e-7 / (alpha * microfacet_angles(kN, l, v).v_dot_h);
            worst = std::max(worst, std::abs(cook_torrance(kN, l, v, setup).specular.x / expected - 1.0) / bound);
        }
        CAPTURE(roughness);
        CHECK(worst < 1.0);
    }
}

TEST_CASE("Cook-Torrance: exchanging light and view changes nothing whatever D and G and F") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Geometry geometry : kGeometries) {
        for (const FresnelMethod fresnel : kFresnelMethods) {
            CookTorranceMaterial m = gold_by_index();
            m.metallic = 0.5f;
            m.geometry = geometry;
            m.fresnel = fresnel;
            const CookTorranceSetup setup = prepare(m);
            for (int i = 0; i < 50; ++i) {
                const vec3 l = direction(1.5 * uniform(random), 6.28 * uniform(random));
                const vec3 v = direction(1.5 * uniform(random), 6.28 * uniform(random));
                const ReflectedTerms there = cook_torrance(kN, l, v, setup), back = cook_torrance(kN, v, l, setup);
                // f itself is the same to the bit (see Microfacets); only the factor n.l differs.
                CHECK(there.specular.x * v.z == doctest::Approx(back.specular.x * l.z).epsilon(1e-6));
                CHECK(there.diffuse.y * v.z == doctest::Approx(back.diffuse.y * l.z).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("Cook-Torrance: every combination is finite everywhere and dark behind") {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Distribution distribution : kDistributions) {
        for (const Geometry geometry : kGeometries) {
            for (const FresnelMethod fresnel : kFresnelMethods) {
                CookTorranceMaterial m = gold_by_index();
                m.distribution = distribution;
                m.geometry = geometry;
                m.fresnel = fresnel;
                CookTorranceSetup setup = prepare(m);
                for (const float roughness : {0.0f, 0.3f, 1.0f}) {
                    setup.surface = surface_from_maps(m.albedo, m.metallic, roughness, setup);
                    for (int i = 0; i < 40; ++i) {
                        const double theta = i % 4 == 0 ? 0.5 * pi : pi * uniform(random);
                        const vec3 l = direction(theta, 6.28 * uniform(random));
                        const vec3 v = i % 5 == 0 ? -l : direction(pi * uniform(random), 6.28 * uniform(random));
                        const vec3 f = cook_torrance(kN, l, v, setup).specular;
                        REQUIRE(std::isfinite(f.x + f.y + f.z));
                        REQUIRE(std::min({f.x, f.y, f.z}) >= 0.0f);
                        if (l.z <= 0.0f) REQUIRE(f == vec3(0.0f));
                    }
                }
            }
        }
    }
}

TEST_CASE("Cook-Torrance: each Fresnel method is its formula") {
    const vec3 n(0.23f, 0.57f, 1.39f), k(3.94f, 2.18f, 1.72f);
    const vec3 f0 = f0_from_index(n, k);
    for (const float c : {0.0f, 0.15f, 0.5f, 1.0f}) {
        const auto F = [&](FresnelMethod method) {
            CookTorranceMaterial m = gold_by_index();
            m.fresnel = method;
            const CookTorranceSetup setup = prepare(m);
            return fresnel_term(setup, c, setup.surface.f0);
        };
        const auto near = [](const vec3& a, const vec3& b) { return glm::length(a - b) < 2e-6f; };
        CHECK(near(F(FresnelMethod::schlick), fresnel_schlick(c, f0)));
        CHECK(near(F(FresnelMethod::exact), fresnel_conductor(c, n, k)));
        CHECK(near(F(FresnelMethod::rescaled_schlick), fresnel_rescaled_schlick(c, n, k)));
        CHECK(near(F(FresnelMethod::schlick_ior), fresnel_schlick_between(c, n)));
        const SchlickCorrection red = fit_correction_as_printed(n.x, k.x);
        CHECK(F(FresnelMethod::corrected_schlick_as_printed).x ==
              doctest::Approx(fresnel_corrected_schlick_as_printed(c, f0.x, red.a, red.lambda)).epsilon(1e-6));
        CHECK(near(F(FresnelMethod::f82), fresnel_f82(c, f0, f82_coefficient_from_index(n, k))));
        CHECK(near(F(FresnelMethod::none), f0));
        CHECK(near(F(FresnelMethod::nvidia), fresnel_schlick(c, f0)));  // bias F0, scale 1 - F0, power 5
        CHECK(glm::length(F(FresnelMethod::table) - fresnel_conductor(c, n, k)) < 1e-4f);  // 256 samples
        if (c == kCorrectionCosine) {
            CHECK(F(FresnelMethod::corrected_schlick).x ==
                  doctest::Approx(fresnel_conductor(c, n.x, k.x)).epsilon(1e-6));
        }
    }
    CookTorranceMaterial plastic;  // no index: that of the dielectric with F0 = 0.04 is 1.5
    plastic.fresnel = FresnelMethod::exact;
    const CookTorranceSetup setup = prepare(plastic);
    CHECK(fresnel_term(setup, 0.5f, setup.surface.f0).x ==
          doctest::Approx(fresnel_dielectric(0.5f, 1.5f)).epsilon(1e-5));
}

TEST_CASE("Cook-Torrance: with compensation a white metal reflects all light and without it less") {
    for (const float roughness : {0.5f, 0.8f, 1.0f}) {
        for (const double theta : {0.0, 0.8, 1.3}) {
            CookTorranceMaterial m;
            m.albedo = vec3(1.0f);
            m.metallic = 1.0f;
            m.roughness = roughness;
            m.geometry = Geometry::smith_correlated;
            m.energy_compensation = EnergyCompensation::kulla_conty;
            CookTorranceSetup setup = prepare(m);
            const vec3 v = direction(theta, 0.0);
            const auto furnace = [&] {
                constexpr int kHeights = 300, kAzimuths = 128;
                double sum = 0.0;
                for (int i = 0; i < kHeights; ++i) {  // midpoints in cos theta_l, half a turn
                    const double mu = (i + 0.5) / kHeights;
                    for (int j = 0; j < kAzimuths; ++j) {
                        const vec3 l = direction(std::acos(mu), pi * (j + 0.5) / kAzimuths);
                        sum += cook_torrance(kN, l, v, setup).specular.x;
                    }
                }
                return sum * 2.0 * pi / (kHeights * kAzimuths);
            };
            CAPTURE(roughness);
            CAPTURE(theta);
            CHECK(std::abs(furnace() - 1.0) < 3e-3);  // table 2e-3, this quadrature 1e-3
            setup.energy_compensation = EnergyCompensation::none;
            CHECK(furnace() < 0.94);
        }
    }
}

TEST_CASE("Cook-Torrance: maps replace the constants and keep the F0 of a measured metal") {
    const CookTorranceSetup plastic = prepare(CookTorranceMaterial{});
    const MicrofacetSurface painted = surface_from_maps(vec3(0.2f), 1.0f, 0.5f, plastic);
    CHECK(painted.f0 == vec3(0.2f));
    CHECK(painted.alpha == 0.25f);
    const CookTorranceSetup gold = prepare(gold_by_index());
    CHECK(surface_from_maps(vec3(0.2f), 1.0f, 0.5f, gold).f0 == gold.surface.f0);
    CHECK(gold.surface.f0.x == doctest::Approx(0.945998).epsilon(1e-6));
}

TEST_CASE("Cook-Torrance: a measured metal has the colours of its whole spectrum or of three wavelengths") {
    CookTorranceMaterial m;
    m.measured = "copper";
    m.metallic = 1.0f;
    const MeasuredMaterial& copper = *find_measured("copper");
    const auto F = [&](FresnelMethod method, float c) {
        m.fresnel = method;
        const CookTorranceSetup setup = prepare(m);
        return fresnel_term(setup, c, setup.surface.f0);
    };
    const auto near = [](const vec3& a, const vec3& b, float tolerance) { return glm::length(a - b) < tolerance; };
    for (const float c : {0.0f, 1.0f / 7.0f, 0.5f, 1.0f}) {
        CAPTURE(c);
        const vec3 exact = spectral_fresnel(copper, c);  // the oracle, summed in double
        CHECK(near(F(FresnelMethod::exact, c), exact, 1e-6f));
        CHECK(near(F(FresnelMethod::table, c), exact, 1e-4f));  // 256 samples
    }
    CHECK(near(F(FresnelMethod::f82, 1.0f / 7.0f), spectral_fresnel(copper, 1.0f / 7.0f), 1e-6f));
    CHECK(near(F(FresnelMethod::schlick, 1.0f), spectral_fresnel(copper, 1.0f), 1e-6f));
    m.spectrum = SpectrumUse::three;
    const ThreeChannelIndex index = three_channel_index(copper);
    CHECK(F(FresnelMethod::exact, 0.3f) == fresnel_conductor(0.3f, index.n, index.k));
    CHECK(needs_three_indices(FresnelMethod::corrected_schlick));
    CHECK_FALSE(needs_three_indices(FresnelMethod::f82));
}

TEST_CASE("Cook-Torrance: from within a denser medium all light is reflected beyond the critical angle") {
    CookTorranceMaterial bubble;  // air in glass, seen from the glass
    bubble.ior = vec3(1.0f);
    bubble.outside_ior = 1.5f;
    bubble.fresnel = FresnelMethod::exact;
    const CookTorranceSetup setup = prepare(bubble);
    CHECK(setup.surface.f0.x == doctest::Approx(0.04).epsilon(1e-6));
    CHECK(fresnel_term(setup, 0.7f, setup.surface.f0) == vec3(1.0f));  // 45.6 degrees, beyond asin(1 / 1.5) = 41.8
    CHECK(fresnel_term(setup, 0.8f, setup.surface.f0).x < 0.2f);       // 36.9 degrees
    bubble.fresnel = FresnelMethod::schlick_ior;
    const CookTorranceSetup approximate = prepare(bubble);
    CHECK(fresnel_term(approximate, 0.7f, setup.surface.f0).x == doctest::Approx(1.0).epsilon(1e-6));
    bubble.fresnel = FresnelMethod::schlick;
    CHECK(fresnel_term(prepare(bubble), 0.7f, setup.surface.f0).x < 0.05f);  // knows nothing of it
}

TEST_CASE("Cook-Torrance: under water glass shows a fifth of the reflection that it shows in air") {
    CookTorranceMaterial glass;
    glass.ior = vec3(1.5f);
    CHECK(prepare(glass).surface.f0.x == doctest::Approx(0.04).epsilon(1e-6));
    glass.outside_ior = 1.333f;
    CHECK(prepare(glass).surface.f0.x == doctest::Approx(std::pow(0.167 / 2.833, 2)).epsilon(1e-5));
    glass.ior.reset();
    glass.measured = "diamond";
    const double n = 2.4226 / 1.333;  // at 550 nm
    CHECK(prepare(glass).surface.f0.y == doctest::Approx(std::pow((n - 1.0) / (n + 1.0), 2)).epsilon(5e-3));
    glass.measured = "water";  // the same on both sides: nothing is there
    glass.outside_ior = 1.3345f;
    CHECK(prepare(glass).surface.f0.y < 1e-5f);
}

TEST_CASE("Cook-Torrance: the colour at 82 degrees and bias and scale and power may be given") {
    CookTorranceMaterial m;
    m.albedo = vec3(0.91f, 0.92f, 0.92f);
    m.metallic = 1.0f;
    m.f82 = vec3(0.83f, 0.86f, 0.89f);
    m.fresnel = FresnelMethod::f82;
    const CookTorranceSetup aluminium = prepare(m);
    CHECK(glm::length(fresnel_term(aluminium, 1.0f / 7.0f, aluminium.surface.f0) - *m.f82) < 1e-6f);
    m.nvidia = vec3(0.1f, 0.5f, 2.0f);
    m.fresnel = FresnelMethod::nvidia;
    CHECK(fresnel_term(prepare(m), 0.5f, m.albedo).x == doctest::Approx(0.1 + 0.5 * 0.25).epsilon(1e-6));
    m.fresnel = FresnelMethod::table;
    m.table_size = 2;  // a straight line from 1 at 90 degrees to F0
    const CookTorranceSetup line = prepare(m);
    CHECK(fresnel_term(line, 0.5f, m.albedo).x == doctest::Approx(0.5 * (1.0 + line.surface.f0.x)).epsilon(1e-4));
}
