#include "scene/plan/left_out.hpp"

#include <algorithm>

#include "scene/map_meshes.hpp"

namespace kreda::scene {

namespace {

struct LeftOutList {
    std::vector<LeftOutPass>& list;

    void add(bool absent, std::string name, std::string why_not) {
        if (absent) list.push_back({std::move(name), std::move(why_not)});
    }
};

bool holds(const RenderPlan& plan, std::string_view name) {
    return std::any_of(plan.passes.begin(), plan.passes.end(),
                       [&](const PlannedPass& pass) { return pass.name.starts_with(name); });
}

std::string why_no_sides(const RenderPlan& plan) {
    if (plan.cull == raster::CullMode::back) return "shading.cull = \"back\": no back is seen";
    if (!plan.two_sided) return "shading.two_sided = false: a back takes the light of its front";
    if (plan.frequency == ShadingFrequency::flat)
        return "shading.frequency = \"flat\": a triangle's normal is that of its winding";
    return "every seen triangle's normals agree with its winding";
}

void add_frequencies(const RenderPlan& plan, LeftOutList& list) {
    const auto other = [&](ShadingFrequency frequency, const char* name, const char* why) {
        list.add(plan.frequency != frequency, name, why);
    };
    other(ShadingFrequency::gouraud, "light vertices", "only shading.frequency = \"gouraud\" lights vertices");
    other(ShadingFrequency::flat, "light triangles", "only shading.frequency = \"flat\" lights triangles");
    other(ShadingFrequency::phong, "light pixels", "only shading.frequency = \"phong\" lights pixels");
    list.add(!holds(plan, "interpolate"), "interpolate",
             plan.frequency == ShadingFrequency::flat && plan.draws_objects
                 ? "shading.frequency = \"flat\" in clear air: a triangle has one colour"
                 : "nothing that varies over a triangle is asked for");
    list.add(!plan.finds_sides, "sides", why_no_sides(plan));
}

/// Who wears each of the materials, by name.
std::vector<std::string> collect_wearers(const Scene& scene) {
    std::vector<std::string> wearers(scene.materials.size());
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const std::string name = name_of_object(scene, o);
        for (const int m : scene.objects[o].part_material) {
            std::string& names = wearers[static_cast<std::size_t>(m)];
            if (!names.ends_with(name)) names += (names.empty() ? "" : ", ") + name;
        }
    }
    return wearers;
}

std::string worn_by(const std::string& names) {
    return names.empty() ? "worn by nothing" : "worn by " + names + ", of which nothing is seen";
}

void add_unseen(const Scene& scene, const RenderPlan& plan, LeftOutList& list) {
    if (!plan.seen) return;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const SeenObject& object = plan.seen->objects[o];
        list.add(object.samples == 0, name_of_object(scene, o),
                 "none of its " + std::to_string(scene.objects[o].mesh->triangle_count()) +
                     " triangles is seen: " + why_unseen(scene.objects[o], object.triangles));
    }
    const std::vector<std::string> wearers = collect_wearers(scene);
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        list.add(!plan.lighting.seen[m], "material " + scene.materials[m].name, worn_by(wearers[m]));
    }
}

std::string why_no_light(const Scene& scene, const RenderPlan& plan, std::size_t k) {
    const lighting::Light& light = scene.lights[k];
    if (!light.on) return "on = false";
    if (light.color * light.intensity == glm::vec3(0.0f)) return "color times intensity is 0";
    if (!plan.wanted.lamps) return "what is asked for does not look at it";
    if (!plan.seen || !any_of(plan.seen->reached[k]))
        return light.type == lighting::LightType::spot ? "nothing that is seen lies in its cone and faces it"
                                                       : "nothing that is seen faces it";
    return "what it reaches reflects no lamp";
}

void add_lights(const Scene& scene, const RenderPlan& plan, LeftOutList& list) {
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        list.add(!any_of(plan.lighting.lamps[k]), name_of_light(scene.lights[k], k), why_no_light(scene, plan, k));
    }
}

std::string why_no_environment(const Scene& scene, const RenderPlan& plan) {
    if (!scene.environment.on) return "there is no [environment] that a lit material or the background shows";
    if (scene.environment.intensity == 0.0f) return "environment.intensity = 0";
    if (!plan.wanted.environment) return "what is asked for does not look at it";
    return "no material that is seen reflects it (ao = 0, black or unlit), and no background is seen";
}

void add_environment_parts(const Scene& scene, const RenderPlan& plan, LeftOutList& list) {
    const lighting::EnvironmentNeeds& needs = plan.environment;
    list.add(!needs.any(), "environment", why_no_environment(scene, plan));
    list.add(needs.any() && !needs.blurred, "prefiltered levels and brdf map",
             "no visible material is cook_torrance, or environment.reference integrates without them");
    list.add(needs.any() && !needs.irradiance && scene.environment.reference == 0, "bake irradiance",
             "what is seen of the environment is mirrored: metals, or the background alone");
}

std::string why_no_fog(const Scene& scene, const RenderPlan& plan) {
    if (scene.fog.mode == lighting::FogMode::none) return "fog.mode = \"none\"";
    if (!plan.draws_objects) return "no object is seen";
    if (!plan.wanted.fog) return "what is asked for does not look at it";
    return "it leaves everything that is seen clear: its density is 0, or its start lies behind it";
}

}  // namespace

std::string name_of_object(const Scene& scene, std::size_t object) {
    return "object " + std::to_string(object) + " (" + scene.objects[object].mesh_name + ")";
}

std::string why_unseen(const Object& object, const raster::TriangleCounts& triangles) {
    if (!object.on) return "on = false, so its mesh was not read";
    if (triangles.input == 0) return "all its parts are hidden";
    if (triangles.drawn > 0) return "others stand before it";
    if (triangles.culled == 0 && triangles.outside > 0) return "outside the picture, or between two samples";
    if (triangles.outside == 0 && triangles.culled > 0) return "they face away (shading.cull)";
    if (triangles.non_finite > 0 || triangles.degenerate > 0) return "without area, facing away or outside the picture";
    return "facing away or outside the picture";
}

void list_left_out(const Scene& scene, const std::vector<std::string>& no_shadows, RenderPlan& plan) {
    LeftOutList list{plan.left_out};
    add_unseen(scene, plan, list);
    add_frequencies(plan, list);
    list.add(!holds(plan, "maps of "), "maps", "no visible material has a map that its model reads");
    add_lights(scene, plan, list);
    add_environment_parts(scene, plan, list);
    list.add(!plan.fog_at_pixels && !plan.fog_at_vertices, "fog", why_no_fog(scene, plan));
    list.add(plan.draws_objects && !plan.shows_background, "background", "objects cover every sample");
    for (const std::string& why_not : no_shadows) list.add(true, "shadows", why_not);
    list.add(plan.shadows.empty() && no_shadows.empty(), "shadows", "no light that is on has shadow = true");
}

}  // namespace kreda::scene
