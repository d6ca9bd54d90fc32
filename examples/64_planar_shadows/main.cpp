// 64_planar_shadows: flatten what casts onto the table. Four ways to do it wrong, and the right one.
// Page docs/64_planar_shadows.md | After 63_soft_shadows | New: planar_projection(), planar_shadow()
// Break at: planar_shadow | Look at: light_height, toward, polygon | Try: a lamp higher than the pillar
#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "raster/depth.hpp"
#include "scene/render/frame_shadows.hpp"
#include "scene/render/render.hpp"
#include "shadows/bvh.hpp"
#include "shadows/planar.hpp"
#include "shadows/projected_triangles.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// What drawing a shadow by hand needs to know of a rendered frame.
struct Stage {
    Image unshadowed;
    shadows::VisibleSampleMemory visible;
    std::vector<bool> is_table;
    std::vector<shadows::Triangle> casting;
    glm::dvec4 plane, light;
};

Stage make_stage(glm::ivec2 size) {
    scene::Scene scene = table_scene(size);
    scene.shadow.method = shadows::ShadowMethod::planar;
    const scene::RenderPlan plan = make_plan(scene);
    scene::RenderBuffers buffers;
    Stage stage;
    render(scene, plan, buffers, 0, [&](const scene::Frame& frame) {
        stage.casting = gather_triangles(collect_occluders(frame, plan.shadows[0].casters).list);
    });
    stage.plane = plan.shadows[0].receivers[0].plane;
    stage.light = homogeneous(plan.shadows[0].source);
    if (glm::dot(stage.plane, stage.light) < 0.0) stage.plane = -stage.plane;  // its front is where the lamp is
    stage.visible = buffers.visible;
    for (const std::uint32_t seen : buffers.visible.triangle) {
        const bool any = seen != raster::kNoTriangle;
        stage.is_table.push_back(any && buffers.triangles.chunks[seen >> raster::kChunkShift].instance == 0);
    }
    scene.lights[0].shadow = false;
    stage.unshadowed = scene::render(scene);
    return stage;
}

/// The images of all triangles on the sample grid. Clipped between table and lamp first; or divided by w before
/// anything is clipped, which throws what is higher than the lamp to the wrong side.
std::vector<shadows::ProjectedTriangle> flatten(const Stage& stage, bool clipped) {
    const glm::dmat4 M = shadows::planar_projection(stage.plane, stage.light);
    const glm::dmat4 clip_from_world(stage.visible.clip_from_world);
    std::vector<shadows::ProjectedTriangle> images;
    for (const shadows::Triangle& t : stage.casting) {
        shadows::OccluderPart polygon{{{{t.a, 1.0}, {t.b, 1.0}, {t.c, 1.0}}}, 3};
        if (clipped) polygon = shadows::between_plane_and_light(stage.plane, stage.light, t.a, t.b, t.c);
        const auto image = [&](int i) {
            const glm::dvec4 q = M * polygon.corner[i];
            return glm::vec4(clip_from_world * (clipped ? q : q / q.w));
        };
        raster::for_each_of_fan(0, polygon.count, [&](int i, int j, int k) {
            append_on_screen(image(i), image(j), image(k), stage.visible.viewport, images);
        });
    }
    return images;
}

/// Darken the picture under each image; `wanted(triangle, x, y, sample)` says where.
template <class Wanted>
Image darken(const Stage& stage, bool clipped, bool every_time, Wanted wanted) {
    Image image = stage.unshadowed;
    std::vector<bool> is_dark(stage.is_table.size(), false);
    for (const shadows::ProjectedTriangle& t : flatten(stage, clipped)) {
        for (int y = 0; y < image.height; ++y) {
            const shadows::SampleSpan span = covered_in_row(t, y, image.width);
            for (int x = span.first; x <= span.last; ++x) {
                const int i = y * image.width + x;
                if (!wanted(t, x, y, i) || (is_dark[i] && !every_time)) continue;
                image.set_rgb(x, y, 0.45f * image.rgb(x, y));
                is_dark[i] = true;
            }
        }
    }
    return image;
}

void draw(const Options& options) {
    scene::Scene scene = table_scene({options.width, options.height});
    scene.image.samples = 3;
    scene.shadow.method = shadows::ShadowMethod::planar;
    render_and_save(options, "planar", scene);

    const int n = options.samples;  // shadows are drawn by hand on n x n samples a pixel
    const Stage stage = make_stage(n * panel_size(options.width, options.height, 3, 2));
    const auto on_table = [&](const auto&, int, int, int i) { return stage.is_table[i]; };
    const auto anywhere = [](const auto&, int, int, int) { return true; };
    const auto nearer = [&](const shadows::ProjectedTriangle& t, int x, int y, int i) {
        const raster::DepthPlane plane =
            depth_plane(t.a, t.b, t.c, raster::edge_function(t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y));
        return depth_at(plane, depth_of_row(plane, y), x) < stage.visible.depth[i];
    };
    std::vector<Image> images = {darken(stage, true, false, on_table), darken(stage, false, false, on_table),
                                 darken(stage, true, false, anywhere), darken(stage, true, false, nearer),
                                 darken(stage, true, true, on_table)};
    for (Image& image : images) image = box_average(image, n);
    save_panels(options, "mistakes", 3,
                with_captions(images, {"right", "not clipped", "off the table", "z-fighting", "darkened twice"}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "64_planar_shadows", draw);
}
