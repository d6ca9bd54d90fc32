#include "tests/plan/plan_scenes.hpp"

#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "raster/shapes.hpp"
#include "scene/map_meshes.hpp"

namespace kreda::tests {

namespace {

using lighting::Material;
using lighting::ReflectionModel;
using scene::Scene;

class Random {
public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    int integer(int low, int high) {
        return low + static_cast<int>(bits_() % static_cast<std::uint32_t>(high - low + 1));
    }
    bool one_in(int n) {
        return integer(1, n) == 1;
    }
    float real(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits_() >> 8) * 0x1p-24f);
    }
    glm::vec3 vector(float low, float high) {
        const float x = real(low, high), y = real(low, high), z = real(low, high);
        return {x, y, z};
    }
    template <class Enum>
    Enum word(int count) {
        return static_cast<Enum>(integer(0, count - 1));
    }

private:
    std::mt19937 bits_;
};

std::shared_ptr<const raster::Texture> random_texture(Random& random, int channels) {
    raster::Image image = raster::make_image(random.integer(1, 9), random.integer(1, 9), channels);
    for (float& value : image.values) value = random.real(0.1f, 0.9f);
    return std::make_shared<raster::Texture>(raster::make_texture(image));
}

void add_maps(Random& random, Material& material) {
    lighting::MaterialMaps& maps = material.maps;
    maps.filter = random.word<lighting::TextureFilter>(3);
    if (random.one_in(2)) maps.diffuse.texture = maps.albedo.texture = random_texture(random, 3);
    if (random.one_in(3)) maps.roughness.texture = random_texture(random, 1);
    if (random.one_in(3)) maps.ao.texture = random_texture(random, 1);
    if (random.one_in(3)) maps.normal.texture = random_texture(random, 3);
    if (!random.one_in(4)) return;
    maps.emission.texture = random_texture(random, 3);
    if (random.one_in(2)) material.phong.emission = random.vector(0.1f, 0.4f);
}

Material random_material(Random& random, int number) {
    Material material;
    material.name = "m" + std::to_string(number);
    material.model = random.word<ReflectionModel>(7);
    material.phong.diffuse = random.one_in(6) ? glm::vec3(0.0f) : random.vector(0.1f, 0.9f);
    material.phong.specular = random.one_in(4) ? glm::vec3(0.0f) : random.vector(0.1f, 0.5f);
    material.phong.shininess = random.real(1.0f, 60.0f);
    lighting::CookTorranceMaterial& m = material.cook_torrance;
    m.albedo = random.vector(0.1f, 0.9f);
    m.metallic = random.one_in(3) ? 1.0f : random.real(0.0f, 0.9f);
    m.roughness = random.one_in(4) ? 0.0f : random.real(0.05f, 1.0f);
    m.ao = random.one_in(5) ? 0.0f : random.real(0.3f, 1.0f);
    m.distribution = random.word<lighting::Distribution>(4);
    m.geometry = random.word<lighting::Geometry>(5);
    if (random.one_in(4)) m.energy_compensation = lighting::EnergyCompensation::kulla_conty;
    if (random.one_in(3)) add_maps(random, material);
    return material;
}

lighting::Light random_light(Random& random) {
    lighting::Light light;
    light.type = random.word<lighting::LightType>(3);
    light.direction = random.vector(-1.0f, 1.0f) - glm::vec3(0.0f, 1.0f, 0.3f);
    light.position = random.vector(-3.0f, 3.0f) + glm::vec3(0.0f, 2.5f, 1.0f);
    light.color = random.vector(0.2f, 1.0f);
    light.intensity = random.one_in(8) ? 0.0f : random.real(0.3f, 2.0f);
    light.outer_cone_deg = random.real(5.0f, 50.0f);
    light.inner_cone_deg = 0.5f * light.outer_cone_deg;
    light.shadow = random.one_in(3);
    light.on = !random.one_in(5);
    return light;
}

scene::Object random_object(Random& random, int materials) {
    static constexpr const char* kShapes[] = {"sphere", "cube", "torus", "plane", "teapot"};
    static constexpr int kDetail[] = {8, 1, 8, 2, 3};
    const int shape = random.integer(0, 4);
    scene::Object object;
    object.mesh_name = kShapes[shape];
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(kShapes[shape], kDetail[shape]).value());
    const bool behind = random.one_in(6);
    const glm::vec3 place = random.vector(-1.3f, 1.3f) + glm::vec3(0.0f, 0.0f, behind ? 12.0f : 0.0f);
    object.world_from_object = glm::translate(glm::mat4(1.0f), place);
    object.world_from_object =
        glm::rotate(object.world_from_object, random.real(0.0f, 6.0f), glm::vec3(0.3f, 1.0f, 0.2f));
    if (random.one_in(8)) object.world_from_object[0] = -object.world_from_object[0];
    object.part_material.assign(object.mesh->parts.size(), random.integer(0, materials - 1));
    object.part_hidden.assign(object.mesh->parts.size(), false);
    if (random.one_in(6)) object.part_hidden[0] = true;
    object.casts_shadow = !random.one_in(6);
    return object;
}

void choose_shading(Random& random, Scene& scene) {
    scene.shading.frequency =
        random.one_in(2) ? scene::ShadingFrequency::phong : random.word<scene::ShadingFrequency>(3);
    scene.shading.cull = random.word<raster::CullMode>(3);
    scene.shading.two_sided = random.one_in(2);
    scene.shadow.size = 64;
    scene.shadow.filter = random.word<shadows::ShadowFilter>(2);
    const bool phong = scene.shading.frequency == scene::ShadingFrequency::phong;
    if (phong && random.one_in(3)) scene.shadow.method = random.word<shadows::ShadowMethod>(5);
}

void choose_fog(Random& random, Scene& scene) {
    if (!random.one_in(3)) return;
    scene.fog.mode = random.word<lighting::FogMode>(4);
    scene.fog.frequency = random.word<lighting::FogFrequency>(2);
    scene.fog.color = random.vector(0.2f, 0.8f);
    scene.fog.density = random.one_in(4) ? 0.0f : random.real(0.05f, 0.5f);
    scene.fog.start = random.one_in(4) ? 100.0f : 1.0f;
    scene.fog.end = scene.fog.start + 6.0f;
}

void choose_environment(Random& random, Scene& scene) {
    if (!random.one_in(6)) return;
    scene.environment.on = true;
    auto image = std::make_shared<raster::Image>(raster::make_image(8, 4, 3));  // baked fast
    for (float& value : image->values) value = random.real(0.1f, 1.0f);
    scene.environment.image = image;
    scene.environment.intensity = random.one_in(5) ? 0.0f : random.real(0.3f, 1.5f);
    scene.environment.samples = 32;
    scene.environment.irradiance = random.word<lighting::IrradianceForm>(2);
    scene.environment.reference = random.one_in(4) ? 2 : 0;
    scene.image.environment_background = random.one_in(2);
}

}  // namespace

Scene random_plan_scene(std::uint32_t seed) {
    Random random(seed);
    Scene scene;
    scene.image.width = random.integer(10, 80);
    scene.image.height = random.integer(10, 60);
    scene.image.samples = random.integer(1, 2);
    scene.image.background = random.vector(0.1f, 0.6f);
    scene.camera.position = {random.real(-1.0f, 1.0f), random.real(-0.5f, 1.5f), random.real(2.0f, 5.0f)};
    scene.camera.vertical_fov_deg = random.real(20.0f, 80.0f);
    if (random.one_in(5)) scene.camera.projection = raster::Projection::orthographic;
    const int materials = random.integer(1, 4);
    for (int m = 0; m < materials; ++m) scene.materials.push_back(random_material(random, m));
    for (int o = random.integer(0, 4); o > 0; --o) scene.objects.push_back(random_object(random, materials));
    for (int l = random.integer(0, 3); l > 0; --l) scene.lights.push_back(random_light(random));
    choose_shading(random, scene);
    choose_fog(random, scene);
    choose_environment(random, scene);
    if (random.one_in(6)) scene.shading.rate = random.integer(2, 4);
    drop_maps_without_uv(scene);
    scene::TangentMeshes made;
    add_tangents(scene, made);
    return scene;
}

}  // namespace kreda::tests
