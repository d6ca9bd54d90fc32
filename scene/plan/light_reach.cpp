#include "scene/plan/light_reach.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/light_sample.hpp"

namespace kreda::scene {

namespace {

using lighting::LightSetup;
using lighting::LightType;

/// Interpolated vectors are rounded: what is within this share of a right angle counts as facing the light.
constexpr float kFacing = -1e-5f;

/// l at a corner, any length.
glm::vec3 to_light(const LightSetup& light, const glm::vec3& p) {
    return light.type == LightType::directional ? -light.axis : light.position - p;
}

/// n.l between the corners is a mean of the products of all corners' n with all corners' l: where none of these is
/// positive, it is not.
bool faces(const LightSetup& light, const LitTriangle& t) {
    for (const glm::vec3& n : t.normal) {
        for (const glm::vec3& p : t.position) {
            const glm::vec3 l = to_light(light, p);
            const float least = kFacing * std::sqrt(glm::dot(n, n) * glm::dot(l, l));
            if (!(glm::dot(n, l) <= least)) return true;  // NaN: not certain
        }
    }
    return false;
}

/// Does the ball around the triangle touch the spot's cone?
bool in_cone(const LightSetup& light, const LitTriangle& t) {
    const glm::vec3 centre = (t.position[0] + t.position[1] + t.position[2]) / 3.0f;
    float radius = 0.0f;
    for (const glm::vec3& p : t.position) radius = std::max(radius, glm::length(p - centre));
    const glm::vec3 away = centre - light.position;
    const float distance = glm::length(away);
    if (!(distance > radius)) return true;
    const float angle = std::acos(std::clamp(glm::dot(away, light.axis) / distance, -1.0f, 1.0f));
    const float half_ball = std::asin(std::min(radius / distance, 1.0f));
    const float half_cone = std::acos(std::clamp(light.cos_outer, -1.0f, 1.0f));
    constexpr float kRounding = 1e-3f;
    return !(angle > half_cone + half_ball + kRounding);
}

}  // namespace

bool reaches_point(const LightSetup& light, const glm::vec3& p, const glm::vec3& n, bool any_normal) {
    lighting::LightSample arrives;
    switch (light.type) {
        case LightType::directional: arrives = sample_directional(light); break;
        case LightType::point: arrives = sample_point(light, p); break;
        case LightType::spot: arrives = sample_spot(light, p); break;
    }
    if (arrives.irradiance == glm::vec3(0.0f)) return false;
    const float least = kFacing * glm::length(n);  // |l| = 1
    return any_normal || !(glm::dot(n, arrives.l) <= least);
}

bool may_reach(const LightSetup& light, const LitTriangle& triangle) {
    if (light.type == LightType::spot && !in_cone(light, triangle)) return false;
    return triangle.any_normal || faces(light, triangle);
}

}  // namespace kreda::scene
