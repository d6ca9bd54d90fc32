#include "tools/measure/fresnel_methods.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace kreda::tools {

namespace {

using lighting::SchlickCorrection;

FresnelCurve table_curve(const lighting::ThreeChannelIndex& index, int size) {
    const lighting::FresnelTable table = lighting::fresnel_table(index.n, index.k, size);
    return {"table of " + std::to_string(size),
            [table](float c, int i) { return lighting::fresnel_lookup(c, table)[i]; }};
}

/// The correction in one of its two forms, fitted channel by channel.
FresnelCurve corrected_curve(const lighting::ThreeChannelIndex& index, bool as_printed) {
    std::vector<SchlickCorrection> fits;
    for (int i = 0; i < 3; ++i) {
        fits.push_back(as_printed ? lighting::fit_correction_as_printed(index.n[i], index.k[i])
                                  : lighting::fit_correction(index.n[i], index.k[i]));
    }
    const glm::vec3 f0 = lighting::f0_from_index(index.n, index.k);
    using Form = float (*)(float c, float f0, float a, float lambda);
    Form form = lighting::fresnel_corrected_schlick;
    if (as_printed) form = lighting::fresnel_corrected_schlick_as_printed;
    return {as_printed ? "corrected, as printed" : "corrected",
            [=](float c, int i) { return form(c, f0[i], fits[i].a, fits[i].lambda); }};
}

}  // namespace

std::vector<FresnelCurve> fresnel_curves(const lighting::ThreeChannelIndex& index) {
    const glm::vec3 n = index.n, k = index.k;
    const glm::vec3 f0 = lighting::f0_from_index(n, k);
    const glm::vec3 b = lighting::f82_coefficient_from_index(n, k);
    return {{"Schlick, without k", [n](float c, int i) { return lighting::fresnel_schlick_from_index(c, n[i]); }},
            {"Schlick, rescaled", [n, k](float c, int i) { return lighting::fresnel_rescaled_schlick(c, n[i], k[i]); }},
            corrected_curve(index, false),
            corrected_curve(index, true),
            {"F82", [f0, b](float c, int i) { return lighting::fresnel_f82(c, f0[i], b[i]); }},
            table_curve(index, 16),
            table_curve(index, 256)};
}

double exact_fresnel(double c, double n, double k) {
    const std::complex<double> index(n, k);
    const std::complex<double> w = std::sqrt(index * index - (1.0 - c) * (1.0 + c));
    const std::complex<double> n2_c = index * index * c;
    return 0.5 * (std::norm((c - w) / (c + w)) + std::norm((n2_c - w) / (n2_c + w)));
}

std::vector<double> mean_errors_percent(const std::vector<FresnelCurve>& curves,
                                        const lighting::ThreeChannelIndex& index, std::span<const float> cosines) {
    std::vector<double> sums(curves.size(), 0.0);
    for (const float c : cosines) {
        for (int i = 0; i < 3; ++i) {
            const double exact = exact_fresnel(c, index.n[i], index.k[i]);
            for (std::size_t m = 0; m < curves.size(); ++m) sums[m] += std::abs(curves[m].F(c, i) - exact) / exact;
        }
    }
    for (double& sum : sums) sum *= 100.0 / (3.0 * static_cast<double>(cosines.size()));
    return sums;
}

std::vector<float> cosines_of_even_angles(int count) {
    std::vector<float> cosines;
    for (int i = 0; i < count; ++i) {
        cosines.push_back(static_cast<float>(std::cos((i + 0.5) / count * 0.5 * std::numbers::pi)));
    }
    return cosines;
}

}  // namespace kreda::tools
