// The directions of a pixel's derivation as lines on the picture.
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "lighting/reflection.hpp"
#include "tools/explain/explain.hpp"
#include "tools/view/viewer.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;

/// The last equation of that name in a section.
std::optional<glm::vec3> vector_of(const Section& section, const std::string& symbol) {
    std::optional<glm::vec3> found;
    for (const Item& item : section.items) {
        const Equation* equation = std::get_if<Equation>(&item);
        if (!equation || equation->symbol != symbol || equation->value.size() != 3) continue;
        found = glm::vec3(equation->value[0], equation->value[1], equation->value[2]);
    }
    return found;
}

/// From the world to pixels of the picture.
struct Projector {
    glm::mat4 clip_from_world;
    int width = 0, height = 0;

    [[nodiscard]] Json operator()(const glm::vec3& p) const {
        const glm::vec4 clip = clip_from_world * glm::vec4(p, 1.0f);
        if (!(clip.w > 0.0f)) return nullptr;
        const glm::vec2 ndc = glm::vec2(clip) / clip.w;
        return Json::array(
            {(0.5f + 0.5f * ndc.x) * static_cast<float>(width), (0.5f - 0.5f * ndc.y) * static_cast<float>(height)});
    }
};

/// World units at p that are a fifth of the picture's height.
float arrow_length(const raster::Camera& camera, const glm::vec3& p) {
    constexpr float kShare = 0.2f;
    if (camera.projection == raster::Projection::orthographic) return kShare * camera.height;
    const float half_height = std::tan(glm::radians(0.5f * camera.vertical_fov_deg));
    return kShare * 2.0f * half_height * glm::length(p - camera.position);
}

Json vectors_of(const Viewer& viewer, const Derivation& derivation) {
    const scene::Scene& scene = viewer.scene;
    std::optional<glm::vec3> p, n, v;
    Json arrows = Json::array();
    for (const Section& section : derivation.sections) {
        if (!p) p = vector_of(section, "p");
        if (!n) n = vector_of(section, "n");
        if (!v) v = vector_of(section, "v");
        if (!p || !n || !v) continue;
        const float length = arrow_length(scene.camera, *p);
        const Projector project{clip_from_world(scene.camera, raster::aspect_of(scene.image.width, scene.image.height)),
                                scene.image.width, scene.image.height};
        const auto add = [&](const char* name, const glm::vec3& direction, const std::string& of) {
            arrows.push_back(
                {{"name", name}, {"of", of}, {"from", project(*p)}, {"to", project(*p + length * direction)}});
        };
        if (arrows.empty()) {
            add("n", *n, "");
            add("v", *v, "");
        }
        const std::optional<glm::vec3> l = vector_of(section, "l");
        if (!l) continue;
        add("l", *l, section.title);
        add("h", lighting::half_vector(*l, *v), section.title);
        add("r", lighting::mirror_vector(*n, *l), section.title);
    }
    return arrows;
}

}  // namespace

nlohmann::ordered_json explain_on_screen(const Viewer& viewer, int x, int y) {
    scene::Scene scene = viewer.scene;
    scene.environment.prepared = viewer.buffers.environment;  // baked by the picture already
    const Explanation explanation = explain_pixel(scene, {x, y}, 1);
    Json told;
    told["text"] = as_text(explanation.derivation);
    told["vectors"] = vectors_of(viewer, explanation.derivation);
    return told;
}

}  // namespace kreda::tools
