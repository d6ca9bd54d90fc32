#include "tools/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "scene/files/gltf_text.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/obj_text.hpp"
#include "scene/files/scene_keys.hpp"

namespace kreda::tools {

namespace {

constexpr double kVerticalFovDeg = 30.0;

/// The ball around the mesh's bounding box, and how the mesh is placed to have it there.
struct Ball {
    glm::dvec3 centre{0.0};  ///< world space
    double radius = 1.0;
    std::string placement;  ///< keys of its [[object]]
};

/// Nine digits say a float, seventeen a double.
int digits(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    const double largest = std::max({size.x, size.y, size.z});
    return largest > 1e4 || largest < 1e-4 ? 17 : 9;
}

std::string vector_text(const glm::dvec3& v) {
    std::ostringstream text;
    text.precision(digits(v));
    text << std::showpoint << "[" << v.x << ", " << v.y << ", " << v.z << "]";
    return text.str();
}

std::string number_text(double number) {
    std::ostringstream text;
    text.precision(digits(glm::dvec3(number)));
    text << std::showpoint << number;
    return text.str();
}

/// A mesh of an ordinary size stays where it is. A tiny or a huge one is scaled to its own unit, and what lies beyond
/// 1e9 is moved to 0: the world has room for neither.
Ball ball_around(const raster::Mesh& mesh, const std::string& path) {
    glm::dvec3 least(mesh.positions.front());
    glm::dvec3 greatest = least;
    for (const glm::vec3& position : mesh.positions) {
        least = glm::min(least, glm::dvec3(position));
        greatest = glm::max(greatest, glm::dvec3(position));
    }
    Ball ball{0.5 * (least + greatest), 0.5 * glm::length(greatest - least), ""};
    if (ball.radius == 0.0) throw scene::UserError(scene::Place{path}, "all its corners are one point: nothing to see");
    if (mesh.unit < 1.0 / scene::kFarthest)
        throw scene::UserError(scene::Place{path}, "is less than 1e-25 wide; make it larger in a modelling program");
    const glm::dvec3 origin = mesh.origin / mesh.unit;
    if (mesh.unit != 1.0) ball.placement += "scale = " + number_text(1.0 / mesh.unit) + "\n";
    if (mesh.unit != 1.0 || glm::length(origin) > 1e9) {
        if (origin != glm::dvec3(0.0)) ball.placement += "translate = " + vector_text(-origin) + "\n";
    } else {
        ball.centre += origin;
    }
    return ball;
}

/// For the length of a reading: the mesh that was read to make the scene is the scene's, too.
struct Reading {
    scene::LoadedFiles& files;
    explicit Reading(scene::LoadedFiles& store) : files(store) {
        files.is_reading = true;
    }
    ~Reading() {
        files.is_reading = false;
    }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
};

/// A string as TOML wants it; JSON's rules are the same.
std::string string_text(const std::string& text) {
    return nlohmann::json(text).dump();
}

/// The camera that sees the whole ball.
std::string camera_around(const Ball& ball) {
    const double half_fov = glm::radians(0.5 * kVerticalFovDeg);
    const double distance = 1.05 * ball.radius / std::sin(half_fov);
    const glm::dvec3 to_camera = glm::normalize(glm::dvec3(0.45, 0.35, 1.0));
    std::string text = "[camera]\nposition = " + vector_text(ball.centre + distance * to_camera) + "\n";
    text += "target = " + vector_text(ball.centre) + "\nvertical_fov = " + number_text(kVerticalFovDeg) + "\n";
    text += "near = " + number_text(0.05 * (distance - ball.radius)) + "\n";
    return text + "far = " + number_text(distance + 2.0 * ball.radius) + "\n";
}

/// The file's camera, in the middle of [image]: its shape is the picture's. It may have no far plane.
std::string camera_of_file(const scene::FileCamera& camera, const Ball& ball) {
    constexpr int kPixels = 640;  // of the longer side
    std::string text;
    if (camera.aspect > 1.0 / 16.0 && camera.aspect < 16.0) {
        const double longer = std::max(1.0, camera.aspect);
        const auto pixels = [&](double side) { return std::to_string(std::lround(kPixels * side / longer)); };
        text += "size = [" + pixels(camera.aspect) + ", " + pixels(1.0) + "]\n";
    }
    const double to_ball = glm::length(ball.centre - camera.position);
    const double near = std::max({camera.near, 1e-9, 1e-5 * (to_ball + ball.radius)});
    const double far = camera.far > near ? camera.far : std::max(2.0 * near, 1.1 * (to_ball + ball.radius));
    const double ahead = std::max(near, glm::dot(ball.centre - camera.position, camera.forward));
    text += "[camera]\nposition = " + vector_text(camera.position) + "\n";
    text += "target = " + vector_text(camera.position + ahead * camera.forward) + "\n";
    text += "up = " + vector_text(camera.up) + "\n";
    if (camera.projection == raster::Projection::orthographic) {
        text += "projection = \"orthographic\"\nheight = " + number_text(camera.height) + "\n";
    } else {
        text += "vertical_fov = " + number_text(camera.vertical_fov_deg) + "\n";
    }
    return text + "near = " + number_text(near) + "\nfar = " + number_text(far) + "\n";
}

/// What all lights of a file send to a point that faces them.
double irradiance_at(const std::vector<scene::FileLight>& lights, const glm::dvec3& p) {
    double sum = 0.0;
    for (const scene::FileLight& light : lights) {
        const double strongest = std::max({light.light.color.x, light.light.color.y, light.light.color.z});
        const glm::dvec3 d = p - light.position;
        const bool weakens = light.light.type != lighting::LightType::directional;
        sum += light.light.intensity * strongest / (weakens ? std::max(glm::dot(d, d), 1e-12) : 1.0);
    }
    return sum;
}

/// Lamps are given in lux and candela: a bright day is 100,000. Outside of a range that eyes do not mind, a white wall
/// that faces the lights (it gives back E / pi) is made white.
double exposure_for(double irradiance) {
    constexpr double kRange = 10.0;
    const double white = irradiance / std::numbers::pi;
    return white > 0.0 && (white > kRange || white < 1.0 / kRange) ? 1.0 / white : 1.0;
}

std::string light_text(const scene::FileLight& light) {
    const bool is_spot = light.light.type == lighting::LightType::spot;
    const bool is_sun = light.light.type == lighting::LightType::directional;
    std::string text = std::string("[[light]]\ntype = ") + (is_spot  ? "\"spot\""
                                                            : is_sun ? "\"directional\""
                                                                     : "\"point\"");
    text += "\ncolor = " + vector_text(glm::dvec3(light.light.color)) + "\nintensity = ";
    text += number_text(double(light.light.intensity)) + "\n";
    if (is_spot || is_sun) text += "direction = " + vector_text(glm::dvec3(light.light.direction)) + "\n";
    if (!is_sun) text += "attenuation = \"physical\"\nposition = " + vector_text(light.position) + "\n";
    if (is_spot) {
        text += "cone = [" + number_text(double(light.light.inner_cone_deg)) + ", " +
                number_text(double(light.light.outer_cone_deg)) + "]\n";
    }
    return text;
}

std::string lights_of_file(const scene::LoadedMesh& loaded) {
    std::string text = "[ambient]\ncolor = [0.02, 0.02, 0.02]\n";
    for (const scene::FileLight& light : loaded.lights) text += light_text(light);
    return text;
}

constexpr const char* kLights =
    "[ambient]\ncolor = [0.3, 0.3, 0.35]\n"
    "[[light]]\ndirection = [0.6, -1.0, -0.8]\ncolor = [1, 0.97, 0.9]\n"
    "[[light]]\ndirection = [-1.0, -0.2, -0.4]\ncolor = [0.5, 0.65, 1]\nintensity = 0.3\n";

/// Metals reflect what is around them: without surroundings they are black.
constexpr const char* kStudio =
    "[environment]\nsky = \"studio\"\n"
    "[[light]]\ndirection = [0.6, -1.0, -0.8]\ncolor = [1, 0.97, 0.9]\n";

}  // namespace

bool is_mesh_file(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return scene::in_lower_case(extension) == ".obj" || scene::is_gltf_name(path);
}

std::string scene_around_mesh(const std::string& path, const scene::LoadedMesh& loaded) {
    const Ball ball = ball_around(loaded.mesh, path);
    const bool moved = !ball.placement.empty();  // then the file's own cameras and lights are elsewhere
    const bool is_physical = std::ranges::any_of(loaded.materials, [](const lighting::Material& material) {
        return material.model == lighting::ReflectionModel::cook_torrance;
    });
    const bool has_lights = !loaded.lights.empty() && !moved;
    std::string text = "[image]\nsamples = 3\nbackground = [0.55, 0.68, 0.85]\n";
    const double exposure = has_lights ? exposure_for(irradiance_at(loaded.lights, ball.centre)) : 1.0;
    if (exposure != 1.0) text += "exposure = " + number_text(exposure) + "\n";
    if (!loaded.cameras.empty() && !moved) {
        text += camera_of_file(loaded.cameras.front(), ball);
    } else {
        text += camera_around(ball);
    }
    if (!scene::is_gltf_name(path)) {
        text += kLights;
    } else if (has_lights) {
        text += lights_of_file(loaded);
    } else {
        text += is_physical ? kStudio : kLights;
    }
    const bool shows_backs = loaded.two_sided || !scene::is_gltf_name(path);
    text += std::string("[shading]\ncull = ") + (shows_backs ? "\"none\"\n" : "\"back\"\n");
    text += "[[object]]\nmesh = " + string_text(std::filesystem::absolute(path).string()) + "\n" + ball.placement;
    return text;
}

scene::Scene read_scene_around_mesh(const std::string& path, const scene::ReadOptions& read) {
    scene::LoadedFiles own;
    scene::ReadOptions with_store = read;
    if (!with_store.files) with_store.files = &own;
    const auto loaded = load_mesh(with_store.files, path, {scene::Normals::file, read.allow_outside});
    const Reading reading(*with_store.files);
    return scene::read_scene_text(scene_around_mesh(path, *loaded), "scene around " + path, "", with_store);
}

}  // namespace kreda::tools
