// The choices of the microfacet model: one switch for D, one for V, one for F. A switch hands the chosen formula to
// `use`, which calls it at one point or loops over a batch, so that a formula is named in one place alone.
// Beside each switch stands its table: what a choice is called, how it is written, what it costs.
// docs/extend.md adds a distribution.
#pragma once

#include <array>
#include <string_view>

#include "lighting/cook_torrance.hpp"

namespace kreda::lighting {

/// A formula as people read it. The entries of a table stand in the order of their enumeration.
struct FormulaFacts {
    std::string_view key;   ///< in a scene file
    std::string_view name;  ///< in a sentence
    std::string_view text;  ///< the formula
    double operations;      ///< at one point, about: for estimates
};

// ----------------------------------------------------------------------------------------------------------- D

/// Every D, in the order of Distribution.
inline constexpr std::array<FormulaFacts, 4> kDistributions = {{
    {"ggx", "GGX", "α² / (π (sin²θ_h + (n·h)² α²)²)", 8.0},
    {"beckmann", "Beckmann", "exp(-tan²θ_h / α²) / (π α² (n·h)⁴)", 9.0 + raster::kExpOperations},
    {"blinn_phong", "Blinn-Phong", "(k + 2) / 2π · (n·h)^k,  k = 2/α² - 2", 50.0 + raster::kExpOperations},
    {"gaussian", "Gaussian", "c exp(-(θ_h / α)²)", 40.0 + raster::kExpOperations},
}};

/// The entry of a D.
[[nodiscard]] constexpr const FormulaFacts& facts_of(Distribution distribution) {
    return kDistributions[static_cast<std::size_t>(distribution)];
}

/// use(D), where D(n_dot_h, sin2_h, alpha) is the chosen distribution [1/sr].
template <class Use>
inline auto with_distribution(Distribution distribution, Use use) {
    switch (distribution) {
        case Distribution::beckmann:
            return use(
                [](float n_dot_h, float sin2_h, float alpha) { return beckmann_distribution(n_dot_h, sin2_h, alpha); });
        case Distribution::blinn_phong:
            return use([](float n_dot_h, float sin2_h, float alpha) {
                return blinn_phong_distribution(n_dot_h, sin2_h, alpha);
            });
        case Distribution::gaussian:
            return use(
                [](float n_dot_h, float sin2_h, float alpha) { return gaussian_distribution(n_dot_h, sin2_h, alpha); });
        case Distribution::ggx: break;
    }
    return use([](float n_dot_h, float sin2_h, float alpha) { return ggx_distribution(n_dot_h, sin2_h, alpha); });
}

// ----------------------------------------------------------------------------------------------------------- V

/// Every G, in the order of Geometry.
inline constexpr std::array<FormulaFacts, 5> kGeometries = {{
    {"schlick_ggx", "Schlick-GGX", "1 / (4 ((n·l)(1-k) + k) ((n·v)(1-k) + k)),  k = (roughness + 1)² / 8", 13.0},
    {"smith", "Smith", "1 / ((n·l + √(α² + (1-α²)(n·l)²)) (n·v + √(α² + (1-α²)(n·v)²)))", 18.0},
    {"smith_correlated", "Smith, correlated", "1 / (2 (n·l √(α² + (1-α²)(n·v)²) + n·v √(α² + (1-α²)(n·l)²)))", 20.0},
    {"implicit", "implicit, G = (n·l)(n·v)", "1/4", 0.0},
    {"cook_torrance", "Cook-Torrance", "min(1, 2 (n·h)(n·v) / (v·h), 2 (n·h)(n·l) / (v·h)) / (4 (n·l)(n·v))", 12.0},
}};

/// The entry of a G.
[[nodiscard]] constexpr const FormulaFacts& facts_of(Geometry geometry) {
    return kGeometries[static_cast<std::size_t>(geometry)];
}

/// What lights the surface: Schlick-GGX takes k = (roughness + 1)^2 / 8 for a lamp and k = alpha / 2 for an image
/// (Karis 2013). The other geometries know no difference.
enum class LitBy { lamp, image };

/// use(V), where V(angles, alpha, roughness) = G / (4 (n.l)(n.v)) of the chosen geometry.
template <class Use>
inline auto with_visibility(Geometry geometry, LitBy lit_by, Use use) {
    switch (geometry) {
        case Geometry::smith:
            return use([](const MicrofacetAngles& a, float alpha, float) {
                return smith_visibility(a.n_dot_l, a.n_dot_v, alpha);
            });
        case Geometry::smith_correlated:
            return use([](const MicrofacetAngles& a, float alpha, float) {
                return smith_correlated_visibility(a.n_dot_l, a.n_dot_v, alpha);
            });
        case Geometry::implicit:
            return use([](const MicrofacetAngles&, float, float) { return implicit_visibility(); });
        case Geometry::cook_torrance:
            return use([](const MicrofacetAngles& a, float, float) {
                return cook_torrance_visibility(a.n_dot_l, a.n_dot_v, a.n_dot_h, a.v_dot_h);
            });
        case Geometry::schlick_ggx: break;
    }
    if (lit_by == LitBy::image) {
        return use([](const MicrofacetAngles& a, float alpha, float) {
            return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_image(alpha));
        });
    }
    return use([](const MicrofacetAngles& a, float, float roughness) {
        return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_direct(roughness));
    });
}

// ----------------------------------------------------------------------------------------------------------- F

/// Every F, in the order of FresnelMethod.
inline constexpr std::array<FormulaFacts, 10> kFresnelMethods = {{
    {"schlick", "Schlick", "F0 + (1 - F0)(1 - v·h)⁵", 3.0 * 3.0 + 4.0},
    {"exact", "exact", "(R_s + R_p) / 2", 3.0 * 32.0},  // fresnel_facts says of which n and k
    {"schlick_ior", "Schlick from n", "((n-1)² + 4n (1 - v·h)⁵) / (n+1)²", 3.0 * 15.0},
    {"rescaled_schlick", "rescaled Schlick", "F0 + (1 - F0)(1 - v·h)⁵,  F0 from n and k", 3.0 * 3.0 + 4.0},
    {"corrected_schlick", "corrected Schlick", "Schlick - a (v·h)(1 - v·h)^λ", 3.0 * (10.0 + raster::kPowOperations)},
    {"corrected_schlick_as_printed", "corrected Schlick as printed", "Schlick - a (1 - v·h)^λ",
     3.0 * (10.0 + raster::kPowOperations)},
    {"f82", "F82", "Schlick - b (v·h)(1 - v·h)⁶", 3.0 * 12.0},
    {"table", "table", "linear between entries of a table over v·h", 3.0 * 8.0},
    {"nvidia", "bias-scale-power", "F0 + (1 - F0)(1 - v·h)^power", raster::kPowOperations + 12.0},
    {"none", "constant", "F0", 0.0},
}};

/// The exact formula once for each wavelength of a measured material.
inline constexpr double kSpectralFresnelOperations = double{kSpectrumSamples} * 36.0;

/// The entry of an F.
[[nodiscard]] constexpr const FormulaFacts& facts_of(FresnelMethod method) {
    return kFresnelMethods[static_cast<std::size_t>(method)];
}

/// The facts of the method as this material uses it: `exact` knows four cases, `nvidia` two.
[[nodiscard]] FormulaFacts fresnel_facts(const CookTorranceSetup& setup);

/// use(F), where F(v_dot_h, f0) is the chosen method's reflectance, linear RGB. Each formula holds copies of its
/// constants, so that a loop over a batch need not ask whether what it writes changes them.
template <class Use>
inline auto with_fresnel(const CookTorranceSetup& setup, Use use) {
    const glm::vec3 n = setup.n, k = setup.k;
    switch (setup.fresnel) {
        case FresnelMethod::schlick:
        case FresnelMethod::rescaled_schlick: break;  // the same, see fresnel_rescaled_schlick
        case FresnelMethod::exact:
            if (setup.all_wavelengths) {
                return use(
                    [spectrum = &setup.spectrum](float c, const glm::vec3&) { return spectral_fresnel(c, *spectrum); });
            }
            if (setup.absorbs) return use([n, k](float c, const glm::vec3&) { return fresnel_conductor(c, n, k); });
            if (setup.has_index) return use([n](float c, const glm::vec3&) { return fresnel_dielectric(c, n); });
            return use([](float c, const glm::vec3& f0) { return fresnel_dielectric(c, index_from_f0(f0)); });
        case FresnelMethod::schlick_ior:
            if (setup.has_index) return use([n](float c, const glm::vec3&) { return fresnel_schlick_between(c, n); });
            return use([](float c, const glm::vec3& f0) { return fresnel_schlick_between(c, index_from_f0(f0)); });
        case FresnelMethod::corrected_schlick:
            return use([a = setup.correction_a, lambda = setup.correction_lambda](float c, const glm::vec3& f0) {
                return fresnel_corrected_schlick(c, f0, a, lambda);
            });
        case FresnelMethod::corrected_schlick_as_printed:
            return use([a = setup.correction_a, lambda = setup.correction_lambda](float c, const glm::vec3& f0) {
                const glm::vec3 F = fresnel_corrected_schlick_as_printed(c, f0, a, lambda);
                return glm::vec3(F.x > 0.0f ? F.x : 0.0f, F.y > 0.0f ? F.y : 0.0f, F.z > 0.0f ? F.z : 0.0f);
            });
        case FresnelMethod::f82:
            return use([b = setup.f82_b](float c, const glm::vec3& f0) { return fresnel_f82(c, f0, b); });
        case FresnelMethod::table:
            return use([r = setup.table.r.data(), g = setup.table.g.data(), b = setup.table.b.data(),
                        size = setup.table.size()](float c, const glm::vec3&) {
                return glm::vec3(fresnel_lookup(c, r, size), fresnel_lookup(c, g, size), fresnel_lookup(c, b, size));
            });
        case FresnelMethod::nvidia:
            if (setup.has_bias) {
                return use([bsp = setup.nvidia](float c, const glm::vec3&) {
                    return glm::vec3(fresnel_nvidia(c, bsp.x, bsp.y, bsp.z));
                });
            }
            return use([power = setup.nvidia.z](float c, const glm::vec3& f0) {
                return fresnel_nvidia(c, f0, 1.0f - f0, power);
            });
        case FresnelMethod::none: return use([](float, const glm::vec3& f0) { return f0; });
    }
    return use([](float c, const glm::vec3& f0) { return fresnel_schlick(c, f0); });
}

}  // namespace kreda::lighting
