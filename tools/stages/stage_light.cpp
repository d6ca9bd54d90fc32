// Stages from the pixel to the picture: the views of the passes, light by light, their sums, the film.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "raster/film.hpp"
#include "scene/render/light_depth.hpp"
#include "tools/draw/draw.hpp"
#include "tools/stages/stage.hpp"

namespace kreda::tools {

namespace {

using raster::Image;
using scene::Frame;
using scene::RenderPlan;
using scene::Scene;
using scene::View;

/// With more lights, only the first get pictures of their own.
constexpr std::size_t kMaxLightsShown = 8;

/// The plan of everything that somebody may look at.
RenderPlan full_plan(const Scene& scene) {
    return make_plan_for(scene, scene::PlanRequest{.prune = false});
}

std::vector<const View*> shown_views(const Scene& scene) {
    const RenderPlan plan = full_plan(scene);
    std::vector<const View*> views;
    for (const View& view : scene::all_views()) {
        if (can_show(plan, scene, view)) views.push_back(&view);
    }
    return views;
}

std::vector<std::size_t> lights_on(const Scene& scene) {
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].on) on.push_back(i);
    }
    return on;
}

/// What belongs to one light and goes dark with it: l, what arrives, its shadow, D, V, F.
bool is_of_one_light(const Scene& scene, const View& view) {
    const Scene dark = with_only_light(scene, scene.lights.size());
    return !can_show(full_plan(dark), dark, view);
}

std::vector<std::string> component_names(const View& view) {
    if (view.components == 1) return {std::string(view.name)};
    const bool in_space = view.scale == scene::ViewScale::direction || view.scale == scene::ViewScale::range;
    return in_space ? std::vector<std::string>{"x", "y", "z"} : std::vector<std::string>{"r", "g", "b"};
}

std::string legend_of(const View& view, const scene::ViewPicture& picture) {
    if (view.scale == scene::ViewScale::direction) return "x, y, z as red, green, blue: -1 dark, 1 bright";
    if (picture.ranges.empty()) return "";
    std::string legend = "dark to bright:";
    const std::vector<std::string> names = component_names(view);
    for (std::size_t i = 0; i < picture.ranges.size(); ++i) {
        char text[96];
        std::snprintf(text, sizeof text, " %s %.4g to %.4g", names[i].c_str(), picture.ranges[i].least,
                      picture.ranges[i].greatest);
        legend += (i ? "," : "") + std::string(text);
    }
    return legend;
}

Stage stage_of(const View& view, const Image& values, const Scene& scene) {
    const scene::ViewPicture picture = picture_of(view, values, scene);
    return {std::string(view.name),   std::string(view.name),  std::string(view.meaning),
            legend_of(view, picture), as_rgb(picture.encoded), values,
            component_names(view)};
}

std::string without_all_lights(std::string meaning, const std::string& light) {
    for (const std::string_view words : {"the last light that is on", "all lights"}) {
        const std::size_t at = meaning.find(words);
        if (at != std::string::npos) meaning.replace(at, words.size(), light);
    }
    return meaning;
}

/// What the light sees has a size of its own: it is shown as large as it fits into the picture.
Stage light_depth_stage(const scene::RenderBuffers& buffers, const Scene& scene) {
    const int width = scene.image.width, height = scene.image.height;
    const Image distances = light_depth(buffers);
    Stage stage = stage_of(scene::light_depth_view(), distances, scene);
    stage.picture = fit(stage.picture, width, height, develop(make_board(1, 1), {}).rgb(0, 0));
    stage.values = fit(distances, width, height, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    return stage;
}

/// What one light does: the scene with all others off.
void visit_one_light(const Scene& scene, std::size_t light, const std::vector<const View*>& of_one_light,
                     const StageVisitor& visit) {
    const Scene alone = with_only_light(scene, light);
    std::vector<const View*> views = of_one_light;
    const bool lit_early = scene.shading.frequency != scene::ShadingFrequency::phong;
    for (const char* name : {"diffuse", "specular"}) {
        if (!lit_early) views.push_back(scene::find_view(name));
    }
    if (lit_early) views.push_back(scene::find_view("radiance"));
    const RenderPlan plan = full_plan(alone);
    std::erase_if(views, [&](const View* view) { return !can_show(plan, alone, *view); });
    scene::RenderBuffers buffers;
    render(alone, make_plan_for(alone, scene::PlanRequest{.views = views, .prune = false}), buffers);
    const auto visit_stage = [&](Stage stage) {
        const std::string number = std::to_string(light);
        stage.name = "light_" + number + "_" + stage.name;
        stage.title = "light." + number + ": " + stage.title;
        stage.meaning = without_all_lights(stage.meaning, "this light");
        visit(stage);
    };
    if (can_show(plan, alone, scene::light_depth_view())) visit_stage(light_depth_stage(buffers, scene));
    for (std::size_t i = 0; i < views.size(); ++i) {
        Stage stage = stage_of(*views[i], buffers.views[i], scene);
        if (lit_early) stage.meaning = "the picture with this light alone";
        visit_stage(std::move(stage));
    }
}

/// What is brighter than 1 is marked: a display cannot show it without a tone map.
Stage hdr_stage(const Frame& frame) {
    const Image& film = frame.buffers.film;
    Image picture = film;
    bool any = false;
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const glm::vec3 L = film.rgb(x, y) * frame.scene.image.exposure;
            const bool too_bright = std::max({L.x, L.y, L.z}) > 1.0f;
            any |= too_bright;
            if (too_bright && (x + y) % 6 < 3) picture.set_rgb(x, y, kRed);
        }
    }
    return {"radiance",
            "HDR radiance",
            "linear RGB on the film, before exposure and tone map",
            any ? "striped: times exposure brighter than 1" : "",
            develop(picture, {}),
            film,
            {"r", "g", "b"}};
}

Stage tone_mapped_stage(const Frame& frame) {
    const scene::ImageSettings& i = frame.scene.image;
    const Image mapped =
        develop(frame.buffers.film, {i.exposure, i.tone_map, i.white, raster::Transfer::linear, i.gamma});
    return {"tone_mapped",
            "tone-mapped",
            "after exposure and tone map, cut off at 0 and 1: still linear, so it looks too dark",
            "",
            mapped,
            mapped,
            {"r", "g", "b"}};
}

Stage final_stage(const Frame& frame) {
    const scene::ImageSettings& i = frame.scene.image;
    const Image encoded = develop(frame.buffers.film, {i.exposure, i.tone_map, i.white, i.transfer, i.gamma});
    Image bytes = encoded;
    for (float& value : bytes.values) value = std::round(255.0f * value);
    return {"final", "final",        "after the transfer function: the PNG that kreda render writes", "", encoded,
            bytes,   {"r", "g", "b"}};
}

}  // namespace

Scene with_only_light(const Scene& scene, std::size_t light) {
    Scene one = scene;
    for (std::size_t i = 0; i < one.lights.size(); ++i) one.lights[i].on = i == light;
    return one;
}

void visit_light_stages(const Frame& frame, const StageVisitor& visit) {
    const std::vector<const View*> views = frame.plan.views;
    std::vector<const View*> of_one_light;
    std::copy_if(views.begin(), views.end(), std::back_inserter(of_one_light),
                 [&](const View* view) { return is_of_one_light(frame.scene, *view); });
    const auto visit_view = [&](std::size_t i) { visit(stage_of(*views[i], frame.buffers.views[i], frame.scene)); };
    const auto is_own = [&](const View* view) {
        return std::find(of_one_light.begin(), of_one_light.end(), view) != of_one_light.end();
    };
    const View* const radiance = scene::find_view("radiance");
    const auto after_lights = [&](const View* view) { return view->name == "ambient" || view->name == "fog"; };
    const auto first_of_light =
        std::find_if(views.begin(), views.end(), [&](const View* v) { return is_own(v) || after_lights(v); }) -
        views.begin();
    for (std::size_t i = 0; i < static_cast<std::size_t>(first_of_light); ++i) {
        if (views[i] != radiance) visit_view(i);
    }
    const std::vector<std::size_t> lights = lights_on(frame.scene);
    const bool worth_it = !frame.scene.objects.empty() && (lights.size() > 1 || !of_one_light.empty());
    for (std::size_t k = 0; k < std::min(lights.size(), kMaxLightsShown) && worth_it; ++k) {
        visit_one_light(frame.scene, lights[k], of_one_light, visit);
    }
    for (std::size_t i = static_cast<std::size_t>(first_of_light); i < views.size(); ++i) {
        if (views[i] != radiance && !is_own(views[i])) visit_view(i);
    }
    visit(hdr_stage(frame));
    visit(tone_mapped_stage(frame));
    visit(final_stage(frame));
}

void for_each_stage(const Scene& scene, const StageVisitor& visit, int threads) {
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, shown_views(scene)), buffers, threads, [&](const Frame& frame) {
        visit_geometry_stages(frame, visit);
        visit_light_stages(frame, visit);
    });
}

}  // namespace kreda::tools
