#include "scene/files/read_scene.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <glm/geometric.hpp>

#include "scene/files/file_key.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/overrides.hpp"
#include "scene/files/place_scene.hpp"
#include "scene/files/read_environment.hpp"
#include "scene/files/read_materials.hpp"
#include "scene/files/read_objects.hpp"
#include "scene/files/toml_check.hpp"
#include "scene/files/unread_keys.hpp"
#include "scene/map_meshes.hpp"
#include "scene/shadow_warnings.hpp"
#include "scene/view_warnings.hpp"

namespace kreda::scene {

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t(16) << 20;
constexpr std::int64_t kMaxSide = 16384;  ///< in samples
constexpr std::int64_t kMaxSamples = std::int64_t(1) << 27;
constexpr double kLeastLength = 1e-9;  ///< shorter vectors have no direction in float
constexpr double kLeastSine = 1e-5;    ///< of the angle between up and the view direction

void check_sample_grid(const Value& table, const ImageSettings& image) {
    const std::int64_t columns = std::int64_t(image.width) * image.samples;
    const std::int64_t rows = std::int64_t(image.height) * image.samples;
    if (columns <= kMaxSide && rows <= kMaxSide && columns * rows <= kMaxSamples) return;
    const std::string asked = std::to_string(columns) + " x " + std::to_string(rows);
    const std::string largest = std::to_string(kMaxSide) + " a side and " + std::to_string(kMaxSamples) + " altogether";
    throw UserError(place_of(table, "size"),
                    "the image has " + asked + " samples (size x samples); the largest is " + largest);
}

/// "environment" is the only word that may stand there.
void read_background(const Value& table, ImageSettings& image) {
    const Value* background = find(table, "background");
    image.environment_background = background && background->kind == ValueKind::text;
    if (!image.environment_background) read(table, "background", image.background);
}

void check_background(const Value& root, const Scene& scene) {
    if (!scene.image.environment_background || scene.environment.on) return;
    throw UserError(find(*find(root, "image"), "background")->place,
                    "background = \"environment\" needs an [environment] that is on, e.g. sky = \"studio\"");
}

ImageSettings read_image(const Value& table) {
    ImageSettings image;
    if (const Value* size = find(table, "size")) {
        image.width = static_cast<int>(size->items[0].integer);
        image.height = static_cast<int>(size->items[1].integer);
    }
    read(table, "samples", image.samples);
    check_sample_grid(table, image);
    read_background(table, image);
    read(table, "exposure", image.exposure);
    read_word(table, "tone_map", image.tone_map);
    read(table, "white", image.white);
    read_word(table, "transfer", image.transfer);
    read(table, "gamma", image.gamma);
    return image;
}

void check_view(const Value& table, const Placements& placements, const raster::Camera& camera) {
    const glm::dvec3 view = placements.camera_target - placements.camera_position;
    const glm::dvec3 up(camera.up);
    const Place& place = place_of(table, find(table, "position") ? "position" : "target");
    if (glm::length(view) < kLeastLength) {
        throw UserError(place, "'position' and 'target' in [camera] are the same point; move one of them");
    }
    if (glm::length(up) < kLeastLength) {
        throw UserError(place_of(table, "up"), "'up' in [camera] has length 0; a direction is e.g. up = [0, 1, 0]");
    }
    const double sine = glm::length(glm::cross(view, up)) / (glm::length(view) * glm::length(up));
    if (sine < kLeastSine) {
        throw UserError(find(table, "up") ? place_of(table, "up") : place,
                        "'up' in [camera] is parallel to the view direction (target - position); choose another, "
                        "e.g. up = [0, 0, 1]");
    }
}

raster::Camera read_camera(const Value& table, Placements& placements) {
    raster::Camera camera;
    read(table, "position", placements.camera_position);
    read(table, "target", placements.camera_target);
    read(table, "up", camera.up);
    read_word(table, "projection", camera.projection);
    read(table, "vertical_fov", camera.vertical_fov_deg);
    read(table, "height", camera.height);
    read(table, "near", camera.near);
    read(table, "far", camera.far);
    check_view(table, placements, camera);
    if (camera.far <= camera.near) {
        const Place& place = place_of(table, find(table, "far") ? "far" : "near");
        throw UserError(place, "'far' in [camera] must be greater than 'near'");
    }
    return camera;
}

ShadingSettings read_shading(const Value& table) {
    ShadingSettings shading;
    read_word(table, "frequency", shading.frequency);
    read_word(table, "interpolation", shading.interpolation);
    read_word(table, "cull", shading.cull);
    read(table, "two_sided", shading.two_sided);
    return shading;
}

lighting::Attenuation read_attenuation(const Value& table) {
    const Value* value = find(table, "attenuation");
    if (!value) return {};
    if (value->kind == ValueKind::text) return {0.0f, 0.0f, 1.0f};  // "physical", the only word
    glm::vec3 c_l_q(0.0f);
    read(table, "attenuation", c_l_q);
    if (c_l_q.x + c_l_q.y + c_l_q.z < static_cast<float>(kLeastLength)) {
        throw UserError(value->place, "'attenuation' in [[light]] divides by zero; [1, 0, 0] means none");
    }
    return {c_l_q.x, c_l_q.y, c_l_q.z};
}

void read_cone(const Value& table, lighting::Light& light) {
    const Value* cone = find(table, "cone");
    if (!cone) return;
    light.inner_cone_deg = static_cast<float>(cone->items[0].number);
    light.outer_cone_deg = static_cast<float>(cone->items[1].number);
    if (light.inner_cone_deg <= light.outer_cone_deg) return;
    throw UserError(cone->place, "'cone' in [[light]]: the first angle must not exceed the second");
}

lighting::Light read_light(const Value& table, Placements& placements) {
    lighting::Light light;
    read_word(table, "type", light.type);
    read(table, "direction", light.direction);
    LightPlacement placement{glm::dvec3(light.position), place_of(table, "position")};
    read(table, "position", placement.position);
    placements.lights.push_back(placement);
    read(table, "color", light.color);
    read(table, "intensity", light.intensity);
    light.attenuation = read_attenuation(table);
    read_cone(table, light);
    read(table, "shadow", light.shadow);
    read(table, "on", light.on);
    if (glm::length(glm::dvec3(light.direction)) < kLeastLength) {
        throw UserError(place_of(table, "direction"),
                        "'direction' in [[light]] has length 0; a direction is e.g. direction = [-1, -2, -1]");
    }
    return light;
}

/// Methods that know only the samples of the picture cannot answer at vertices or centroids.
void check_method(const Value& table, shadows::ShadowMethod method, ShadingFrequency frequency) {
    if (frequency == ShadingFrequency::phong || !is_frame_by_frame(method)) return;
    const Value& value = *find(table, "method");
    throw UserError(value.place, "shadow.method = " + in_quotes(value.text, '"') +
                                     " finds shadows at the pixels, but shading.frequency lights " +
                                     (frequency == ShadingFrequency::flat ? "triangles" : "vertices") +
                                     " (expected \"map\" or \"exact\", or shading.frequency = \"phong\")");
}

shadows::ShadowSettings read_shadow(const Value& table, ShadingFrequency frequency) {
    shadows::ShadowSettings shadow;
    read_word(table, "method", shadow.method);
    check_method(table, shadow.method, frequency);
    read(table, "size", shadow.size);
    read_word(table, "filter", shadow.filter);
    read(table, "radius", shadow.radius);
    read(table, "light_size", shadow.light_size);
    read_word(table, "bias", shadow.bias);
    read(table, "constant_bias", shadow.constant_bias);
    read(table, "slope_bias", shadow.slope_bias);
    read_word(table, "cull", shadow.cull);
    return shadow;
}

lighting::Fog read_fog(const Value& table) {
    lighting::Fog fog;
    read_word(table, "mode", fog.mode);
    read(table, "color", fog.color);
    read(table, "start", fog.start);
    read(table, "end", fog.end);
    read(table, "density", fog.density);
    read_word(table, "distance", fog.distance);
    read_word(table, "frequency", fog.frequency);
    return fog;
}

/// A [[material]] that no object wears.
void warn_of_unworn(const Value& root, Scene& scene) {
    const Value* tables = find(root, "material");
    if (!tables) return;
    for (std::size_t m = 0; m < tables->items.size(); ++m) {
        const auto wears = [&](const Object& object) {
            return std::find(object.part_material.begin(), object.part_material.end(), static_cast<int>(m)) !=
                   object.part_material.end();
        };
        if (std::any_of(scene.objects.begin(), scene.objects.end(), wears)) continue;
        const std::string name = in_quotes(scene.materials[m].name, '"');
        scene.warnings.push_back(UserError(place_of(tables->items[m], "name"), "no object wears the material " + name +
                                                                                   "; write material = " + name +
                                                                                   " in an [[object]], or remove it")
                                     .what());
    }
}

Scene build_scene(const Value& root, const std::string& name, const std::string& folder, const ReadOptions& options) {
    Scene scene;
    scene.file = name;
    Placements placements;
    placements.camera_position = scene.camera.position;
    placements.camera_target = scene.camera.target;
    if (const Value* table = find(root, "image")) scene.image = read_image(*table);
    if (const Value* table = find(root, "camera")) scene.camera = read_camera(*table, placements);
    if (const Value* table = find(root, "shading")) scene.shading = read_shading(*table);
    if (const Value* table = find(root, "ambient")) read(*table, "color", scene.ambient);
    if (const Value* tables = find(root, "light")) {
        for (const Value& table : tables->items) scene.lights.push_back(read_light(table, placements));
    }
    if (const Value* table = find(root, "shadow")) scene.shadow = read_shadow(*table, scene.shading.frequency);
    if (const Value* table = find(root, "environment")) {
        scene.environment = read_environment(*table, folder, scene.warnings);
    }
    check_background(root, scene);
    if (const Value* table = find(root, "fog")) scene.fog = read_fog(*table);
    if (const Value* tables = find(root, "material")) read_materials(*tables, folder, scene);
    read_objects(root, folder, options, placements, scene);
    warn_of_unworn(root, scene);
    place_scene(placements, scene);
    drop_maps_without_uv(scene);
    if (!options.maps_later) load_maps(scene, visible_materials(scene));
    for (const std::string& warning : byte_colors(root)) scene.warnings.push_back(warning);
    for (const std::string& warning : shadow_warnings(scene)) scene.warnings.push_back(name + ": " + warning);
    for (const std::string& warning : view_warnings(scene)) scene.warnings.push_back(name + ": " + warning);
    return scene;
}

std::string read_text_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw UserError({path}, "is a folder, not a scene file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
        throw UserError({path}, "cannot be opened" + why + did_you_mean_file(path));
    }
    std::string text(kMaxFileBytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw UserError({path}, "cannot be read");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxFileBytes) throw UserError({path}, "is larger than 16 MB; a scene file is text (TOML)");
    return text;
}

}  // namespace

Scene read_scene_text(const std::string& text, const std::string& name, const std::string& folder,
                      const ReadOptions& options) {
    if (text.find('\0') != std::string::npos) {
        throw UserError({name}, "is not a text file (it holds zero bytes); expected a scene file (TOML, UTF-8)");
    }
    Value root = parse_toml(text, name);
    check_tables(root);
    apply_overrides(root, options.overrides);
    check_keys(root);
    return build_scene(root, name, folder, options);
}

Scene read_scene(const std::string& path, const ReadOptions& options) {
    return read_scene_text(read_text_file(path), path, std::filesystem::path(path).parent_path().string(), options);
}

}  // namespace kreda::scene
