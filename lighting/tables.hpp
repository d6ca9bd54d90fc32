// What formulas look up instead of computing it, as plain data: F over the angle, indices over the wavelength, energy
// over angle and roughness. The formulas that fill and read them: lighting/fresnel.hpp, spectrum.hpp, energy.hpp.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace kreda::lighting {

/// Nodes a side of the table of directional albedo.
inline constexpr int kEnergyNodes = 31;

/// E at the nodes mu = (i / 30)^2, roughness = j / 30, and its average. Computed once by compute_energy_table.
/// The square puts nodes where E bends: near grazing.
struct EnergyTable {
    std::array<float, kEnergyNodes * kEnergyNodes> E{};  ///< E[j * kEnergyNodes + i]
    std::array<float, kEnergyNodes> E_avg{};             ///< 2 int_0^1 E(mu) mu dmu of each roughness
};

/// A number for each of the observer's wavelengths.
inline constexpr int kSpectrumSamples = 31;

/// What an exact spectral F needs in a batch loop: n + i k at the observer's wavelengths, relative to the medium before
/// the surface, and the colour of each wavelength as it comes to linear sRGB. The colours add up to white.
struct SpectralIndex {
    std::array<float, kSpectrumSamples> n{};          ///< index of refraction
    std::array<float, kSpectrumSamples> k{};          ///< extinction, >= 0
    std::array<glm::vec3, kSpectrumSamples> color{};  ///< linear sRGB; single ones may be negative
};

/// One table for each channel, samples at c = i / (size - 1).
struct FresnelTable {
    std::vector<float> r, g, b;  ///< F of the channel, 0..1

    /// Number of entries.
    [[nodiscard]] int size() const {
        return static_cast<int>(r.size());
    }
};

}  // namespace kreda::lighting
