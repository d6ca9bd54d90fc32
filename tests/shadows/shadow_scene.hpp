// A small scene for the tests of shadows: objects, a camera, a light; and everything the methods ask for.
#pragma once

#include <deque>
#include <vector>

#include <glm/ext/matrix_transform.hpp>

#include "raster/camera.hpp"
#include "raster/shapes.hpp"
#include "raster/triangle_setup.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/visible_sample_memory.hpp"
#include "shadows/volume.hpp"

namespace kreda::tests {

struct ShadowScene {
    raster::Camera camera;
    raster::Viewport viewport{160, 90};
    raster::CullMode cull = raster::CullMode::back;
    shadows::ShadowLight light;
    std::deque<raster::Mesh> meshes;  // a deque: instances point at them
    std::vector<raster::MeshInstance> instances;
    raster::VertexStreams streams;
    raster::TriangleSet set;
    shadows::VisibleSampleMemory frame;
    std::vector<shadows::Occluder> occluders;

    /// Add a mesh at a place.
    void add(raster::Mesh mesh, const glm::mat4& world_from_object = glm::mat4(1.0f)) {
        meshes.push_back(std::move(mesh));
        raster::MeshInstance instance;
        instance.mesh = &meshes.back();
        instance.world_from_object = world_from_object;
        instance.part_material.assign(meshes.back().parts.size(), 0);
        instances.push_back(instance);
    }
    void add(const char* shape, int detail, const glm::vec3& place = glm::vec3(0.0f),
             const glm::vec3& size = glm::vec3(1.0f)) {
        add(raster::make_shape(shape, detail).value(), glm::scale(glm::translate(glm::mat4(1.0f), place), size));
    }

    [[nodiscard]] glm::mat4 clip_from_world() const {
        return raster::clip_from_world(camera,
                                       static_cast<float>(viewport.width) / static_cast<float>(viewport.height));
    }

    /// Vertices, triangles, visible samples and occluders of all objects.
    void draw() {
        raster::VertexNeeds needs;
        needs.position_world = true;
        lay_out_vertices(instances, needs, streams);
        transform_vertices(instances, clip_from_world(), viewport, streams);
        setup_triangles(instances, clip_from_world(), viewport, cull, 1, streams, set);
        find_visible(streams, set, raster::AttributeInterpolation::perspective, viewport, clip_from_world(), frame);
        occluders.clear();
        for (const raster::MeshInstance& instance : instances) {
            occluders.push_back({{&streams.position_world[instance.first_vertex], instance.mesh->positions.size()},
                                 instance.mesh->indices,
                                 glm::determinant(instance.world_from_object) < 0.0f});
        }
    }

    [[nodiscard]] std::size_t sample_count() const {
        return frame.depth.size();
    }
    [[nodiscard]] bool is_seen(std::size_t i) const {
        return frame.triangle[i] != raster::kNoTriangle;
    }

    /// The depths, with those of surfaces that lie along the light's rays taken for unseen.
    [[nodiscard]] raster::AlignedVector<float> depth_without_edge_on_surfaces() const {
        auto depth = frame.depth;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            if (!is_seen(i)) continue;
            const auto [a, b, c] = set.triangle(frame.triangle[i]).vertex;
            const auto& p = streams.position_world;
            const glm::vec3 n = glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a]));
            const glm::vec3 l = glm::normalize(shadows::toward_light(shadows::homogeneous(light), frame.position[i]));
            if (std::abs(glm::dot(n, l)) < 1e-5f) depth[i] = raster::kClearDepth;
        }
        return depth;
    }
};

/// Every object of a drawn scene as a caster of shadow volumes.
inline std::vector<shadows::VolumeCaster> casters_of(const ShadowScene& scene) {
    std::vector<shadows::VolumeCaster> casters;
    for (std::size_t i = 0; i < scene.occluders.size(); ++i) {
        casters.push_back({scene.occluders[i], shadows::clip_positions(scene.instances[i], scene.clip_from_world())});
    }
    return casters;
}

inline shadows::ShadowLight point_light(const glm::vec3& position) {
    shadows::ShadowLight light;
    light.kind = shadows::LightKind::point;
    light.position = position;
    return light;
}

inline shadows::ShadowLight directional_light(const glm::vec3& direction) {
    shadows::ShadowLight light;
    light.direction = glm::normalize(direction);
    return light;
}

/// A mesh of loose triangles, three corners each.
inline raster::Mesh mesh_of(const std::vector<glm::vec3>& corners) {
    raster::Mesh mesh;
    mesh.positions = corners;
    for (std::uint32_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(i);
    mesh.parts.push_back({"loose", 0, mesh.triangle_count(), -1});
    return mesh;
}

}  // namespace kreda::tests
