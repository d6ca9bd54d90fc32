// What every pass over a light does at a point of a batch: say where the light stands, add what is reflected of it.
#pragma once

#include <glm/geometric.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/reflection.hpp"

namespace kreda::lighting {

/// The way to the light that is being added, unit, at point i: l and n.l. Requires n, and that l is not even.
inline void set_direction_to_light(LightingChannels& c, int i, const glm::vec3& l) {
    c.l.each.set(i, l);
    c.n_dot_l.set(i, glm::dot(c.n.at(i), l));
}

/// use(before), where before(sum, i) is what the lights before this one left in a sum at point i: 0 for the first.
template <class Use>
inline void with_sums(LightingChannels& c, Use use) {
    const bool is_first = !c.is_lit;
    c.is_lit = true;
    if (is_first) return use([](const raster::Channel3&, int) { return glm::vec3(0.0f); });
    use([](const raster::Channel3& sum, int i) { return sum.at(i); });
}

/// add(i, terms) for every point of the batch by `loop`: add one light's reflection to the sums. Where it is the last
/// one and nobody looks at the sums, they are no channels: radiance is, at once.
template <class Loop>
inline void with_adder(LightingChannels& c, Loop loop) {
    const bool to_radiance = c.is_last && c.ambient.is_even;
    const glm::vec3 ambient = c.ambient.even;
    c.is_summed = to_radiance;
    with_quantity(c.irradiance, [&](auto irradiance) {
        with_sums(c, [&](auto before) {
            if (to_radiance) {
                return loop([&c, irradiance, before, ambient](int i, const ReflectedTerms& terms) {
                    const glm::vec3 s = irradiance(i);
                    const glm::vec3 diffuse = before(c.diffuse, i) + s * terms.diffuse;
                    const glm::vec3 specular = before(c.specular, i) + s * terms.specular;
                    c.radiance.set(i, ambient + diffuse + specular);
                });
            }
            loop([&c, irradiance, before](int i, const ReflectedTerms& terms) {
                const glm::vec3 s = irradiance(i);
                c.diffuse.set(i, before(c.diffuse, i) + s * terms.diffuse);
                c.specular.set(i, before(c.specular, i) + s * terms.specular);
            });
        });
    });
}

}  // namespace kreda::lighting
