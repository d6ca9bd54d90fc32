// 66_irregular_z_buffer: the light's samples are the points that the camera sees, wherever they lie.
// Page docs/66_irregular_z_buffer.md | After 65_shadow_volumes | New: LightGrid, cells_in_row()
// Break at: set_up | Look at: q, triangle.edge, triangle.first_row | Try: a lamp nearer to the table
#include <algorithm>

#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "raster/visibility.hpp"
#include "scene/render/frame_shadows.hpp"
#include "scene/render/render.hpp"
#include "shadows/bvh.hpp"
#include "shadows/irregular.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// So few pixels that every sample can be drawn as a dot.
struct Few {
    scene::RenderBuffers buffers;
    raster::AlignedVector<float> factor;            ///< of every sample
    std::vector<shadows::LightGrid> grids;          ///< one for each side of the lamp that sees any
    std::vector<shadows::LightTriangle> triangles;  ///< in the fullest grid
};

const shadows::LightGrid& fullest(const std::vector<shadows::LightGrid>& grids) {
    return *std::max_element(grids.begin(), grids.end(),
                             [](const auto& a, const auto& b) { return a.points.size() < b.points.size(); });
}

Few draw_few(glm::ivec2 pixels) {
    Few few;
    scene::Scene scene = table_scene(pixels);
    scene.lights = {directional_light(-kLampPosition)};  // the sun from where the lamp was: one grid instead of six
    scene.lights[0].shadow = true;
    scene.shadow.method = shadows::ShadowMethod::irregular;
    const scene::RenderPlan plan = make_plan(scene, {scene::find_view("shadow")});
    render(scene, plan, few.buffers, 0, [&](const scene::Frame& frame) {
        few.grids = make_light_grids(plan.shadows[0].source, few.buffers.visible.samples());
        for (const shadows::Triangle& t :
             shadows::gather_triangles(collect_occluders(frame, plan.shadows[0].casters).list)) {
            few.triangles.push_back(set_up(fullest(few.grids), t));
        }
    });
    few.factor = few.buffers.views[0].values;
    return few;
}

glm::vec3 dot_color(float factor) {
    return factor > 0.5f ? kYellow : kBlue;
}

/// The pixels as squares, a dot in the middle of each that sees something.
Image camera_picture(const Few& few, glm::ivec2 size, int pixel) {
    Image image = make_board(size.x, size.y);
    Image dim = enlarge(few.buffers.film, pixel);
    for (float& value : dim.values) value *= 0.4f;
    paste(image, dim, 0, 0);
    for (int i = 0; i < static_cast<int>(few.factor.size()); ++i) {
        if (few.buffers.visible.depth[i] >= raster::kClearDepth) continue;
        const glm::vec2 place(i % few.buffers.film.width, i / few.buffers.film.width);
        draw_disc(image, (place + 0.5f) * static_cast<float>(pixel), 0.28f * static_cast<float>(pixel),
                  dot_color(few.factor[i]));
    }
    return image;
}

/// The same samples where the lamp sees them, its grid, and what casts.
Image lamp_picture(const Few& few, glm::ivec2 size) {
    const shadows::LightGrid& grid = fullest(few.grids);
    Image image = make_board(size.x, size.y);
    const glm::vec2 cell(static_cast<float>(size.x) / grid.columns, static_cast<float>(size.y) / grid.rows);
    const float line = std::max(1.0f, static_cast<float>(size.y) / 360.0f);
    for (int c = 1; c < grid.columns; ++c) draw_line(image, {c * cell.x, 0}, {c * cell.x, size.y}, 0.5f * line, kSlate);
    for (int r = 1; r < grid.rows; ++r) draw_line(image, {0, r * cell.y}, {size.x, r * cell.y}, 0.5f * line, kSlate);
    for (const shadows::LightTriangle& t : few.triangles) {
        for (int i = 0; i < t.corner_count; ++i) {
            const glm::vec2 a(t.corner[i]), b(t.corner[(i + 1) % t.corner_count]);
            draw_line(image, a * cell, b * cell, 0.3f * line, kGreen);
        }
    }
    for (const shadows::LightPoint& point : grid.points) {
        draw_disc(image, glm::vec2(grid.place(point.q)) * cell, 0.005f * size.x, dot_color(few.factor[point.sample]));
    }
    return image;
}

/// One corner of the table with its shadows.
Image close_up(glm::ivec2 size, int samples, shadows::ShadowMethod method, int map_size) {
    scene::Scene scene = table_scene(size, samples);
    scene.shadow.method = method;
    scene.shadow.size = map_size;
    scene.camera.target = {-0.75f, 0.05f, 0.1f};
    scene.camera.vertical_fov_deg = 17.0f;
    return scene::render(scene);
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 1);
    const int pixel = std::max(1, size.x / 52);
    const Few few = draw_few({size.x / pixel, size.y / pixel});
    save_panels(options, "samples", 2,
                {{camera_picture(few, size, pixel), "from the camera"},
                 as_drawings({{lamp_picture(few, size), "from the lamp"}})[0]});
    save_panels(options, "edges", 2,
                {{close_up(size, options.samples, shadows::ShadowMethod::map, 128), "map, 6 × 128 × 128"},
                 {close_up(size, options.samples, shadows::ShadowMethod::irregular, 128), "irregular"}});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "66_irregular_z_buffer", draw);
}
