// Experiments on shadows: maps against exact ones, soft filters against a wide lamp.
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/paired_times.hpp"
#include "tools/measure/picture.hpp"
#include "tools/measure/shadow_settings.hpp"

namespace kreda::tools {

namespace {

constexpr const char* kTable = R"(
[image]
size = [320, 180]
[camera]
position = [0, 2.2, 4.2]
target = [0, 0.4, 0]
vertical_fov = 40
[[light]]
type = "directional"
direction = [-1, -1.1, -0.6]
shadow = true
[[material]]
name = "wood"
model = "lambert"
diffuse = [0.7, 0.6, 0.5]
[[object]]
mesh = "plane"
scale = [2, 1, 1.5]
material = "wood"
casts_shadow = false
[[object]]
mesh = "cube"
scale = [0.3, 0.3, 0.3]
translate = [-0.7, 0.3, 0.2]
material = "wood"
[[object]]
mesh = "sphere"
detail = 48
scale = [0.35, 0.35, 0.35]
translate = [0.4, 0.7, 0.2]
material = "wood"
)";

std::string name_of(shadows::ShadowFilter filter) {
    const std::array<const char*, 3> names = {"none", "pcf", "pcss"};
    return names[static_cast<std::size_t>(filter)];
}
std::string name_of(shadows::ShadowBias bias) {
    const std::array<const char*, 4> names = {"none", "constant", "slope", "normal_offset"};
    return names[static_cast<std::size_t>(bias)];
}

}  // namespace

Finding measure_shadow_map(const Effort& effort) {
    Finding finding{{{"filter", "bias", "size", "wrong [%]", "acne [%]", "edge off [pixels]", "time [ms]"}, {}},
                    {"texels a side", "wrong samples [%]", true, true, {}, true},
                    ""};
    const scene::Scene scene = effort.quick ? scene_of(kTable) : scene_of(kTable, {"image.size=[1280,720]"});
    const std::vector<ShadowRow> rows = measure_shadow_maps(scene, 0.02f, 2, effort.progress);
    double without_bias = 0.0, with_bias = 0.0, small = 0.0, large = 0.0;
    for (const ShadowRow& row : rows) {
        const double visible = static_cast<double>(row.error.visible);
        const shadows::ShadowBias bias = kMapBiases[row.bias];
        const std::string name = name_of(kMapFilters[row.filter]) + ", " + name_of(bias);
        finding.table.add({name_of(kMapFilters[row.filter]), name_of(bias), std::to_string(kMapSizes[row.size]),
                           digits(wrong_percent(row)), digits(100.0 * static_cast<double>(row.error.acne) / visible),
                           digits(row.error.edge_displacement), digits(row.ms)});
        if (row.filter < 2 && bias != shadows::ShadowBias::constant) {
            if (finding.plot.series.empty() || finding.plot.series.back().name != name)
                finding.plot.series.push_back({name, {}});
            finding.plot.series.back().points.emplace_back(kMapSizes[row.size], wrong_percent(row));
        }
        if (row.filter != 0) continue;
        if (bias == shadows::ShadowBias::none && row.size == 2) without_bias = wrong_percent(row);
        if (bias == shadows::ShadowBias::slope && row.size == 2) with_bias = wrong_percent(row);
        if (bias == shadows::ShadowBias::slope && row.size == 0) small = wrong_percent(row);
        if (bias == shadows::ShadowBias::slope && row.size == 3) large = wrong_percent(row);
    }
    finding.text =
        "A map of 1024 texels a side gets " + fixed(without_bias, 2) + " % of the samples wrong without bias and " +
        fixed(with_bias, 3) + " % with the least bias that a flat surface needs. From 256 to 2048 texels a side " +
        "the error falls from " + digits(small) + " % to " + digits(large) +
        " %: the edges' length stays, their displacement shrinks with the texels. Without a bias a larger map " +
        "does not help.";
    return finding;
}

namespace {

/// The scene with so many lamps a side in a square across the sun's direction, each a small part of it, in place of the
/// wide one.
scene::Scene with_many_lamps(scene::Scene scene, int side, float width) {
    const lighting::Light sun = scene.lights[0];
    const glm::vec3 d = glm::normalize(sun.direction);
    const glm::vec3 across = glm::normalize(glm::cross(d, glm::vec3(0.0f, 1.0f, 0.0f))), up = glm::cross(across, d);
    scene.lights.clear();
    for (int i = 0; i < side * side; ++i) {
        const float x = (static_cast<float>(i % side) + 0.5f) / static_cast<float>(side) - 0.5f;
        const float y = (static_cast<float>(i / side) + 0.5f) / static_cast<float>(side) - 0.5f;
        lighting::Light lamp = sun;
        lamp.direction = d + width * (x * across + y * up);
        lamp.intensity = sun.intensity / static_cast<float>(side * side);
        scene.lights.push_back(lamp);
    }
    scene.shadow.method = shadows::ShadowMethod::exact;
    return scene;
}

}  // namespace

Finding measure_soft_shadow(const Effort& effort) {
    Finding finding{
        {{"width of the sun", "filter", "mean error [codes]", "99th percentile [codes]", "worst [codes]"}, {}},
        {"width of the sun at distance 1", "mean error [codes]", true, true, {}, true},
        ""};
    const std::vector<const char*> filters = {"none", "pcf", "pcss"};
    for (const char* filter : filters) finding.plot.series.push_back({filter, {}});
    const std::vector<float> widths = {0.02f, 0.05f, 0.1f, 0.2f, 0.4f};
    std::vector<std::vector<double>> means(filters.size());
    for (std::size_t w = 0; w < widths.size(); ++w) {
        scene::RenderBuffers buffers;
        const scene::Scene base = scene_of(kTable);
        const raster::Image exact =
            draw_picture(with_many_lamps(base, effort.count(8, 24), widths[w]), buffers, effort.threads).encoded;
        for (std::size_t f = 0; f < filters.size(); ++f) {
            scene::RenderBuffers own;
            const scene::Scene scene =
                scene_of(kTable, {std::string("shadow.filter=") + filters[f], "shadow.size=2048", "shadow.radius=4",
                                  "shadow.light_size=" + digits(double{widths[w]})});
            const CodeError error = code_error(draw_picture(scene, own, effort.threads).encoded, exact);
            means[f].push_back(error.mean);
            finding.table.add(
                {digits(double{widths[w]}), filters[f], digits(error.mean), digits(error.p99), digits(error.worst)});
            finding.plot.series[f].points.emplace_back(double{widths[w]}, error.mean);
        }
        effort.show(static_cast<double>(w + 1) / static_cast<double>(widths.size()));
    }
    const int side = effort.count(8, 24);
    finding.text = "Against " + std::to_string(side * side) +
                   " lamps spread over the sun, each with exact shadows: for a sun of width 0.02 hard edges miss " +
                   fixed(means[0].front(), 3) + " codes in the mean, pcf " + fixed(means[1].front(), 3) + " and pcss " +
                   fixed(means[2].front(), 3) + "; for one of width 0.4 they miss " + fixed(means[0].back(), 3) + ", " +
                   fixed(means[1].back(), 3) + " and " + fixed(means[2].back(), 3) +
                   ". pcf blurs all edges alike, pcss as the blocker's distance says.";
    return finding;
}

}  // namespace kreda::tools
