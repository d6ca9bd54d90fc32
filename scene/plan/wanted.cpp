#include "scene/plan/wanted.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace kreda::scene {

namespace {

using Names = std::initializer_list<std::string_view>;

bool is_one_of(const View& view, Names names) {
    return std::find(names.begin(), names.end(), view.name) != names.end();
}

/// Up to which step of the pipeline a view looks. One that is not named here gets everything.
Wanted wanted_of_view(const View& view) {
    if (is_one_of(view, {"depth", "position", "uv"})) return {};
    if (is_one_of(view, {"fog"})) return {.fog = true};
    if (is_one_of(view, {"level", "diffuse_map", "normal_map", "albedo", "metallic", "roughness", "ao", "f0"}))
        return {.maps = true};
    if (is_one_of(view, {"normal", "grain"})) return {.maps = true, .surface = true};
    Wanted wanted{.maps = true, .surface = true, .position = true};
    if (is_one_of(view, {"to_viewer"})) return wanted;
    wanted.last_lamp =
        is_one_of(view, {"to_light", "light_irradiance", "n_dot_l", "sigma", "highlight", "D", "V", "G", "F"});
    wanted.last_shadow = is_one_of(view, {"shadow", "blocker_distance", "penumbra"});
    wanted.environment = is_one_of(view, {"irradiance", "prefilter", "brdf", "fresnel", "environment_diffuse",
                                          "environment_specular", "environment_error", "ambient"});
    wanted.lamps = is_one_of(view, {"diffuse", "specular", "light"});
    wanted.radiance = !wanted.last_lamp && !wanted.last_shadow && !wanted.environment && !wanted.lamps;
    return wanted;
}

void add(const Wanted& more, Wanted& wanted) {
    wanted.radiance |= more.radiance;
    wanted.maps |= more.maps;
    wanted.surface |= more.surface;
    wanted.position |= more.position;
    wanted.environment |= more.environment;
    wanted.lamps |= more.lamps;
    wanted.last_lamp |= more.last_lamp;
    wanted.last_shadow |= more.last_shadow;
    wanted.fog |= more.fog;
}

}  // namespace

Wanted wanted_of(const PlanRequest& request) {
    Wanted wanted{.radiance = request.film};
    for (const View* view : request.views) add(wanted_of_view(*view), wanted);
    if (!wanted.radiance) return wanted;
    add({.maps = true, .surface = true, .position = true, .environment = true, .lamps = true, .fog = true}, wanted);
    return wanted;
}

}  // namespace kreda::scene
