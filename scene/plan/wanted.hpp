// How far the pipeline must go for what is asked of it: the film, or a view of a quantity on the way.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace kreda::scene {

struct Seen;
struct View;

/// What somebody looks at in the end.
struct PlanRequest {
    std::vector<const View*> views = {};
    bool film = true;            ///< the picture itself, too
    bool bytes = false;          ///< of the picture only what a display is sent; not beside views
    const Seen* seen = nullptr;  ///< what plan_loading() saw; nullptr: it is found anew
    bool prune = true;  ///< leave out what changes no bit of it; false: everything that the scene names, to look at
};

/// Names of material maps, as MapUse has them; an empty one ends the list.
using MapNames = std::array<std::string_view, 4>;

/// What must be computed for it.
struct Wanted {
    bool radiance = false;     ///< all of the light: what follows, and fog
    bool maps = false;         ///< the material at every point: constants and maps
    bool surface = false;      ///< n and v
    bool position = false;     ///< of a lit point: everything but n alone needs it
    bool effects = false;      ///< sums alone are looked at: what adds nothing to them is not needed
    bool shadows = false;      ///< what they leave of the lamps
    MapNames map_names{};      ///< maps that matter; none named: all of them, if maps are wanted
    bool environment = false;  ///< what it adds
    bool lamps = false;        ///< what all of them add
    bool last_lamp = false;    ///< quantities of the last light that is on
    bool last_shadow = false;  ///< quantities of the last light that casts a shadow
    bool fog = false;

    [[nodiscard]] bool any_light() const {
        return radiance || maps || surface || environment || lamps || last_lamp || last_shadow;
    }
};
[[nodiscard]] Wanted wanted_of(const PlanRequest& request);

}  // namespace kreda::scene
