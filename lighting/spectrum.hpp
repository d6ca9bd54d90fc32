// Colours of metals and dielectrics from their measured indices of refraction, wavelength by wavelength: the oracle
// that three-channel Fresnel is measured against, and the set-up that turns n and k into the colours F0 and F82.
//
//   F(lambda) -> X, Y, Z  by the CIE 1931 observer under the light D65 -> linear sRGB, white = (1, 1, 1)
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

#include "lighting/fresnel.hpp"
#include "lighting/tables.hpp"

namespace kreda::lighting {

/// n + i k at one wavelength.
struct IndexSample {
    double wavelength;  ///< nm
    double n;           ///< index of refraction
    double k;           ///< extinction, >= 0
};

/// A material as somebody measured it. Linear between the published points, constant beyond the first and last.
struct MeasuredMaterial {
    std::string_view name;                 ///< "gold"
    std::string_view source;               ///< who measured it, and when
    std::span<const IndexSample> samples;  ///< by growing wavelength
};

/// gold, silver, copper, aluminium, platinum, gold_hagemann, water, diamond, glass.
[[nodiscard]] std::span<const MeasuredMaterial> measured_materials();

/// The material of this name, or nullptr.
[[nodiscard]] const MeasuredMaterial* find_measured(std::string_view name);

/// n + i k at a wavelength in nm.
[[nodiscard]] IndexSample index_at(const MeasuredMaterial& material, double wavelength);

/// One index for each colour channel.
struct ThreeChannelIndex {
    glm::vec3 n{1.5f};  ///< index of refraction for red, green, blue
    glm::vec3 k{0.0f};  ///< extinction for red, green, blue, >= 0
};

/// Stetic-Kozic 2014, section 4: the middles of the red, green and blue parts of the spectrum, nm.
inline constexpr std::array<double, 3> kChannelWavelengths = {685.0, 535.0, 475.0};

/// The indices at 685, 535 and 475 nm.
[[nodiscard]] ThreeChannelIndex three_channel_index(const MeasuredMaterial& material);

/// Table 1 of Stetic-Kozic 2014, as printed, for one of its four materials: gold, platinum, water, diamond.
/// Its gold is Hagemann's second set, its platinum Rakic's, its water Hale and Querry's, its diamond Phillip and
/// Taft's.
[[nodiscard]] ThreeChannelIndex published_index(std::string_view name);

/// The observer and the light at one wavelength.
struct ObserverSample {
    double wavelength;           ///< nm
    double x_bar, y_bar, z_bar;  ///< CIE 1931, 2 degrees
    double d65;                  ///< relative power of the illuminant D65
};

/// 400 to 700 nm in steps of 10 nm.
[[nodiscard]] std::span<const ObserverSample> observer_samples();

/// A value for each of the observer's wavelengths.
using Spectrum = std::array<double, kSpectrumSamples>;

/// Colour of a surface that reflects this share of D65, linear sRGB. All ones: white, (1, 1, 1). Pure colours lie
/// outside sRGB: gold's red is 1.04, and nothing here clamps it.
[[nodiscard]] glm::vec3 linear_srgb_from_spectrum(const Spectrum& reflectance);

/// Exact F at angle cos theta = c for each wavelength: the spectral evaluation.
[[nodiscard]] Spectrum fresnel_spectrum(const MeasuredMaterial& material, float c);

/// Its colour: the oracle.
[[nodiscard]] glm::vec3 spectral_fresnel(const MeasuredMaterial& material, float c);

/// What one wavelength adds to the colour   color F(c, n, k)
inline glm::vec3 reflected_at(float c, const glm::vec3& color, float n, float k) {
    return color * fresnel_conductor(c, n, k);
}

/// n + i k of a measured material at every wavelength, relative to the medium before the surface (outside_ior >= 0.1).
[[nodiscard]] SpectralIndex spectral_index(const MeasuredMaterial& material, float outside_ior = 1.0f);

/// The oracle in float   F = sum over wavelengths  color F(c, n, k)
[[nodiscard]] glm::vec3 spectral_fresnel(float c, const SpectralIndex& index);

/// The same from few wavelengths only, in the middles of `count` equal parts of 400 to 700 nm.
[[nodiscard]] glm::vec3 spectral_fresnel_of_few(const MeasuredMaterial& material, float c, int count);

/// What a material needs at run time: two colours.
struct SpectralColors {
    glm::vec3 f0;   ///< at normal incidence
    glm::vec3 f82;  ///< at c = 1/7
    glm::vec3 b;    ///< coefficient of fresnel_f82
};

/// The two colours of a measured material, from all of its wavelengths.
[[nodiscard]] SpectralColors spectral_colors(const MeasuredMaterial& material);
/// The same from an index that was looked up before.
[[nodiscard]] SpectralColors spectral_colors(const SpectralIndex& index);

/// The oracle as a table for fresnel_lookup.
[[nodiscard]] FresnelTable spectral_fresnel_table(const MeasuredMaterial& material, int size = 256);
/// The same from an index that was looked up before.
[[nodiscard]] FresnelTable spectral_fresnel_table(const SpectralIndex& index, int size = 256);

}  // namespace kreda::lighting
