// The ways to compute Fresnel's F, side by side, and how far each is from the exact one.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lighting/spectrum.hpp"

namespace kreda::tools {

/// One method for one material of three indices.
struct FresnelCurve {
    std::string name;
    std::function<float(float c, int channel)> F;
};

/// Schlick's with k ignored, rescaled, corrected, corrected as printed, F82, and tables of 16 and 256.
[[nodiscard]] std::vector<FresnelCurve> fresnel_curves(const lighting::ThreeChannelIndex& index);

/// Exact F in double, by complex numbers: w = n cos theta_t = sqrt(n^2 - sin^2 theta), R_s = |(c - w) / (c + w)|^2,
/// R_p = |(n^2 c - w) / (n^2 c + w)|^2. Nothing in common with lighting/fresnel.hpp.
[[nodiscard]] double exact_fresnel(double c, double n, double k);

/// Mean of |F' - F| / F over these cosines and the three channels, in percent: one number for each curve.
[[nodiscard]] std::vector<double> mean_errors_percent(const std::vector<FresnelCurve>& curves,
                                                      const lighting::ThreeChannelIndex& index,
                                                      std::span<const float> cosines);

/// Cosines of angles spread evenly over (0, 90) degrees.
[[nodiscard]] std::vector<float> cosines_of_even_angles(int count);

}  // namespace kreda::tools
