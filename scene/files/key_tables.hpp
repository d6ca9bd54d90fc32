// The table of all keys of a scene file, a function for each table of the file: its keys with the members they set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/files/key_rows.hpp"
#include "scene/files/place_scene.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// [camera]: the places in double, as the file says them; those of `camera` follow from place_scene().
struct CameraTable {
    raster::Camera camera;
    glm::dvec3 position{camera.position};
    glm::dvec3 target{camera.target};
    float orbit_deg = 0.0f;  ///< about the axis `up` through the target, counter-clockwise seen from above
};

/// [[light]]
struct LightTable {
    lighting::Light light;
    glm::dvec3 position{light.position};
};

/// [[object]]
struct ObjectTable {
    std::string mesh;           ///< a built-in shape or a file
    std::optional<int> detail;  ///< of a built-in shape
    Normals normals = Normals::file;
    std::optional<float> crease;
    std::string material;  ///< empty: the mesh's own
    ObjectPlacement placement;
    bool casts_shadow = true;
    bool on = true;
};

// Numbers outside of these are refused.
inline constexpr Range kAnyNumber{};
inline constexpr Range kPlace{-kFarthest, kFarthest};  // read in double; what matters is the distance to the camera
inline constexpr Range kNotNegative{0.0, 1e9};
inline constexpr Range kPositive{1e-9, 1e9};
inline constexpr Range kShare{0.0, 1.0};

[[nodiscard]] const std::vector<Key<ImageSettings>>& image_keys();
[[nodiscard]] const std::vector<Key<CameraTable>>& camera_keys();
[[nodiscard]] const std::vector<Key<ShadingSettings>>& shading_keys();
[[nodiscard]] const std::vector<Key<Scene>>& ambient_keys();
[[nodiscard]] const std::vector<Key<LightTable>>& light_keys();
[[nodiscard]] const std::vector<Key<shadows::ShadowSettings>>& shadow_keys();
[[nodiscard]] const std::vector<Key<lighting::Fog>>& fog_keys();
[[nodiscard]] const std::vector<Key<EnvironmentSettings>>& environment_keys();
[[nodiscard]] const std::vector<Key<lighting::Material>>& material_keys();
[[nodiscard]] const std::vector<Key<ObjectTable>>& object_keys();

}  // namespace kreda::scene
