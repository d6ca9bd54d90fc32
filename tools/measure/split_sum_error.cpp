#include "tools/measure/split_sum_error.hpp"

#include <algorithm>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raster/shapes.hpp"

namespace kreda::tools {

SpecularPicture draw_specular(const scene::Scene& scene, scene::RenderBuffers& buffers) {
    std::vector<const scene::View*> views;
    for (const char* name : {"environment_specular", "normal", "to_viewer", "roughness", "metallic"}) {
        views.push_back(scene::find_view(name));
    }
    render(scene, make_plan(scene, views), buffers);
    const std::vector<raster::Image>& v = buffers.views;
    SpecularPicture picture{buffers.film, {}};
    for (int y = 0; y < picture.film.height; ++y) {
        for (int x = 0; x < picture.film.width; ++x) {
            const glm::vec3 n = v[1].rgb(x, y);
            if (n == glm::vec3(0.0f)) continue;  // the background
            const float n_dot_v = std::max(glm::dot(n, v[2].rgb(x, y)), 0.0f);
            picture.samples.push_back({v[0].rgb(x, y), n_dot_v, v[3].at(0, x, y), v[4].at(0, x, y)});
        }
    }
    return picture;
}

scene::Scene metal_ball(const scene::EnvironmentSettings& environment, float roughness, int side) {
    scene::Scene scene;
    scene.image.width = scene.image.height = side;
    scene.ambient = glm::vec3(0.0f);
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 2.0f;
    scene.environment = environment;
    scene.environment.on = true;
    lighting::Material metal;
    metal.model = lighting::ReflectionModel::cook_torrance;
    metal.cook_torrance.albedo = glm::vec3(0.9f);
    metal.cook_torrance.metallic = 1.0f;
    metal.cook_torrance.roughness = roughness;
    metal.cook_torrance.geometry = lighting::Geometry::smith_correlated;
    scene.materials = {metal};
    scene::Object ball;
    ball.mesh = std::make_shared<raster::Mesh>(raster::make_shape("sphere", 64).value());
    ball.part_material = {0};
    scene.objects = {ball};
    return scene;
}

scene::Scene with_reference(scene::Scene scene, int samples) {
    scene.environment.reference = samples;
    return scene;
}

double error_percent(const SpecularPicture& split, const SpecularPicture& exact, float roughness, float from,
                     float to) {
    double error = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < exact.samples.size(); ++i) {
        const SpecularSample& seen = split.samples[i];
        const SpecularSample& truth = exact.samples[i];
        if (truth.roughness != roughness || truth.metallic < 1.0f) continue;
        if (truth.n_dot_v < from || truth.n_dot_v >= to) continue;
        const double weight = 1.0 / std::max(truth.n_dot_v, 1e-3f);
        error += weight * glm::dot(glm::abs(seen.radiance - truth.radiance), glm::vec3(1.0f));
        sum += weight * glm::dot(truth.radiance, glm::vec3(1.0f));
    }
    return sum > 0.0 ? 100.0 * error / sum : 0.0;
}

}  // namespace kreda::tools
