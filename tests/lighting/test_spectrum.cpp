// Colours from measured indices: against independently computed values, and what three or few wavelengths cost.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "lighting/spectrum.hpp"

using namespace kreda::lighting;
using glm::vec3;

namespace {

double mean_relative_error_percent(const vec3& color, const vec3& reference) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += std::abs(color[i] - reference[i]) / reference[i];
    return 100.0 * sum / 3.0;
}

const MeasuredMaterial& measured(const char* name) {
    const MeasuredMaterial* material = find_measured(name);
    REQUIRE(material != nullptr);
    return *material;
}

/// Exact Fresnel from the indices at 685, 535 and 475 nm taken as red, green and blue.
vec3 three_wavelength_color(const MeasuredMaterial& material, float c) {
    const ThreeChannelIndex index = three_channel_index(material);
    return fresnel_conductor(c, index.n, index.k);
}

void check_near(const vec3& color, const vec3& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) CHECK(std::abs(color[i] - expected[i]) < tolerance);
}

/// Mean relative error over angles and channels of a model against the spectral evaluation.
template <class Model>
double mean_error_over_angles(const MeasuredMaterial& material, Model model) {
    constexpr int kAngles = 200;
    double sum = 0.0;
    for (int i = 0; i < kAngles; ++i) {
        const float c = static_cast<float>(std::cos((i + 0.5) / kAngles * 1.5707963267948966));
        sum += mean_relative_error_percent(model(c), spectral_fresnel(material, c));
    }
    return sum / kAngles;
}

}  // namespace

TEST_CASE("Spectrum: a surface that reflects everything is white") {
    Spectrum ones;
    ones.fill(1.0);
    check_near(linear_srgb_from_spectrum(ones), vec3(1.0f), 1e-7);
    ones.fill(0.25);
    check_near(linear_srgb_from_spectrum(ones), vec3(0.25f), 1e-7);
}

TEST_CASE("Spectrum: the observer and daylight add up to the white of D65") {
    double X = 0.0, Y = 0.0, Z = 0.0;
    for (const ObserverSample& s : observer_samples()) {
        X += s.x_bar * s.d65;
        Y += s.y_bar * s.d65;
        Z += s.z_bar * s.d65;
    }
    CHECK(Y == doctest::Approx(1056.5085).epsilon(1e-6));
    CHECK(X / Y == doctest::Approx(0.949401).epsilon(2e-6));
    CHECK(Z / Y == doctest::Approx(1.087091).epsilon(2e-6));
}

TEST_CASE("Spectrum: colours of metals at normal incidence and at 82 degrees") {
    struct Row {
        const char* name;
        vec3 f0, f82, three;  ///< by a program of its own with 1 nm steps from 360 to 830 nm
    };
    const std::array<Row, 5> rows = {{
        {"gold", {1.0376f, 0.7284f, 0.3646f}, {0.9910f, 0.8572f, 0.6464f}, {0.9678f, 0.7202f, 0.4067f}},
        {"silver", {0.9894f, 0.9840f, 0.9778f}, {0.9876f, 0.9860f, 0.9870f}, {0.9923f, 0.9831f, 0.9790f}},
        {"copper", {0.9317f, 0.6227f, 0.5223f}, {0.9459f, 0.7549f, 0.7024f}, {0.9511f, 0.6050f, 0.5578f}},
        {"aluminium", {0.9073f, 0.9159f, 0.9223f}, {0.8302f, 0.8622f, 0.8938f}, {0.9002f, 0.9163f, 0.9201f}},
        {"platinum", {0.6789f, 0.6395f, 0.5836f}, {0.6554f, 0.6604f, 0.6630f}, {0.6881f, 0.6354f, 0.6035f}},
    }};
    for (const Row& row : rows) {
        CAPTURE(std::string(row.name));
        const SpectralColors colors = spectral_colors(measured(row.name));
        check_near(colors.f0, row.f0, 2e-3);  // 10 nm steps: 2e-4 measured
        check_near(colors.f82, row.f82, 2e-3);
        check_near(three_wavelength_color(measured(row.name), 1.0f), row.three, 1e-4);  // the digits of the list
        check_near(fresnel_f82(1.0f / 7.0f, colors.f0, colors.b), colors.f82, 1e-6);
    }
    check_near(spectral_colors(measured("gold_hagemann")).f0, {1.0319f, 0.7061f, 0.3199f}, 2e-3);
    CHECK(spectral_colors(measured("gold")).f0.x > 1.0f);  // gold lies outside sRGB
}

TEST_CASE("Spectrum: dielectrics reflect as much as their index says and almost without colour") {
    struct Row {
        const char* name;
        float n;  ///< at 550 nm
    };
    for (const Row& row : {Row{"water", 1.333f}, Row{"diamond", 2.4226f}, Row{"glass", 1.5185f}}) {
        CAPTURE(std::string(row.name));
        const vec3 f0 = spectral_fresnel(measured(row.name), 1.0f);
        CHECK(f0.y == doctest::Approx(f0_from_index(row.n, 0.0f)).epsilon(5e-3));
        CHECK(f0.z > f0.x);  // normal dispersion: more blue
        CHECK(f0.z < 1.04f * f0.x);
        for (const IndexSample& s : measured(row.name).samples) CHECK(s.k == 0.0);
    }
    CHECK(index_at(measured("glass"), 587.6).n == doctest::Approx(1.5168).epsilon(2e-4));  // n_d of the catalogue
}

TEST_CASE("Spectrum: three-channel indices are those the comparison of Fresnel methods printed") {
    for (const char* name : {"gold", "platinum", "water", "diamond"}) {
        CAPTURE(std::string(name));
        const bool gold = std::string(name) == "gold";
        const ThreeChannelIndex index = three_channel_index(measured(gold ? "gold_hagemann" : name));
        const ThreeChannelIndex printed = published_index(name);
        // The author truncated rather than rounded (1.726 -> 1.72): up to one unit of the second digit.
        check_near(index.n, printed.n, 0.01);
        check_near(index.k, printed.k, 0.01);
    }
}

TEST_CASE("Spectrum: three wavelengths miss the colour of gold by percents and that of silver not") {
    struct Row {
        const char* name;
        double percent;
    };
    for (const Row& row : {Row{"gold", 6.47}, Row{"gold_hagemann", 7.91}, Row{"silver", 0.17}, Row{"copper", 3.91},
                           Row{"aluminium", 0.36}, Row{"platinum", 1.80}}) {
        CAPTURE(std::string(row.name));
        const MeasuredMaterial& material = measured(row.name);
        const double error =
            mean_relative_error_percent(three_wavelength_color(material, 1.0f), spectral_fresnel(material, 1.0f));
        CHECK(std::abs(error - row.percent) < 0.03);  // 2e-4 of 10 nm steps and the last printed digit
    }
}

TEST_CASE("Spectrum: eight wavelengths suffice") {
    const MeasuredMaterial& gold = measured("gold");
    const vec3 exact = spectral_fresnel(gold, 1.0f);
    const auto error = [&](int count) {
        return mean_relative_error_percent(spectral_fresnel_of_few(gold, 1.0f, count), exact);
    };
    CHECK(std::abs(error(3) - 12.6) < 0.1);  // printed 12.6 3.5 2.0 1.1 0.29; here the observer is linear between 10 nm
    CHECK(std::abs(error(4) - 3.5) < 0.3);
    CHECK(std::abs(error(5) - 2.0) < 0.2);
    CHECK(std::abs(error(6) - 1.1) < 0.3);
    CHECK(error(8) < 0.5);
    CHECK(error(30) < 0.15);
    for (const char* name : {"silver", "copper", "aluminium", "platinum"}) {
        const MeasuredMaterial& metal = measured(name);
        CHECK(mean_relative_error_percent(spectral_fresnel_of_few(metal, 1.0f, 8), spectral_fresnel(metal, 1.0f)) <
              0.3);
    }
}

TEST_CASE("Spectrum: the wrong formula with the right colours beats the right formula at three wavelengths") {
    struct Row {
        const char* name;
        double three_exact, schlick, f82;  ///< mean relative error over all angles, percent
    };
    for (const Row& row :
         {Row{"gold", 5.49, 0.86, 0.71}, Row{"silver", 0.16, 0.14, 0.06}, Row{"copper", 3.29, 1.17, 0.29},
          Row{"aluminium", 0.52, 2.31, 0.32}, Row{"platinum", 1.44, 5.14, 0.59}}) {
        CAPTURE(std::string(row.name));
        const MeasuredMaterial& metal = measured(row.name);
        const SpectralColors colors = spectral_colors(metal);
        const double three = mean_error_over_angles(metal, [&](float c) { return three_wavelength_color(metal, c); });
        const double schlick = mean_error_over_angles(metal, [&](float c) { return fresnel_schlick(c, colors.f0); });
        const double f82 = mean_error_over_angles(metal, [&](float c) { return fresnel_f82(c, colors.f0, colors.b); });
        CHECK(std::abs(three - row.three_exact) < 0.03);  // steps of 10 nm, and angles: 200
        CHECK(std::abs(schlick - row.schlick) < 0.03);
        CHECK(std::abs(f82 - row.f82) < 0.03);
    }
}

TEST_CASE("Spectrum: a table made from the spectrum is the spectrum at its samples") {
    const MeasuredMaterial& copper = measured("copper");
    const FresnelTable table = spectral_fresnel_table(copper, 33);
    for (const float c : {0.0f, 0.25f, 0.5f, 1.0f})
        check_near(fresnel_lookup(c, table), spectral_fresnel(copper, c), 1e-6);
    check_near(fresnel_lookup(0.39f, table), spectral_fresnel(copper, 0.39f), 1e-3);
    check_near(fresnel_lookup(0.0f, table), vec3(1.0f), 1e-6);  // at 90 degrees every surface is a white mirror
}

TEST_CASE("Spectrum: indices are linear between the published points and constant beyond") {
    const MeasuredMaterial& gold = measured("gold");
    CHECK(index_at(gold, 413.3).n == doctest::Approx(1.46));
    CHECK(index_at(gold, 0.5 * (413.3 + 430.5)).k == doctest::Approx(0.5 * (1.958 + 1.948)));
    CHECK(index_at(gold, 300.0).n == 1.47);
    CHECK(index_at(gold, 900.0).n == 0.13);
    CHECK(find_measured("unobtainium") == nullptr);
    for (const MeasuredMaterial& m : measured_materials()) {
        CAPTURE(std::string(m.name));
        CHECK(m.samples.front().wavelength <= 400.0);
        CHECK(m.samples.back().wavelength >= 700.0);
        const auto before = [](const IndexSample& a, const IndexSample& b) { return a.wavelength < b.wavelength; };
        CHECK(std::is_sorted(m.samples.begin(), m.samples.end(), before));
    }
}
