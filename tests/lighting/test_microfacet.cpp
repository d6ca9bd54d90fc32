// D and V: normalization, precision, reciprocity, and the energy a single bounce keeps.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/microfacet.hpp"

using namespace kreda::lighting;
using glm::dvec3;
using glm::vec3;
using std::numbers::pi;

namespace {

using DistributionFunction = float (*)(float n_dot_h, float sin2_h, float alpha);
using VisibilityFunction = float (*)(const MicrofacetAngles& angles, float roughness);

struct NamedDistribution {
    const char* name;
    DistributionFunction D;
    double (*reference)(double c, double s2, double theta, double alpha);
};

double gaussian_normalizer_by_quadrature(double m) {
    const double end = std::min(0.5 * pi, 9.0 * m);
    constexpr int kSteps = 2000;
    double sum = 0.0;  // midpoints: the integrand and its slope vanish at 0 and 9 m, else error 1e-7
    for (int i = 0; i < kSteps; ++i) {
        const double theta = end * (i + 0.5) / kSteps;
        sum += std::exp(-theta * theta / (m * m)) * std::sin(2.0 * theta);
    }
    return pi * sum * end / kSteps;
}

double ggx_reference(double c, double s2, double, double a) {
    const double q = s2 + c * c * a * a;
    return a * a / (pi * q * q);
}
double beckmann_reference(double c, double s2, double, double a) {
    return std::exp(-s2 / (c * c * a * a)) / (pi * a * a * c * c * c * c);
}
double blinn_phong_reference(double, double s2, double, double a) {
    return std::exp((1.0 / (a * a) - 1.0) * std::log1p(-s2)) / (pi * a * a);
}
double gaussian_reference(double, double, double theta, double a) {
    return std::exp(-theta * theta / (a * a)) / gaussian_normalizer_by_quadrature(a);
}

constexpr std::array<NamedDistribution, 4> kDistributions = {{
    {"ggx", ggx_distribution, ggx_reference},
    {"beckmann", beckmann_distribution, beckmann_reference},
    {"blinn_phong", blinn_phong_distribution, blinn_phong_reference},
    {"gaussian", gaussian_distribution, gaussian_reference},
}};

/// int D (n.h) dh, midpoints in u, where tan^2 theta = alpha^2 u / (1 - u): GGX becomes a constant, the others smooth.
double projected_area(DistributionFunction D, double alpha) {
    constexpr int kSteps = 4000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps;
        const double tan2 = alpha * alpha * u / (1.0 - u);
        const double c2 = 1.0 / (1.0 + tan2), s2 = tan2 / (1.0 + tan2);
        const double q = s2 + c2 * alpha * alpha;
        const double ggx = alpha * alpha / (pi * q * q);
        sum += D(static_cast<float>(std::sqrt(c2)), static_cast<float>(s2), static_cast<float>(alpha)) / ggx;
    }
    return sum / kSteps;
}

float v_schlick(const MicrofacetAngles& a, float r) {
    return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_direct(r));
}
float v_schlick_image(const MicrofacetAngles& a, float r) {
    return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_image(r * r));
}
float v_smith(const MicrofacetAngles& a, float r) {
    return smith_visibility(a.n_dot_l, a.n_dot_v, r * r);
}
float v_correlated(const MicrofacetAngles& a, float r) {
    return smith_correlated_visibility(a.n_dot_l, a.n_dot_v, r * r);
}
float v_implicit(const MicrofacetAngles&, float) {
    return implicit_visibility();
}
float v_grooves(const MicrofacetAngles& a, float) {
    return cook_torrance_visibility(a.n_dot_l, a.n_dot_v, a.n_dot_h, a.v_dot_h);
}
constexpr std::array<VisibilityFunction, 6> kVisibilities = {v_schlick,    v_schlick_image, v_smith,
                                                             v_correlated, v_implicit,      v_grooves};

/// E(mu) for F = 1: mean of (f n.l / p) over the visible facets of GGX (Dupuy & Benyoub 2023), in double.
double white_furnace(VisibilityFunction V, double mu, double roughness, int steps) {
    const double alpha = roughness * roughness;
    const dvec3 v{std::sqrt(1.0 - mu * mu), 0.0, mu};
    const double G_1 = 2.0 * mu / (mu + std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * mu * mu));
    const dvec3 s = glm::normalize(dvec3(alpha * v.x, 0.0, v.z));
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double phi = 2.0 * pi * (i + 0.5) / steps;
        for (int j = 0; j < steps; ++j) {
            const double z = (1.0 - (j + 0.5) / steps) * (1.0 + s.z) - s.z;
            const double radius = std::sqrt(1.0 - z * z);
            const dvec3 m =
                glm::normalize(dvec3(alpha * (radius * std::cos(phi) + s.x), alpha * radius * std::sin(phi), z + s.z));
            const double v_dot_m = glm::dot(v, m);
            const double l_z = 2.0 * v_dot_m * m.z - v.z;
            if (l_z <= 0.0) continue;
            const MicrofacetAngles angles{static_cast<float>(l_z), static_cast<float>(mu), static_cast<float>(m.z),
                                          static_cast<float>(v_dot_m), static_cast<float>(m.x * m.x + m.y * m.y)};
            sum += 4.0 * l_z * mu * V(angles, static_cast<float>(roughness)) / G_1;
        }
    }
    return sum / (static_cast<double>(steps) * steps);
}

vec3 direction(double theta, double phi) {
    return vec3(static_cast<float>(std::sin(theta) * std::cos(phi)),
                static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
}

}  // namespace

TEST_CASE("Microfacets: the projected area of every distribution is one") {
    for (const NamedDistribution& d : kDistributions) {
        for (const double alpha : {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0}) {
            CAPTURE(std::string(d.name));
            CAPTURE(alpha);
            CHECK(std::abs(projected_area(d.D, alpha) - 1.0) < 1e-4);  // midpoints: 1e-6; Gaussian's fit 2e-6
        }
    }
}

TEST_CASE("Microfacets: the normalizer of the Gaussian is its quadrature") {
    CHECK(gaussian_normalizer(0.05f) ==
          doctest::Approx(0.007841).epsilon(1e-4));  // printed digits of the literature's list
    CHECK(gaussian_normalizer(0.5f) == doctest::Approx(0.666705).epsilon(1e-5));
    for (int i = 1; i <= 100; ++i) {
        const double m = i / 100.0;
        CAPTURE(m);
        CHECK(gaussian_normalizer(static_cast<float>(m)) ==
              doctest::Approx(gaussian_normalizer_by_quadrature(m)).epsilon(4e-6));
    }
}

TEST_CASE("Microfacets: the squared angle and the logarithm follow libm in double") {
    for (int i = 0; i <= 1000; ++i) {
        const double theta = 0.5 * pi * i / 1000.0;
        const float c = static_cast<float>(std::cos(theta)), s2 = static_cast<float>(std::sin(theta) * std::sin(theta));
        CAPTURE(theta);
        CHECK(squared_angle(c, s2) == doctest::Approx(theta * theta).epsilon(4e-7));  // five roundings
        if (i > 0 && i < 1000) {
            CHECK(log_one_minus(s2, c * c) == doctest::Approx(2.0 * std::log(std::cos(theta))).epsilon(1e-6));
        }
    }
}

TEST_CASE("Microfacets: D in float follows double for the same vectors however narrow the highlight") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const NamedDistribution& d : kDistributions) {
        for (const float alpha : {0.002025f, 0.0079f, 0.03f, 0.1f, 0.5f, 1.0f}) {
            double worst = 0.0, worst_normalized = 0.0;
            for (int i = 0; i < 2000; ++i) {
                const dvec3 axis = glm::normalize(dvec3(uniform(random), uniform(random), uniform(random)) - 0.5);
                const dvec3 side = glm::normalize(glm::cross(axis, dvec3(0.3, 0.5, 0.8)));
                const double angle = uniform(random) * std::atan(3.0 * alpha);
                const vec3 n(axis), h(axis * std::cos(angle) + side * std::sin(angle));
                const double sine = glm::length(glm::cross(dvec3(n), dvec3(h)));
                const double theta = std::atan2(sine, glm::dot(dvec3(n), dvec3(h)));
                const double exact = d.reference(std::cos(theta), std::sin(theta) * std::sin(theta), theta, alpha);
                worst = std::max(worst, std::abs(d.D(glm::dot(n, h), squared_sine(n, h), alpha) / exact - 1.0));
                const MicrofacetAngles angles = microfacet_angles(n, h, h);  // normalizes h once more
                const double again = d.D(angles.n_dot_h, angles.sin2_h, alpha);
                worst_normalized = std::max(worst_normalized, std::abs(again / exact - 1.0));
            }
            CAPTURE(std::string(d.name));
            CAPTURE(alpha);
            CHECK(worst < 1e-5);  // measured: GGX 7e-7; the others up to 4.5e-6, for the exponent reaches -9
            // h normalized once more is off by 6e-8: in D up to s / alpha^2 times that, s up to 3 alpha. Measured 2e-7.
            CHECK(worst_normalized < 1e-5 + 3e-7 / alpha);
        }
    }
}

TEST_CASE("Microfacets: with one minus the squared cosine a narrow highlight is wrong by percents") {
    const float alpha = 0.01f;
    double worst = 0.0;
    for (int i = 0; i < 100; ++i) {
        const double theta = 0.03 * (i + 0.5) / 100.0;
        const float c = static_cast<float>(std::cos(theta));
        const double exact = ggx_reference(std::cos(theta), std::sin(theta) * std::sin(theta), theta, alpha);
        worst = std::max(worst, std::abs(ggx_distribution(c, 1.0f - c * c, alpha) / exact - 1.0));
    }
    CHECK(worst > 1e-3);
}

TEST_CASE("Microfacets: values by hand") {
    CHECK(ggx_distribution(1.0f, 0.0f, 0.5f) == doctest::Approx(1.0 / (pi * 0.25)).epsilon(1e-6));
    CHECK(ggx_distribution(0.6f, 0.64f, 1.0f) ==
          doctest::Approx(1.0 / pi).epsilon(1e-6));  // alpha 1: the same everywhere
    CHECK(beckmann_distribution(1.0f, 0.0f, 0.5f) == doctest::Approx(1.0 / (pi * 0.25)).epsilon(1e-6));
    CHECK(blinn_phong_distribution(0.6f, 0.64f, 1.0f) == doctest::Approx(1.0 / pi).epsilon(1e-6));  // exponent 0
    CHECK(schlick_k_direct(1.0f) == 0.5f);
    CHECK(schlick_k_image(0.5f) == 0.25f);
    CHECK(schlick_ggx_g1(0.5f, 0.5f) == doctest::Approx(2.0 / 3.0).epsilon(1e-6));
    CHECK(smith_g1(1.0f, 0.7f) == 1.0f);
    CHECK(alpha_from_roughness(0.5f) == 0.25f);
    CHECK(alpha_from_roughness(0.0f) == kMinAlpha);
    CHECK(alpha_from_roughness(3.0f) == 1.0f);
}

TEST_CASE("Microfacets: each V is the textbook's G over four cosines") {
    for (const double l : {0.02, 0.3, 0.7, 1.0}) {
        for (const double v : {0.05, 0.4, 0.9}) {
            for (const double r : {0.1, 0.5, 1.0}) {
                const double a2 = r * r * r * r, k = (r + 1.0) * (r + 1.0) / 8.0;
                const auto lambda = [a2](double c) {
                    return 0.5 * (std::sqrt(1.0 + a2 * (1.0 - c * c) / (c * c)) - 1.0);
                };
                const auto g1_schlick = [k](double c) { return c / (c * (1.0 - k) + k); };
                const double below = 4.0 * l * v;
                const float fl = static_cast<float>(l), fv = static_cast<float>(v), alpha = static_cast<float>(r * r);
                const float fk = schlick_k_direct(static_cast<float>(r));
                CHECK(schlick_ggx_visibility(fl, fv, fk) ==
                      doctest::Approx(g1_schlick(l) * g1_schlick(v) / below).epsilon(1e-6));
                CHECK(smith_visibility(fl, fv, alpha) ==
                      doctest::Approx(1.0 / ((1.0 + lambda(l)) * (1.0 + lambda(v))) / below).epsilon(1e-6));
                CHECK(smith_correlated_visibility(fl, fv, alpha) ==
                      doctest::Approx(1.0 / (1.0 + lambda(l) + lambda(v)) / below).epsilon(1e-6));
                for (const double h : {0.2, 0.8}) {
                    for (const double vh : {0.3, 0.9}) {
                        const double G = std::min({1.0, 2.0 * h * v / vh, 2.0 * h * l / vh});
                        CHECK(cook_torrance_visibility(fl, fv, static_cast<float>(h), static_cast<float>(vh)) ==
                              doctest::Approx(G / below).epsilon(1e-6));
                    }
                }
            }
        }
    }
}

TEST_CASE("Microfacets: V in float follows double from roughness 0 to 1 up to grazing") {
    double worst = 0.0;
    constexpr std::array<float, 9> cosines = {1e-6f, 1e-4f, 0.003f, 0.02f, 0.1f, 0.3f, 0.7f, 0.99f, 1.0f};
    const auto follow = [&worst](float V, double exact) { worst = std::max(worst, std::abs(V / exact - 1.0)); };
    for (int i = 0; i <= 40; ++i) {
        const float r = static_cast<float>(i) / 40.0f, alpha = alpha_from_roughness(r);
        const double a2 = double{alpha} * alpha, k = (double{r} + 1.0) * (double{r} + 1.0) / 8.0;
        const auto root = [a2](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
        for (const float l : cosines) {
            for (const float v : cosines) {
                const double dl = l, dv = v;
                follow(schlick_ggx_visibility(l, v, schlick_k_direct(r)),
                       0.25 / ((dl * (1.0 - k) + k) * (dv * (1.0 - k) + k)));
                follow(smith_visibility(l, v, alpha), 1.0 / ((dl + root(dl)) * (dv + root(dv))));
                follow(smith_correlated_visibility(l, v, alpha), 0.5 / (dl * root(dv) + dv * root(dl)));
                const double grooves = std::min({1.0, 2.0 * 0.8f * dv / 0.6f, 2.0 * 0.8f * dl / 0.6f});
                follow(cook_torrance_visibility(l, v, 0.8f, 0.6f), grooves / (4.0 * dl * dv));
            }
        }
    }
    CAPTURE(worst);
    CHECK(worst < 1e-6);  // some eight roundings
}

TEST_CASE("Microfacets: V is finite at grazing light and view") {
    for (const VisibilityFunction V : kVisibilities) {
        for (const float l : {0.0f, 1e-20f, 1e-6f, 1.0f}) {
            for (const float v : {0.0f, 1e-20f, 1e-6f, 1.0f}) {
                for (const float r : {0.045f, 1.0f}) {
                    const float value = V({l, v, 0.5f, 0.0f, 0.75f}, r);
                    CHECK(std::isfinite(value));
                    CHECK(value >= 0.0f);
                    CHECK(std::isfinite(value * l));
                }
            }
        }
    }
}

TEST_CASE("Microfacets: V has its limit at grazing view") {
    // n.v = 0, n.l = 1.   Grooves: G / (4 n.l n.v) -> n.h / (2 v.h)
    CHECK(cook_torrance_visibility(1.0f, 0.0f, 0.6f, 0.3f) == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(schlick_ggx_visibility(1.0f, 0.0f, 0.5f) == doctest::Approx(0.5).epsilon(1e-6));       // 1 / (4 k)
    CHECK(smith_visibility(1.0f, 0.0f, 0.5f) == doctest::Approx(1.0).epsilon(1e-6));             // 1 / (2 alpha)
    CHECK(smith_correlated_visibility(1.0f, 0.0f, 0.5f) == doctest::Approx(1.0).epsilon(1e-6));  // 1 / (2 alpha)
}

TEST_CASE("Microfacets: exchanging light and view changes no bit of D or V or the angle of Fresnel") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 5000; ++i) {
        const vec3 n = direction(0.4 * uniform(random), 6.28 * uniform(random));
        const vec3 l = direction(1.57 * uniform(random), 6.28 * uniform(random));
        const vec3 v = direction(1.57 * uniform(random), 6.28 * uniform(random));
        const MicrofacetAngles there = microfacet_angles(n, l, v), back = microfacet_angles(n, v, l);
        REQUIRE(there.n_dot_l == back.n_dot_v);
        REQUIRE(there.v_dot_h == back.v_dot_h);
        REQUIRE(there.n_dot_h == back.n_dot_h);
        REQUIRE(there.sin2_h == back.sin2_h);
        for (const VisibilityFunction V : kVisibilities) REQUIRE(V(there, 0.3f) == V(back, 0.3f));
    }
}

TEST_CASE("Microfacets: the angles are those of the half vector") {
    const vec3 n(0.0f, 0.0f, 1.0f), l = direction(0.5, 0.0), v = direction(0.9, pi);
    const MicrofacetAngles angles = microfacet_angles(n, l, v);
    CHECK(angles.n_dot_l == doctest::Approx(std::cos(0.5)).epsilon(1e-6));
    CHECK(angles.n_dot_h == doctest::Approx(std::cos(0.2)).epsilon(1e-6));  // in one plane: (0.9 - 0.5) / 2
    CHECK(angles.sin2_h == doctest::Approx(std::sin(0.2) * std::sin(0.2)).epsilon(1e-6));
    CHECK(angles.v_dot_h == doctest::Approx(std::cos(0.7)).epsilon(1e-6));
    const MicrofacetAngles opposite = microfacet_angles(n, l, -l);
    CHECK(opposite.v_dot_h < 1e-6f);
    CHECK(std::isfinite(opposite.sin2_h));
}

TEST_CASE("Microfacets: weak white furnace holds for Smith and fails for Schlick as known") {
    // G_1(v) int <v.h> D dh = n.v (Heitz 2014): what the facets show to v must cover the surface. alpha = 0.1.
    const double alpha = 0.1;
    const float k_direct = schlick_k_direct(static_cast<float>(std::sqrt(alpha)));
    constexpr std::array<double, 3> views = {0.05, 0.3, 0.7};
    constexpr std::array<double, 3> schlick_direct = {0.0158, 0.204, 0.642};
    constexpr std::array<double, 3> schlick_image = {0.0415, 0.275, 0.687};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double mu = views[i], sine = std::sqrt(1.0 - mu * mu);
        constexpr int kSteps = 1000;
        double visible = 0.0;
        for (int a = 0; a < kSteps; ++a) {
            const double u = (a + 0.5) / kSteps, tan2 = alpha * alpha * u / (1.0 - u), c = 1.0 / std::sqrt(1.0 + tan2);
            const double s = std::sqrt(tan2) * c;
            for (int b = 0; b < 256; ++b) {
                const double v_dot_h = mu * c + sine * s * std::cos(pi * (b + 0.5) / 256);
                visible += std::max(v_dot_h, 0.0) / c / (256.0 * kSteps);  // D dh = du / c
            }
        }
        CAPTURE(mu);
        const float c = static_cast<float>(mu);
        CHECK(smith_g1(c, 0.1f) * visible == doctest::Approx(mu).epsilon(3e-3));  // heavy tail cut at u = 1 - 1/2000
        CHECK(schlick_ggx_g1(c, k_direct) * visible == doctest::Approx(schlick_direct[i]).epsilon(5e-3));
        CHECK(schlick_ggx_g1(c, schlick_k_image(0.1f)) * visible == doctest::Approx(schlick_image[i]).epsilon(5e-3));
    }
}

TEST_CASE("Microfacets: the white furnace returns the known share of the light") {
    struct Row {
        double roughness;
        VisibilityFunction V;
        std::array<double, 3> E;  ///< mu = 1, 0.5, 0.1; by a program of its own, 512 x 512 points
    };
    const std::array<Row, 12> rows = {{
        {0.1, v_smith, {1.00000, 0.99992, 0.99415}},
        {0.1, v_correlated, {1.00000, 0.99992, 0.99416}},
        {0.1, v_schlick, {0.99978, 0.75410, 0.18270}},
        {0.1, v_grooves, {1.00000, 0.99988, 0.99532}},
        {0.5, v_smith, {0.91582, 0.85509, 0.85430}},
        {0.5, v_correlated, {0.91582, 0.85726, 0.89162}},
        {0.5, v_schlick, {0.85985, 0.58526, 0.35967}},
        {0.5, v_schlick_image, {0.89508, 0.74708, 0.68854}},
        {1.0, v_smith, {0.30685, 0.40914, 0.55791}},
        {1.0, v_correlated, {0.30685, 0.45069, 0.76021}},
        {1.0, v_schlick, {0.30685, 0.40914, 0.55791}},
        {1.0, v_grooves, {0.37500, 0.65305, 0.93104}},
    }};
    for (const Row& row : rows) {
        const std::array<double, 3> views = {1.0, 0.5, 0.1};
        for (std::size_t i = 0; i < views.size(); ++i) {
            CAPTURE(row.roughness);
            CAPTURE(views[i]);
            const double E = white_furnace(row.V, views[i], row.roughness, 256);
            CHECK(std::abs(E - row.E[i]) < 5e-4);  // quadrature
            CHECK(E < 1.0 + 1e-4);
        }
    }
    CHECK(std::abs(white_furnace(v_smith, 1.0, 1.0, 256) - (1.0 - std::log(2.0))) < 1e-5);  // closed form
}
