// What every pass over a light does at a point of a batch: say where the light stands, add what is reflected of it.
#pragma once

#include <glm/geometric.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/reflection.hpp"

namespace kreda::lighting {

/// The way to the light that is being added, unit, at point i: l and n.l. Requires n.
inline void set_direction_to_light(LightingChannels& c, int i, const glm::vec3& l) {
    c.l.set(i, l);
    c.n_dot_l.set(i, glm::dot(c.n.at(i), l));
}

/// Add one light's reflection at point i to the sums.
inline void add_terms(LightingChannels& c, int i, const ReflectedTerms& terms) {
    const glm::vec3 s = c.irradiance.at(i);
    c.diffuse.set(i, c.diffuse.at(i) + s * terms.diffuse);
    c.specular.set(i, c.specular.at(i) + s * terms.specular);
}

}  // namespace kreda::lighting
