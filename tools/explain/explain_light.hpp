// The light at one point as a derivation: directions, ambient light, every light's terms, their sum.
#pragma once

#include <cstdint>
#include <string>

#include "lighting/batch/channels.hpp"
#include "lighting/reflection.hpp"
#include "scene/render/frame.hpp"
#include "tools/explain/derivation.hpp"

namespace kreda::tools {

/// A point that the passes light: a sample of the picture, a vertex, or the centroid of a triangle.
struct LitPoint {
    const scene::Frame& frame;
    const raster::Fragments& points;  ///< a batch of one
    std::uint32_t material = 0;
    std::string name;  ///< what stands before the titles of its sections: "", "corner a: "
    std::string id;    ///< and before their ids: "", "corner_a_"
};

/// One section for what is there without lights, one for each light, one for the sum. Returns the radiance of the point
/// before fog: what scene::shade_points() leaves in its channel.
glm::vec3 explain_lighting(const LitPoint& point, Derivation& derivation);

/// A section with what the maps say and where they were read; nothing without maps.
void explain_maps(const LitPoint& point, const lighting::LightingChannels& c, Derivation& derivation);

/// Where a normal map is read: t, b, m and n, after the interpolated normal n0.
void explain_bent_normal(const LitPoint& point, const lighting::LightingChannels& c, Section& section);

/// What the environment adds: its equations behind those of the surface. `c`: the channels without lamps.
void explain_environment(const LitPoint& point, const lighting::LightingChannels& c, Section& section);

/// One light's terms by the point's reflection model, symbol by symbol, before they are multiplied by what the light
/// sends: what lighting::reflect() says. `after`: the channels once this light was added.
[[nodiscard]] lighting::ReflectedTerms explain_reflection(const lighting::MaterialSetup& material,
                                                          const lighting::LightingChannels& after, Section& section);

/// The same for the microfacet model, whose terms are known.
void explain_microfacets(const lighting::CookTorranceSetup& setup, const lighting::LightingChannels& after,
                         const lighting::ReflectedTerms& terms, Section& section);

}  // namespace kreda::tools
