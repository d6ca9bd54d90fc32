#include "tools/measure/shadow_settings.hpp"

#include "scene/render/render.hpp"

namespace kreda::tools {

double wrong_percent(const ShadowRow& row) {
    return 100.0 * row.error.misclassified_share();
}

std::vector<ShadowRow> measure_shadow_maps(scene::Scene scene, float light_size, int band,
                                           const lighting::Progress& progress) {
    const std::vector<const scene::View*> views = {scene::find_view("shadow")};
    scene.shadow.method = shadows::ShadowMethod::irregular;  // exact, and it keeps what the camera sees
    scene::RenderBuffers exact, buffers;
    render(scene, make_plan(scene, views), exact);
    scene.shadow.method = shadows::ShadowMethod::map;
    scene.shadow.light_size = light_size;
    scene.shadow.size = kMapSizes.back();
    render(scene, make_plan(scene, views), buffers);  // the first frame allocates: not timed
    std::vector<ShadowRow> rows;
    constexpr std::size_t kCount = kMapFilters.size() * kMapBiases.size() * kMapSizes.size();
    for (std::size_t i = 0; i < kCount; ++i) {
        ShadowRow row{i / 16, i / 4 % 4, i % 4, {}, 0.0};
        scene.shadow.filter = kMapFilters[row.filter];
        scene.shadow.bias = kMapBiases[row.bias];
        scene.shadow.size = kMapSizes[row.size];
        row.ms = render(scene, make_plan(scene, views), buffers, 1).times.total_ms;
        row.error = compare_shadows(exact.visible.samples(), exact.views[0].values, buffers.views[0].values, band);
        rows.push_back(row);
        if (progress) progress(static_cast<double>(i + 1) / kCount);
    }
    return rows;
}

}  // namespace kreda::tools
