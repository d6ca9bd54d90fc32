#include "tools/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "scene/files/loaded_files.hpp"
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

/// A string as TOML wants it; JSON's rules are the same.
std::string string_text(const std::string& text) {
    return nlohmann::json(text).dump();
}

}  // namespace

bool is_mesh_file(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".obj";
}

std::string scene_around_mesh(const std::string& path, const raster::Mesh& mesh) {
    const Ball ball = ball_around(mesh, path);
    const double half_fov = glm::radians(0.5 * kVerticalFovDeg);
    const double distance = 1.05 * ball.radius / std::sin(half_fov);
    const glm::dvec3 to_camera = glm::normalize(glm::dvec3(0.45, 0.35, 1.0));
    std::string text;
    text += "[image]\nsamples = 3\nbackground = [0.55, 0.68, 0.85]\n";
    text += "[camera]\nposition = " + vector_text(ball.centre + distance * to_camera) + "\n";
    text += "target = " + vector_text(ball.centre) + "\nvertical_fov = " + number_text(kVerticalFovDeg) + "\n";
    text += "near = " + number_text(0.05 * (distance - ball.radius)) + "\n";
    text += "far = " + number_text(distance + 2.0 * ball.radius) + "\n";
    text += "[shading]\ncull = \"none\"\n";
    text += "[ambient]\ncolor = [0.3, 0.3, 0.35]\n";
    text += "[[light]]\ndirection = [0.6, -1.0, -0.8]\ncolor = [1, 0.97, 0.9]\n";
    text += "[[light]]\ndirection = [-1.0, -0.2, -0.4]\ncolor = [0.5, 0.65, 1]\nintensity = 0.3\n";
    text += "[[object]]\nmesh = " + string_text(std::filesystem::absolute(path).string()) + "\n" + ball.placement;
    return text;
}

scene::Scene read_scene_around_mesh(const std::string& path, const scene::ReadOptions& read) {
    scene::LoadedFiles own;
    scene::ReadOptions with_store = read;
    if (!with_store.files) with_store.files = &own;
    const auto loaded = load_mesh(with_store.files, path, {scene::Normals::file, read.allow_outside});
    return scene::read_scene_text(scene_around_mesh(path, loaded->mesh), "scene around " + path, "", with_store);
}

}  // namespace kreda::tools
