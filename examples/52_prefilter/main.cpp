// 52_prefilter: the environment as mirrors of each roughness see it; samples that miss a small sun, and their cure.
// Page docs/52_prefilter.md | After 51_irradiance, 41_microfacets | New: ggx_half_vector(), prefilter()
// Break at: ggx_half_vector | Look at: u, alpha, cos2 | Try: kAlpha 0.0625, Sky::studio, kFew 8
#include <cmath>
#include <cstdio>
#include <string>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "examples/sphere_views.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/importance.hpp"
#include "lighting/microfacet.hpp"
#include "scene/render/render.hpp"
#include "tools/measure/irradiance_error.hpp"
#include "tools/measure/prefilter_levels.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using lighting::CubeMap;

namespace {

constexpr float kAlpha = 0.25f;        // of the noisy pictures: roughness 0.5
constexpr int kFew = 32, kMany = 512;  // samples
constexpr int kSize = 64;              // texels a side of a face

/// The first samples around n = v = (0, 0, 1): density, share of the sphere, and the mip level that has texels as
/// large.
void print_samples() {
    std::printf("%2s %7s %7s %9s %10s %6s\n", "k", "n.h", "n.l", "p [1/sr]", "w_s [sr]", "lod");
    for (const int k : {0, 1, 2, 3, 31}) {
        const glm::vec3 h = lighting::ggx_half_vector(lighting::hammersley(k, kFew), kAlpha);
        const glm::vec3 l = lighting::mirror_vector(h, {0.0f, 0.0f, 1.0f});
        const float p = 0.25f * lighting::ggx_distribution(h.z, h.x * h.x + h.y * h.y, kAlpha);
        const float w_s = 1.0f / (kFew * p), w_p = 4.0f * raster::kPi / (6.0f * kSize * kSize);
        const glm::dvec4 row(h.z, l.z, p, w_s);
        std::printf("%2d %7.4f %7.4f %9.4f %10.5f %6.2f\n", k, row.x, row.y, row.z, row.w,
                    static_cast<double>(0.5f * raster::log2(w_s / w_p)));
    }
}

/// Radiance as a display shows it, in linear RGB.
Image shown(const Image& radiance, float exposure) {
    return develop(radiance, {exposure, raster::ToneMap::reinhard_extended, 6.0f, raster::Transfer::linear});
}

Panel level_picture(int width, const CubeMap& map, int level, const std::string& caption) {
    return {shown(equirect_picture(width, [&](const glm::vec3& d) { return sample_level(map, level, d); }), 1.0f),
            caption};
}

/// A mirror ball for each level.
Image balls(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.environment.on = true;
    scene.environment.samples = 512;
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 2.0f * 8.0f * static_cast<float>(size.y) / static_cast<float>(size.x) * 1.1f;
    for (int level = 0; level < lighting::kPrefilterLevels; ++level) {
        const float roughness = std::sqrt(lighting::alpha_of_level(level));
        add_shape(scene, "sphere", 64, {2.2f * (static_cast<float>(level) - 3.5f), 0.0f, 0.0f},
                  microfacet(glm::vec3(1.0f), 1.0f, roughness));
    }
    return shown(scene::render(scene), 1.0f);
}

/// Two rows of levels, a third one of balls.
void draw_levels(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 4, 3);
    const float type = caption_size(options.height);
    const CubeMap map = prefilter(lighting::cube_from_sky(lighting::Sky::studio, 128), {.samples = 512});
    Panel whole(make_board(options.width, options.height, kSlate));
    for (int level = 0; level < lighting::kPrefilterLevels; ++level) {
        const Image picture = level_picture(size.x, map, level, "").image;
        const glm::ivec2 corner =
            panel_corner(options.width, options.height, 4, level, 12, {picture.width, picture.height});
        paste(whole.image, picture, corner.x, corner.y);
        char roughness[16];
        std::snprintf(roughness, sizeof roughness, "%.3g",
                      std::sqrt(static_cast<double>(lighting::alpha_of_level(level))));
        const glm::vec2 lower_left(corner.x, corner.y + picture.height);
        whole.labels.push_back({lower_left + type * glm::vec2(0.3f, -0.3f), roughness, kChalk, type});
    }
    paste(whole.image, balls({options.width, size.y}), 0, options.height - size.y);
    save_panel(options, "levels", whole);
}

void draw_fireflies(const Options& options) {
    const int width = panel_size(options.width, options.height, 3, 2).x;
    const CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, kSize), plain = without_mips(sky);
    const auto panel = [&](const CubeMap& radiance, int samples, const char* caption) {
        return level_picture(width, sampled_level(radiance, kAlpha, samples, 32), 0, caption);
    };
    save_panels(options, "fireflies", 3,
                {level_picture(width, sky, 0, "$L$"), panel(plain, kFew, "32 plain"), panel(plain, kMany, "512 plain"),
                 level_picture(width, exact_level(sky, kAlpha, 16), 0, "every texel"), panel(sky, kFew, "32 from mips"),
                 panel(sky, kMany, "512 from mips")});
}

/// Error over the number of samples.
Panel error_plot(const Options& options, const char* file, const char* name, float alpha) {
    const CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, kSize), plain = without_mips(sky);
    const CubeMap exact = exact_level(sky, alpha, 8);
    Plot plot = empty_plot("samples", "mean error [%]", true, true);
    plot.x_range = {10.0, 10000.0};
    plot.y_range = {0.1, 100.0};
    plot.key = "outside top center horizontal";
    for (const bool mips : {false, true}) {
        Series errors{mips ? "from mips" : "plain", {}};
        std::printf("%-18s %-8s", name, mips ? "mips" : "plain");
        for (const int samples : {16, 64, 256, 1024, 4096}) {
            const CubeMap level = sampled_level(mips ? sky : plain, alpha, samples, 8);
            errors.points.push_back({samples, 100.0 * map_error(level, exact).mean});
            std::printf(" %8.2f", errors.points.back().y);
        }
        std::printf("\n");
        plot.series.push_back(errors);
    }
    return plot_panel(options, file, name, plot, panel_size(options.width, options.height, 2, 1));
}

void draw(const Options& options) {
    print_samples();
    draw_levels(options);
    draw_fireflies(options);
    std::printf("\nmean error in percent, sunset; samples   16       64      256     1024     4096\n");
    const Panel quarter = error_plot(options, "error_0.5", "roughness 0.5", 0.25f);
    save_panels(options, "error", 2, {quarter, error_plot(options, "error_1", "roughness 1", 1.0f)});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "52_prefilter", draw);
}
