// 97_extremes: the equation as it is printed against the same equation arranged for floats, where they differ most.
// Page docs/97_extremes.md | After 41_microfacets, 40_fresnel | New: nothing; naive forms of what is known
// Break at: printed_ggx | Look at: c, q | Try: kAlpha 0.02, kIndex 1.01
#include <cmath>

#include "examples/plots.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/microfacet.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr float kAlpha = lighting::kMinAlpha;  ///< the narrowest highlight: half of it within 0.1 degrees
constexpr float kIndex = 1.00001f;             ///< hardly anything is there: warm air under cold

/// (1)   D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2), as printed. In double it is what both forms should give.
template <class Real>
Real printed_ggx(Real c, Real alpha) {
    const Real q = c * c * (alpha * alpha - Real{1}) + Real{1};
    return alpha * alpha / (Real{3.14159265358979323846} * q * q);
}

/// (2)   F = ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2) / 2,   g^2 = n^2 - 1 + c^2, as printed
template <class Real>
Real printed_fresnel(Real c, Real n) {
    const Real g = std::sqrt(n * n - Real{1} + c * c);
    const Real r_s = (g - c) / (g + c);
    const Real p_by_s = (c * (g + c) - Real{1}) / (c * (g - c) + Real{1});
    return Real{0.5} * r_s * r_s * (Real{1} + p_by_s * p_by_s);
}

/// A flat mirror seen from straight above under a lamp: what D is at every pixel, 1 in the middle.
template <class D>
Panel draw_highlight(glm::ivec2 size, const char* name, D distribution) {
    Image image = make_board(size.x, size.y);
    const glm::vec3 n{0.0f, 0.0f, 1.0f};
    const float top = lighting::ggx_distribution(1.0f, 0.0f, kAlpha);
    const float step = 1.2f * kAlpha / static_cast<float>(size.y);  // 0.6 alpha from the middle to the edge
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const float right = (static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(size.x)) * step;
            const float down = (static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(size.y)) * step;
            const glm::vec3 h = glm::normalize(glm::vec3(right, -down, 1.0f));
            image.set_rgb(x, y, kChalk * raster::saturate(distribution(n, h) / top));
        }
    }
    return {image, name};
}

/// How far a float is from what it should be, as a share of that; nothing smaller than 1e-9 is shown.
double error_of(float value, double exact) {
    return std::max(std::abs(double{value} - exact) / exact, 1e-9);
}

Plot errors_plot() {
    Plot plot = empty_plot("cosine", "relative error", true, true);
    plot.x_range = {0.001, 1.0};
    plot.y_range = {1e-9, 100.0};
    plot.key = "inside right top";
    const auto exact = [](double c) { return printed_fresnel(double{static_cast<float>(c)}, double{kIndex}); };
    const auto printed = [&](double c) { return error_of(printed_fresnel(static_cast<float>(c), kIndex), exact(c)); };
    const auto arranged = [&](double c) {
        return error_of(lighting::fresnel_dielectric(static_cast<float>(c), kIndex), exact(c));
    };
    plot.series = {curve("as printed", *plot.x_range, printed, true),
                   curve("$g$ − $c$ as ($n^2$ − 1) / ($g$ + $c$)", *plot.x_range, arranged, true)};
    return plot;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 1);
    const auto printed = [](const glm::vec3& n, const glm::vec3& h) { return printed_ggx(glm::dot(n, h), kAlpha); };
    const auto arranged = [](const glm::vec3& n, const glm::vec3& h) {
        return lighting::ggx_distribution(glm::dot(n, h), lighting::squared_sine(n, h), kAlpha);
    };
    save_panels(options, "highlight", 2,
                {draw_highlight(size, "as printed", printed), draw_highlight(size, "sin² from $n$ − $h$", arranged)});
    save_plot(options, "fresnel", "$n$ = 1.00001", errors_plot());
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "97_extremes", draw);
}
