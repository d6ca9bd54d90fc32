#include "scene/files/gltf_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace kreda::scene {

namespace {

constexpr double kMostIntensity = 1e9;  // as of a scene's [[light]]

double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

/// The way a node's own axis points in the world, or 0.
glm::dvec3 axis_of(const PlacedNode& placed, const glm::dvec3& axis) {
    const glm::dvec3 v(placed.world_from_node * glm::dvec4(axis, 0.0));
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

bool read_perspective(const tinygltf::PerspectiveCamera& from, FileCamera& to) {
    to.vertical_fov_deg = degrees(from.yfov);
    to.aspect = from.aspectRatio;
    to.near = from.znear;
    to.far = from.zfar;
    return to.vertical_fov_deg > 0.0 && to.vertical_fov_deg < 180.0;
}

bool read_orthographic(const tinygltf::OrthographicCamera& from, FileCamera& to) {
    to.projection = raster::Projection::orthographic;
    to.height = 2.0 * std::abs(from.ymag);
    to.aspect = from.ymag != 0.0 ? std::abs(from.xmag / from.ymag) : 0.0;
    to.near = from.znear;
    to.far = from.zfar;
    return to.height > 0.0 && to.height < 1e9;
}

/// The light that a node carries, or -1.
int light_of(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    if (found == node.extensions.end() || !found->second.Has("light")) return -1;
    const tinygltf::Value& light = found->second.Get("light");
    return light.IsInt() ? light.Get<int>() : -1;
}

/// False: of no known type.
bool read_type(const tinygltf::Light& from, FileLight& to) {
    lighting::Light& light = to.light;
    if (from.type != "directional") light.attenuation = {0.0f, 0.0f, 1.0f};
    if (from.type == "spot") {
        light.type = lighting::LightType::spot;
        light.outer_cone_deg = static_cast<float>(std::clamp(degrees(from.spot.outerConeAngle), 0.0, 90.0));
        light.inner_cone_deg =
            static_cast<float>(std::clamp(degrees(from.spot.innerConeAngle), 0.0, double(light.outer_cone_deg)));
        return true;
    }
    if (from.type == "point") light.type = lighting::LightType::point;
    return from.type == "point" || from.type == "directional";
}

}  // namespace

std::vector<FileCamera> read_gltf_cameras(const GltfFile& gltf, const std::vector<PlacedNode>& nodes,
                                          std::vector<std::string>& warnings) {
    std::vector<FileCamera> cameras;
    for (const PlacedNode& placed : nodes) {
        const int index = gltf.model.nodes[static_cast<std::size_t>(placed.node)].camera;
        if (index < 0) continue;
        FileCamera camera;
        camera.position = glm::dvec3(placed.world_from_node[3]);
        camera.forward = axis_of(placed, {0.0, 0.0, -1.0});
        camera.up = axis_of(placed, {0.0, 1.0, 0.0});
        bool is_usable = has_element(gltf.model.cameras, index);
        if (is_usable) {
            const tinygltf::Camera& from = gltf.model.cameras[static_cast<std::size_t>(index)];
            is_usable = from.type == "orthographic" ? read_orthographic(from.orthographic, camera)
                                                    : read_perspective(from.perspective, camera);
        }
        const double sine = glm::length(glm::cross(camera.forward, camera.up));
        if (is_usable && sine > 1e-3) {
            cameras.push_back(camera);
        } else {
            warnings.push_back(
                gltf_error(gltf.text, "cameras", static_cast<std::size_t>(index), "makes no picture; it is left out")
                    .what());
        }
    }
    return cameras;
}

std::vector<FileLight> read_gltf_lights(const GltfFile& gltf, const std::vector<PlacedNode>& nodes, LeftOut& left_out,
                                        std::vector<std::string>& warnings) {
    std::vector<FileLight> lights;
    for (const PlacedNode& placed : nodes) {
        const int index = light_of(gltf.model.nodes[static_cast<std::size_t>(placed.node)]);
        if (index < 0) continue;
        FileLight light;
        const bool is_there = has_element(gltf.model.lights, index);
        const tinygltf::Light& from = is_there ? gltf.model.lights[static_cast<std::size_t>(index)] : tinygltf::Light{};
        const glm::dvec3 direction = axis_of(placed, {0.0, 0.0, -1.0});
        if (!is_there || !read_type(from, light) || direction == glm::dvec3(0.0)) {
            warnings.push_back(gltf_error(gltf.text, "nodes", static_cast<std::size_t>(placed.node),
                                          "its light is of no known type, or not there; it is left out")
                                   .what());
            continue;
        }
        light.position = glm::dvec3(placed.world_from_node[3]);
        light.light.direction = glm::vec3(direction);
        light.light.intensity = static_cast<float>(std::clamp(from.intensity, 0.0, kMostIntensity));
        for (std::size_t c = 0; c < 3 && from.color.size() == 3; ++c)
            light.light.color[static_cast<int>(c)] = static_cast<float>(std::clamp(from.color[c], 0.0, kMostIntensity));
        if (from.range > 0.0) left_out.add("ranges of lights (they shine on with 1 / d^2)");
        lights.push_back(light);
    }
    return lights;
}

}  // namespace kreda::scene
