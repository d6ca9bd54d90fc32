#include "examples/table_scene.hpp"

#include "scene/render/render.hpp"

namespace kreda::examples {

int add_scaled_shape(scene::Scene& scene, const std::string& shape, int detail, const glm::vec3& position,
                     const glm::vec3& scale, const lighting::Material& material) {
    const int object = add_shape(scene, shape, detail, position, material);
    for (int axis = 0; axis < 3; ++axis) scene.objects.back().world_from_object[axis][axis] = scale[axis];
    return object;
}

scene::Scene table_scene(glm::ivec2 size, int samples) {
    scene::Scene scene = empty_scene(size);
    scene.image.samples = samples;
    scene.camera.position = {1.7f, 2.2f, 4.0f};
    scene.camera.target = {-0.1f, 0.5f, 0.0f};
    scene.camera.vertical_fov_deg = 32.0f;
    const glm::vec3 table_size(kTableHalfSize.x, 1.0f, kTableHalfSize.y);
    add_scaled_shape(scene, "plane", 1, glm::vec3(0.0f), table_size, matte(kDust));
    add_scaled_shape(scene, "cube", 1, kBoxCentre, kBoxHalfSize, matte(kBlue));
    add_scaled_shape(scene, "sphere", 48, kBallCentre, glm::vec3(kBallRadius), matte(kOrange));
    add_scaled_shape(scene, "cube", 1, kPillarCentre, kPillarHalfSize, matte(kGreen));
    scene.lights = {point_light(kLampPosition, 1.1f)};
    scene.lights[0].shadow = true;
    scene.shadow.method = shadows::ShadowMethod::exact;
    return scene;
}

scene::Scene sunny_table(glm::ivec2 size, int samples) {
    scene::Scene scene = table_scene(size, samples);
    scene.lights = {directional_light({-1.0f, -1.1f, -0.6f})};
    scene.lights[0].shadow = true;
    scene.shadow.method = shadows::ShadowMethod::map;
    return scene;
}

scene::Scene sunny_table_closely(glm::ivec2 size, int samples) {
    scene::Scene scene = sunny_table(size, samples);
    scene.camera.target = {-0.35f, 0.15f, 0.1f};
    scene.camera.vertical_fov_deg = 17.0f;
    return scene;
}

raster::AlignedVector<float> shadow_factors(const scene::Scene& scene) {
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("shadow")}), buffers);
    return buffers.views[0].values;
}

}  // namespace kreda::examples
