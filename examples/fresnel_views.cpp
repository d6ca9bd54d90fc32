#include "examples/fresnel_views.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "examples/paint.hpp"

namespace kreda::examples {

namespace {

constexpr int kViews = tools::kViewsAround;
constexpr int kShownView = 47;
constexpr glm::ivec2 kViewSize(96, 72);

float positive_n_dot_v(const SurfacePoint& point) {
    return std::max(glm::dot(point.n, point.v), 0.0f);  // below 0 at a silhouette: the interpolated normal looks away
}

glm::vec3 color_of(const FresnelCurve& curve, float c) {
    return {curve.F(c, 0), curve.F(c, 1), curve.F(c, 2)};
}

}  // namespace

std::vector<float> cosines_of_views(const raster::Mesh& mesh, glm::ivec2 size) {
    std::vector<float> cosines;
    for (int view = 0; view < kViews; ++view) {
        for_each_surface_point(mesh, comparison_camera(view), size, [&](int, int, const SurfacePoint& point) {
            cosines.push_back(positive_n_dot_v(point));
        });
    }
    return cosines;
}

void add_comparison(const Subject& subject, glm::ivec2 size, const lighting::ThreeChannelIndex& index, float gain,
                    std::vector<Panel>& panels) {
    const FresnelCurve schlick = fresnel_curves(index)[1];
    const FresnelCurve exact = {
        "exact", [&index](float c, int i) { return static_cast<float>(exact_fresnel(c, index.n[i], index.k[i])); }};
    raster::Camera camera = comparison_camera(kShownView);
    camera.vertical_fov_deg = 64.0f;
    const auto add = [&](const std::string& name, const SurfaceColor& color) {
        panels.emplace_back(paint(subject.mesh, camera, size, 3, glm::vec3(0.0f), color), name);
    };
    add("exact", [&](const SurfacePoint& point) { return color_of(exact, positive_n_dot_v(point)); });
    add("Schlick", [&](const SurfacePoint& point) { return color_of(schlick, positive_n_dot_v(point)); });
    add("mask", [](const SurfacePoint&) { return glm::vec3(1.0f); });
    char amplified[32];
    std::snprintf(amplified, sizeof amplified, "error x %g", gain);
    add(amplified, [&](const SurfacePoint& point) {
        const float c = positive_n_dot_v(point);
        const glm::vec3 F = color_of(exact, c);
        return gain * glm::abs(color_of(schlick, c) - F) / F;
    });
}

void print_picture_errors() {
    constexpr std::size_t kShown[] = {1, 2, 4, 6};  // rescaled, corrected, F82, table of 256
    std::printf("\nMean relative error in percent over the pixels of %d views; in brackets as published in 2014\n",
                kViews);
    std::printf("%-10s %-6s %-16s %-16s %-8s %s\n", "", "", "Schlick", "corrected", "F82", "table of 256");
    const char* const published[4][2][2] = {{{"0.59", "0.52"}, {"0.87", "0.79"}},
                                            {{"2.4", "1.16"}, {"3.03", "1.66"}},
                                            {{"7.7", "-"}, {"10.1", "-"}},
                                            {{"2.62", "-"}, {"3.19", "-"}}};
    const std::vector<Subject> subjects = comparison_subjects();
    for (std::size_t s = 0; s < subjects.size(); ++s) {
        const std::vector<float> cosines = cosines_of_views(subjects[s].mesh, kViewSize);
        const char* const materials[] = {"gold", "platinum", "water", "diamond"};
        for (std::size_t m = 0; m < 4; ++m) {
            const lighting::ThreeChannelIndex index = lighting::published_index(materials[m]);
            const std::vector<double> errors = mean_errors_percent(fresnel_curves(index), index, cosines);
            std::printf("%-10s %-6s", materials[m], subjects[s].name.c_str());
            for (int i = 0; i < 2; ++i) std::printf(" %6.2f  (%4s)  ", errors[kShown[i]], published[m][s][i]);
            std::printf(" %-8.2f %.4f\n", errors[kShown[2]], errors[kShown[3]]);
        }
    }
}

}  // namespace kreda::examples
