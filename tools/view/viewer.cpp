#include "tools/view/viewer.hpp"

#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "raster/film.hpp"
#include "scene/files/hash_of_bytes.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/files/overrides.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/toml_check.hpp"
#include "scene/render/light_depth.hpp"
#include "tools/keys_json.hpp"
#include "tools/mesh_scene.hpp"
#include "tools/view/scene_text.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;
using scene::Scene;
using scene::UserError;

std::string text_of_file(const std::string& path) {
    const std::ifstream file(path, std::ios::binary);
    if (!file) throw UserError(scene::Place{path}, "cannot be opened");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The mesh is named as it was given, so that a saved scene file beside it finds it.
std::string scene_around_file(const std::string& path, scene::LoadedFiles& files) {
    std::string text = scene_around_mesh(path, *load_mesh(&files, path, {}));
    const std::string whole = std::filesystem::absolute(path).string();
    const std::size_t at = text.find(whole);
    if (at != std::string::npos) text.replace(at, whole.size(), std::filesystem::path(path).filename().string());
    return text;
}

/// The text of the scene that is shown for a file.
std::string scene_text_for(const std::string& path, scene::LoadedFiles& files) {
    if (path.empty()) return scene::built_in_scene_text();
    if (is_mesh_file(path)) return scene_around_file(path, files);
    const std::string other = scene::other_format(path);
    if (!other.empty()) throw UserError(scene::Place{path}, other);
    return text_of_file(path);
}

scene::Value changed_tree(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
    scene::Value root = scene::parse_toml(text, name);
    scene::check_tables(root);
    scene::apply_overrides(root, overrides);
    return root;
}

/// Everything that the scene names, whatever the camera sees: the plan serves until a value is changed.
scene::PlanRequest request_for(const scene::View* view) {
    if (!view || scene::is_light_depth(view)) return {.prune = false};
    return {.views = {view}, .film = false, .prune = false};
}

Json json_of(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json views_of(const Viewer& viewer) {
    const scene::RenderPlan plan = make_plan_for(viewer.scene, request_for(nullptr));
    Json views = Json::array();
    for (const scene::View* view : scene::known_views()) {
        Json entry;
        entry["name"] = view->name;
        entry["meaning"] = view->meaning;
        if (!can_show(plan, viewer.scene, *view)) entry["requires"] = view->requires_what;
        views.push_back(entry);
    }
    return views;
}

std::uint8_t byte_of(float radiance, const raster::FilmSettings& settings) {
    return scene::byte_from_encoded(raster::display_value(radiance, settings));
}

bool same(const raster::FilmSettings& a, const raster::FilmSettings& b) {
    return a.exposure == b.exposure && a.tone_map == b.tone_map && a.white == b.white && a.transfer == b.transfer &&
           a.gamma == b.gamma;
}

/// What is shown rises with radiance: the first float that gives more than the least one is found by halving.
DisplayStep step_of(std::uint32_t high, const raster::FilmSettings& settings) {
    const auto shown = [&](std::uint32_t low) { return byte_of(std::bit_cast<float>(high << 16 | low), settings); };
    const int first = shown(0), last = shown(0xffffu);
    if (first == last) return {std::numeric_limits<float>::quiet_NaN(), first};
    if (last != first + 1) return {0.0f, -1};
    std::uint32_t below = 0, above = 0xffffu;
    while (above - below > 1) {
        const std::uint32_t middle = (below + above) / 2;
        (shown(middle) == first ? below : above) = middle;
    }
    return {std::bit_cast<float>(high << 16 | above), first};
}

void prepare_display(const raster::FilmSettings& settings, DisplayBytes& display) {
    if (!display.steps.empty() && same(settings, display.settings)) return;
    display.settings = settings;
    display.steps.clear();
    for (std::uint32_t high = 0; high < 1u << 16; ++high) display.steps.push_back(step_of(high, settings));
}

std::uint8_t shown_byte(float radiance, const DisplayBytes& display) {
    const DisplayStep& step = display.steps[std::bit_cast<std::uint32_t>(radiance) >> 16];
    if (step.first < 0) return byte_of(radiance, display.settings);
    return static_cast<std::uint8_t>(step.first + (radiance >= step.next ? 1 : 0));
}

void put_film_on_screen(const raster::Image& film, const DisplayBytes& display, ScreenPicture& picture) {
    picture.width = film.width;
    picture.height = film.height;
    const std::size_t count = film.plane_size();
    picture.rgba.assign(4 * count, 255);
    for (std::size_t c = 0; c < 3; ++c) {
        const float* const plane = film.plane(static_cast<int>(c));
        for (std::size_t i = 0; i < count; ++i) { picture.rgba[4 * i + c] = shown_byte(plane[i], display); }
    }
}

/// What the display shows of the chosen view, 1 or 3 channels.
raster::Image encoded_view(const Viewer& viewer) {
    const scene::RenderBuffers& buffers = viewer.buffers;
    if (scene::is_light_depth(viewer.view)) return picture_of(*viewer.view, light_depth(buffers), viewer.scene).encoded;
    return picture_of(*viewer.view, buffers.views[0], viewer.scene).encoded;
}

void put_on_screen(const raster::Image& encoded, ScreenPicture& picture) {
    picture.width = encoded.width;
    picture.height = encoded.height;
    const std::size_t count = encoded.plane_size();
    picture.rgba.assign(4 * count, 255);
    for (int c = 0; c < 3; ++c) {
        const float* const plane = encoded.plane(encoded.channels == 1 ? 0 : c);
        for (std::size_t i = 0; i < count; ++i) {
            picture.rgba[4 * i + static_cast<std::size_t>(c)] = scene::byte_from_encoded(plane[i]);
        }
    }
}

}  // namespace

void open_scene(Viewer& viewer, const std::string& path, const std::vector<std::string>& overrides) {
    const std::string text = scene_text_for(path, viewer.files);
    const std::string name = path.empty() ? "built-in scene" : path;
    const scene::ReadOptions options{.overrides = overrides, .files = &viewer.files};
    Scene scene = read_scene_text(text, name, std::filesystem::path(path).parent_path().string(), options);
    forget_unused(viewer.files);
    viewer.path = path;
    viewer.text = text;
    viewer.tree = changed_tree(text, name, overrides);
    viewer.scene = std::move(scene);
    viewer.is_planned = false;
}

nlohmann::ordered_json describe(const Viewer& viewer) {
    const Scene& scene = viewer.scene;
    Json description;
    description["file"] = viewer.path;
    description["warnings"] = scene.warnings;
    description["size"] = {scene.image.width, scene.image.height};
    description["samples"] = scene.image.samples;
    description["camera"] = {{"position", json_of(glm::dvec3(scene.camera.position) + scene.origin)},
                             {"target", json_of(glm::dvec3(scene.camera.target) + scene.origin)},
                             {"up", json_of(scene.camera.up)}};
    description["tables"] = as_json(viewer.tree);
    description["views"] = views_of(viewer);
    return description;
}

void move_camera(Viewer& viewer, const CameraPose& pose) {
    viewer.scene.camera.position = glm::vec3(pose.position - viewer.scene.origin);
    viewer.scene.camera.target = glm::vec3(pose.target - viewer.scene.origin);
    viewer.scene.camera.up = glm::vec3(pose.up);
}

void set_size(Viewer& viewer, int width, int height, int samples) {
    scene::ImageSettings& image = viewer.scene.image;
    const int wanted = samples > 0 ? samples : image.samples;
    if (image.width == width && image.height == height && image.samples == wanted) return;
    image.width = width;
    image.height = height;
    image.samples = wanted;
    viewer.is_planned = false;
}

void choose_view(Viewer& viewer, const std::string& name) {
    const scene::View* chosen = nullptr;
    for (const scene::View* view : scene::known_views()) {
        if (view->name == name) chosen = view;
    }
    if (!chosen && !name.empty()) throw UserError("there is no view '" + name + "'");
    if (chosen != viewer.view) viewer.is_planned = false;
    viewer.view = chosen;
}

double draw(Viewer& viewer) {
    if (!viewer.is_planned) {
        const scene::RenderPlan whole = make_plan_for(viewer.scene, request_for(nullptr));
        if (viewer.view && !can_show(whole, viewer.scene, *viewer.view)) {
            throw UserError("the view " + std::string(viewer.view->name) + " has nothing to show here; it needs " +
                            std::string(viewer.view->requires_what));
        }
        viewer.plan = make_plan_for(viewer.scene, request_for(viewer.view));
        viewer.is_planned = true;
    }
    const scene::RenderStatistics statistics = render(viewer.scene, viewer.plan, viewer.buffers);
    if (viewer.view) {
        put_on_screen(encoded_view(viewer), viewer.picture);
    } else {
        prepare_display(film_settings(viewer.scene.image), viewer.display);
        put_film_on_screen(viewer.buffers.film, viewer.display, viewer.picture);
    }
    return statistics.times.total_ms;
}

std::uint64_t hash_of_film(const Viewer& viewer) {
    return scene::hash_of_bytes(std::as_bytes(std::span(viewer.buffers.film.values)));
}

std::string changed_text(const Viewer& viewer, const std::vector<std::string>& overrides) {
    return text_of_scene(changed_tree(viewer.text, viewer.path, overrides));
}

}  // namespace kreda::tools
