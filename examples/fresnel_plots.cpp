#include "examples/fresnel_plots.hpp"

#include <cmath>
#include <string>

#include <glm/trigonometric.hpp>

#include "examples/plot_legend.hpp"
#include "examples/plots.hpp"
#include "lighting/fresnel.hpp"

namespace kreda::examples {

namespace {

using lighting::fresnel_dielectric;

constexpr AxisRange kRightAngle{0.0, 90.0};

float cosine_of_degrees(double degrees) {
    return static_cast<float>(std::cos(glm::radians(degrees)));
}

/// What an index of refraction does: from hydrogen, that nearly nothing is reflected of, to germanium.
Plot index_plot() {
    Plot plot = empty_plot("angle [degrees]", "$F$", false, true);
    plot.x_range = kRightAngle;
    plot.y_range = {1e-7, 1.0};
    plot.key = "off";
    for (const float n : {1.001f, 1.33f, 2.04f, 4.01f}) {
        plot.series.push_back(curve(std::to_string(n).substr(0, 5), kRightAngle,
                                    [n](double a) { return fresnel_dielectric(cosine_of_degrees(a), n); }));
    }
    return plot;
}

/// Water, and NVIDIA's form with numbers chosen by hand: none of them is water.
Plot nvidia_plot() {
    Plot plot = empty_plot("angle [degrees]", "$F$");
    plot.x_range = kRightAngle;
    plot.y_range = {0.0, 1.0};
    plot.key = "off";
    const auto add = [&](const char* name, float bias, float scale, float power) {
        plot.series.push_back(curve(name, kRightAngle, [=](double a) {
            return lighting::fresnel_nvidia(cosine_of_degrees(a), bias, scale, power);
        }));
    };
    plot.series.push_back(
        curve("exact", kRightAngle, [](double a) { return fresnel_dielectric(cosine_of_degrees(a), 1.33f); }));
    add("5", 0.02f, 0.98f, 5.0f);
    add("4", 0.0f, 1.0f, 4.0f);
    add("6", 0.05f, 0.8f, 6.0f);
    return plot;
}

}  // namespace

void draw_fresnel_by_index(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const std::vector<std::string> indices = {"1.001, hydrogen", "1.33, water", "2.04, As₂S₃", "4.01, germanium"};
    const std::vector<std::string> numbers = {"exact", "0.02, 0.98, 5", "0, 1, 4", "0.05, 0.8, 6"};
    save_panels(options, "index", 2,
                {plot_panel(options, "index_of_refraction", "by index of refraction", index_plot(), size),
                 plot_legend(options, size, indices),
                 plot_panel(options, "nvidia", "water, and NVIDIA's form", nvidia_plot(), size),
                 plot_legend(options, size, numbers)});
}

}  // namespace kreda::examples
