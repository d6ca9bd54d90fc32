#include "lighting/batch/maps.hpp"

#include <algorithm>
#include <array>

#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/cook_torrance.hpp"
#include "lighting/normal_map.hpp"
#include "raster/platform.hpp"
#include "raster/texture_passes.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel;
using raster::Channel3;
using raster::Fragments;
using raster::lanes_for;

raster::TextureLookup lookup_of(const MaterialMaps& maps) {
    return {maps.filter, maps.wrap, maps.scale};
}

void set_level(const Fragments& fragments, const raster::Texture& texture, const MaterialMaps& maps, Channel& level) {
    if (maps.filter == TextureFilter::trilinear) set_levels(fragments, texture, lookup_of(maps), level);
}

void read_color(const Fragments& fragments, const Map& map, const MaterialMaps& maps, Channel& level, Channel3& out) {
    if (!map.texture) return;
    set_level(fragments, *map.texture, maps, level);
    sample_color(fragments, level, *map.texture, lookup_of(maps), out);
}

void read_value(const Fragments& fragments, const Map& map, const MaterialMaps& maps, Channel& level, Channel& out) {
    if (!map.texture) return;
    set_level(fragments, *map.texture, maps, level);
    sample_value(fragments, level, *map.texture, lookup_of(maps), out);
}

/// F0 and alpha of the points' own albedo, metallic and roughness.
KREDA_BATCH_LOOP void derive_surface(int lanes, bool keep, glm::vec3 f0, SurfaceChannels& surface) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 from_albedo = base_reflectivity(surface.albedo.at(i), surface.metallic.at(i));
        surface.f0.set(i, keep ? f0 : from_albedo);
        surface.alpha.set(i, alpha_from_roughness(surface.roughness.at(i)));
    }
}

KREDA_BATCH_LOOP void bend(const Fragments& f, int lanes, float up, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 stored = c.map_normal.at(i);
        const glm::vec3 m(stored.x, up * stored.y, stored.z);
        c.n.set(i, bend_normal(f.normal.at(i), f.tangent.at(i), f.tangent_side.at(i), m));
    }
}

}  // namespace

std::span<const MapUse> map_uses() {
    static constexpr std::array<MapUse, 7> kUses = {{
        {"albedo", MapKind::color, &MaterialMaps::albedo},
        {"diffuse", MapKind::color, &MaterialMaps::diffuse},
        {"emission", MapKind::radiance, &MaterialMaps::emission},
        {"metallic", MapKind::value, &MaterialMaps::metallic},
        {"roughness", MapKind::value, &MaterialMaps::roughness},
        {"ao", MapKind::value, &MaterialMaps::ao},
        {"normal", MapKind::normal, &MaterialMaps::normal},
    }};
    return kUses;
}

bool reads_map(ReflectionModel model, const MapUse& use) {
    if (use.map == &MaterialMaps::emission) return true;
    if (use.kind == MapKind::normal) return model != ReflectionModel::unlit;
    const bool is_empirical = use.map == &MaterialMaps::diffuse;
    return is_empirical == (model != ReflectionModel::cook_torrance);
}

bool reads_maps(const Material& material) {
    return std::ranges::any_of(map_uses(), [&](const MapUse& use) {
        return reads_map(material.model, use) && is_given(material.maps.*use.map);
    });
}

bool reads_normal_map(const Material& material) {
    return material.model != ReflectionModel::unlit && is_given(material.maps.normal);
}

MaterialMaps maps_in_use(const Material& material) {
    MaterialMaps maps = material.maps;
    for (const MapUse& use : map_uses()) {
        const bool used = (maps.*use.map).texture && reads_map(material.model, use);
        if (!used) maps.*use.map = {};
    }
    return maps;
}

MapNeeds needs_of(const MaterialMaps& maps) {
    MapNeeds needs;
    for (const MapUse& use : map_uses()) {
        if (!(maps.*use.map).texture) continue;
        needs.uv = true;
        needs.uv_steps |= maps.filter == TextureFilter::trilinear;
        needs.tangent |= use.kind == MapKind::normal;
    }
    return needs;
}

void read_maps(const Fragments& fragments, const MaterialMaps& maps, const CookTorranceSetup& setup,
               LightingChannels& channels) {
    SurfaceChannels& surface = channels.microfacet.surface;
    read_color(fragments, maps.normal, maps, channels.level, channels.map_normal);
    const bool varies = maps.albedo.texture || maps.metallic.texture || maps.roughness.texture;
    if (varies) fill_surface(fragments.count, surface);
    read_value(fragments, maps.ao, maps, channels.level, channels.microfacet.ao);
    read_value(fragments, maps.roughness, maps, channels.level, surface.roughness);
    read_value(fragments, maps.metallic, maps, channels.level, surface.metallic);
    read_color(fragments, maps.emission, maps, channels.level, channels.map_emission);
    read_color(fragments, maps.albedo, maps, channels.level, surface.albedo);
    read_color(fragments, maps.diffuse, maps, channels.level, channels.m_D);
    if (varies) derive_surface(lanes_for(fragments.count), setup.has_index, setup.surface.f0, surface);
}

void bend_normals(const Fragments& fragments, const MaterialMaps& maps, LightingChannels& channels) {
    if (!maps.normal.texture) return;
    bend(fragments, lanes_for(fragments.count), maps.normal_y == NormalMapY::up ? 1.0f : -1.0f, channels);
}

}  // namespace kreda::lighting
