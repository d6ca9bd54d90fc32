// 41_microfacets: D, G and F, each alone: which facets mirror, which are seen, how much they reflect.
// Page docs/41_microfacets.md | After 40_fresnel | New: microfacet_angles(), ggx_distribution(), V, alpha
// Break at: ggx_distribution | Look at: sin2_h, c_alpha, q | Try: kRoughness {0.1, 1}, Geometry::implicit
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "examples/geometry_drawings.hpp"
#include "examples/paint.hpp"
#include "examples/plots.hpp"
#include "lighting/cook_torrance.hpp"
#include "raster/shapes.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::lighting;

namespace {

constexpr float kRoughness[] = {0.3f, 0.7f};
const glm::vec3 kLamp(1.1f, 1.0f, -1.3f);  // behind the knot: there F differs from place to place
const glm::vec3 kMetal(0.16f, 0.33f, 0.62f);
const raster::Camera kCamera{.position = {0.0f, 2.4f, 3.0f}, .target = {0.0f, -0.13f, 0.0f}, .vertical_fov_deg = 50.0f};

CookTorranceSetup blue_metal(float roughness) {
    CookTorranceMaterial material;
    material.albedo = kMetal;
    material.metallic = 1.0f;
    material.roughness = roughness;
    material.geometry = Geometry::smith_correlated;
    return prepare(material);
}

struct Terms {
    float D, G;
    glm::vec3 F, product;
};

/// The terms of one light at a point, and what they reflect together: D G F / (4 (n.l)(n.v)) (n.l).
Terms terms_at(const SurfacePoint& point, const CookTorranceSetup& setup) {
    const MicrofacetSurface& surface = setup.surface;
    const MicrofacetAngles angles = microfacet_angles(point.n, glm::normalize(kLamp - point.position), point.v);
    const float D = distribution_term(setup.distribution, angles, surface.alpha);
    const float V = visibility_term(setup.geometry, angles, surface.alpha, surface.roughness);
    const glm::vec3 F = fresnel_term(setup, angles.v_dot_h, surface.f0);
    return {D, 4.0f * angles.n_dot_l * angles.n_dot_v * V, F, F * (D * V * angles.n_dot_l)};
}

/// A row of four pictures: the root of D as a share of its peak, G, F, and their product under a light of strength 3
/// pi.
void add_row(glm::ivec2 size, float roughness, std::vector<Panel>& panels) {
    const raster::Mesh knot = raster::make_torus_knot(384);
    const CookTorranceSetup setup = blue_metal(roughness);
    const float peak = ggx_distribution(1.0f, 0.0f, setup.surface.alpha);
    const auto add = [&](const std::string& name, const std::function<glm::vec3(const Terms&)>& color) {
        panels.emplace_back(paint(knot, kCamera, size, 3, kBoard,
                                  [&](const SurfacePoint& point) { return color(terms_at(point, setup)); }),
                            name);
    };
    add("$D$, rough " + std::to_string(roughness).substr(0, 3),
        [peak](const Terms& t) { return glm::vec3(std::sqrt(t.D / peak)); });
    add("$G$", [](const Terms& t) { return glm::vec3(t.G); });
    add("$F$", [](const Terms& t) { return t.F; });
    add("all three", [](const Terms& t) { return 3.0f * raster::kPi * t.product; });
}

MicrofacetAngles facet_at(double degrees) {
    const double theta = glm::radians(degrees);
    const float sine = static_cast<float>(std::sin(theta));
    return {1.0f, 1.0f, static_cast<float>(std::cos(theta)), 1.0f, sine * sine};
}

/// D over the angle between n and h for one alpha: the four distributions.
Plot distribution_plot() {
    constexpr float kAlpha = 0.3f;
    Plot plot = empty_plot("angle between $n$ and $h$ [degrees]", "$D$ [1/sr]");
    plot.x_range = {0.0, 60.0};
    plot.y_range = {0.0, 4.0};
    plot.key = "inside right top";
    const auto add = [&](const char* name, Distribution distribution) {
        plot.series.push_back(curve(name, *plot.x_range, [=](double degrees) {
            return distribution_term(distribution, facet_at(degrees), kAlpha);
        }));
    };
    add("GGX", Distribution::ggx);
    add("Beckmann", Distribution::beckmann);
    add("Blinn-Phong", Distribution::blinn_phong);
    add("Gaussian", Distribution::gaussian);
    return plot;
}

/// G over the angle of light and view, both the same, on either side of n.
Plot geometry_plot() {
    constexpr float kRough = 0.5f;
    Plot plot = empty_plot("angle of light and view [degrees]", "$G$");
    plot.x_range = {0.0, 90.0};
    plot.y_range = {0.0, 1.0};
    plot.key = "outside top center horizontal";
    const auto add = [&](const char* name, Geometry geometry) {
        plot.series.push_back(curve(name, *plot.x_range, [=](double degrees) {
            const float c = static_cast<float>(std::cos(glm::radians(degrees)));
            const MicrofacetAngles mirrored{c, c, 1.0f, c, 0.0f};
            return 4.0f * c * c * visibility_term(geometry, mirrored, alpha_from_roughness(kRough), kRough);
        }));
    };
    add("grooves", Geometry::cook_torrance);
    add("correlated", Geometry::smith_correlated);
    add("Smith", Geometry::smith);
    add("Schlick-GGX", Geometry::schlick_ggx);
    add("implicit", Geometry::implicit);
    return plot;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 4, 2);
    std::vector<Panel> panels;
    for (const float roughness : kRoughness) add_row(size, roughness, panels);
    save_panels(options, "terms", 4, panels);

    const glm::ivec2 half = panel_size(options.width, options.height, 2, 1);
    save_panels(options, "curves", 2,
                {plot_panel(options, "distributions", "$α$ = 0.3", distribution_plot(), half),
                 plot_panel(options, "geometry", "roughness 0.5", geometry_plot(), half)});
    save_panels(options, "shadowing_and_masking", 3, shadowing_and_masking(options));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "41_microfacets", draw);
}
