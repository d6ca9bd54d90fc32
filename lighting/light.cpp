#include "lighting/light.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "lighting/light_sample.hpp"

namespace kreda::lighting {

LightSetup prepare(const Light& light) {
    LightSetup setup;
    setup.type = light.type;
    setup.position = light.position;
    setup.axis = glm::vec3(glm::normalize(glm::dvec3(light.direction)));
    setup.radiance = light.color * light.intensity;
    setup.attenuation = light.attenuation;
    setup.most_weight = kMostIrradiance / std::max({setup.radiance.x, setup.radiance.y, setup.radiance.z, 1.0f});
    setup.cos_inner = static_cast<float>(std::cos(glm::radians(double{light.inner_cone_deg})));
    setup.cos_outer = static_cast<float>(std::cos(glm::radians(double{light.outer_cone_deg})));
    return setup;
}

LightSample sample(const Light& light, const glm::vec3& p) {
    const LightSetup setup = prepare(light);
    switch (light.type) {
        case LightType::directional: return sample_directional(setup);
        case LightType::point: return sample_point(setup, p);
        case LightType::spot: return sample_spot(setup, p);
    }
    return {};
}

}  // namespace kreda::lighting
