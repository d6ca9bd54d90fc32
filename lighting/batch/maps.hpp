// Maps: what varies over a surface, read from textures: albedo, metallic, roughness, ao, diffuse,
// emission, normal.
#pragma once

#include <span>
#include <string_view>

#include "lighting/batch/channels.hpp"
#include "lighting/material.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

struct CookTorranceSetup;

/// What the values of a map's file mean.
enum class MapKind {
    color,     ///< 3 channels, shares of light: 0..1; integers are sRGB
    radiance,  ///< 3 channels, light: 0 and more; integers are sRGB
    value,     ///< the first channel alone, linear
    normal     ///< 3 channels, linear, 0..1 stands for -1..1
};

/// A map that a material may have.
struct MapUse {
    std::string_view name;             ///< "albedo"; the key of a scene file is "albedo_map"
    MapKind kind = MapKind::value;     ///< what the values of its file mean
    Map MaterialMaps::*map = nullptr;  ///< where a material keeps it
};

/// All of them.
[[nodiscard]] std::span<const MapUse> map_uses();

/// Whether a model reads a map. One that it does not read is never looked at, nor loaded.
[[nodiscard]] bool reads_map(ReflectionModel model, const MapUse& use);

/// Is there such a map: its texels, or a file that they will be read from?
[[nodiscard]] inline bool is_given(const Map& map) {
    return map.texture != nullptr || !map.file.empty();
}

/// Does the material's model read a map that is given? One that bends normals?
[[nodiscard]] bool reads_maps(const Material& material);
[[nodiscard]] bool reads_normal_map(const Material& material);  ///< one that bends normals

/// The maps that the material's model reads and whose texels are there; the others are empty.
[[nodiscard]] MaterialMaps maps_in_use(const Material& material);

/// Which attributes reading these maps asks for.
struct MapNeeds {
    bool uv = false;        ///< texture coordinates: any map
    bool uv_steps = false;  ///< trilinear: the level comes from them
    bool tangent = false;   ///< normal map
};
/// What the maps ask of the fragments: texture coordinates, their steps, tangents.
[[nodiscard]] MapNeeds needs_of(const MaterialMaps& maps);

/// Look up the maps at every point: channels.m_D, channels.map_emission, channels.map_normal, and albedo, metallic,
/// roughness, ao of channels.microfacet (f0 and alpha follow; call it after start_surface). channels.level is that of
/// the color map, or of another where there is none.
void read_maps(const raster::Fragments& fragments, const MaterialMaps& maps, const CookTorranceSetup& setup,
               LightingChannels& channels);

/// channels.n from the interpolated normal, the tangent and channels.map_normal.
void bend_normals(const raster::Fragments& fragments, const MaterialMaps& maps, LightingChannels& channels);

}  // namespace kreda::lighting
