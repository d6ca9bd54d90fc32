// Which materials each of the lighting passes works on: those that are seen, and on which it changes something.
#pragma once

#include <vector>

#include "lighting/material.hpp"
#include "scene/plan/seen.hpp"
#include "scene/plan/wanted.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// One flag a material, by its number.
using MaterialMask = std::vector<bool>;

/// The materials that each pass works on. A pass without any is left out.
struct LightingChoices {
    MaterialMask seen;                ///< some sample shows it
    MaterialMask maps;                ///< its maps are read
    MaterialMask surface;             ///< n and v are found
    MaterialMask environment;         ///< the environment is added
    std::vector<MaterialMask> lamps;  ///< of each of the scene's lights: it is added
    bool any = false;                 ///< light is computed at all

    [[nodiscard]] bool lit_by_environment() const;
    [[nodiscard]] bool lit_by_lamps() const;
};

[[nodiscard]] bool any_of(const MaterialMask& mask);

/// Does the model reflect any light at all?
[[nodiscard]] bool is_lit(const lighting::Material& material);

/// Where nothing is drawn.
[[nodiscard]] LightingChoices nothing_lit(const Scene& scene);

/// Maps count whether their texels are there already or not. `seen`: nullptr where nothing shall be left out; then
/// everything that is not hidden counts as seen.
[[nodiscard]] LightingChoices choose_lighting(const Scene& scene, const Seen* seen, const Wanted& wanted);

}  // namespace kreda::scene
