#include "scene/plan/plan_cost.hpp"

#include <algorithm>

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

double fog_operations(const lighting::Fog& fog) {
    const double distance = 10.0;
    return distance + (fog.mode == lighting::FogMode::linear ? 6.0 : kExpOperations + 3.0);
}

/// Work at every visible sample, or at one of a block of them: then several triangles may share the block.
PassCost at_shaded_samples(const RenderPlan& plan, const PlanCounts& counts, double operations) {
    const std::uint64_t block = static_cast<std::uint64_t>(plan.shading_rate) * plan.shading_rate;
    if (block == 1) return {"samples", counts.samples, operations};
    return {"points, about,", (counts.samples + block - 1) / block, operations};
}

/// Where light is computed, how often, and what that takes at each of these points.
PassCost at_lit_points(const RenderPlan& plan, const PlanCounts& counts, double operations) {
    switch (plan.frequency) {
        case ShadingFrequency::phong: return at_shaded_samples(plan, counts, operations);
        case ShadingFrequency::gouraud: return {"vertices", counts.vertices, operations * (plan.two_sided ? 2.0 : 1.0)};
        case ShadingFrequency::flat: return {"triangles", counts.triangles, operations};
    }
    return {};
}

/// Operations of one light at one point, by the dearest material that is seen.
double dearest_reflection(const Scene& scene, const RenderPlan& plan, const lighting::Light& light) {
    const bool one_half_vector =
        light.type == lighting::LightType::directional && scene.camera.projection == raster::Projection::orthographic;
    double dearest = 0.0;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (plan.lighting.seen[m]) {
            dearest = std::max(dearest, reflection_operations(scene.materials[m], one_half_vector));
        }
    }
    return dearest;
}

bool is_of_frame(const PlannedPass& pass) {
    return pass.scope != PassScope::once;
}

}  // namespace

double reflection_operations(const lighting::Material& material, bool one_half_vector) {
    switch (material.model) {
        case ReflectionModel::unlit: return 0.0;
        case ReflectionModel::lambert: return kPositiveDot + 3.0 + kAddUp;
        case ReflectionModel::phong:
            return kPositiveDot + 3.0 + 12.0 + kPositiveDot + kPowOperations + kPositiveDot + 4.0 + kAddUp;
        case ReflectionModel::blinn_phong:
            return kPositiveDot + 3.0 + (one_half_vector ? 0.0 : kHalfVector) + kPositiveDot + kPowOperations +
                   kPositiveDot + 4.0 + kAddUp;
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

PlanCounts count(const Scene& scene, const RenderPlan& plan) {
    PlanCounts counts;
    for (const Object& object : scene.objects) {
        counts.vertices += object.mesh->positions.size();
        counts.triangles += object.mesh->triangle_count();
    }
    counts.drawn = counts.triangles;
    if (plan.seen) {
        counts.drawn = 0;
        for (const SeenObject& object : plan.seen->objects) counts.drawn += object.triangles.drawn;
    }
    counts.samples = static_cast<std::uint64_t>(plan.viewport.width) * static_cast<std::uint64_t>(plan.viewport.height);
    counts.pixels = static_cast<std::uint64_t>(scene.image.width) * static_cast<std::uint64_t>(scene.image.height);
    return counts;
}

PassCost vertex_cost(const RenderPlan& plan, const PlanCounts& counts) {
    constexpr double kProject = kMatrixTimesPoint + 25.0;  // clip, inside the view?, divide, snap
    return {"vertices", counts.vertices,
            kProject + 18.0 * plan.vertex.position_world + 15.0 * plan.vertex.normal_world};
}

PassCost vertex_fog_cost(const Scene& scene, const PlanCounts& counts) {
    return {"vertices", counts.vertices, fog_operations(scene.fog)};
}

PassCost triangle_cost(const PlanCounts& counts) {
    return {"triangles", counts.triangles, 60.0};
}

PassCost side_cost(const PlanCounts& counts) {
    return {"triangles", counts.triangles, 35.0};
}

PassCost visibility_cost(const PlanCounts& counts) {
    return {"samples", counts.samples, 14.0};
}

PassCost interpolation_cost(const RenderPlan& plan, const PlanCounts& counts) {
    const raster::FragmentNeeds& needs = plan.fragment;
    const int numbers = 3 * (needs.position + needs.normal + needs.color) + 2 * needs.uv + needs.fog;
    // weights, then three products and two sums a number
    return at_shaded_samples(plan, counts, 13.0 + 5.0 * numbers);
}

PassCost copy_cost(const PlanCounts& counts) {
    return {"samples", counts.samples, 0.0};
}

PassCost fog_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts) {
    return at_shaded_samples(plan, counts, fog_operations(scene.fog));
}

PassCost mix_fog_cost(const RenderPlan& plan, const PlanCounts& counts) {
    return at_shaded_samples(plan, counts, 10.0);
}

PassCost film_cost(const RenderPlan& plan, const PlanCounts& counts) {
    const double n2 = static_cast<double>(plan.samples) * plan.samples;
    const double display = plan.bytes ? 3.0 * (raster::kPowOperations + 10.0) : 0.0;
    return {"pixels", counts.pixels, (plan.samples == 1 ? 0.0 : 3.0 * n2) + display};
}

/// What there is without lights, and the sum; a flat triangle's centroid is found, too.
PassCost sum_cost(const RenderPlan& plan, const PlanCounts& counts) {
    return at_lit_points(plan, counts, 6.0 + (plan.frequency == ShadingFrequency::flat ? 12.0 : 0.0));
}

/// n and v.
PassCost surface_cost(const RenderPlan& plan, const PlanCounts& counts) {
    return at_lit_points(plan, counts, kUnit + 3.0 + kUnit);
}

/// Reading the maps of one material, each trilinear: eight texels of three numbers.
PassCost map_cost(const RenderPlan& plan, const PlanCounts& counts, std::size_t maps) {
    constexpr double kLevel = 25.0, kTrilinear = 90.0;
    return at_lit_points(plan, counts, kLevel + kTrilinear * static_cast<double>(maps));
}

/// E for every lit material, P, A and B for those with a highlight; or samples of the integral.
PassCost environment_light_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts) {
    constexpr double kCubeTap = 35.0, kFourTexels = 28.0, kTurn = 6.0, kDiffuse = 15.0;
    constexpr double kIrradiance = kTurn + kCubeTap + kFourTexels + kDiffuse;
    constexpr double kSpecular = kTurn + 2.0 * (kCubeTap + kFourTexels) + 22.0 + kFourTexels + 45.0;
    constexpr double kSample = 200.0;  // a direction, a look-up, D, G, F, two densities and the sums
    const int reference = scene.environment.reference;
    if (reference > 0) return at_lit_points(plan, counts, static_cast<double>(reference) * 3.0 * kSample);
    return at_lit_points(plan, counts, kIrradiance + (plan.environment.blurred ? kSpecular : 0.0));
}

PassCost light_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts, int light) {
    const lighting::Light& lamp = scene.lights[static_cast<std::size_t>(light)];
    double operations = light_operations(lamp) + dearest_reflection(scene, plan, lamp);
    for (const PlannedShadow& shadow : plan.shadows) {
        if (shadow.light == light) operations += shadow_look_up_operations(scene, shadow);
    }
    return at_lit_points(plan, counts, operations);
}

double operations_of(const RenderPlan& plan, std::string_view name) {
    const auto found = std::find_if(plan.passes.begin(), plan.passes.end(),
                                    [&](const PlannedPass& pass) { return pass.name == name; });
    if (found == plan.passes.end()) return 0.0;
    double sum = found->cost.operations();
    for (auto pass = found + 1; pass != plan.passes.end() && pass->scope == PassScope::points; ++pass) {
        sum += pass->cost.operations();
    }
    return sum;
}

double baking_operations(const RenderPlan& plan) {
    double sum = 0.0;
    for (const PlannedPass& pass : plan.passes) sum += is_of_frame(pass) ? 0.0 : pass.cost.operations();
    return sum;
}

double total_operations(const RenderPlan& plan) {
    double sum = 0.0;
    for (const PlannedPass& pass : plan.passes) sum += is_of_frame(pass) ? pass.cost.operations() : 0.0;
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
