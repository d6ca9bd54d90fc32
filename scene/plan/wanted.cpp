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

/// A view of the material, and the maps that it comes from; all of them for the level at which they are read.
Wanted material_view(const View& view) {
    if (is_one_of(view, {"level"})) return {.maps = true};
    if (is_one_of(view, {"diffuse_map"})) return {.maps = true, .map_names = {"diffuse"}};
    if (is_one_of(view, {"emission_map"})) return {.maps = true, .map_names = {"emission"}};
    if (is_one_of(view, {"normal_map"})) return {.maps = true, .map_names = {"normal"}};
    if (is_one_of(view, {"f0"})) return {.maps = true, .map_names = {"albedo", "metallic"}};
    return {.maps = true, .map_names = {view.name}};
}

/// A view of one lamp's quantities.
Wanted lamp_view(const View& view) {
    Wanted wanted{.position = true, .last_lamp = true};
    wanted.shadows = is_one_of(view, {"light_irradiance"});
    if (is_one_of(view, {"to_light", "light_irradiance"})) return wanted;
    wanted.maps = wanted.surface = true;
    wanted.map_names = {"normal"};
    if (is_one_of(view, {"D", "V", "G", "F"})) wanted.map_names = {"normal", "albedo", "metallic", "roughness"};
    return wanted;
}

/// Up to which step of the pipeline a view looks. One that is not named here gets everything.
Wanted wanted_of_view(const View& view) {
    if (is_one_of(view, {"depth", "position", "uv"})) return {};
    if (is_one_of(view, {"fog"})) return {.fog = true};
    if (is_one_of(view, {"level", "diffuse_map", "emission_map", "normal_map", "albedo", "metallic", "roughness", "ao",
                         "f0"}))
        return material_view(view);
    if (is_one_of(view, {"normal", "grain"})) return {.maps = true, .surface = true, .map_names = {"normal"}};
    if (is_one_of(view, {"to_viewer"})) return {.surface = true, .position = true};
    if (is_one_of(view, {"shadow", "blocker_distance", "penumbra"}))
        return {.position = true, .shadows = true, .last_shadow = true};
    if (is_one_of(view, {"to_light", "light_irradiance", "n_dot_l", "sigma", "highlight", "D", "V", "G", "F"}))
        return lamp_view(view);
    Wanted wanted{.maps = true, .surface = true, .position = true};
    wanted.effects = is_one_of(view, {"ambient", "diffuse", "specular", "light"});
    wanted.environment = is_one_of(view, {"irradiance", "prefilter", "brdf", "fresnel", "environment_diffuse",
                                          "environment_specular", "environment_error", "ambient"});
    wanted.lamps = wanted.shadows = is_one_of(view, {"diffuse", "specular", "light"});
    wanted.radiance = !wanted.environment && !wanted.lamps;
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
    wanted.shadows |= more.shadows;
}

}  // namespace

Wanted wanted_of(const PlanRequest& request) {
    if (!request.film && request.views.size() == 1) {
        const Wanted wanted = wanted_of_view(*request.views[0]);
        if (!wanted.radiance) return wanted;
    }
    Wanted wanted{.radiance = true, .maps = true, .surface = true, .position = true, .effects = true, .shadows = true};
    wanted.environment = wanted.lamps = wanted.fog = true;
    for (const View* view : request.views) add(wanted_of_view(*view), wanted);
    return wanted;
}

}  // namespace kreda::scene
