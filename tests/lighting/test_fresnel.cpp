// Fresnel's coefficient: against complex arithmetic in double, its laws, and the published comparison of methods.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <doctest/doctest.h>

#include "lighting/energy.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/spectrum.hpp"

using namespace kreda::lighting;

namespace {

using std::numbers::pi;

float cosine_deg(double degrees) {
    return static_cast<float>(std::cos(degrees * pi / 180.0));
}

/// The textbook's form with complex numbers: n cos theta_t = sqrt(n^2 - sin^2 theta). Nothing in common with the code.
std::complex<double> refracted(double c, std::complex<double> n) {
    return std::sqrt(n * n - (1.0 - c * c));
}
double reference_s(double c, std::complex<double> n) {
    const std::complex<double> w = refracted(c, n);
    return std::norm((c - w) / (c + w));
}
double reference_p(double c, std::complex<double> n) {
    const std::complex<double> w = refracted(c, n);
    return std::norm((n * n * c - w) / (n * n * c + w));
}
double reference(double c, double n, double k) {
    return 0.5 * (reference_s(c, {n, k}) + reference_p(c, {n, k}));
}

struct Metal {
    const char* name;
    float n, k;
    std::array<double, 6> F;  ///< 0, 45, 60, 75 degrees, c = 1/7, 85 degrees; by a program of its own in long double
};
constexpr std::array<Metal, 6> kMetals = {{
    {"gold, red", 0.23f, 3.94f, {0.945998, 0.943861, 0.939167, 0.935081, 0.946770, 0.961909}},
    {"gold, green", 0.57f, 2.18f, {0.684092, 0.685819, 0.697741, 0.761254, 0.838165, 0.892018}},
    {"gold, blue", 1.39f, 1.72f, {0.358745, 0.369091, 0.400783, 0.517309, 0.653955, 0.757799}},
    {"platinum, red", 2.49f, 4.44f, {0.687713, 0.679876, 0.660537, 0.627792, 0.651382, 0.713860}},
    {"platinum, green", 2.04f, 3.63f, {0.636015, 0.629564, 0.615681, 0.608676, 0.661277, 0.736568}},
    {"platinum, blue", 1.9f, 3.28f, {0.603514, 0.598197, 0.588182, 0.596028, 0.662317, 0.742936}},
}};

struct Dielectric {
    double n;
    std::array<double, 6> F;  ///< 0, 30, 45, 60, 75, 85 degrees
    double brewster_deg;
};
constexpr std::array<Dielectric, 3> kDielectrics = {{
    {1.331, {0.02016376, 0.02122029, 0.02764692, 0.05931419, 0.21174471, 0.58299479}, 53.0819},
    {1.5, {0.04, 0.04152263, 0.05023991, 0.08918671, 0.25306056, 0.61279965}, 56.3099},
    {2.42, {0.17239492, 0.17388297, 0.18152106, 0.21159757, 0.33062717, 0.62162162}, 67.5485},
}};

/// Mean relative error over angles spread evenly over (0, 90) degrees and over the three channels, in percent: the
/// measure of Stetic-Kozic 2014, section 5.2, with a million angles.
template <class Approximation>
double mean_error_percent(const ThreeChannelIndex& index, Approximation approximation, int angles = 1'000'000) {
    double sum = 0.0;
    for (int i = 0; i < angles; ++i) {
        const double theta = (i + 0.5) / angles * 0.5 * pi;
        const double c = std::cos(theta);
        for (int channel = 0; channel < 3; ++channel) {
            const double n = index.n[channel], k = index.k[channel], s2 = 1.0 - c * c;
            // Eq. (8) to (12) as printed: in double the cancellation does no harm.
            const double A = n * n - k * k - s2;
            const double root = std::sqrt(A * A + 4.0 * n * n * k * k);
            const double a = std::sqrt(0.5 * (root + A));
            const double F_s = (root - 2.0 * a * c + c * c) / (root + 2.0 * a * c + c * c);
            const double st = s2 / c;
            const double F = 0.5 * F_s * (1.0 + (root - 2.0 * a * st + st * st) / (root + 2.0 * a * st + st * st));
            sum += std::abs(approximation(static_cast<float>(c), channel) - F) / F;
        }
    }
    return 100.0 * sum / (3.0 * angles);
}

double rescaled_error(const ThreeChannelIndex& i) {
    return mean_error_percent(i, [&](float c, int j) { return fresnel_rescaled_schlick(c, i.n[j], i.k[j]); });
}

using Fit = SchlickCorrection (*)(float n, float k, float c_m);
using Form = float (*)(float c, float f0, float a, float lambda);

double corrected_error(const ThreeChannelIndex& index, float c_m, Fit fit, Form form) {
    std::array<SchlickCorrection, 3> fits;
    for (int j = 0; j < 3; ++j) fits[static_cast<std::size_t>(j)] = fit(index.n[j], index.k[j], c_m);
    const glm::vec3 f0 = f0_from_index(index.n, index.k);
    return mean_error_percent(index, [&](float c, int j) {
        const SchlickCorrection& correction = fits[static_cast<std::size_t>(j)];
        return form(c, f0[j], correction.a, correction.lambda);
    });
}

double lookup_error(const ThreeChannelIndex& index, int size) {
    const FresnelTable table = fresnel_table(index.n, index.k, size);
    const std::array<const float*, 3> channels = {table.r.data(), table.g.data(), table.b.data()};
    return mean_error_percent(
        index, [&](float c, int j) { return fresnel_lookup(c, channels[static_cast<std::size_t>(j)], size); }, 50'000);
}

}  // namespace

TEST_CASE("Fresnel: metals have the values of an independent program") {
    for (const Metal& m : kMetals) {
        CAPTURE(std::string(m.name));
        const std::array<float, 6> cosines = {1.0f,           cosine_deg(45), cosine_deg(60),
                                              cosine_deg(75), 1.0f / 7.0f,    cosine_deg(85)};
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            CAPTURE(cosines[i]);
            CHECK(std::abs(fresnel_conductor(cosines[i], m.n, m.k) - m.F[i]) < 1e-6);  // digits of the list; float 3e-7
        }
    }
}

TEST_CASE("Fresnel: dielectrics have the values of an independent program") {
    constexpr std::array<double, 6> degrees = {0, 30, 45, 60, 75, 85};
    for (const Dielectric& d : kDielectrics) {
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            CAPTURE(d.n);
            CAPTURE(degrees[i]);
            const float c = cosine_deg(degrees[i]);
            const float n = static_cast<float>(d.n);
            CHECK(std::abs(fresnel_dielectric(c, n) - d.F[i]) < 1e-6);
            CHECK(std::abs(fresnel_conductor(c, n, 0.0f) - d.F[i]) < 1e-6);
        }
    }
}

TEST_CASE("Fresnel: float follows complex arithmetic in double up to grazing") {
    double worst_metal = 0.0, worst_dielectric = 0.0;
    for (int i = 0; i <= 300; ++i) {
        const float c = static_cast<float>(i) / 300.0f;
        for (const float n : {0.03f, 0.1f, 0.5f, 1.0f, 2.0f, 3.0f}) {
            for (const float k : {1.5f, 3.0f, 9.0f, 100.0f}) {
                const double F = reference(c, n, k);
                worst_metal = std::max(worst_metal, std::abs(fresnel_conductor(c, n, k) - F) / F);
            }
        }
        for (const float n : {1.0001f, 1.01f, 1.333f, 1.5f, 2.42f, 4.0f}) {
            const double F = reference(c, n, 0.0);
            worst_dielectric = std::max(worst_dielectric, std::abs(fresnel_dielectric(c, n) - F) / F);
        }
    }
    CAPTURE(worst_metal);
    CAPTURE(worst_dielectric);
    CHECK(worst_metal < 5e-7);       // eight roundings; the printed eq. (8) has 2e-4 at k = 100
    CHECK(worst_dielectric < 2e-6);  // even at F = 3e-9: with g - c as a difference n = 1.0001 is off by 6e-4
}

TEST_CASE("Fresnel: the polarized parts follow complex arithmetic") {
    for (int i = 0; i <= 100; ++i) {
        const float c = static_cast<float>(i) / 100.0f;
        CAPTURE(c);
        const PolarizedFresnel gold = fresnel_conductor_polarized(c, 0.23f, 3.94f);
        CHECK(std::abs(gold.s - reference_s(c, {0.23f, 3.94f})) < 1e-6);
        CHECK(std::abs(gold.p - reference_p(c, {0.23f, 3.94f})) < 1e-6);
        const PolarizedFresnel glass = fresnel_dielectric_polarized(c, 1.5f);
        CHECK(std::abs(glass.s - reference_s(c, 1.5)) < 1e-6);
        CHECK(std::abs(glass.p - reference_p(c, 1.5)) < 1e-6);
    }
}

TEST_CASE("Fresnel: the coefficient is in 0..1 and 1 at 90 degrees") {
    for (const float n : {0.03f, 0.5f, 0.66666f, 1.0f, 1.0001f, 1.5f, 4.0f, 100.0f}) {
        for (const float k : {0.0f, 0.5f, 4.0f, 100.0f}) {
            CAPTURE(n);
            CAPTURE(k);
            for (int i = 0; i <= 1000; ++i) {
                const float F = fresnel_conductor(static_cast<float>(i) / 1000.0f, n, k);
                REQUIRE(F >= 0.0f);
                REQUIRE(F <= 1.0f);
            }
            const bool nothing_there = n == 1.0f && k == 0.0f;
            CHECK(fresnel_conductor(0.0f, n, k) == (nothing_there ? 0.0f : 1.0f));
        }
        CHECK(fresnel_dielectric(0.0f, n) == doctest::Approx(n == 1.0f ? 0.0 : 1.0).epsilon(3e-7));
        CHECK(fresnel_schlick_between(0.0f, n) == doctest::Approx(1.0).epsilon(3e-7));
        CHECK(fresnel_schlick(0.0f, f0_from_index(n, 2.0f)) == 1.0f);
    }
}

TEST_CASE("Fresnel: at Brewster's angle nothing swings within the plane of incidence") {
    for (const Dielectric& d : kDielectrics) {
        CAPTURE(d.n);
        const double brewster = std::atan(d.n);
        CHECK(brewster * 180.0 / pi == doctest::Approx(d.brewster_deg).epsilon(1e-6));
        const float c = static_cast<float>(std::cos(brewster));
        CHECK(fresnel_dielectric_polarized(c, static_cast<float>(d.n)).p < 1e-12f);  // square of a rounding error
        CHECK(fresnel_dielectric_polarized(c, static_cast<float>(d.n)).s > 0.02f);
    }
}

TEST_CASE("Fresnel: the way back reflects as much as the way in") {
    for (const float n : {1.1f, 1.333f, 1.5f, 2.42f}) {
        for (int i = 1; i <= 100; ++i) {
            const float c = static_cast<float>(i) / 100.0f;
            const float c_t = refracted_cosine(c, n);
            CAPTURE(n);
            CAPTURE(c);
            // c_t -> c -> F: dc / dc_t = n^2 c_t / c, dF / dc up to 4 n; one rounding of c_t is 6e-8.
            const float tolerance = 1e-6f + 2.4e-7f * n * n * n / c;
            CHECK(std::abs(fresnel_dielectric(c, n) - fresnel_dielectric(c_t, 1.0f / n)) < tolerance);
        }
    }
}

TEST_CASE("Fresnel: beyond the critical angle all light is reflected") {
    const float n = relative_index(1.5f, 1.0f);  // from glass into air: 41.81 degrees
    for (const double degrees : {41.82, 45.0, 60.0, 75.0, 85.0, 90.0}) {
        CAPTURE(degrees);
        CHECK(fresnel_dielectric(cosine_deg(degrees), n) == 1.0f);
        CHECK(fresnel_conductor(cosine_deg(degrees), n, 0.0f) == doctest::Approx(1.0).epsilon(1e-7));
        CHECK(fresnel_schlick_between(cosine_deg(degrees), n) == doctest::Approx(1.0).epsilon(1e-6));
    }
    CHECK(fresnel_dielectric(1.0f, n) == doctest::Approx(0.04).epsilon(1e-6));
    CHECK(fresnel_dielectric(cosine_deg(30.0), n) == doctest::Approx(0.05519017).epsilon(1e-5));
    CHECK(fresnel_dielectric(cosine_deg(41.80), n) < 0.99f);
    CHECK(fresnel_schlick_from_index(cosine_deg(60.0), n) < 0.1f);  // eq. (7) as printed knows nothing of it
}

TEST_CASE("Fresnel: the two forms of Schlick and the rescaled one are the same function") {
    for (const Metal& m : kMetals) {
        for (int i = 0; i <= 100; ++i) {
            const float c = static_cast<float>(i) / 100.0f;
            const float expected = fresnel_schlick(c, f0_from_index(m.n, m.k));
            CHECK(fresnel_rescaled_schlick(c, m.n, m.k) == doctest::Approx(expected).epsilon(5e-7));
            const float dielectric = fresnel_schlick(c, f0_from_index(m.n, 0.0f));
            CHECK(fresnel_schlick_from_index(c, m.n) == doctest::Approx(dielectric).epsilon(5e-7));
        }
    }
    CHECK(fresnel_schlick(0.5f, 0.04f) == doctest::Approx(0.04 + 0.96 / 32.0).epsilon(1e-6));
}

TEST_CASE("Fresnel: index_from_f0 gives back F0") {
    for (const float f0 : {0.0f, 0.02f, 0.04f, 0.5f, 0.9f}) {
        CAPTURE(f0);
        CHECK(f0_from_index(index_from_f0(f0), 0.0f) == doctest::Approx(f0).epsilon(1e-5));
    }
    CHECK(std::isfinite(index_from_f0(1.0f)));
    CHECK(index_from_f0(0.04f) == doctest::Approx(1.5).epsilon(1e-6));
}

TEST_CASE("Fresnel: the published errors of Schlick's approximations come out again") {
    // Printed: 0.98 5.31 8.68 3.8 (table 2 and 3). Half a unit of the last printed digit, and for platinum, whose
    // printed indices are rounded more than its error is, one unit.
    CHECK(std::abs(rescaled_error(published_index("gold")) - 0.98) < 0.005);
    CHECK(std::abs(rescaled_error(published_index("platinum")) - 5.31) < 0.01);
    CHECK(std::abs(rescaled_error(published_index("water")) - 8.68) < 0.005);
    CHECK(std::abs(rescaled_error(published_index("diamond")) - 3.8) < 0.05);
}

TEST_CASE("Fresnel: the published errors of the corrected approximation come out of the undivided form") {
    const ThreeChannelIndex gold = three_channel_index(*find_measured("gold_hagemann"));
    const ThreeChannelIndex platinum = three_channel_index(*find_measured("platinum"));
    // Printed: 0.82 and 2.07 (table 2). With the indices of the database, which the author had, not those he rounded
    // for print.
    const auto error = [](const ThreeChannelIndex& index) {
        return corrected_error(index, kCorrectionCosine, fit_correction, fresnel_corrected_schlick);
    };
    CHECK(std::abs(error(gold) - 0.82) < 0.005);
    CHECK(std::abs(error(platinum) - 2.07) < 0.005);
    CHECK(std::abs(error(published_index("gold")) - 0.833) < 0.002);
}

TEST_CASE("Fresnel: the correction as printed is worse than none") {
    const auto error = [](const ThreeChannelIndex& index) {
        return corrected_error(index, kCorrectionCosineAsPrinted, fit_correction_as_printed,
                               fresnel_corrected_schlick_as_printed);
    };
    CHECK(std::abs(error(published_index("gold")) - 2.26) < 0.01);
    CHECK(std::abs(error(published_index("platinum")) - 12.35) < 0.02);
    const SchlickCorrection fit = fit_correction_as_printed(2.49f, 4.44f);
    const float at_90 = fresnel_corrected_schlick_as_printed(0.0f, f0_from_index(2.49f, 4.44f), fit.a, fit.lambda);
    CHECK(at_90 == doctest::Approx(1.0 - 2.0 * 2.49).epsilon(1e-6));  // F = 1 - 2 n: far below 0
}

TEST_CASE("Fresnel: the correction is exact where it was fitted and absent where Schlick is too small") {
    for (const Metal& m : kMetals) {
        CAPTURE(std::string(m.name));
        const SchlickCorrection fit = fit_correction(m.n, m.k);
        const float f0 = f0_from_index(m.n, m.k);
        const double exact = reference(kCorrectionCosine, m.n, m.k);
        if (fit.a > 0.0f) {
            CHECK(fresnel_corrected_schlick(kCorrectionCosine, f0, fit.a, fit.lambda) ==
                  doctest::Approx(exact).epsilon(1e-6));
        } else {
            CHECK(fresnel_schlick(kCorrectionCosine, f0) <= exact);
        }
        for (int i = 0; i <= 1000; ++i) {
            const float F = fresnel_corrected_schlick(static_cast<float>(i) / 1000.0f, f0, fit.a, fit.lambda);
            REQUIRE(F >= 0.0f);
            REQUIRE(F <= 1.0f);
        }
        CHECK(fresnel_corrected_schlick(0.0f, f0, fit.a, fit.lambda) == 1.0f);
    }
    CHECK(fit_correction(0.57f, 2.18f).a == 0.0f);  // gold's green
    CHECK(fit_correction(0.23f, 3.94f).lambda == doctest::Approx(6.35).epsilon(1e-3));
    CHECK(fit_correction(2.49f, 4.44f).lambda == doctest::Approx(8.78).epsilon(1e-3));
}

TEST_CASE("Fresnel: F82 is exact at its angle and three times as good as the correction on platinum") {
    for (const Metal& m : kMetals) {
        CAPTURE(std::string(m.name));
        const float f0 = f0_from_index(m.n, m.k);
        const float f82 = fresnel_conductor(1.0f / 7.0f, m.n, m.k);
        const float b = f82_coefficient(f0, f82);
        CHECK(fresnel_f82(1.0f / 7.0f, f0, b) == doctest::Approx(f82).epsilon(1e-6));
        CHECK(fresnel_f82(1.0f, f0, b) == f0);
        CHECK(fresnel_f82(0.0f, f0, b) == 1.0f);
        double average = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const double mu = (i + 0.5) / 1000.0;
            const float F = fresnel_f82(static_cast<float>(mu), f0, b);
            REQUIRE(F >= 0.0f);
            REQUIRE(F <= 1.0f);
            average += 2.0 * F * mu / 1000.0;
        }
        CHECK(average == doctest::Approx(average_f82(f0, b)).epsilon(2e-6));  // midpoints: 1e-6
    }
    const ThreeChannelIndex platinum = published_index("platinum");
    const glm::vec3 f0 = f0_from_index(platinum.n, platinum.k);
    const glm::vec3 b = f82_coefficient_from_index(platinum.n, platinum.k);
    const double error = mean_error_percent(
        platinum, [&](float c, int j) { return fresnel_f82(c, f0[j], b[j]); }, 100'000);
    CHECK(std::abs(error - 0.61) < 0.005);
}

TEST_CASE("Fresnel: the error of a table falls four times with twice the samples and 16 beat every closed form") {
    for (const char* name : {"gold", "platinum", "water", "diamond"}) {
        CAPTURE(std::string(name));
        const ThreeChannelIndex index = published_index(name);
        std::array<double, 4> errors{};
        int size = 16;
        for (double& error : errors) {
            error = lookup_error(index, size);
            size *= 2;
        }
        for (std::size_t i = 1; i < errors.size(); ++i) {
            const double ratio = errors[i - 1] / errors[i];
            CAPTURE(ratio);
            CHECK(ratio > 3.9);  // order 2 gives 4; (2N - 1)^2 / (N - 1)^2 is up to 4.3; the steep end adds
            CHECK(ratio < 4.7);
        }
        CHECK(errors[0] < corrected_error(index, kCorrectionCosine, fit_correction, fresnel_corrected_schlick));
    }
    CHECK(lookup_error(published_index("platinum"), 16) == doctest::Approx(0.155).epsilon(0.01));
}

TEST_CASE("Fresnel: a table is exact at its samples and does not read beyond them") {
    const std::array<float, 3> values = {1.0f, 0.5f, 0.25f};
    CHECK(fresnel_lookup(0.0f, values.data(), 3) == 1.0f);
    CHECK(fresnel_lookup(0.5f, values.data(), 3) == 0.5f);
    CHECK(fresnel_lookup(1.0f, values.data(), 3) == 0.25f);
    CHECK(fresnel_lookup(0.75f, values.data(), 3) == 0.375f);
    CHECK(fresnel_lookup(-0.1f, values.data(), 3) == 1.0f);
    CHECK(fresnel_lookup(1.5f, values.data(), 3) == 0.25f);
}

TEST_CASE("Fresnel: the form of NVIDIA by hand and as Schlick") {
    CHECK(fresnel_nvidia(0.5f, 0.1f, 0.5f, 2.0f) == doctest::Approx(0.1 + 0.5 * 0.25).epsilon(1e-6));
    CHECK(fresnel_nvidia(0.0f, 0.5f, 2.0f, 3.0f) == 1.0f);
    CHECK(fresnel_nvidia(0.0f, -2.0f, 1.0f, 3.0f) == 0.0f);
    for (int i = 0; i <= 20; ++i) {
        const float c = static_cast<float>(i) / 20.0f;
        CHECK(fresnel_nvidia(c, 0.04f, 0.96f, 5.0f) == doctest::Approx(fresnel_schlick(c, 0.04f)).epsilon(1e-6));
    }
}
