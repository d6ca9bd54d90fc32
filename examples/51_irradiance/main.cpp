// 51_irradiance: all the light that falls on a plane: every texel, two sums over samples, and nine numbers.
// Page docs/51_irradiance.md | After 50_environment | New: irradiance_of_hemisphere(), irradiance_of_cosine(), Sh9
// Break at: irradiance_of_sh9 | Look at: n, p, sh.c, sum | Try: kSky Sky::sunset, kN2 16, kRounds 9
#include <algorithm>
#include <cstdio>

#include "examples/geometry_drawings.hpp"
#include "examples/plots.hpp"
#include "examples/sphere_views.hpp"
#include "examples/stopwatch.hpp"
#include "lighting/environment/environment_image.hpp"
#include "raster/film.hpp"
#include "tools/measure/irradiance_error.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using lighting::CubeMap;
using lighting::IrradianceSum;

namespace {

constexpr lighting::Sky kSky = lighting::Sky::studio;  // of the pictures and of the times
constexpr int kN2 = 4, kN1 = 4 * kN2;                  // of the picture's double sum
constexpr int kSize = 16;                              // of the irradiance maps: 1536 normals
constexpr int kRounds = 3;                             // every way is timed once a round

/// E / pi of a few normals, green.
void print_four_ways(const CubeMap& radiance) {
    const lighting::Sh9 sh = project_to_sh9(radiance);
    std::printf("E / pi       every texel    16 x 4   64 cosines      SH9\n");
    for (const glm::vec3& n : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1)}) {
        const glm::dvec4 E(irradiance_of_texels(radiance, n).y, irradiance_of_hemisphere(radiance, n, kN1, kN2).y,
                           irradiance_of_cosine(radiance, n, kN1 * kN2).y, irradiance_of_sh9(sh, n).y);
        const glm::dvec4 shown = E / static_cast<double>(raster::kPi);
        std::printf("(%2.0f %2.0f %2.0f) %12.4f %12.4f %10.4f %10.4f\n", double{n.x}, double{n.y}, double{n.z}, shown.x,
                    shown.y, shown.z, shown.w);
    }
}

/// L or E / pi as a display shows it, in linear RGB.
Image shown(int width, const CubeMap& map, float scale) {
    const Image radiance = equirect_picture(width, [&](const glm::vec3& d) { return scale * sample_level(map, 0, d); });
    return develop(radiance, {0.7f, raster::ToneMap::none, 4.0f, raster::Transfer::linear});
}

/// Too dark blue, too bright orange: full where a fifth of the mean E is missing or too much.
Image error_picture(int width, const CubeMap& map, const CubeMap& exact) {
    const float gain = static_cast<float>(5.0 / mean_of(exact));
    return equirect_picture(width, [&](const glm::vec3& n) {
        return signed_color(gain * (sample_level(map, 0, n).y - sample_level(exact, 0, n).y));
    });
}

void draw_maps(const Options& options, const CubeMap& radiance) {
    const int width = panel_size(options.width, options.height, 3, 2).x;
    const CubeMap exact = every_texel(kSize).make(radiance), sh = nine_coefficients(kSize).make(radiance);
    const CubeMap sum = irradiance_map(radiance, {IrradianceSum::hemisphere, kN1, kN2, kSize});
    constexpr float kInvPi = 1.0f / raster::kPi;
    save_panels(options, "irradiance", 3,
                {{shown(width, exact, kInvPi), "every texel"},
                 {shown(width, sum, kInvPi), "16 × 4"},
                 {shown(width, sh, kInvPi), "nine numbers"},
                 {shown(width, radiance, 1.0f), "$L$"},
                 {error_picture(width, sum, exact), "error"},
                 {error_picture(width, sh, exact), "error"}});
}

// --------------------------------------------------------------------------------------- error and time

/// Error over samples; the numbers are printed, too.
Panel error_plot(const Options& options, const char* name, lighting::Sky sky) {
    const CubeMap radiance = lighting::cube_from_sky(sky, 64), exact = every_texel(kSize).make(radiance);
    const MapError sh = map_error(nine_coefficients(kSize).make(radiance), exact);
    std::printf("%-8s %6.2f %6.2f", name, 100.0 * sh.mean, 100.0 * sh.largest);
    Plot plot = empty_plot("samples", "mean error [%]", true, true);
    plot.x_range = {10.0, 10000.0};
    plot.y_range = {0.01, 100.0};
    plot.key = "inside left bottom Left reverse";
    for (const IrradianceSum sum : {IrradianceSum::hemisphere, IrradianceSum::cosine}) {
        Series errors{sum == IrradianceSum::cosine ? "cosine" : "double sum", {}};
        for (const IrradianceWay& way : sampling_ways(sum, kSize)) {
            errors.points.push_back({way.samples, 100.0 * map_error(way.make(radiance), exact).mean});
            std::printf("%s%6.2f", way.samples == 16 ? "    " : " ", errors.points.back().y);
        }
        plot.series.push_back(errors);
    }
    std::printf("\n");
    plot.series.push_back(curve(
        "SH9", *plot.x_range, [&](double) { return 100.0 * sh.mean; }, true, 2));
    return plot_panel(options, std::string("error_") + name, name, plot,
                      panel_size(options.width, options.height, 2, 1));
}

/// Error over the time for a map of 1536 normals. A picture of this machine.
void draw_times(const Options& options, const CubeMap& radiance) {
    std::vector<IrradianceWay> ways = sampling_ways(IrradianceSum::hemisphere, kSize);
    for (const IrradianceWay& way : sampling_ways(IrradianceSum::cosine, kSize)) ways.push_back(way);
    ways.push_back(nine_coefficients(kSize));
    ways.push_back(every_texel(kSize));
    std::vector<std::function<void()>> works;
    for (const IrradianceWay& way : ways) works.push_back([&] { (void)way.make(radiance); });
    const std::vector<double> times = shortest_times(works, kRounds);
    const CubeMap exact = ways.back().make(radiance);
    Plot plot = empty_plot("time [ms]", "mean error [%]", true, true);
    plot.series = {{"double sum", {}}, {"cosine", {}}, {"others", {}}};
    for (Series& series : plot.series) series.joined = false;
    plot.x_range = {0.1, 1000.0};
    plot.y_range = {0.01, 100.0};
    plot.key = "inside right top";
    std::printf("\nstudio, 1536 normals: ms, error in percent\n");
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const double error = 100.0 * map_error(ways[i].make(radiance), exact).mean;
        std::printf("%-6s %-12s %8.3f %8.3f\n", i < 5 ? "double" : (i < 10 ? "cosine" : ""), ways[i].name.c_str(),
                    times[i], error);
        Series& series = plot.series[i < 5 ? 0 : (i < 10 ? 1 : 2)];
        series.points.push_back({times[i], std::max(error, 0.01)});
        series.point_names.push_back(i < 5 || i >= 10 ? ways[i].name : "");  // as many samples in both sums
    }
    save_plot(options, "measured_time", "studio, 1536 normals", plot);
}

void draw(const Options& options) {
    const CubeMap radiance = lighting::cube_from_sky(kSky, 64);
    print_four_ways(radiance);
    draw_maps(options, radiance);
    save_panels(options, "double_sum", 2, double_sum_directions(options, kN1, kN2));
    std::printf("\nerror in percent of the mean irradiance, with 16, 64, 256, 1024, 4096 samples\n");
    std::printf("%-8s %6s %6s    %-37s %s\n", "", "SH9", "most", "double sum", "cosine-weighted");
    const Panel gradient = error_plot(options, "gradient", lighting::Sky::gradient);
    save_panels(options, "error", 2, {gradient, error_plot(options, "sunset", lighting::Sky::sunset)});
    draw_times(options, radiance);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "51_irradiance", draw);
}
