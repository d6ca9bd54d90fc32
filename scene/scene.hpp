// The scene as plain data: what is there, nothing about how it will be drawn.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lighting/fog_settings.hpp"
#include "lighting/light.hpp"
#include "lighting/material.hpp"
#include "raster/camera.hpp"
#include "raster/cull_mode.hpp"
#include "raster/film.hpp"
#include "raster/mesh.hpp"
#include "scene/environment.hpp"
#include "scene/error.hpp"
#include "shadows/shadow.hpp"

namespace kreda::scene {

using raster::ToneMap;
using raster::Transfer;
enum class ShadingFrequency { flat, gouraud, phong };
enum class Interpolation { perspective, affine };
enum class Normals { file, smooth, flat };

struct ImageSettings {
    int width = 640;
    int height = 360;
    int samples = 1;             ///< n x n supersampling, 1..8
    glm::vec3 background{0.0f};  ///< linear RGB
    bool environment_background = false;
    float exposure = 1.0f;
    ToneMap tone_map = ToneMap::none;
    float white = 4.0f;
    Transfer transfer = Transfer::srgb;
    float gamma = 2.2f;
};

/// The settings that turn the linear film into the picture: exposure, tone map and transfer function.
[[nodiscard]] inline raster::FilmSettings film_settings(const ImageSettings& image) {
    return {image.exposure, image.tone_map, image.white, image.transfer, image.gamma};
}

struct ShadingSettings {
    ShadingFrequency frequency = ShadingFrequency::phong;
    int rate = 1;  ///< with phong: one point is lit for rate x rate samples of a triangle
    Interpolation interpolation = Interpolation::perspective;
    raster::CullMode cull = raster::CullMode::back;
    bool two_sided = true;  ///< where culling is off: normals are turned to the viewer
};

/// An instance of a mesh in the world.
struct Object {
    std::string mesh_name;                     ///< as written in the scene file
    std::shared_ptr<const raster::Mesh> mesh;  ///< shared when several objects name the same file and settings
    glm::mat4 world_from_object{1.0f};         ///< of the mesh's positions; the mesh's origin and the scene's are in it
    std::vector<int> part_material;            ///< for each part of the mesh: index into Scene::materials
    std::vector<bool> part_hidden;             ///< for each part of the mesh: not drawn
    bool casts_shadow = true;
    bool on = true;  ///< off: the file's mesh was not read; `mesh` is one part without triangles, and hidden
};

struct Scene {
    std::string file;  ///< where it came from; empty: built in
    ImageSettings image;
    glm::dvec3 origin{
        0.0};  ///< of all places below, in the file's world; 0 unless they are far from it: see origin.hpp
    raster::Camera camera;
    ShadingSettings shading;
    glm::vec3 ambient{0.05f};  ///< s_A
    std::vector<lighting::Light> lights;
    shadows::ShadowSettings shadow;  ///< for all lights with shadow = true
    EnvironmentSettings environment;
    lighting::Fog fog;
    std::vector<lighting::Material> materials;  ///< at least one when there is an object
    std::vector<Object> objects;
    std::vector<std::string> warnings;  ///< what was wrong but not fatal while loading, a line each
};

/// Where the light stands in Scene::lights that is number k among those that are on; the number of a file's light.0.
[[nodiscard]] inline int index_of_light(const Scene& scene, int k) {
    int index = 0;
    for (; k > 0 || !scene.lights[static_cast<std::size_t>(index)].on; ++index) {
        if (scene.lights[static_cast<std::size_t>(index)].on) --k;
    }
    return index;
}

}  // namespace kreda::scene
