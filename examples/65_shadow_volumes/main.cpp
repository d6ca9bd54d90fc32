// 65_shadow_volumes: extrude the silhouettes, count faces behind every pixel: where the count is not 0 is shadow.
// Page docs/65_shadow_volumes.md | After 64_planar_shadows | New: make_shadow_volume(), pushed_away(), count_volumes()
// Break at: make_shadow_volume | Look at: shape.caps, shape.sides | Try: a lamp inside the ball, a teapot (it is open)
#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "scene/render/frame_shadows.hpp"
#include "scene/render/render.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/silhouette.hpp"
#include "shadows/volume.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// A rendered frame and what casts in it.
struct Stage {
    scene::Scene scene;
    scene::RenderBuffers buffers;
    shadows::ShadowLight light;
    std::vector<shadows::VolumeCaster> casters;  ///< look into the buffers
};

Stage make_stage(scene::Scene scene) {
    Stage stage;
    stage.scene = std::move(scene);
    stage.scene.shadow.method = shadows::ShadowMethod::volume;
    const scene::RenderPlan plan = make_plan(stage.scene);
    render(stage.scene, plan, stage.buffers, 0, [&](const scene::Frame& frame) {
        const std::vector<shadows::Occluder> occluders = collect_occluders(frame, plan.shadows[0].casters).list;
        for (std::size_t i = 0; i < occluders.size(); ++i) {
            const auto object = static_cast<std::size_t>(plan.shadows[0].casters[i]);
            stage.casters.push_back({occluders[i], shadows::clip_positions(stage.buffers.instances[object],
                                                                           stage.buffers.visible.clip_from_world)});
        }
    });
    stage.light = plan.shadows[0].source;
    return stage;
}

/// How many faces a ray leaves less how many it enters, behind what is seen; or, with `before`, the other way round
/// before it.
std::vector<std::int32_t> count(const Stage& stage, bool before) {
    shadows::VisibleSamples samples = stage.buffers.visible.samples();
    const shadows::VolumeFaces faces = make_volume_faces(stage.casters, stage.light, samples);
    std::vector<std::int32_t> behind = count_volumes(faces, samples);
    if (!before) return behind;
    const std::vector<float> at_the_camera(samples.depth.size(), 0.0f);
    samples.depth = at_the_camera;
    const std::vector<std::int32_t> all = count_volumes(faces, samples);
    for (std::size_t i = 0; i < all.size(); ++i) behind[i] -= all[i];
    return behind;
}

/// The counter as colours over a darkened picture: 1 blue, 2 orange, 3 and more red; below 0 green.
Image counter_picture(const Stage& stage, const std::vector<std::int32_t>& counts) {
    Image image = stage.buffers.film;
    for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
        const int n = counts[i], x = i % image.width, y = i / image.width;
        const glm::vec3 color = n < 0 ? kGreen : n == 1 ? kBlue : n == 2 ? kOrange : kRed;
        if (stage.buffers.visible.depth[i] >= 1.0f) continue;
        image.set_rgb(x, y, n == 0 ? 0.35f * image.rgb(x, y) : 0.9f * color);
    }
    return image;
}

void draw_edge(Image& image, const glm::vec4& a, const glm::vec4& b, float width, const glm::vec3& color) {
    const glm::vec2 half(0.5f * image.width, -0.5f * image.height), middle(0.5f * image.width, 0.5f * image.height);
    if (a.w <= 0.0f || b.w <= 0.0f) return;
    draw_line(image, middle + half * glm::vec2(a) / a.w, middle + half * glm::vec2(b) / b.w, width, color);
}

/// The edges between what the lamp sees and what it does not, and the way from each corner away from the lamp.
Image silhouette_picture(const Stage& stage) {
    Image image = stage.buffers.film;
    for (float& value : image.values) value *= 0.5f;
    const float line = std::max(1.0f, static_cast<float>(image.height) / 178.0f);
    for (const shadows::VolumeCaster& caster : stage.casters) {
        const shadows::VolumeShape shape = make_shadow_volume(caster.occluder, homogeneous(stage.light));
        for (const shadows::SilhouetteEdge& edge : shape.sides) {
            const glm::vec3 corner = caster.occluder.positions[edge.from];
            const glm::vec4 away(corner + 0.8f * (corner - stage.light.position), 1.0f);
            draw_edge(image, caster.position_clip[edge.from], stage.buffers.visible.clip_from_world * away, 0.6f * line,
                      kDust);
        }
        for (const shadows::SilhouetteEdge& edge : shape.sides) {
            draw_edge(image, caster.position_clip[edge.from], caster.position_clip[edge.to], 2.0f * line, kYellow);
        }
    }
    return image;
}

/// The camera in the shadow of the ball, looking at the box.
scene::Scene from_inside(glm::ivec2 size) {
    scene::Scene scene = table_scene(size);
    scene.camera.position = kBallCentre + 0.55f * (kBallCentre - kLampPosition);
    scene.camera.target = {-0.75f, 0.1f, 0.15f};
    scene.camera.vertical_fov_deg = 75.0f;
    scene.camera.near = 0.02f;
    return scene;
}

void draw(const Options& options) {
    const int n = options.samples;  // every sample is counted; a pixel is the mean of n x n
    const glm::ivec2 size = n * panel_size(options.width, options.height, 2, 2);
    const Stage stage = make_stage(table_scene(size));
    const Stage inside = make_stage(from_inside(size));
    std::vector<Image> images = {silhouette_picture(stage), counter_picture(stage, count(stage, false)),
                                 counter_picture(inside, count(inside, true)),
                                 counter_picture(inside, count(inside, false))};
    for (Image& image : images) image = box_average(image, n);
    save_panels(options, "steps", 2,
                with_captions(images, {"silhouettes", "counted", "inside: before", "inside: behind"}));
    const Stage whole = make_stage(table_scene(n * glm::ivec2(options.width, options.height)));
    save(options, "counter", box_average(counter_picture(whole, count(whole, false)), n));
    save(options, "shadow", box_average(whole.buffers.film, n));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "65_shadow_volumes", draw);
}
