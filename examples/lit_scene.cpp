#include "examples/lit_scene.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raster/shapes.hpp"
#include "scene/render/render.hpp"

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

std::vector<lighting::Light> lights_all_around(int count, const std::function<glm::vec3(const glm::vec3&)>& radiance) {
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<lighting::Light> lights;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count;  // equal heights of a sphere hold equal areas
        const double ring = std::sqrt(1.0 - y * y);
        const double turn = golden_angle * i;
        const glm::vec3 from(ring * std::cos(turn), y, ring * std::sin(turn));
        lighting::Light light = directional_light(-from, static_cast<float>(4.0 * std::numbers::pi / count));
        light.color = radiance(from);
        if (light.color != glm::vec3(0.0f)) lights.push_back(light);
    }
    return lights;
}

glm::vec3 studio(const glm::vec3& direction) {
    const auto lamp = [&](const glm::vec3& from, float cosine_of_edge) {
        const float inside = (glm::dot(direction, glm::normalize(from)) - cosine_of_edge) / (1.0f - cosine_of_edge);
        return raster::saturate(3.0f * inside);  // a soft edge
    };
    const glm::vec3 soft_box = glm::vec3(6.0f, 6.1f, 6.3f) * lamp({-0.8f, 0.8f, 0.6f}, 0.84f);
    const glm::vec3 warm = glm::vec3(3.6f, 2.8f, 2.0f) * lamp({1.0f, 0.35f, 0.1f}, 0.87f);
    const float up = 0.5f + 0.5f * direction.y;
    return soft_box + warm + glm::mix(glm::vec3(0.10f, 0.09f, 0.08f), glm::vec3(0.35f, 0.38f, 0.42f), up);
}

lighting::Material microfacet(const glm::vec3& albedo, float metallic, float roughness) {
    lighting::Material material;
    material.model = lighting::ReflectionModel::cook_torrance;
    material.cook_torrance.albedo = albedo;
    material.cook_torrance.metallic = metallic;
    material.cook_torrance.roughness = roughness;
    material.cook_torrance.geometry = lighting::Geometry::smith_correlated;
    return material;
}

Panel captioned(const scene::Scene& scene, const std::string& caption) {
    return {scene::render(scene), caption};
}

namespace {

/// How much of each pixel something covers, of 3 x 3 samples.
Image coverage_of(scene::Scene scene) {
    scene.image.samples = 3;
    scene.image.background = glm::vec3(0.0f);
    scene.environment.on = false;
    scene.lights.clear();
    for (lighting::Material& material : scene.materials) {
        material.model = lighting::ReflectionModel::unlit;
        material.phong.diffuse = glm::vec3(1.0f);
    }
    return scene::render(scene);
}

/// The mean colour of those of the nine pixels around (x, y) that are covered whole; its own if none is.
glm::vec3 color_beside(const Image& lit, const Image& coverage, int x, int y) {
    glm::vec3 sum(0.0f);
    int count = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, lit.height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, lit.width - 1); ++i) {
            if (coverage.at(0, i, j) < 0.999f) continue;
            sum += lit.rgb(i, j);
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<float>(count) : lit.rgb(x, y);
}

}  // namespace

Image render_outlined(const Options& options, const scene::Scene& scene) {
    if (options.draft) return scene::render(scene);
    scene::Scene once = scene;
    once.image.samples = 1;
    const Image lit = scene::render(once), coverage = coverage_of(scene);
    Image image = lit;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float covered = coverage.at(0, x, y);
            if (covered < 0.001f || covered > 0.999f) continue;
            image.set_rgb(x, y, glm::mix(scene.image.background, color_beside(lit, coverage, x, y), covered));
        }
    }
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
