#include "tools/brdf/lobes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lighting/reflect.hpp"

namespace kreda::tools {

namespace {

using lighting::Distribution;
using lighting::Material;
using lighting::ReflectionModel;

constexpr float kSpecular = 0.5f, kDiffuse = 0.3f;

/// h of Blinn's model whose highlight is as wide as that of facets of this alpha.
float exponent_of(float roughness) {
    const float alpha = roughness * roughness;
    return std::max(2.0f / (alpha * alpha) - 2.0f, 0.0f);
}

Material local(ReflectionModel model, float shininess) {
    Material material;
    material.model = model;
    material.phong.diffuse = glm::vec3(model == ReflectionModel::lambert ? 0.8f : kDiffuse);
    material.phong.specular = glm::vec3(model == ReflectionModel::lambert ? 0.0f : kSpecular);
    material.phong.shininess = shininess;
    return material;
}

/// A metal that reflects all of the light at every angle: what is missing is lost between the facets.
template <Distribution distribution>
Material microfacets(float roughness) {
    Material material;
    material.model = ReflectionModel::cook_torrance;
    material.cook_torrance.albedo = glm::vec3(1.0f);
    material.cook_torrance.metallic = 1.0f;
    material.cook_torrance.roughness = roughness;
    material.cook_torrance.distribution = distribution;
    material.cook_torrance.geometry = lighting::Geometry::smith_correlated;
    return material;
}

Material plastic(float roughness) {
    Material material = microfacets<Distribution::ggx>(roughness);
    material.cook_torrance.albedo = glm::vec3(0.8f);
    material.cook_torrance.metallic = 0.0f;
    return material;
}

Material ward_round(float roughness) {
    Material material = local(ReflectionModel::ward, 0.0f);
    material.phong.ward_alpha = glm::vec2(roughness * roughness);
    return material;
}

Material ward_brushed(float roughness) {
    Material material = ward_round(roughness);
    const float alpha = roughness * roughness;
    material.phong.ward_alpha = glm::vec2(std::max(0.25f * alpha, 0.002f), alpha);
    return material;
}

/// An orthonormal frame whose third vector is z.
struct Frame {
    glm::dvec3 x, y, z;
};

Frame frame_about(const glm::dvec3& z) {
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), z));
    return {x, glm::cross(z, x), z};
}

}  // namespace

const std::vector<LobeModel>& lobe_models() {
    static const std::vector<LobeModel> models = {
        {"lambert", "Lambert", false, true, [](float) { return local(ReflectionModel::lambert, 0.0f); }},
        {"phong", "Phong", true, false, [](float r) { return local(ReflectionModel::phong, 0.25f * exponent_of(r)); }},
        {"blinn_phong", "Blinn-Phong", true, false,
         [](float r) { return local(ReflectionModel::blinn_phong, exponent_of(r)); }},
        {"ward", "Ward", true, false, ward_round},
        {"ward_brushed", "Ward, brushed (four times as wide across the grain)", true, false, ward_brushed},
        {"heidrich_seidel", "Heidrich-Seidel, threads", true, false,
         [](float r) { return local(ReflectionModel::heidrich_seidel, 0.25f * exponent_of(r)); }},
        {"ggx", "Cook-Torrance with GGX, a white metal", true, true, microfacets<Distribution::ggx>},
        {"beckmann", "Cook-Torrance with Beckmann, a white metal", true, true, microfacets<Distribution::beckmann>},
        {"facets_blinn_phong", "Cook-Torrance with Blinn-Phong facets, a white metal", true, true,
         microfacets<Distribution::blinn_phong>},
        {"facets_gaussian", "Cook-Torrance with Gaussian facets, a white metal", true, true,
         microfacets<Distribution::gaussian>},
        {"plastic", "Cook-Torrance with GGX, a white plastic", true, false, plastic},
    };
    return models;
}

Reflector make_reflector(const LobeModel& model, float roughness) {
    Reflector reflector{model.material(roughness), {}};
    if (reflector.material.model == ReflectionModel::cook_torrance)
        reflector.setup = lighting::prepare(reflector.material.cook_torrance);
    return reflector;
}

double brdf(const Reflector& reflector, const glm::dvec3& l, const glm::dvec3& v) {
    if (l.z <= 0.0 || v.z <= 0.0) return 0.0;
    lighting::PointMaterial point;
    point.model = reflector.material.model;
    point.phong = reflector.material.phong;
    point.setup = &reflector.setup;
    point.surface = reflector.setup.surface;
    const lighting::ReflectedTerms terms =
        lighting::reflect(point, glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(l), glm::vec3(v));
    const bool is_physical = point.model == ReflectionModel::cook_torrance;
    const double radiance = double(terms.diffuse.x) + double(terms.specular.x);
    return radiance / (l.z * (is_physical ? 1.0 : std::numbers::pi));
}

glm::dvec3 direction(double theta_deg, double phi_deg) {
    const double theta = glm::radians(theta_deg), phi = glm::radians(phi_deg);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double reflectance(const Reflector& reflector, double theta_deg, int steps) {
    const glm::dvec3 l = direction(theta_deg);
    const Frame frame = frame_about(direction(-theta_deg));
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        // The angle from the mirror direction is pi t^3: most cells lie where the lobe is.
        const double t = (i + 0.5) / steps, angle = std::numbers::pi * t * t * t;
        const double d_angle = 3.0 * std::numbers::pi * t * t / steps;
        for (int j = 0; j < 2 * steps; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / steps;
            const glm::dvec3 v =
                std::sin(angle) * (std::cos(phi) * frame.x + std::sin(phi) * frame.y) + std::cos(angle) * frame.z;
            if (v.z > 0.0) sum += brdf(reflector, l, v) * v.z * std::sin(angle) * d_angle;
        }
    }
    return sum * std::numbers::pi / steps;
}

}  // namespace kreda::tools
