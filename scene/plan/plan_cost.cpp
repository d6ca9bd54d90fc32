#include "scene/plan/plan_cost.hpp"

#include <algorithm>
#include <string_view>

#include "lighting/microfacet_choices.hpp"
#include "scene/plan/shadow_cost.hpp"

namespace kreda::scene {

namespace {

using lighting::ReflectionModel;

using raster::kExpOperations, raster::kPowOperations;
constexpr double kDot = 5.0;
constexpr double kPositiveDot = kDot + 1.0;
constexpr double kUnit = kDot + 1.0 + 2.0 + 3.0;  // dot, guard, root and division, three products
constexpr double kHalfVector = 3.0 + kUnit;
constexpr double kAddUp = 2.0 * (3.0 + 3.0);  // s times diffuse and specular, added
constexpr double kMatrixTimesPoint = 28.0;

double cook_torrance_operations(const lighting::CookTorranceMaterial& material) {
    constexpr double kAngles = 3.0 * kPositiveDot + kHalfVector + 2.0 + 11.0;
    constexpr double kCombine = 30.0;
    const double compensation = material.energy_compensation == lighting::EnergyCompensation::none ? 0.0 : 90.0;
    const bool spectral = material.fresnel == lighting::FresnelMethod::exact && !material.measured.empty() &&
                          material.spectrum == lighting::SpectrumUse::full;
    const double fresnel = spectral ? lighting::kSpectralFresnelOperations : facts_of(material.fresnel).operations;
    return kAngles + facts_of(material.distribution).operations + facts_of(material.geometry).operations + fresnel +
           kCombine + compensation;
}

struct LitObjects {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    double dearest_light = 0.0;  ///< of one light, by the dearest visible material
    bool lit = false;            ///< any material that is not unlit
};

LitObjects look_at_objects(const Scene& scene) {
    LitObjects all;
    for (const Object& object : scene.objects) {
        all.vertices += object.mesh->positions.size();
        all.triangles += object.mesh->triangle_count();
        for (const int m : object.part_material) {
            const lighting::Material& material = scene.materials[static_cast<std::size_t>(m)];
            all.dearest_light = std::max(all.dearest_light, reflection_operations(material));
            all.lit |= material.model != ReflectionModel::unlit;
        }
    }
    return all;
}

/// Lighting one point: directions and sums, and every light that is on.
double lighting_operations(const Scene& scene, const RenderPlan& plan, const LitObjects& objects) {
    constexpr double kWithoutLights = 6.0;               // ambient, the sum
    constexpr double kDirections = kUnit + 3.0 + kUnit;  // n, v
    if (!objects.lit) return kWithoutLights;
    double operations = kWithoutLights + kDirections;
    for (const PlannedShadow& shadow : plan.shadows) operations += shadow_look_up_operations(scene, shadow);
    for (const lighting::Light& light : scene.lights) {
        if (light.on) operations += light_operations(light) + objects.dearest_light;
    }
    return operations;
}

double fog_operations(const lighting::Fog& fog) {
    const double distance = 10.0;
    return distance + (fog.mode == lighting::FogMode::linear ? 6.0 : kExpOperations + 3.0);
}

double interpolation_operations(const RenderPlan& plan) {
    const raster::FragmentNeeds& needs = plan.fragment;
    const int numbers = 3 * (needs.position + needs.normal + needs.color) + 2 * needs.uv + needs.fog;
    return 13.0 + 5.0 * numbers;  // weights, then three products and two sums a number
}

double vertex_operations(const RenderPlan& plan) {
    constexpr double kProject = kMatrixTimesPoint + 25.0;  // clip, inside the view?, divide, snap
    return kProject + 18.0 * plan.vertex.position_world + 15.0 * plan.vertex.normal_world;
}

/// Reading the maps of one material at one point, each trilinear: eight texels of three numbers.
double map_operations(const PlannedPass& pass) {
    constexpr double kLevel = 25.0, kTrilinear = 90.0;
    return kLevel + kTrilinear * static_cast<double>(pass.buffers.size());
}

/// Where light is computed, and how often.
const char* lit_points(const RenderPlan& plan) {
    if (plan.frequency == ShadingFrequency::phong) return "samples";
    return plan.frequency == ShadingFrequency::gouraud ? "vertices" : "triangles";
}

std::uint64_t lit_count(const RenderPlan& plan, const LitObjects& objects, std::uint64_t samples) {
    if (plan.frequency == ShadingFrequency::phong) return samples;
    return plan.frequency == ShadingFrequency::gouraud ? objects.vertices : objects.triangles;
}

bool is_baked(const PlannedPass& pass) {
    return pass.name.starts_with("bake ");
}

/// The environment at one point: E for every lit material, P, A and B for those with a highlight; or samples of the
/// integral.
double environment_operations(const Scene& scene, const RenderPlan& plan) {
    constexpr double kCubeTap = 35.0, kFourTexels = 28.0, kTurn = 6.0, kDiffuse = 15.0;
    constexpr double kIrradiance = kTurn + kCubeTap + kFourTexels + kDiffuse;
    constexpr double kSpecular = kTurn + 2.0 * (kCubeTap + kFourTexels) + 22.0 + kFourTexels + 45.0;
    constexpr double kSample = 200.0;  // a direction, a look-up, D, G, F, two densities and the sums
    const int reference = scene.environment.reference;
    if (reference > 0) return static_cast<double>(reference) * 3.0 * kSample;
    return kIrradiance + (plan.environment.blurred ? kSpecular : 0.0);
}

}  // namespace

double reflection_operations(const lighting::Material& material) {
    switch (material.model) {
        case ReflectionModel::unlit: return 0.0;
        case ReflectionModel::lambert: return kPositiveDot + 3.0 + kAddUp;
        case ReflectionModel::phong:
            return kPositiveDot + 3.0 + 12.0 + kPositiveDot + kPowOperations + kPositiveDot + 4.0 + kAddUp;
        case ReflectionModel::blinn_phong:
            return kPositiveDot + 3.0 + kHalfVector + kPositiveDot + kPowOperations + kPositiveDot + 4.0 + kAddUp;
        case ReflectionModel::ward:
            return 3.0 * kPositiveDot + kHalfVector + 13.0 + kExpOperations + 15.0 + 7.0 + kAddUp;
        case ReflectionModel::heidrich_seidel: return 2.0 * kDot + 8.0 + kPositiveDot + kPowOperations + 12.0 + kAddUp;
        case ReflectionModel::cook_torrance: return cook_torrance_operations(material.cook_torrance) + kAddUp;
    }
    return 0.0;
}

double light_operations(const lighting::Light& light) {
    constexpr double kPoint = 3.0 + kDot + 2.0 + 4.0 + 6.0 + 3.0;  // to the light, its length, l, attenuation, s
    switch (light.type) {
        case lighting::LightType::directional: return 3.0;
        case lighting::LightType::point: return kPoint;
        case lighting::LightType::spot: return kPoint + kDot + 1.0 + 10.0 + 3.0;
    }
    return 0.0;
}

void estimate_costs(const Scene& scene, RenderPlan& plan) {
    const LitObjects objects = look_at_objects(scene);
    const auto samples =
        static_cast<std::uint64_t>(plan.viewport.width) * static_cast<std::uint64_t>(plan.viewport.height);
    const auto pixels = static_cast<std::uint64_t>(scene.image.width) * static_cast<std::uint64_t>(scene.image.height);
    const double lighting = lighting_operations(scene, plan, objects);
    const double n2 = static_cast<double>(plan.samples) * plan.samples;
    const std::vector<std::pair<std::string_view, PassCost>> known = {
        {"vertices", {"vertices", objects.vertices, vertex_operations(plan)}},
        {"light vertices", {"vertices", objects.vertices, lighting * (plan.two_sided ? 2.0 : 1.0)}},
        {"fog at vertices", {"vertices", objects.vertices, fog_operations(scene.fog)}},
        {"triangles", {"triangles", objects.triangles, 60.0}},
        {"sides", {"triangles", objects.triangles, plan.frequency == ShadingFrequency::flat ? 0.0 : 35.0}},
        {"light triangles", {"triangles", objects.triangles, lighting + 12.0}},
        {"visibility", {"samples", samples, 14.0}},
        {"interpolate", {"samples", samples, interpolation_operations(plan)}},
        {"light pixels", {"samples", samples, lighting}},
        {"environment", {lit_points(plan), lit_count(plan, objects, samples), environment_operations(scene, plan)}},
        {"fog at pixels", {"samples", samples, fog_operations(scene.fog)}},
        {"mix fog", {"samples", samples, 10.0}},
        {"film", {"pixels", pixels, plan.samples == 1 ? 0.0 : 3.0 * n2}},
    };
    for (PlannedPass& pass : plan.passes) {
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const auto& entry) { return entry.first == pass.name; });
        if (found != known.end()) pass.cost = found->second;
        if (pass.name.starts_with("maps of ")) pass.cost = {"samples", samples, map_operations(pass)};
    }
}

double baking_operations(const RenderPlan& plan) {
    double sum = 0.0;
    for (const PlannedPass& pass : plan.passes) sum += is_baked(pass) ? pass.cost.operations() : 0.0;
    return sum;
}

double total_operations(const RenderPlan& plan) {
    double sum = 0.0;
    for (const PlannedPass& pass : plan.passes) sum += is_baked(pass) ? 0.0 : pass.cost.operations();
    return sum;
}

std::uint64_t total_bytes(const RenderPlan& plan) {
    std::uint64_t sum = 0;
    for (const PlannedPass& pass : plan.passes) {
        for (const PlannedBuffer& buffer : pass.buffers) sum += buffer.bytes;
    }
    return sum;
}

}  // namespace kreda::scene
