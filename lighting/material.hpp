// Materials as plain data: which reflection model, and its constants.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/texture.hpp"

namespace kreda::lighting {

/// Which model reflects the light of lamps.
enum class ReflectionModel { unlit, lambert, phong, blinn_phong, ward, heidrich_seidel, cook_torrance };
/// D of cook_torrance: how many microfacets face a direction.
enum class Distribution { ggx, beckmann, blinn_phong, gaussian };
/// G of cook_torrance: which of them light and viewer both see.
enum class Geometry { schlick_ggx, smith, smith_correlated, implicit, cook_torrance };
/// F of cook_torrance: how much they reflect.
enum class FresnelMethod {
    schlick,  ///< from F0
    exact,
    schlick_ior,                   ///< from n alone; knows total reflection
    rescaled_schlick,              ///< from n and k
    corrected_schlick,             ///< in the form that gives its published errors
    corrected_schlick_as_printed,  ///< falls below 0 at grazing angles: to show why not
    f82,
    table,
    nvidia,
    none
};
/// Where the indices of a measured material come from: all wavelengths, or one for each colour channel.
enum class SpectrumUse { full, three };
/// Whether light that bounces more than once between facets is given back.
enum class EnergyCompensation { none, kulla_conty };
using raster::TextureFilter;
using raster::TextureWrap;
/// Where the green of a normal map points on the picture.
enum class NormalMapY { up, down };

/// Constants of the local models (Strachota 2020, section 3): all but cook_torrance.
struct PhongMaterial {
    glm::vec3 ambient{0.1f};   ///< m_A
    glm::vec3 diffuse{0.7f};   ///< m_D
    glm::vec3 specular{0.3f};  ///< m_S
    glm::vec3 emission{0.0f};  ///< m_E
    float shininess = 32.0f;   ///< h, the specular reflection exponent, >= 0
    /// ward: widths of the lobe along and across the grain; without them one width from shininess
    std::optional<glm::vec2> ward_alpha = std::nullopt;
    glm::vec3 grain{0.0f, 1.0f, 0.0f};  ///< ward, heidrich_seidel: the way scratches or threads run, world space
};

/// Constants of the microfacet model (Gelemanovic 2018, section 2).
struct CookTorranceMaterial {
    glm::vec3 albedo{0.8f};                          ///< c, linear RGB, 0..1
    float metallic = 0.0f;                           ///< 0 dielectric, 1 metal
    float roughness = 0.5f;                          ///< perceptual; alpha = roughness^2
    float ao = 1.0f;                                 ///< share of the environment's light that arrives
    Distribution distribution = Distribution::ggx;   ///< D
    Geometry geometry = Geometry::schlick_ggx;       ///< G
    FresnelMethod fresnel = FresnelMethod::schlick;  ///< F
    EnergyCompensation energy_compensation =
        EnergyCompensation::none;              ///< what replaces the light that single reflection loses
    std::optional<glm::vec3> ior;              ///< n per channel (685, 535, 475 nm); with it fresnel uses n and k
    std::optional<glm::vec3> extinction;       ///< k per channel
    std::string measured;                      ///< instead of ior: a name of measured_materials()
    SpectrumUse spectrum = SpectrumUse::full;  ///< of measured
    float outside_ior = 1.0f;         ///< n of what lies before the surface: 1.33 under water. With ior or measured
    int table_size = 256;             ///< fresnel = table: samples, >= 2
    std::optional<glm::vec3> nvidia;  ///< fresnel = nvidia: bias, scale, power; else F0, 1 - F0, 5
    std::optional<glm::vec3> f82;     ///< fresnel = f82: F at cos theta = 1/7; else from n and k
};

/// A picture that says what a quantity is at every point of a surface:  quantity = offset + factor x picture.
struct Map {
    std::string file;                                ///< where it comes from; empty: nowhere, or made by a program
    std::shared_ptr<const raster::Texture> texture;  ///< linear texels; null: not loaded. Maps of one file share it
    std::shared_ptr<const std::string> bytes;  ///< of a picture that stands within another file; null: read `file`
    int channel = 0;                           ///< maps of one value: 0, 1, 2 red, green, blue of the picture
    glm::vec3 factor{1.0f};                    ///< of each component, linear
    float offset = 0.0f;                       ///< of each component, linear
};

/// Maps replace the constant of the same name, but emission multiplies it: a file of bytes ends at 1, light does not.
/// normal bends the interpolated normal.
struct MaterialMaps {
    Map albedo, diffuse, emission, metallic, roughness, ao, normal;  ///< a map each
    bool normal_from_height = false;       ///< the file of `normal` holds heights; its texels are made from them
    float bump_scale = 0.02f;              ///< heights: how far white stands above black, in widths of the picture
    NormalMapY normal_y = NormalMapY::up;  ///< where green points: up (OpenGL) or down (DirectX)
    TextureFilter filter = TextureFilter::trilinear;  ///< how the maps are read between their texels
    TextureWrap wrap = TextureWrap::repeat;           ///< what lies beyond 0..1 of u and v
    glm::vec2 scale{1.0f};                            ///< how often the pictures are laid over 0..1 of u and v, > 0
};

/// A [[material]] table of a scene.
struct Material {
    std::string name = "default";                          ///< what objects of a scene call it
    ReflectionModel model = ReflectionModel::blinn_phong;  ///< decides which of the constants count
    PhongMaterial phong;                                   ///< phong, blinn_phong and their relatives
    CookTorranceMaterial cook_torrance;                    ///< cook_torrance
    MaterialMaps maps;                                     ///< where a map says otherwise
};

}  // namespace kreda::lighting
