// 40_fresnel: how much a smooth surface reflects, by angle: exact, and the ways to approximate it.
// Page docs/40_fresnel.md | After 23_blinn_phong | New: fresnel_dielectric(), fresnel_conductor(), fresnel_schlick()
// Break at: fresnel_conductor_polarized | Look at: A, B, a, b, R_s | Try: kSmallTable 4, kPlatinumRed.x 4
#include <cmath>
#include <cstdio>

#include <glm/trigonometric.hpp>

#include "examples/fresnel_plots.hpp"
#include "examples/plot_legend.hpp"
#include "examples/plots.hpp"
#include "tools/measure/fresnel_methods.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using namespace kreda::lighting;

namespace {

constexpr int kSmallTable = 8;
constexpr int kAngles = 1'000'000;

const glm::vec2 kPlatinumRed(2.49f, 4.44f);  // n, k

float cosine(double degrees) {
    return static_cast<float>(std::cos(glm::radians(degrees)));
}

constexpr AxisRange kQuarterTurn{0.0, 90.0};

Plot degrees_plot() {
    Plot plot = empty_plot("angle [degrees]", "$F$");
    plot.x_range = kQuarterTurn;
    plot.y_range = {0.0, 1.0};
    plot.key = "off";
    return plot;
}

/// A dielectric: the two polarizations, their mean, and Schlick's approximation of it.
Plot dielectric_plot(float n) {
    Plot plot = degrees_plot();
    plot.series = {curve("$s$", kQuarterTurn, [n](double a) { return fresnel_dielectric_polarized(cosine(a), n).s; }),
                   curve("$p$", kQuarterTurn, [n](double a) { return fresnel_dielectric_polarized(cosine(a), n).p; }),
                   curve("mean", kQuarterTurn, [n](double a) { return fresnel_dielectric(cosine(a), n); }),
                   curve("Schlick", kQuarterTurn, [n](double a) { return fresnel_schlick_from_index(cosine(a), n); })};
    return plot;
}

/// A metal: exact and rescaled Schlick for red, green and blue.
Plot metal_plot(const std::string& name) {
    Plot plot = degrees_plot();
    const ThreeChannelIndex index = published_index(name);
    const char* const channels[] = {"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        const float n = index.n[i], k = index.k[i];
        plot.series.push_back(
            curve(channels[i], kQuarterTurn, [=](double a) { return fresnel_conductor(cosine(a), n, k); }));
    }
    for (int i = 0; i < 3; ++i) {
        const float n = index.n[i], k = index.k[i];
        plot.series.push_back(curve("Schlick, " + std::string(channels[i]), kQuarterTurn,
                                    [=](double a) { return fresnel_rescaled_schlick(cosine(a), n, k); }));
        plot.series.back().style = 4;
    }
    return plot;
}

/// All methods on platinum's red, where they differ most: 60 to 90 degrees.
Plot methods_plot() {
    constexpr AxisRange kGrazing{60.0, 90.0};
    const float n = kPlatinumRed.x, k = kPlatinumRed.y;
    const float f0 = f0_from_index(n, k);
    const float b = f82_coefficient(f0, fresnel_conductor(1.0f / 7.0f, n, k));
    const SchlickCorrection fit = fit_correction(n, k), printed = fit_correction_as_printed(n, k);
    const FresnelTable table = fresnel_table(glm::vec3(n), glm::vec3(k), kSmallTable);
    const auto add = [&](const std::string& name, auto F) {
        return curve(name, kGrazing, [&](double a) { return F(cosine(a)); });
    };
    Plot plot = empty_plot("angle [degrees]", "$F$ of platinum, red");
    plot.series = {add("exact", [=](float c) { return fresnel_conductor(c, n, k); }),
                   add("Schlick, NVIDIA 5", [=](float c) { return fresnel_schlick(c, f0); }),
                   add("corrected", [=](float c) { return fresnel_corrected_schlick(c, f0, fit.a, fit.lambda); }),
                   add("corrected, as printed",
                       [=](float c) { return fresnel_corrected_schlick_as_printed(c, f0, printed.a, printed.lambda); }),
                   add("F82", [=](float c) { return fresnel_f82(c, f0, b); }),
                   add("table of " + std::to_string(kSmallTable),
                       [&](float c) { return fresnel_lookup(c, table.r.data(), kSmallTable); })};
    plot.x_range = kGrazing;
    plot.y_range = {0.4, 1.0};
    return plot;
}

/// The published comparison: a million angles, mean relative error of three channels.
void print_errors() {
    const std::vector<float> cosines = cosines_of_even_angles(kAngles);
    std::printf("Mean relative error in percent over %d angles from 0 to 90 degrees\n", kAngles);
    std::printf("%-22s %8s %8s %8s %8s\n", "", "gold", "platinum", "water", "diamond");
    std::vector<std::vector<double>> errors;
    for (const char* name : {"gold", "platinum", "water", "diamond"}) {
        const ThreeChannelIndex index = published_index(name);
        errors.push_back(mean_errors_percent(fresnel_curves(index), index, cosines));
    }
    const std::vector<FresnelCurve> curves = fresnel_curves(published_index("gold"));
    for (std::size_t m = 0; m < curves.size(); ++m) {
        std::printf("%-22s %8.4g %8.4g %8.4g %8.4g\n", curves[m].name.c_str(), errors[0][m], errors[1][m], errors[2][m],
                    errors[3][m]);
    }
    std::printf("published (2014): rescaled 0.98, 5.31; corrected 0.82, 2.07; Schlick for water 8.68, diamond 3.8\n");
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    const auto panel = [&](const char* file, const char* title, const Plot& plot) {
        return plot_panel(options, file, title, plot, size);
    };
    save_panels(options, "curves", 3,
                {panel("water", "water, $n$ = 1.33", dielectric_plot(1.33f)),
                 panel("as2s3", "As₂S₃, $n$ = 2.04", dielectric_plot(2.04f)),
                 panel("germanium", "germanium, $n$ = 4.01", dielectric_plot(4.01f)),
                 panel("platinum", "platinum", metal_plot("platinum")), panel("gold", "gold", metal_plot("gold")),
                 plot_legend(options, size, {"$s$;  red", "$p$;  green", "mean of both;  blue", "Schlick"})});
    save_plot(options, "methods", "", methods_plot());
    draw_fresnel_by_index(options);
    print_errors();
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "40_fresnel", draw);
}
