#include "scene/plan/views.hpp"

#include <algorithm>
#include <cmath>

#include "lighting/batch/ward_passes.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::scene {

namespace {

using lighting::ReflectionModel;
using Batch = BatchChannels;

bool always(const RenderPlan&, std::uint32_t) {
    return true;
}

bool lit_at_pixels(const RenderPlan& plan, std::uint32_t material) {
    return plan.frequency == ShadingFrequency::phong &&
           plan.materials[material].material.model != ReflectionModel::unlit;
}

bool lit_by_lights(const RenderPlan& plan, std::uint32_t material) {
    return lit_at_pixels(plan, material) && plan.has_lights;
}

bool is_shiny(const RenderPlan& plan, std::uint32_t material) {
    const ReflectionModel model = plan.materials[material].material.model;
    return lit_by_lights(plan, material) && (model == ReflectionModel::phong || model == ReflectionModel::blinn_phong);
}

bool has_grain(const RenderPlan& plan, std::uint32_t material) {
    return lit_at_pixels(plan, material) && needs_grain(plan.materials[material].material);
}

bool in_shadows(const RenderPlan& plan, std::uint32_t material) {
    return lit_at_pixels(plan, material) && !plan.shadows.empty();
}

bool finds_blockers(const RenderPlan& plan, std::uint32_t material) {
    return in_shadows(plan, material) && !plan.shadows_by_frame;
}

bool is_microfacet(const RenderPlan& plan, std::uint32_t material) {
    return lit_at_pixels(plan, material) && plan.materials[material].material.model == ReflectionModel::cook_torrance;
}

bool is_lit_microfacet(const RenderPlan& plan, std::uint32_t material) {
    return is_microfacet(plan, material) && plan.has_lights;
}

bool in_environment(const RenderPlan& plan, std::uint32_t material) {
    return lit_at_pixels(plan, material) && plan.lit_by_environment;
}

bool in_split_sum(const RenderPlan& plan, std::uint32_t material) {
    return in_environment(plan, material) && plan.environment.irradiance;
}

bool in_sum_of_samples(const RenderPlan& plan, std::uint32_t material) {
    return in_environment(plan, material) && !plan.environment.irradiance;
}

bool mirrors_environment(const RenderPlan& plan, std::uint32_t material) {
    return is_microfacet(plan, material) && plan.environment.blurred;
}

bool has_map(const RenderPlan& plan, std::uint32_t material, lighting::Map lighting::MaterialMaps::*map) {
    return plan.frequency == ShadingFrequency::phong && (plan.materials[material].maps.*map).texture;
}

bool has_diffuse_map(const RenderPlan& plan, std::uint32_t material) {
    return has_map(plan, material, &lighting::MaterialMaps::diffuse);
}

bool has_emission_map(const RenderPlan& plan, std::uint32_t material) {
    return has_map(plan, material, &lighting::MaterialMaps::emission);
}

bool has_normal_map(const RenderPlan& plan, std::uint32_t material) {
    return has_map(plan, material, &lighting::MaterialMaps::normal);
}

bool has_level(const RenderPlan& plan, std::uint32_t material) {
    return plan.frequency == ShadingFrequency::phong && plan.materials[material].map_needs.uv_steps;
}

bool in_fog(const RenderPlan& plan, std::uint32_t) {
    return plan.fog_at_pixels || plan.fog_at_vertices;
}

constexpr const char* kAnything = "an object";
constexpr const char* kLit = "shading.frequency = \"phong\" and a material that is not unlit";
constexpr const char* kLights = "shading.frequency = \"phong\", a material that is not unlit and a light";
constexpr const char* kShiny =
    "shading.frequency = \"phong\", a material with model = \"phong\" or \"blinn_phong\" and a light";
constexpr const char* kMicrofacet = "shading.frequency = \"phong\" and a material with model = \"cook_torrance\"";
constexpr const char* kLitMicrofacet =
    "shading.frequency = \"phong\", a material with model = \"cook_torrance\" and a light";
constexpr const char* kGrain =
    "shading.frequency = \"phong\" and a material with model = \"heidrich_seidel\", or \"ward\" and ward_alpha";
constexpr const char* kEnvironment = "shading.frequency = \"phong\", a material that is not unlit and an [environment]";
constexpr const char* kSplitSum =
    "shading.frequency = \"phong\", a material that is not unlit and an [environment] with reference = 0";
constexpr const char* kSamples =
    "shading.frequency = \"phong\", a material that is not unlit and an [environment] with reference above 0";
constexpr const char* kMirror =
    "shading.frequency = \"phong\", a material with model = \"cook_torrance\" and an [environment] with reference = 0";
constexpr const char* kShadows =
    "shading.frequency = \"phong\", a material that is not unlit and a light whose shadow = true falls on something "
    "seen";
constexpr const char* kBlockers =
    "shading.frequency = \"phong\", a material that is not unlit, shadow.method = \"map\" or \"exact\" and a light "
    "whose shadow = true falls on something seen";
constexpr const char* kMap = "shading.frequency = \"phong\" and a material with that map, read by its model";
constexpr const char* kLevel =
    "shading.frequency = \"phong\" and a material with a map and texture_filter = \"trilinear\"";
constexpr const char* kFog = "fog.mode that is not \"none\"";

/// G from V = G / (4 (n.l)(n.v)).
float geometry_from_visibility(const lighting::MicrofacetChannels& m, int i) {
    return 4.0f * m.n_dot_l.at(i) * m.n_dot_v.at(i) * m.V.at(i);
}

float fraction_of(const raster::Channel& coordinate, int i) {
    return coordinate.at(i) - std::floor(coordinate.at(i));
}

/// What material maps give; those maps alone are read.
constexpr Wanted from_maps(MapNames names) {
    return {.maps = true, .map_names = names};
}

// How far the pipeline must go for a view.
constexpr Wanted kNoLight{};
constexpr Wanted kMaps{.maps = true};
constexpr Wanted kViewer{.surface = true, .position = true};
constexpr Wanted kSurface{.maps = true, .surface = true, .map_names = {"normal"}};
constexpr Wanted kLamp{.position = true, .last_lamp = true};
constexpr Wanted kShadowedLamp{.position = true, .shadows = true, .last_lamp = true};
constexpr Wanted kLampOnSurface{
    .maps = true, .surface = true, .position = true, .map_names = {"normal"}, .last_lamp = true};
constexpr Wanted kMicrofacets{.maps = true,
                              .surface = true,
                              .position = true,
                              .map_names = {"normal", "albedo", "metallic", "roughness"},
                              .last_lamp = true};
constexpr Wanted kShadow{.position = true, .shadows = true, .last_shadow = true};
constexpr Wanted kFromEnvironment{.maps = true, .surface = true, .position = true, .environment = true};
constexpr Wanted kAmbient{.maps = true, .surface = true, .position = true, .effects = true, .environment = true};
constexpr Wanted kFromLamps{
    .maps = true, .surface = true, .position = true, .effects = true, .shadows = true, .lamps = true};
constexpr Wanted kPicture{.radiance = true, .maps = true, .surface = true, .position = true};
constexpr Wanted kFogAlone{.fog = true};

std::vector<View> make_views() {
    using enum ViewScale;
    constexpr raster::FragmentNeeds kNothing{};
    constexpr raster::FragmentNeeds kPosition{.position = true};
    constexpr raster::FragmentNeeds kUv{.uv = true};
    return {
        {"radiance", "what leaves toward the viewer, fog included: the picture itself", kAnything, 3, radiance,
         kNothing, kPicture, always, [](const Batch& b, int i, int c) { return b.lighting.radiance.at(i)[c]; }},
        {"depth", "window depth: 0 at the near plane, 1 at the far plane", kAnything, 1, range, kNothing, kNoLight,
         always, nullptr, 1.0f},
        {"position", "world position", kAnything, 3, range, kPosition, kNoLight, always,
         [](const Batch& b, int i, int c) { return b.points.position.at(i)[c]; }},
        {"uv", "texture coordinates, their fractions: red u, green v", kAnything, 3, share, kUv, kNoLight, always,
         [](const Batch& b, int i, int c) { return c == 2 ? 0.0f : fraction_of(c == 0 ? b.points.u : b.points.v, i); }},
        {"level", "level of detail at which the colour map is read: 0 finest", kLevel, 1, range, kNothing, kMaps,
         has_level, [](const Batch& b, int i, int) { return std::max(b.lighting.level.at(i), 0.0f); }},
        {"diffuse_map", "m_D as the map gives it", kMap, 3, color, kNothing, from_maps({"diffuse"}), has_diffuse_map,
         [](const Batch& b, int i, int c) { return b.lighting.m_D.at(i)[c]; }},
        {"emission_map", "what the emission map says; m_E is emission times it", kMap, 3, radiance, kNothing,
         from_maps({"emission"}), has_emission_map,
         [](const Batch& b, int i, int c) { return b.lighting.map_emission.at(i)[c]; }},
        {"normal_map", "the map's vector, in the surface's directions t, b, n", kMap, 3, direction, kNothing,
         from_maps({"normal"}), has_normal_map,
         [](const Batch& b, int i, int c) { return b.lighting.map_normal.at(i)[c]; }},
        {"normal", "n: unit normal, world space", kLit, 3, direction, kNothing, kSurface, lit_at_pixels,
         [](const Batch& b, int i, int c) { return b.lighting.n.at(i)[c]; }},
        {"to_viewer", "v: unit, to the viewer", kLit, 3, direction, kNothing, kViewer, lit_at_pixels,
         [](const Batch& b, int i, int c) { return b.lighting.v.at(i)[c]; }},
        {"grain", "t: unit, the way scratches or threads run, world space", kGrain, 3, direction, kNothing, kSurface,
         has_grain, [](const Batch& b, int i, int c) { return b.lighting.t.at(i)[c]; }},
        {"albedo", "c: base colour", kMicrofacet, 3, color, kNothing, from_maps({"albedo"}), is_microfacet,
         [](const Batch& b, int i, int c) { return b.lighting.microfacet.surface.at(i).albedo[c]; }},
        {"metallic", "0 dielectric .. 1 metal", kMicrofacet, 1, share, kNothing, from_maps({"metallic"}), is_microfacet,
         [](const Batch& b, int i, int) { return b.lighting.microfacet.surface.at(i).metallic; }},
        {"roughness", "0 smooth .. 1 rough", kMicrofacet, 1, share, kNothing, from_maps({"roughness"}), is_microfacet,
         [](const Batch& b, int i, int) { return b.lighting.microfacet.surface.at(i).roughness; }},
        {"ao", "share of the environment's light that arrives", kMicrofacet, 1, share, kNothing, from_maps({"ao"}),
         is_microfacet, [](const Batch& b, int i, int) { return b.lighting.microfacet.ao.at(i); }},
        {"f0", "F0: reflectance at normal incidence", kMicrofacet, 3, color, kNothing,
         from_maps({"albedo", "metallic"}), is_microfacet,
         [](const Batch& b, int i, int c) { return b.lighting.microfacet.surface.at(i).f0[c]; }},
        {"to_light", "l: unit, to the last light that is on", kLights, 3, direction, kNothing, kLamp, lit_by_lights,
         [](const Batch& b, int i, int c) { return b.lighting.l.at(i)[c]; }},
        {"light_irradiance", "s: what arrives of the last light that is on, on a plane facing it", kLights, 3, radiance,
         kNothing, kShadowedLamp, lit_by_lights,
         [](const Batch& b, int i, int c) { return b.lighting.irradiance.at(i)[c]; }},
        {"n_dot_l", "max(n.l, 0): Lambert's cosine, of the last light that is on", kLights, 1, share, kNothing,
         kLampOnSurface, lit_by_lights,
         [](const Batch& b, int i, int) { return raster::saturate(b.lighting.n_dot_l.at(i)); }},
        {"sigma", "Sigma: max(v.r, 0) or max(n.h, 0), of the last light that is on", kShiny, 1, share, kNothing,
         kLampOnSurface, is_shiny, [](const Batch& b, int i, int) { return b.lighting.sigma.at(i); }},
        {"highlight", "Sigma^h of the last light that is on, 0 where the surface faces away from it", kShiny, 1, share,
         kNothing, kLampOnSurface, is_shiny, [](const Batch& b, int i, int) { return b.lighting.highlight.at(i); }},
        {"shadow", "1 lit .. 0 in shadow, of the last light that casts shadows", kShadows, 1, share, kNothing, kShadow,
         in_shadows, [](const Batch& b, int i, int) { return b.lighting.shadow.at(i); }},
        {"blocker_distance", "how far before the point lies what keeps that light from it", kBlockers, 1, range,
         kNothing, kShadow, finds_blockers,
         [](const Batch& b, int i, int) { return b.lighting.blocker_distance.at(i); }},
        {"penumbra", "width of the soft edge of that shadow (shadow.filter = \"pcss\")", kBlockers, 1, range, kNothing,
         kShadow, finds_blockers, [](const Batch& b, int i, int) { return b.lighting.penumbra.at(i); }},
        {"D", "microfacets that face the half vector, of the last light that is on [1/sr]", kLitMicrofacet, 1, range,
         kNothing, kMicrofacets, is_lit_microfacet,
         [](const Batch& b, int i, int) { return b.lighting.microfacet.D.at(i); }},
        {"V", "V = G / (4 (n.l)(n.v)) of the last light that is on", kLitMicrofacet, 1, range, kNothing, kMicrofacets,
         is_lit_microfacet, [](const Batch& b, int i, int) { return b.lighting.microfacet.V.at(i); }},
        {"G", "share of the microfacets that light and viewer both see, of the last light that is on", kLitMicrofacet,
         1, share, kNothing, kMicrofacets, is_lit_microfacet,
         [](const Batch& b, int i, int) { return geometry_from_visibility(b.lighting.microfacet, i); }},
        {"F", "Fresnel reflectance at v.h, of the last light that is on", kLitMicrofacet, 3, color, kNothing,
         kMicrofacets, is_lit_microfacet,
         [](const Batch& b, int i, int c) { return b.lighting.microfacet.F.at(i)[c]; }},
        {"irradiance", "E: what the environment sends to a plane of this normal", kSplitSum, 3, radiance, kNothing,
         kFromEnvironment, in_split_sum,
         [](const Batch& b, int i, int c) { return b.lighting.environment.irradiance.at(i)[c]; }},
        {"prefilter", "P: the environment around the mirror direction, blurred as the surface is rough", kMirror, 3,
         radiance, kNothing, kFromEnvironment, mirrors_environment,
         [](const Batch& b, int i, int c) { return b.lighting.environment.prefiltered.at(i)[c]; }},
        {"brdf", "A and B: scale (red) and bias (green) of F0 in the split sum", kMirror, 3, share, kNothing,
         kFromEnvironment, mirrors_environment,
         [](const Batch& b, int i, int c) { return c < 2 ? b.lighting.environment.brdf.at(i)[c] : 0.0f; }},
        {"fresnel", "Fresnel reflectance at n.v, as the environment sees it", kMirror, 3, color, kNothing,
         kFromEnvironment, mirrors_environment,
         [](const Batch& b, int i, int c) { return b.lighting.environment.F.at(i)[c]; }},
        {"environment_diffuse", "diffuse reflection of the environment", kEnvironment, 3, radiance, kNothing,
         kFromEnvironment, in_environment,
         [](const Batch& b, int i, int c) { return b.lighting.environment.diffuse.at(i)[c]; }},
        {"environment_specular", "specular reflection of the environment", kEnvironment, 3, radiance, kNothing,
         kFromEnvironment, in_environment,
         [](const Batch& b, int i, int c) { return b.lighting.environment.specular.at(i)[c]; }},
        {"environment_error",
         "standard error of the samples' sum, luminance (of a white surface where the material has no highlight)",
         kSamples, 1, range, kNothing, kFromEnvironment, in_sum_of_samples,
         [](const Batch& b, int i, int) { return b.lighting.environment.error.at(i); }},
        {"ambient", "s_A m_A + m_E and the environment: what is there without any light", kLit, 3, radiance, kNothing,
         kAmbient, lit_at_pixels, [](const Batch& b, int i, int c) { return b.lighting.ambient.at(i)[c]; }},
        {"diffuse", "diffuse reflection of all lights", kLit, 3, radiance, kNothing, kFromLamps, lit_at_pixels,
         [](const Batch& b, int i, int c) { return b.lighting.diffuse.at(i)[c]; }},
        {"specular", "specular reflection of all lights", kLit, 3, radiance, kNothing, kFromLamps, lit_at_pixels,
         [](const Batch& b, int i, int c) { return b.lighting.specular.at(i)[c]; }},
        {"light", "diffuse + specular of all lights", kLit, 3, radiance, kNothing, kFromLamps, lit_at_pixels,
         [](const Batch& b, int i, int c) { return b.lighting.diffuse.at(i)[c] + b.lighting.specular.at(i)[c]; }},
        {"fog", "f: 1 clear .. 0 nothing but fog", kFog, 1, share, kNothing, kFogAlone, in_fog,
         [](const Batch& b, int i, int) { return b.lighting.fog.at(i); }},
    };
}

}  // namespace

const std::vector<View>& all_views() {
    static const std::vector<View> views = make_views();
    return views;
}

const View* find_view(std::string_view name) {
    for (const View& view : all_views()) {
        if (view.name == name) return &view;
    }
    return nullptr;
}

}  // namespace kreda::scene
