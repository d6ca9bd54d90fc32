// Scenes on which methods of finding shadows have failed, each with a name. All methods are held against the exact
// shadow on them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shadow_scene.hpp"
#include "tests/raster/random_scenes.hpp"

namespace kreda::tests {

struct HardCase {
    std::string name;
    std::function<void(ShadowScene&)> build;
    bool looks_along_light = false;
};

/// A floor at y = -1 and things on it.
inline void add_room(ShadowScene& scene) {
    scene.add("plane", 8, {0.0f, -1.0f, 0.0f}, glm::vec3(5.0f));
    scene.add("torus", 24, {0.1f, 0.3f, 0.0f});
    scene.add("cube", 2, {-1.9f, -0.6f, 0.4f}, glm::vec3(0.35f));
    scene.add("sphere", 20, {1.7f, -0.2f, 1.1f}, glm::vec3(0.5f));
    scene.camera.position = {1.0f, 2.2f, 6.0f};
    scene.camera.target = {0.0f, -0.3f, 0.0f};
}

/// Triangles that share no edge, some without area, some twice.
inline raster::Mesh loose_triangles(std::uint32_t seed) {
    Random random(seed);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 a = random.in_box(2.0f);
        const glm::vec3 b = a + random.in_box(0.8f), c = a + random.in_box(0.8f);
        corners.insert(corners.end(), {a, b, random.integer(0, 9) == 0 ? b : c});
        if (random.integer(0, 9) == 0) corners.insert(corners.end(), {a, b, c});
    }
    return mesh_of(corners);
}

inline std::vector<HardCase> hard_cases() {
    using S = ShadowScene;
    const auto in_room = [](const shadows::ShadowLight& light) {
        return [light](S& s) {
            add_room(s);
            s.light = light;
        };
    };
    std::vector<HardCase> cases;
    const auto add = [&](const std::string& name, std::function<void(S&)> build) {
        cases.push_back({name, std::move(build)});
    };
    add("directional", in_room(directional_light({-1, -1.3f, -0.6f})));
    add("point", in_room(point_light({2, 3, 2})));
    add("light inside the scene", in_room(point_light({-0.9f, -0.4f, 0.9f})));
    add("light inside a closed object", in_room(point_light({1.7f, -0.2f, 1.1f})));
    add("light behind the camera", in_room(point_light({1.3f, 2.9f, 9.0f})));
    add("light at the camera", in_room(point_light({1.0f, 2.2f, 6.0f})));
    cases.back().looks_along_light = true;
    add("light below the floor", in_room(point_light({0.5f, -2.5f, 0.3f})));
    add("light in the floor's plane", in_room(point_light({4.0f, -1.0f, 1.0f})));
    add("low sun", in_room(directional_light({-1, -0.02f, -0.1f})));
    add("sun from below", in_room(directional_light({-0.4f, 1, 0.2f})));
    add("toward the camera", in_room(directional_light({0.15f, 0.35f, 1})));
    add("along an axis", in_room(directional_light({0, -1, 0})));
    add("camera in the shadow", [](S& s) {
        add_room(s);
        s.camera.position = {-0.2f, -0.7f, 0.3f};
        s.camera.target = {-1.5f, -0.8f, 1.5f};
        s.light = directional_light({0.1f, -1, 0.1f});
    });
    add("camera inside the caster", [](S& s) {
        add_room(s);
        s.cull = raster::CullMode::none;
        s.camera.position = {0.9f, 0.32f, 0.02f};
        s.camera.target = {0.5f, 0.2f, 1.0f};
        s.light = point_light({0.3f, 3.5f, 0.5f});
    });
    add("caster outside the view", [](S& s) {
        add_room(s);
        s.add("torus_knot", 48, {-2.0f, 4.5f, 3.0f});
        s.light = directional_light({0.5f, -1, -0.7f});
    });
    add("caster behind the far plane", [](S& s) {
        add_room(s);
        s.camera.far = 9.0f;
        s.add("sphere", 20, {0.0f, 2.0f, -9.0f}, glm::vec3(2.0f));
        s.light = point_light({0.0f, 5.0f, -20.0f});
    });
    add("receiver through the near plane", [](S& s) {
        add_room(s);
        s.camera.near = 2.5f;
        s.camera.position = {0.8f, -0.3f, 2.5f};
        s.light = point_light({2, 3, 2});
    });
    add("orthographic", [](S& s) {
        add_room(s);
        s.camera.projection = raster::Projection::orthographic;
        s.camera.height = 5.0f;
        s.light = point_light({2, 3, 2});
    });
    add("orthographic along the light", [](S& s) {
        add_room(s);
        s.camera.projection = raster::Projection::orthographic;
        s.camera.height = 5.0f;
        s.camera.position = {0.0f, 5.0f, 3.0f};
        s.light = directional_light({0.0f, -5.3f, -3.0f});
    });
    cases.back().looks_along_light = true;
    add("orthographic along the light below the caster", [](S& s) {
        add_room(s);
        s.camera.projection = raster::Projection::orthographic;
        s.camera.height = 5.0f;
        s.camera.position = {0.0f, 5.0f, 3.0f};
        s.light = directional_light({0.0f, -5.3f, -3.0f});
        s.add("torus_knot", 48, {0.3f, 9.0f, 5.2f});
    });
    add("loose and degenerate triangles", [](S& s) {
        s.add("plane", 8, {0.0f, -1.5f, 0.0f}, glm::vec3(5.0f));
        s.cull = raster::CullMode::none;
        s.add(loose_triangles(7));
        s.light = point_light({0.3f, 4, 1});
    });
    add("open mesh seen from both sides", [](S& s) {
        s.add("plane", 8, {0.0f, -1.5f, 0.0f}, glm::vec3(5.0f));
        s.cull = raster::CullMode::none;
        s.add("teapot", 6, {0.0f, -0.7f, 0.0f}, glm::vec3(1.5f));
        s.light = directional_light({-1, -1.1f, 0.3f});
    });
    add("mirrored object", [](S& s) {
        s.add("plane", 8, {0.0f, -1.0f, 0.0f}, glm::vec3(5.0f));
        s.add("torus_knot", 48, {0, 0.2f, 0}, {-1, 1, 1});
        s.light = point_light({2, 3, 2});
    });
    return cases;
}

}  // namespace kreda::tests
