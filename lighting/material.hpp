// Materials as plain data: which reflection model, and its constants.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace kreda::lighting {

enum class ReflectionModel { unlit, lambert, phong, blinn_phong, ward, cook_torrance };
enum class Distribution { ggx, beckmann, blinn_phong, gaussian };
enum class Geometry { schlick_ggx, smith, smith_correlated, implicit, cook_torrance };
enum class FresnelMethod { schlick, exact, rescaled_schlick, corrected_schlick, f82, table, nvidia, none };
enum class EnergyCompensation { none, kulla_conty };
enum class TextureFilter { nearest, bilinear, trilinear };
enum class NormalMapY { up, down };

/// Constants of the empirical models (Strachota 2020, section 3): unlit, lambert, phong, blinn_phong, ward.
struct PhongMaterial {
    glm::vec3 ambient{0.1f};   ///< m_A
    glm::vec3 diffuse{0.7f};   ///< m_D
    glm::vec3 specular{0.3f};  ///< m_S
    glm::vec3 emission{0.0f};  ///< m_E
    float shininess = 32.0f;   ///< h, the specular reflection exponent, >= 0
};

/// Constants of the microfacet model (Gelemanovic 2018, section 2).
struct CookTorranceMaterial {
    glm::vec3 albedo{0.8f};
    float metallic = 0.0f;   ///< 0 dielectric, 1 metal
    float roughness = 0.5f;  ///< perceptual; alpha = roughness^2
    float ao = 1.0f;         ///< share of the environment's light that arrives
    Distribution distribution = Distribution::ggx;
    Geometry geometry = Geometry::schlick_ggx;
    FresnelMethod fresnel = FresnelMethod::schlick;
    EnergyCompensation energy_compensation = EnergyCompensation::none;
    std::optional<glm::vec3> ior;         ///< n per channel (685, 535, 475 nm); with it fresnel uses n and k
    std::optional<glm::vec3> extinction;  ///< k per channel
};

/// Files that replace a constant of the same name. Empty: the constant holds.
struct MaterialMaps {
    std::string albedo, diffuse, metallic, roughness, ao, normal;
    NormalMapY normal_y = NormalMapY::up;
    TextureFilter filter = TextureFilter::trilinear;
};

struct Material {
    std::string name = "default";
    ReflectionModel model = ReflectionModel::blinn_phong;
    PhongMaterial phong;
    CookTorranceMaterial cook_torrance;
    MaterialMaps maps;
};

}  // namespace kreda::lighting
