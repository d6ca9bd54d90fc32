// 40_fresnel: how much a smooth surface reflects, by angle: exact, and the ways to approximate it.
// Page docs/40_fresnel.md | After 23_blinn_phong | New: fresnel_dielectric(), fresnel_conductor(), fresnel_schlick()
// Break at: fresnel_conductor_polarized | Look at: A, B, a, b, R_s | Try: kSmallTable 4, kPlatinumRed.x 4
#include <cmath>
#include <cstdio>

#include <glm/trigonometric.hpp>

#include "examples/chart.hpp"
#include "examples/example.hpp"
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

Chart degrees_chart(glm::ivec2 size, int picture_height, const std::string& title, const Axis& y) {
    return make_chart(size, picture_height, title, {0.0, 90.0, 30.0}, y);
}

/// A dielectric: the two polarizations, their mean, and Schlick's approximation of it.
Image dielectric_panel(glm::ivec2 size, int picture_height, const std::string& title, float n) {
    Chart chart = degrees_chart(size, picture_height, title, {0.0, 1.0, 0.5});
    plot(chart, kDust, [n](double a) { return fresnel_dielectric_polarized(cosine(a), n).s; });
    plot(chart, kDust, [n](double a) { return fresnel_dielectric_polarized(cosine(a), n).p; });
    plot(chart, kChalk, [n](double a) { return fresnel_dielectric(cosine(a), n); });
    plot(
        chart, kYellow, [n](double a) { return fresnel_schlick_from_index(cosine(a), n); }, true);
    return chart.image;
}

/// A metal: exact and rescaled Schlick for red, green and blue.
Image metal_panel(glm::ivec2 size, int picture_height, const std::string& name) {
    Chart chart = degrees_chart(size, picture_height, name, {0.0, 1.0, 0.5});
    const ThreeChannelIndex index = published_index(name);
    const glm::vec3 colors[] = {kRed, kGreen, kBlue};
    for (int i = 0; i < 3; ++i) {
        const float n = index.n[i], k = index.k[i];
        plot(chart, colors[i], [=](double a) { return fresnel_conductor(cosine(a), n, k); });
        plot(
            chart, kYellow, [=](double a) { return fresnel_rescaled_schlick(cosine(a), n, k); }, true);
    }
    return chart.image;
}

Image legend_panel(glm::ivec2 size, int picture_height) {
    Chart chart;
    chart.image = make_board(size.x, size.y);
    chart.scale = text_scale(picture_height);
    chart.lower_left = {0.0f, static_cast<float>(size.y)};
    chart.upper_right = {static_cast<float>(size.x), 0.0f};
    const glm::vec2 start(0.06f, 0.1f);
    legend(chart, "F over degrees", kChalk, start);
    legend(chart, "", kChalk, start);
    legend(chart, "s and p", kDust, start);
    legend(chart, "their mean", kChalk, start);
    legend(chart, "red", kRed, start);
    legend(chart, "green", kGreen, start);
    legend(chart, "blue", kBlue, start);
    legend(chart, "- - Schlick", kYellow, start);
    return chart.image;
}

/// All methods on platinum's red, where they differ most: 60 to 90 degrees.
Image methods_chart(glm::ivec2 size, int picture_height) {
    const float n = kPlatinumRed.x, k = kPlatinumRed.y;
    const float f0 = f0_from_index(n, k);
    const float b = f82_coefficient(f0, fresnel_conductor(1.0f / 7.0f, n, k));
    const SchlickCorrection fit = fit_correction(n, k), printed = fit_correction_as_printed(n, k);
    const FresnelTable table = fresnel_table(glm::vec3(n), glm::vec3(k), kSmallTable);
    Chart chart =
        make_chart(size, picture_height, "platinum, red: F over degrees", {60.0, 90.0, 10.0}, {0.4, 1.0, 0.2});
    plot(chart, kRed,
         [=](double a) { return fresnel_corrected_schlick_as_printed(cosine(a), f0, printed.a, printed.lambda); });
    plot(chart, kYellow, [=](double a) { return fresnel_schlick(cosine(a), f0); });
    plot(chart, kBlue, [&](double a) { return fresnel_lookup(cosine(a), table.r.data(), kSmallTable); });
    plot(chart, kGreen, [=](double a) { return fresnel_corrected_schlick(cosine(a), f0, fit.a, fit.lambda); });
    plot(chart, kOrange, [=](double a) { return fresnel_f82(cosine(a), f0, b); });
    plot(
        chart, kChalk, [=](double a) { return fresnel_conductor(cosine(a), n, k); }, true);
    const glm::vec2 start(0.05f, 0.05f);
    legend(chart, "- - exact", kChalk, start);
    legend(chart, "Schlick, NVIDIA 5", kYellow, start);
    legend(chart, "corrected", kGreen, start);
    legend(chart, "corrected, as printed", kRed, start);
    legend(chart, "F82", kOrange, start);
    legend(chart, "table of " + std::to_string(kSmallTable), kBlue, start);
    return chart.image;
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
    const int height = options.height;
    const std::vector<Image> panels = {dielectric_panel(size, height, "water 1.33", 1.33f),
                                       dielectric_panel(size, height, "As2S3 2.04", 2.04f),
                                       dielectric_panel(size, height, "germanium 4.01", 4.01f),
                                       metal_panel(size, height, "platinum"),
                                       metal_panel(size, height, "gold"),
                                       legend_panel(size, height)};
    save(options, "curves", montage(options.width, options.height, 3, panels));
    save(options, "methods", methods_chart({options.width, options.height}, height));
    print_errors();
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "40_fresnel", draw);
}
