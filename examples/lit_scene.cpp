#include "examples/lit_scene.hpp"

#include <cmath>
#include <memory>

#include "raster/shapes.hpp"
#include "scene/render.hpp"

namespace kreda::examples {

scene::Scene empty_scene(glm::ivec2 size) {
    scene::Scene scene;
    scene.image.width = size.x;
    scene.image.height = size.y;
    scene.image.samples = 3;
    scene.image.background = kBoard;
    scene.ambient = glm::vec3(1.0f);
    return scene;
}

int add_shape(scene::Scene& scene, const std::string& shape, int detail, const glm::vec3& position,
              const lighting::Material& material) {
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(shape, detail).value());
    object.world_from_object[3] = glm::vec4(position, 1.0f);
    object.part_material.assign(object.mesh->parts.size(), static_cast<int>(scene.materials.size()));
    scene.materials.push_back(material);
    scene.objects.push_back(object);
    return static_cast<int>(scene.objects.size()) - 1;
}

lighting::Material shiny(const glm::vec3& m_D, float shininess, lighting::ReflectionModel model) {
    lighting::Material material;
    material.model = model;
    material.phong.ambient = 0.15f * m_D;
    material.phong.diffuse = m_D;
    material.phong.specular = glm::vec3(0.4f);
    material.phong.shininess = shininess;
    return material;
}

lighting::Material matte(const glm::vec3& m_D) {
    lighting::Material material = shiny(m_D, 1.0f, lighting::ReflectionModel::lambert);
    material.phong.specular = glm::vec3(0.0f);
    return material;
}

lighting::Light directional_light(const glm::vec3& direction, float intensity) {
    lighting::Light light;
    light.direction = direction;
    light.intensity = intensity;
    return light;
}

lighting::Light point_light(const glm::vec3& position, float intensity) {
    lighting::Light light;
    light.type = lighting::LightType::point;
    light.position = position;
    light.intensity = intensity;
    return light;
}

Image captioned(const scene::Scene& scene, const std::string& caption, int picture_height) {
    Image image = scene::render(scene);
    draw_caption(image, caption, text_scale(picture_height));
    return image;
}

Image difference_picture(const Image& a, const Image& b, float gain) {
    Image difference = a;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        difference.values[i] = gain * std::abs(a.values[i] - b.values[i]);
    }
    return difference;
}

}  // namespace kreda::examples
