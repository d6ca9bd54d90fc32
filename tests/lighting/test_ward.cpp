// Ward's and Heidrich and Seidel's models: symmetry, energy, and values by hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "lighting/ward.hpp"

using namespace kreda::lighting;
using glm::vec3;
using std::numbers::pi;

namespace {

const vec3 kN(0.0f, 0.0f, 1.0f);
const vec3 kT(1.0f, 0.0f, 0.0f);
const vec3 kB(0.0f, 1.0f, 0.0f);

vec3 direction(double theta, double phi) {
    return vec3(static_cast<float>(std::sin(theta) * std::cos(phi)),
                static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
}

/// int f (n.l) dl over the hemisphere: midpoints in cos^2 theta_l and phi.
template <class Brdf>
double directional_albedo_of(Brdf f, const vec3& v) {
    constexpr int kHeights = 400, kAzimuths = 400;
    double sum = 0.0;
    for (int i = 0; i < kHeights; ++i) {
        const double theta = std::acos(std::sqrt((i + 0.5) / kHeights));  // dl n.l = dphi d(cos^2) / 2
        for (int j = 0; j < kAzimuths; ++j) sum += f(direction(theta, 2.0 * pi * (j + 0.5) / kAzimuths), v);
    }
    return sum * pi / (kHeights * kAzimuths);
}

}  // namespace

TEST_CASE("Ward: values by hand") {
    CHECK(ward_isotropic(microfacet_angles(kN, kN, kN), 0.5f) ==
          doctest::Approx(1.0 / (4.0 * pi * 0.25)).epsilon(1e-6));
    // l and v 60 degrees to both sides: h = n, and 1 / sqrt(cos cos) = 2
    const vec3 l = direction(pi / 3.0, 0.0), v = direction(pi / 3.0, pi);
    CHECK(ward_isotropic(microfacet_angles(kN, l, v), 0.5f) == doctest::Approx(2.0 / pi).epsilon(1e-5));
    CHECK(ward_anisotropic(kN, kT, kB, l, v, 0.2f, 0.5f) == doctest::Approx(2.0 / (4.0 * pi * 0.1)).epsilon(1e-5));
    // v.h = 1/2: 1 / (4 pi alpha^2 / 4)
    CHECK(ward_bounded(microfacet_angles(kN, l, v), 0.5f) == doctest::Approx(4.0 / pi).epsilon(1e-5));
    CHECK(ward_alpha_from_shininess(30.0f) == 0.25f);
}

TEST_CASE("Ward: with equal widths the anisotropic lobe is the isotropic one") {
    for (const double theta : {0.1, 0.7, 1.3}) {
        for (const double phi : {0.0, 1.0, 2.5}) {
            const vec3 l = direction(theta, phi), v = direction(0.6, 4.0);
            const float isotropic = ward_isotropic(microfacet_angles(kN, l, v), 0.3f);
            // 1e-4: the half vector's slope at 80 degrees enters an exponent near 30
            CHECK(ward_anisotropic(kN, kT, kB, l, v, 0.3f, 0.3f) == doctest::Approx(isotropic).epsilon(1e-4));
        }
    }
}

TEST_CASE("Ward: exchanging light and view changes nothing") {
    for (const double theta : {0.1, 0.7, 1.3, 1.57}) {
        for (const double phi : {0.0, 1.0, 2.5}) {
            const vec3 l = direction(theta, phi), v = direction(0.6, 4.0);
            CHECK(ward_isotropic(microfacet_angles(kN, l, v), 0.3f) ==
                  ward_isotropic(microfacet_angles(kN, v, l), 0.3f));
            CHECK(ward_bounded(microfacet_angles(kN, l, v), 0.3f) == ward_bounded(microfacet_angles(kN, v, l), 0.3f));
            CHECK(ward_anisotropic(kN, kT, kB, l, v, 0.1f, 0.4f) == ward_anisotropic(kN, kT, kB, v, l, 0.1f, 0.4f));
        }
    }
}

TEST_CASE("Ward: the lobe is long across the scratches") {
    // Small alpha_t: the highlight is narrow along t and wide along b.
    const float along_t = ward_anisotropic(kN, kT, kB, direction(0.4, 0.0), kN, 0.1f, 0.5f);
    const float along_b = ward_anisotropic(kN, kT, kB, direction(0.4, 0.5 * pi), kN, 0.1f, 0.5f);
    CHECK(along_b > 10.0f * along_t);
    CHECK(std::abs(ward_exponent(direction(0.4, 0.0), kN, kT, kB, 0.1f, 0.5f) - std::pow(std::tan(0.4) / 0.1, 2)) <
          1e-3);
}

TEST_CASE("Ward: a smooth surface seen from above reflects almost everything and the bounded one never more") {
    const auto isotropic = [](const vec3& l, const vec3& v) {
        return ward_isotropic(microfacet_angles(kN, l, v), 0.1f);
    };
    // x = tan^2 theta_h: E = int exp(-x / a^2) / a^2 (1 + x)^-2 sqrt((1 - x) / (1 + x)) dx = 1 - 3 a^2 + 11 a^4 - ...
    CHECK(std::abs(directional_albedo_of(isotropic, kN) - (1.0 - 0.03 + 0.0011)) < 3e-4);  // next term 5e-5; midpoints
    for (const float alpha : {0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const double theta : {0.0, 0.5, 1.0, 1.3, 1.5}) {
            CAPTURE(alpha);
            CAPTURE(theta);
            const auto bounded = [alpha](const vec3& l, const vec3& v) {
                return ward_bounded(microfacet_angles(kN, l, v), alpha);
            };
            CHECK(directional_albedo_of(bounded, direction(theta, 0.0)) < 1.0 + 2e-3);  // midpoints
        }
    }
}

TEST_CASE("Ward: albedo over the angle is lost towards grazing and the bounded form keeps most of it") {
    // Computed apart from this program, in double, with 4000 x 3000 midpoints in theta_l and phi, for alpha = 0.1.
    struct Row {
        double degrees, ward, bounded;
    };
    for (const Row& row : {Row{0.0, 0.9711, 0.9900}, Row{45.0, 0.6883, 0.9848}, Row{60.0, 0.4890, 0.9740},
                           Row{80.0, 0.1836, 0.8674}, Row{85.0, 0.1196, 0.8128}}) {
        CAPTURE(row.degrees);
        const vec3 v = direction(row.degrees * pi / 180.0, 0.0);
        const auto albedo_of = [&](float (*f)(const MicrofacetAngles&, float)) {
            return directional_albedo_of(
                [f](const vec3& l, const vec3& to_eye) { return f(microfacet_angles(kN, l, to_eye), 0.1f); }, v);
        };
        CHECK(std::abs(albedo_of(ward_isotropic) - row.ward) < 2e-3);  // 400 x 400 midpoints
        CHECK(std::abs(albedo_of(ward_bounded) - row.bounded) < 2e-3);
    }
}

TEST_CASE("Ward: nothing is reflected from behind and nothing is infinite at grazing") {
    const PhongMaterial m;
    const vec3 v = direction(0.3, 0.0);
    const ReflectedTerms behind = ward(kN, direction(2.0, 1.0), v, m);
    CHECK(behind.diffuse.x == 0.0f);
    CHECK(behind.specular.x == 0.0f);
    CHECK(ward_isotropic({0.0f, 0.5f, 0.9f, 0.5f, 0.19f}, 0.5f) == 0.0f);  // n.l = 0
    CHECK(ward_anisotropic(kN, kT, kB, direction(2.0, 1.0), v, 0.5f, 0.5f) == 0.0f);
    for (const double theta : {1.5, 1.57, 1.5707963, 3.14159265}) {
        const vec3 l = direction(theta, 2.0);
        CHECK(std::isfinite(ward(kN, l, v, m).specular.x));
        CHECK(std::isfinite(ward(kN, v, l, m).specular.x));
        CHECK(std::isfinite(ward_bounded(microfacet_angles(kN, l, v), 0.3f)));
        CHECK(std::isfinite(ward_anisotropic(kN, kT, kB, l, v, 0.1f, 0.3f)));
    }
}

TEST_CASE("Heidrich-Seidel: a thread is brightest where light and view mirror in its normal plane") {
    PhongMaterial m;
    m.diffuse = vec3(1.0f);
    m.specular = vec3(1.0f);
    m.shininess = 50.0f;
    // l and v make the same angle with +t and -t: the bracket is 1, whatever the turn about t.
    const vec3 l = direction(0.5, 0.0);
    CHECK(heidrich_seidel(kN, kT, l, direction(0.5, pi), m).specular.x == doctest::Approx(l.z).epsilon(1e-5));
    const vec3 turned(-l.x, l.z * 0.6f, l.z * 0.8f);  // the mirrored v, turned about t
    CHECK(heidrich_seidel(kN, kT, l, turned, m).specular.x == doctest::Approx(l.z).epsilon(1e-5));
    CHECK(heidrich_seidel(kN, kT, l, direction(0.9, pi), m).specular.x < 0.1f);
    CHECK(heidrich_seidel(kN, kT, kN, kN, m).diffuse.x == 1.0f);
    CHECK(heidrich_seidel(kN, kT, l, kN, m).diffuse.x == doctest::Approx(std::cos(0.5) * std::cos(0.5)).epsilon(1e-6));
    CHECK(heidrich_seidel(kN, kT, -kN, kN, m).specular.x == 0.0f);
}

TEST_CASE("Grain: the tangent is unit and in the surface and nearest to the grain") {
    for (const double theta : {0.0, 0.4, 1.2, 2.0, pi}) {
        for (const double phi : {0.0, 1.0, 4.0}) {
            const vec3 n = direction(theta, phi);
            for (const vec3& grain : {vec3(0.0f, 1.0f, 0.0f), vec3(0.6f, 0.0f, 0.8f), n, -n}) {
                const vec3 t = tangent_of_grain(grain, n);
                CHECK(glm::length(t) == doctest::Approx(1.0).epsilon(1e-6));
                CHECK(std::abs(glm::dot(t, n)) < 1e-4f);  // a grain 1e-4 from the normal leaves that many digits
            }
            const vec3 t = tangent_of_grain(kT, n);
            const double sine = std::sqrt(1.0 - static_cast<double>(n.x) * n.x);  // the best that a tangent can do
            if (sine > 0.01) CHECK(t.x == doctest::Approx(sine).epsilon(1e-5));
        }
    }
}

TEST_CASE("Ward: with equal widths the brushed model is the plain one of that width") {
    PhongMaterial m;
    m.shininess = 30.0f;  // alpha = sqrt(2 / 32) = 0.25
    const vec3 v = direction(0.4, 3.0);
    for (const double theta : {0.1, 0.5, 1.0}) {
        const vec3 l = direction(theta, 0.3);
        const ReflectedTerms plain = ward(kN, l, v, m), brushed = ward_brushed(kN, kT, l, v, m, glm::vec2(0.25f));
        CHECK(brushed.specular.x == doctest::Approx(plain.specular.x).epsilon(1e-4));  // the exponent is up to 30
        CHECK(brushed.diffuse.x == plain.diffuse.x);
    }
}

namespace {

/// Ward 1992 eq. (5) in double from the same float vectors, by tan and azimuth instead of dot products.
double ward_reference(const vec3& t_, const vec3& l_, const vec3& v_, double alpha_t, double alpha_b) {
    const glm::dvec3 l(l_), v(v_), h = glm::normalize(l + v);
    const double c = h.z, tan2 = (h.x * h.x + h.y * h.y) / (c * c);
    const double azimuth = std::atan2(h.y, h.x) - std::atan2(double{t_.y}, double{t_.x});
    const double width = std::pow(std::cos(azimuth) / alpha_t, 2) + std::pow(std::sin(azimuth) / alpha_b, 2);
    return std::exp(-tan2 * width) / (4.0 * pi * alpha_t * alpha_b * std::sqrt(l.z * v.z));
}

double heidrich_seidel_reference(const vec3& l_, const vec3& v_, double shininess) {
    const double l_t = l_.x, v_t = v_.x;  // angles to the thread: the mirror cosine is cos(angle difference)
    const double mirrored =
        std::cos(std::acos(std::clamp(v_t, -1.0, 1.0)) - (pi - std::acos(std::clamp(l_t, -1.0, 1.0))));
    return std::pow(std::max(mirrored, 0.0), shininess) * l_.z;
}

}  // namespace

TEST_CASE("Ward and Heidrich-Seidel: float follows double from narrow to wide up to grazing") {
    PhongMaterial m;
    m.specular = vec3(1.0f);
    double worst_ward = 0.0, worst_threads = 0.0;
    for (const float alpha : {0.01f, 0.05f, 0.2f, 1.0f}) {
        for (int i = 0; i < 2000; ++i) {
            const double theta = i % 2 == 0 ? 1.57 * i / 2000.0 : 0.5 * pi - 1e-3 * i / 2000.0 - 1e-6;
            const double phi = 0.37 * i;
            const vec3 l = direction(theta, phi);
            const vec3 v =
                direction(std::min(theta + alpha * std::sin(1.1 * i), 1.5707), phi + pi + alpha * std::cos(0.7 * i));
            const vec3 t = direction(0.5 * pi, 0.11 * i);
            const vec3 flat_t = glm::normalize(vec3(t.x, t.y, 0.0f));
            const double exact = ward_reference(flat_t, l, v, alpha, 0.3);
            // l and v are rounded by 6e-8: that turns h by 6e-8 / |l + v| and the exponent, up to 30, by twice the
            // slope times that over alpha.
            const double v_h = 0.5 * glm::length(l + v);
            const double bound = 1e-5 + 2e-6 / (alpha * v_h);
            if (exact > 1e-10) {
                const double error =
                    std::abs(ward_anisotropic(kN, flat_t, glm::cross(kN, flat_t), l, v, alpha, 0.3f) / exact - 1.0);
                worst_ward = std::max(worst_ward, error / bound);
            }
            for (const float shininess : {1.0f, 30.0f, 1000.0f}) {
                m.shininess = shininess;
                const double threads = heidrich_seidel_reference(l, v, shininess);
                if (threads < 1e-10) continue;
                const double error = std::abs(heidrich_seidel(kN, kT, l, v, m).specular.x / threads - 1.0);
                worst_threads =
                    std::max(worst_threads, error / (1e-6 + 4e-7 * shininess));  // a cosine's rounding, h times
            }
        }
    }
    CAPTURE(worst_ward);
    CAPTURE(worst_threads);
    CHECK(worst_ward < 1.0);
    CHECK(worst_threads < 1.0);
}
