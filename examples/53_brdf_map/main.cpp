// 53_brdf_map: scale and bias of the split sum as a map, as quadrature and as a closed form; the error of both.
// Page docs/53_brdf_map.md | After 52_prefilter | New: compute_brdf_map(), look_up_brdf(), brdf_fit()
// Break at: brdf_fit | Look at: A_above, A_below, B_above, B_below | Try: kSamples 16, kMapGain, Geometry::smith
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "tools/measure/brdf_quadrature.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using lighting::BrdfTerms;

namespace {

constexpr int kSamples = 1024;
constexpr int kCells = 24;  ///< quadrature is slow: one value for each cell
constexpr float kMapGain = 100.0f, kFitGain = 10.0f;

/// The terms at n.v and roughness.
using Terms = std::function<BrdfTerms(float, float)>;

/// A square: n.v from 0 to 1 to the right, roughness from 0 to 1 upward; A red, B green.
Image picture(int side, const Terms& terms) {
    Image image = make_board(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto share = [&](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(side); };
            const BrdfTerms found = terms(share(x), 1.0f - share(y));
            image.set_rgb(x, y, {found.scale, found.bias, 0.0f});
        }
    }
    return image;
}

/// |A - A'| and |B - B'| of two pictures of cells; the largest and the mean error of F0 A + B as a line on stdout.
Image error_picture(const char* name, const Image& found, const Image& exact, float gain) {
    std::printf("%-5s", name);
    for (const float F0 : {0.04f, 0.5f, 1.0f}) {
        float largest = 0.0f, sum = 0.0f;
        for (int i = 0; i < kCells * kCells; ++i) {
            const glm::vec3 a = found.rgb(i % kCells, i / kCells), b = exact.rgb(i % kCells, i / kCells);
            const float error = std::abs(F0 * (a.x - b.x) + a.y - b.y);
            largest = std::max(largest, error);
            sum += error;
        }
        std::printf("   F0 %.2f: mean %.5f, largest %.4f", F0, sum / (kCells * kCells), largest);
    }
    std::printf("\n");
    Image error = found;
    for (std::size_t i = 0; i < error.values.size(); ++i) {
        error.values[i] = gain * std::abs(found.values[i] - exact.values[i]);
    }
    return error;
}

void draw(const Options& options) {
    using lighting::Distribution, lighting::Geometry;
    const lighting::BrdfMap smith = compute_brdf_map(Distribution::ggx, Geometry::smith_correlated, kSamples);
    const lighting::BrdfMap schlick = compute_brdf_map(Distribution::ggx, Geometry::schlick_ggx, kSamples);
    const Terms from_map = [&](float n_dot_v, float roughness) { return look_up_brdf(smith, n_dot_v, roughness); };
    const Terms from_schlick = [&](float n_dot_v, float r) { return look_up_brdf(schlick, n_dot_v, r); };
    const Terms from_fit = [](float n_dot_v, float roughness) { return lighting::brdf_fit(n_dot_v, roughness); };
    const Image exact =
        picture(kCells, [](float n_dot_v, float roughness) { return brdf_by_quadrature(n_dot_v, roughness, 128); });

    const glm::ivec2 panel = panel_size(options.width, options.height, 3, 2);
    const int cell = std::min(panel.x, panel.y) / kCells, side = cell * kCells;
    const std::vector<Image> images = {picture(side, from_map),
                                       enlarge(exact, cell),
                                       picture(side, from_fit),
                                       picture(side, from_schlick),
                                       enlarge(error_picture("map", picture(kCells, from_map), exact, kMapGain), cell),
                                       enlarge(error_picture("fit", picture(kCells, from_fit), exact, kFitGain), cell)};
    save_panels(options, "maps", 3,
                with_captions(images, {"map", "quadrature", "fit", "Schlick-GGX", "error × 100", "error × 10"}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "53_brdf_map", draw);
}
