// Renders a set of scenes and prints a hash of each film's bytes: two builds that print the same lines make the same
// pictures to the last bit. Built without OpenImageIO, so that every variant builds in seconds.
//   hash_scenes [THREADS] [shuffle|third]      third: one scene of three, for programs that are slow
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "raster/film.hpp"
#include "raster/shapes.hpp"
#include "scene/map_meshes.hpp"
#include "scene/render/render.hpp"

namespace {

using namespace kreda;

struct NamedScene {
    std::string name;
    scene::Scene scene;
};

scene::Object object_of(const std::string& shape, int detail, glm::vec3 position, int material) {
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(shape, detail).value());
    object.world_from_object[3] = glm::vec4(position, 1.0f);
    object.part_material.assign(object.mesh->parts.size(), material);
    return object;
}

lighting::Material material_of(lighting::ReflectionModel model) {
    lighting::Material material;
    material.model = model;
    material.phong.diffuse = {0.7f, 0.3f, 0.2f};
    material.phong.shininess = 47.5f;
    material.cook_torrance.albedo = {0.9f, 0.6f, 0.3f};
    material.cook_torrance.metallic = 0.7f;
    material.cook_torrance.roughness = 0.35f;
    return material;
}

/// Three objects, three kinds of light, a part of the ground behind the camera so that the clipper has work.
scene::Scene base_scene(lighting::ReflectionModel model) {
    scene::Scene s;
    s.image.width = 333;
    s.image.height = 211;
    s.camera.position = {0.3f, 1.1f, 2.7f};
    s.materials = {material_of(model), material_of(lighting::ReflectionModel::blinn_phong)};
    s.objects = {object_of("torus_knot", 96, {0.0f, 0.3f, 0.0f}, 0), object_of("teapot", 6, {1.2f, 0.0f, -0.5f}, 0),
                 object_of("terrain", 80, {0.0f, -0.9f, 0.0f}, 1)};
    s.objects[2].world_from_object[0][0] = s.objects[2].world_from_object[2][2] = 4.0f;
    s.lights.resize(3);
    s.lights[1].type = lighting::LightType::point;
    s.lights[1].attenuation = {0.2f, 0.1f, 0.3f};
    s.lights[2].type = lighting::LightType::spot;
    s.lights[2].position = {-1.0f, 3.0f, 2.0f};
    s.lights[2].direction = {0.3f, -1.0f, -0.6f};
    return s;
}

/// A picture of odd size with something on every scale.
std::shared_ptr<const raster::Texture> patterned_texture(int channels, int width, int height) {
    raster::Image image = raster::make_image(width, height, channels);
    std::mt19937 bits(static_cast<std::uint32_t>(width));
    for (float& value : image.values) value = static_cast<float>(bits() >> 8) * 0x1p-24f;
    return std::make_shared<raster::Texture>(raster::make_texture(image));
}

/// Maps of every kind on the torus knot and the teapot, and on the ground up to the horizon.
scene::Scene textured_scene(lighting::ReflectionModel model, int i) {
    scene::Scene s = base_scene(model);
    for (lighting::Material& material : s.materials) {
        lighting::MaterialMaps& maps = material.maps;
        maps.filter = static_cast<lighting::TextureFilter>(i % 3);
        maps.wrap = static_cast<lighting::TextureWrap>(i % 2);
        maps.normal_y = static_cast<lighting::NormalMapY>(i % 2);
        maps.albedo.texture = maps.diffuse.texture = patterned_texture(3, 61, 43);
        maps.roughness.texture = patterned_texture(1, 128, 64);
        maps.metallic.texture = patterned_texture(1, 7, 1);
        maps.normal.texture = patterned_texture(3, 33, 32);
    }
    s.shading.frequency = static_cast<scene::ShadingFrequency>(2 - i % 3);
    s.image.samples = 1 + i % 2;
    scene::TangentMeshes made;
    scene::add_tangents(s, made);
    return s;
}

std::vector<NamedScene> make_scenes() {
    using lighting::ReflectionModel;
    std::vector<NamedScene> scenes;
    for (const ReflectionModel model :
         {ReflectionModel::unlit, ReflectionModel::lambert, ReflectionModel::phong, ReflectionModel::blinn_phong,
          ReflectionModel::ward, ReflectionModel::heidrich_seidel}) {
        scenes.push_back({"model " + std::to_string(static_cast<int>(model)), base_scene(model)});
    }
    scenes.push_back({"ward brushed", base_scene(ReflectionModel::ward)});
    scenes.back().scene.materials[0].phong.ward_alpha = glm::vec2(0.1f, 0.5f);
    scenes.push_back({"all wavelengths", base_scene(ReflectionModel::cook_torrance)});
    scenes.back().scene.materials[0].cook_torrance.measured = "gold";
    scenes.back().scene.materials[0].cook_torrance.fresnel = lighting::FresnelMethod::exact;
    for (int i = 0; i < 10; ++i) {
        scene::Scene s = base_scene(ReflectionModel::cook_torrance);
        lighting::CookTorranceMaterial& m = s.materials[0].cook_torrance;
        m.fresnel = static_cast<lighting::FresnelMethod>(i);
        m.distribution = static_cast<lighting::Distribution>(i % 4);
        m.geometry = static_cast<lighting::Geometry>(i % 5);
        m.energy_compensation = i == 0 ? lighting::EnergyCompensation::kulla_conty : lighting::EnergyCompensation::none;
        if (i > 1) m.ior = glm::vec3(0.18f, 0.42f, 1.37f);
        if (i > 1) m.extinction = glm::vec3(3.42f, 2.35f, 1.77f);
        scenes.push_back({"cook_torrance " + std::to_string(i), s});
    }
    for (int i = 0; i < 6; ++i) {
        const ReflectionModel model = i < 3 ? ReflectionModel::cook_torrance : ReflectionModel::blinn_phong;
        scenes.push_back({"textures " + std::to_string(i), textured_scene(model, i)});
    }
    scenes.push_back({"textures filtered", textured_scene(ReflectionModel::cook_torrance, 0)});
    for (lighting::Material& material : scenes.back().scene.materials) {
        material.maps.filter = lighting::TextureFilter::trilinear;
    }
    for (int i = 0; i < 6; ++i) {
        scene::Scene s = base_scene(ReflectionModel::phong);
        s.shading.frequency = static_cast<scene::ShadingFrequency>(i % 3);
        s.fog.mode = static_cast<lighting::FogMode>(1 + i % 3);
        s.fog.start = 1.0f;
        s.fog.density = 0.3f;
        s.fog.distance = static_cast<lighting::FogDistance>(i % 2);
        s.fog.frequency = static_cast<lighting::FogFrequency>(i / 3);
        s.image.samples = 1 + i % 4;
        s.shading.cull = static_cast<raster::CullMode>(i % 3);
        s.camera.projection = i == 5 ? raster::Projection::orthographic : raster::Projection::perspective;
        scenes.push_back({"fog " + std::to_string(i), s});
    }
    constexpr raster::CullMode kCulls[] = {raster::CullMode::none, raster::CullMode::back, raster::CullMode::front};
    for (int i = 0; i < 9; ++i) {  // all lights cast: one picture, six pictures, one
        scene::Scene s = base_scene(ReflectionModel::blinn_phong);
        for (lighting::Light& light : s.lights) light.shadow = true;
        s.shadow.size = 200;
        s.shadow.filter = static_cast<shadows::ShadowFilter>(i % 3);
        s.shadow.bias = static_cast<shadows::ShadowBias>(i % 4);
        s.shadow.radius = 1 + i % 2;
        s.shadow.cull = kCulls[i / 3];
        s.shading.frequency = static_cast<scene::ShadingFrequency>(i < 6 ? 2 : i % 3);
        scenes.push_back({"shadow map " + std::to_string(i), s});
    }
    for (int method = 1; method < 5; ++method) {
        scene::Scene s = base_scene(ReflectionModel::phong);
        for (lighting::Light& light : s.lights) light.shadow = true;
        s.shadow.method = static_cast<shadows::ShadowMethod>(method);
        if (s.shadow.method == shadows::ShadowMethod::planar)
            s.objects[2] = object_of("plane", 4, {0.0f, -0.9f, 0.0f}, 1);
        s.image.samples = 1 + method % 2;
        scenes.push_back({"shadow method " + std::to_string(method), s});
    }
    for (int i = 0; i < 4; ++i) {  // split sum by map and by coefficients, with bounces; the integral itself
        scene::Scene s = base_scene(ReflectionModel::cook_torrance);
        s.environment.on = true;
        s.environment.sky = static_cast<lighting::Sky>(i % 3);
        s.environment.samples = 256;
        s.environment.rotation_deg = 30.0f * static_cast<float>(i);
        s.environment.irradiance = static_cast<lighting::IrradianceForm>(i % 2);
        s.environment.reference = i == 3 ? 16 : 0;
        s.image.environment_background = true;
        s.materials[0].cook_torrance.energy_compensation = static_cast<lighting::EnergyCompensation>(i % 2);
        scenes.push_back({"environment " + std::to_string(i), s});
    }
    return scenes;
}

/// FNV-1a over the bytes of the film and of what the display shows of it.
std::uint64_t hash(const raster::Image& film) {
    std::uint64_t h = 14695981039346656037ull;
    const auto add = [&](const raster::AlignedVector<float>& values) {
        for (const float value : values) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            for (int byte = 0; byte < 4; ++byte) h = (h ^ (bits >> (8 * byte) & 0xffu)) * 1099511628211ull;
        }
    };
    add(film.values);
    add(raster::develop(film, {}).values);
    return h;
}

void shuffle_tiles(const scene::RenderPlan& plan, scene::RenderBuffers& buffers) {
    const raster::TileGrid grid = raster::make_tile_grid(plan.viewport, plan.samples);
    buffers.tiles.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    for (std::size_t i = 0; i < buffers.tiles.size(); ++i) buffers.tiles[i] = static_cast<int>(i);
    std::shuffle(buffers.tiles.begin(), buffers.tiles.end(), std::mt19937(7));
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 0;
    const bool shuffle = argc > 2 && std::strcmp(argv[2], "shuffle") == 0;
    const int step = argc > 2 && std::strcmp(argv[2], "third") == 0 ? 3 : 1;
    int number = 0;
    for (const NamedScene& named : make_scenes()) {
        if (number++ % step != 0) continue;
        const scene::RenderPlan plan = make_plan(named.scene);
        scene::RenderBuffers buffers;
        if (shuffle) shuffle_tiles(plan, buffers);
        render(named.scene, plan, buffers, threads);
        std::printf("%-18s %016llx\n", named.name.c_str(), static_cast<unsigned long long>(hash(buffers.film)));
    }
}
