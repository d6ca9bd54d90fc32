#include "scene/files/read_scene.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/files/file_content.hpp"
#include "scene/files/file_key.hpp"
#include "scene/files/key_tables.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/loaded_files.hpp"
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

void check_background(const Value& root, const Scene& scene) {
    if (!scene.image.environment_background || scene.environment.on) return;
    throw UserError(find(*find(root, "image"), "background")->place,
                    "background = \"environment\" needs an [environment] that is on, e.g. sky = \"studio\"");
}

ImageSettings read_image(const Value& table) {
    ImageSettings image;
    read_keys(table, image_keys(), image);
    check_sample_grid(table, image);
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

/// The position after going round the target by so many degrees; 0 changes no bit.
glm::dvec3 orbited_position(const CameraTable& read) {
    if (read.orbit_deg == 0.0f) return read.position;
    const double angle = glm::radians(static_cast<double>(read.orbit_deg));
    const glm::dvec3 up = glm::normalize(glm::dvec3(read.camera.up)), arm = read.position - read.target;
    const glm::dvec3 along = glm::dot(arm, up) * up;
    return read.target + along + std::cos(angle) * (arm - along) + std::sin(angle) * glm::cross(up, arm);
}

raster::Camera read_camera(const Value& table, Placements& placements) {
    CameraTable read;
    read_keys(table, camera_keys(), read);
    placements.camera_position = read.position;
    placements.camera_target = read.target;
    check_view(table, placements, read.camera);
    placements.camera_position = orbited_position(read);
    if (read.camera.far <= read.camera.near) {
        const Place& place = place_of(table, find(table, "far") ? "far" : "near");
        throw UserError(place, "'far' in [camera] must be greater than 'near'");
    }
    return read.camera;
}

void check_light(const Value& table, const lighting::Light& light) {
    const lighting::Attenuation& a = light.attenuation;
    if (a.constant + a.linear + a.quadratic < static_cast<float>(kLeastLength)) {
        throw UserError(place_of(table, "attenuation"),
                        "'attenuation' in [[light]] divides by zero; [1, 0, 0] means none");
    }
    if (light.inner_cone_deg > light.outer_cone_deg) {
        throw UserError(place_of(table, "cone"), "'cone' in [[light]]: the first angle must not exceed the second");
    }
    if (glm::length(glm::dvec3(light.direction)) < kLeastLength) {
        throw UserError(place_of(table, "direction"),
                        "'direction' in [[light]] has length 0; a direction is e.g. direction = [-1, -2, -1]");
    }
}

lighting::Light read_light(const Value& table, Placements& placements) {
    LightTable read;
    read_keys(table, light_keys(), read);
    placements.lights.push_back({read.position, place_of(table, "position")});
    check_light(table, read.light);
    return read.light;
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
    read_keys(table, shadow_keys(), shadow);
    check_method(table, shadow.method, frequency);
    return shadow;
}

/// A [[material]] that no object wears.
void warn_of_unworn(const Value& root, Scene& scene) {
    const Value* tables = find(root, "material");
    if (!tables) return;
    std::vector<bool> worn(scene.materials.size(), false);
    for (const Object& object : scene.objects) {
        for (const int m : object.part_material) worn[static_cast<std::size_t>(m)] = true;
    }
    for (std::size_t m = 0; m < tables->items.size(); ++m) {
        if (worn[m]) continue;
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
    if (const Value* table = find(root, "shading")) read_keys(*table, shading_keys(), scene.shading);
    if (const Value* table = find(root, "ambient")) read_keys(*table, ambient_keys(), scene);
    if (const Value* tables = find(root, "light")) {
        for (const Value& table : tables->items) scene.lights.push_back(read_light(table, placements));
    }
    if (const Value* table = find(root, "shadow")) scene.shadow = read_shadow(*table, scene.shading.frequency);
    if (const Value* table = find(root, "environment")) {
        scene.environment = read_environment(*table, folder, options.files, scene.warnings);
    }
    check_background(root, scene);
    if (const Value* table = find(root, "fog")) read_keys(*table, fog_keys(), scene.fog);
    if (const Value* tables = find(root, "material")) read_materials(*tables, folder, scene);
    read_objects(root, folder, options, placements, scene);
    warn_of_unworn(root, scene);
    place_scene(placements, scene);
    drop_maps_without_uv(scene);
    if (!options.maps_later) load_maps(scene, visible_materials(scene), options.files);
    for (const std::string& warning : byte_colors(root)) scene.warnings.push_back(warning);
    for (const std::string& warning : shadow_warnings(scene)) scene.warnings.push_back(name + ": " + warning);
    for (const std::string& warning : view_warnings(scene)) scene.warnings.push_back(name + ": " + warning);
    return scene;
}

/// What a shell hands over, `kreda render <(generate)`: a pipe that somebody writes to.
bool is_from_shell(const std::string& path) {
    return path == "/dev/stdin" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
}

std::string read_text_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw UserError({path}, "is a folder, not a scene file");
    const bool is_odd = std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
    if (is_odd && !is_from_shell(path)) throw UserError({path}, "is a pipe or a device, not a scene file");
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
    const std::string other = other_content(text);
    if (!other.empty()) throw UserError({name}, other);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        throw UserError({name}, "is UTF-16 text; save it as UTF-8");
    }
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
    if (options.files) options.files->used.push_back(use_file(path));
    return read_scene_text(read_text_file(path), path, std::filesystem::path(path).parent_path().string(), options);
}

}  // namespace kreda::scene
