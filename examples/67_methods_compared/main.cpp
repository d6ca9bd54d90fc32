// 67_methods_compared: every method against rays: where it errs, by how much, and how long it takes.
// Page docs/67_methods_compared.md | After 66_irregular_z_buffer | New: compare_shadows(), error_picture()
// Break at: compare_shadows | Look at: error.acne, error.leaks | Try: scene.shadow.bias none, a map of 64 texels
#include <algorithm>
#include <cstdio>

#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "scene/render/render.hpp"
#include "shadows/compare.hpp"

using namespace kreda;
using namespace kreda::examples;
using shadows::ShadowMethod;

namespace {

struct Candidate {
    std::string name;
    ShadowMethod method;
    int size = 1024;
};

/// What one method says about a frame.
struct Answer {
    raster::AlignedVector<float> factor;
    shadows::VisibleSampleMemory visible;  ///< only of methods that look at all samples at once
    double ms = 0.0;                       ///< the whole picture
};

/// The table with a knot and an open pot on it. `nudge` turns the camera by so many pixels.
scene::Scene crowded_table(glm::ivec2 size, const Candidate& candidate, float nudge) {
    scene::Scene scene = table_scene(size);
    add_scaled_shape(scene, "torus_knot", 160, {-1.1f, 0.5f, -0.5f}, glm::vec3(0.27f), matte(kRed));
    add_scaled_shape(scene, "teapot", 10, {1.05f, 0.0f, -0.55f}, glm::vec3(0.5f), matte(kChalk));
    scene.camera.target.x +=
        nudge * 3.4f * 2.0f * 0.344f / static_cast<float>(size.y);  // distance x 2 tan(fov / 2) / rows
    scene.shadow.method = candidate.method;
    scene.shadow.size = candidate.size;
    return scene;
}

Answer ask(glm::ivec2 size, const Candidate& candidate, float nudge = 0.0f) {
    const scene::Scene scene = crowded_table(size, candidate, nudge);
    scene::RenderBuffers buffers;
    const scene::RenderPlan plan = make_plan(scene, {scene::find_view("shadow")});
    const double ms = render(scene, plan, buffers).times.total_ms;
    return {buffers.views[0].values, std::move(buffers.visible), ms};
}

void print_row(const Candidate& candidate, const shadows::ShadowError& error, double flicker, double ms) {
    const auto share = [&](std::uint64_t count) {
        return 100.0 * static_cast<double>(count) / static_cast<double>(error.visible);
    };
    std::printf("%-12s %8.3f %8.3f %8.3f %10.3f %8.4f %9.3f %8.1f\n", candidate.name.c_str(),
                share(error.misclassified()), share(error.acne), share(error.leaks), error.edge_displacement,
                error.rmse, 100.0 * flicker, ms);
}

void draw(const Options& options) {
    const std::vector<Candidate> candidates = {
        {"map 256", ShadowMethod::map, 256},   {"map 1024", ShadowMethod::map, 1024},
        {"map 2048", ShadowMethod::map, 2048}, {"planar", ShadowMethod::planar},
        {"volumes", ShadowMethod::volume},     {"irregular", ShadowMethod::irregular}};
    const glm::ivec2 small = measured_size(options);  // wrong pixels are shown as squares of a larger picture
    const glm::ivec2 size = panel_size(small.x, small.y, 3, 2);
    const int pixel = options.height / small.y;
    const auto exact = ask(size, {"exact", ShadowMethod::exact}).factor;
    const shadows::VisibleSampleMemory visible = ask(size, candidates.back()).visible;
    std::printf("method       wrong %%   acne %%   leak %%  edge off/px    rmse  flicker %%       ms\n");
    std::vector<Panel> panels;
    for (const Candidate& candidate : candidates) {
        const Answer answer = ask(size, candidate), nudged = ask(size, candidate, 0.1f);
        const shadows::ShadowError error = compare_shadows(visible.samples(), exact, answer.factor, 2);
        print_row(candidate, error, flipped_share(visible.samples(), answer.factor, nudged.factor), answer.ms);
        char caption[40];
        std::snprintf(caption, sizeof caption, "%s %.2f %%", candidate.name.c_str(),
                      100.0 * error.misclassified_share());
        panels.emplace_back(enlarge(error_picture(visible.samples(), exact, answer.factor), pixel), caption);
    }
    save_panels(options, "errors", 3, panels);
    scene::Scene scene = crowded_table({options.width, options.height}, {"exact", ShadowMethod::exact}, 0.0f);
    scene.image.samples = 3;
    render_and_save(options, "exact", scene);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "67_methods_compared", draw);
}
