// Which lights cast shadows, which objects throw them, and how large a light's picture must be.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "shadows/planar.hpp"
#include "shadows/shadow_map.hpp"

namespace kreda::scene {

/// A flat object, onto which method = "planar" casts shadows.
struct ShadowReceiver {
    int object = 0;         ///< index into scene.objects
    glm::dvec4 plane{0.0};  ///< shadows/planar.hpp
};

/// One light's shadows.
struct PlannedShadow {
    int light = 0;             ///< index into scene.lights
    int light_that_is_on = 0;  ///< the same, counting only those that are on
    shadows::ShadowLight source;
    std::vector<int> casters;               ///< indices into scene.objects
    shadows::ShadowMapPlan map;             ///< for method = "map"; its settings are those of any method
    std::vector<ShadowReceiver> receivers;  ///< method = "planar"
};

/// What a scene's lights cast, and for each light that casts nothing, why not.
struct ShadowPlan {
    std::vector<PlannedShadow> shadows;  ///< in the order of the lights
    std::vector<std::string> why_not;    ///< one for each light with shadow = true that needs none after all
};

/// "light 2 (spot)", by its number in scene.lights.
[[nodiscard]] std::string name_of_light(const lighting::Light& light, std::size_t index);

/// `only_visible`: points outside the picture are not lit (shading.frequency = "phong"), so nothing need fall on them.
/// `shines`: for each light whether it is added to anything; what is not needs no shadow.
[[nodiscard]] ShadowPlan plan_shadows(const Scene& scene, bool only_visible, const std::vector<bool>& shines);

}  // namespace kreda::scene
