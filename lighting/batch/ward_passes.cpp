#include "lighting/batch/ward_passes.hpp"

#include <glm/geometric.hpp>

#include "lighting/batch/model_loop.hpp"
#include "lighting/ward.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void set_tangents(int lanes, glm::vec3 grain, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.t.set(i, tangent_of_grain(grain, c.n.at(i)));
}

/// l as a channel even where it is the same at every point: these models are rare, and compiled for that alone.
KREDA_BATCH_LOOP void spread_direction(int lanes, LightingChannels& c) {
    const glm::vec3 l = c.l.even;
    for (int i = 0; i < lanes; ++i) c.l.each.set(i, l);
    c.l.is_even = false;
}

KREDA_BATCH_LOOP void add_ward_isotropic(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c,
              [&c](int i, const PhongMaterial& m) { return ward(c.n.at(i), c.l.each.at(i), c.v.at(i), m); });
}

KREDA_BATCH_LOOP void add_ward_brushed(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    const glm::vec2 alpha = *material.ward_alpha;
    add_model(lanes, material, map, c, [&c, alpha](int i, const PhongMaterial& m) {
        return ward_brushed(c.n.at(i), c.t.at(i), c.l.each.at(i), c.v.at(i), m, alpha);
    });
}

KREDA_BATCH_LOOP void add_threads(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c, [&c](int i, const PhongMaterial& m) {
        return heidrich_seidel(c.n.at(i), c.t.at(i), c.l.each.at(i), c.v.at(i), m);
    });
}

}  // namespace

void set_grain(int count, const PhongMaterial& material, LightingChannels& channels) {
    set_tangents(lanes_for(count), glm::normalize(material.grain), channels);
}

void add_ward(int count, const PhongMaterial& material, bool diffuse_from_map, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    if (channels.l.is_even) spread_direction(lanes, channels);
    if (material.ward_alpha) return add_ward_brushed(lanes, material, diffuse_from_map, channels);
    add_ward_isotropic(lanes, material, diffuse_from_map, channels);
}

void add_heidrich_seidel(int count, const PhongMaterial& material, bool diffuse_from_map, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    if (channels.l.is_even) spread_direction(lanes, channels);
    add_threads(lanes, material, diffuse_from_map, channels);
}

bool needs_grain(const Material& material) {
    return material.model == ReflectionModel::heidrich_seidel ||
           (material.model == ReflectionModel::ward && material.phong.ward_alpha.has_value());
}

}  // namespace kreda::lighting
