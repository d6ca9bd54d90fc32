#include "tools/measure/frequency_error.hpp"

#include <algorithm>
#include <string>

#include "tools/bench/time_report.hpp"

namespace kreda::tools {

namespace {

constexpr const char* kBall = R"(
[image]
samples = 2
[camera]
position = [0, 0, 4]
target = [0, 0, 0]
vertical_fov = 32
[[light]]
type = "directional"
direction = [-1, -1, -1.5]
[[material]]
name = "plastic"
model = "phong"
shininess = 32
[[object]]
mesh = "sphere"
material = "plastic"
)";

}  // namespace

scene::Scene shiny_ball(std::size_t frequency, int detail, glm::ivec2 size) {
    return scene_of(kBall, {"image.size=[" + std::to_string(size.x) + "," + std::to_string(size.y) + "]",
                            "object.0.detail=" + std::to_string(detail),
                            std::string("shading.frequency=") + kFrequencyNames[frequency]});
}

raster::Image finest_ball(glm::ivec2 size, int threads) {
    scene::RenderBuffers buffers;
    return draw_picture(shiny_ball(2, 512, size), buffers, threads).encoded;
}

std::vector<FrequencyRow> measure_frequency_rows(std::size_t frequency, const std::vector<int>& details,
                                                 const raster::Image& exact, int frames, int threads) {
    std::vector<FrequencyRow> rows;
    for (const int detail : details) {
        const scene::Scene scene = shiny_ball(frequency, detail, {exact.width, exact.height});
        scene::RenderBuffers buffers;
        const Picture first = draw_picture(scene, buffers, threads);
        std::vector<double> ms = {first.frame_ms};
        for (int i = 1; i < frames; ++i) ms.push_back(draw_picture(scene, buffers, threads).frame_ms);
        rows.push_back(
            {frequency, detail, scene.objects[0].mesh->triangle_count(), code_error(first.encoded, exact), median(ms)});
    }
    return rows;
}

}  // namespace kreda::tools
