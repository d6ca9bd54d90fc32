// What a material's maps say at a point, and where in each picture it was read.
#include <glm/geometric.hpp>

#include "lighting/batch/maps.hpp"
#include "lighting/normal_map.hpp"
#include "raster/texture.hpp"
#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

namespace {

using lighting::LightingChannels;
using lighting::MaterialMaps;

glm::vec3 value_of(const lighting::MapUse& use, const LightingChannels& c) {
    const lighting::MicrofacetChannels& m = c.microfacet;
    if (use.map == &MaterialMaps::albedo) return m.surface.at(0).albedo;
    if (use.map == &MaterialMaps::diffuse) return c.m_D.at(0);
    if (use.map == &MaterialMaps::emission) return c.map_emission.at(0);
    if (use.map == &MaterialMaps::normal) return c.map_normal.at(0);
    if (use.map == &MaterialMaps::metallic) return glm::vec3(m.surface.at(0).metallic);
    return glm::vec3(use.map == &MaterialMaps::roughness ? m.surface.at(0).roughness : m.ao.at(0));
}

const char* what_is_read(lighting::TextureFilter filter) {
    switch (filter) {
        case lighting::TextureFilter::nearest: return "nearest: the texel that holds the point";
        case lighting::TextureFilter::bilinear: return "bilinear: the four texels around the point";
        case lighting::TextureFilter::trilinear: return "trilinear: four texels on each of the two levels beside λ";
    }
    return "";
}

/// λ of a texture from the steps of (u, v) to the neighbouring samples.
void explain_level(const raster::Fragments& f, const MaterialMaps& maps, const raster::Texture& texture,
                   const std::string& name, Section& section) {
    const glm::vec2 right = maps.scale * glm::vec2(f.du_dx.at(0), f.dv_dx.at(0));
    const glm::vec2 down = maps.scale * glm::vec2(f.du_dy.at(0), f.dv_dy.at(0));
    const glm::vec2 side(static_cast<float>(texture.width), static_cast<float>(texture.height));
    section.equation("λ of " + name, "log2 max(|step right|, |step down|)",
                     "log2 max(|" + vector_text(right * side) + "|, |" + vector_text(down * side) + "|)",
                     raster::level_of_detail(right, down, texture.width, texture.height),
                     "steps in texels; levels 0 to " + std::to_string(texture.level_count - 1));
}

}  // namespace

void explain_maps(const LitPoint& point, const LightingChannels& c, Derivation& derivation) {
    const lighting::MaterialSetup& material = point.frame.plan.materials[point.material];
    if (!material.map_needs.uv) return;
    const MaterialMaps& maps = material.maps;
    const raster::Fragments& f = point.points;
    Section section{point.id + "maps", point.name + "maps", {}};
    const glm::vec2 uv(f.u.at(0), f.v.at(0));
    const glm::vec2 laid = maps.scale * uv;
    section.equation("(u, v)", "texture_scale (u, v)", vector_text(maps.scale) + " ⊗ " + vector_text(uv),
                     std::vector<double>{laid.x, laid.y});
    section.say(std::string(what_is_read(maps.filter)) + ".");
    for (const lighting::MapUse& use : lighting::map_uses()) {
        const raster::Texture* const texture = (maps.*use.map).texture.get();
        if (!texture) continue;
        const std::string name(use.name);
        if (material.map_needs.uv_steps) explain_level(f, maps, *texture, name, section);
        const glm::vec3 value = value_of(use, c);
        const std::string size = std::to_string(texture->width) + " x " + std::to_string(texture->height) + " texels";
        if (use.kind == lighting::MapKind::value)
            section.equation(name, "", "", value.x, size);
        else
            section.equation(name, "", "", value, size);
    }
    derivation.sections.push_back(section);
}

void explain_bent_normal(const LitPoint& point, const LightingChannels& c, Section& section) {
    const MaterialMaps& maps = point.frame.plan.materials[point.material].maps;
    const raster::Fragments& f = point.points;
    const glm::vec3 normal = lighting::unit(f.normal.at(0));
    const lighting::TangentFrame frame = lighting::tangent_frame(normal, f.tangent.at(0), f.tangent_side.at(0));
    const bool up = maps.normal_y == lighting::NormalMapY::up;
    const glm::vec3 stored = c.map_normal.at(0);
    const glm::vec3 m(stored.x, up ? stored.y : -stored.y, stored.z);
    section.equation("T", "", "", f.tangent.at(0), "tangent as interpolated");
    section.equation("t", "T - (n0·T) n0, made unit", "", frame.t, "where u grows");
    section.equation("b", f.tangent_side.at(0) < 0.0f ? "t × n0" : "n0 × t", "", frame.b, "where v grows");
    section.equation("m", "", "", m,
                     up ? "from the normal map" : "from the normal map, its green turned: it points down");
    section.equation("n", "m_x t + m_y b + m_z n0, made unit",
                     factor_text(m.x) + "·t + " + factor_text(m.y) + "·b + " + factor_text(m.z) + "·n0", c.n.at(0));
}

}  // namespace kreda::tools
