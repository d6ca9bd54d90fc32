// The pictures of 53_brdf_map, 54_split_sum and 55_views against sums over the sky itself and against each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/sky.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/measure/brdf_quadrature.hpp"
#include "tools/measure/split_sum_error.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::tools;
using std::numbers::pi;

namespace {

/// Views of the scene of 55_views, one sample a pixel: small, but every material covers hundreds of pixels.
struct Views {
    explicit Views(const std::vector<const char*>& names)
        : scene(scene::read_scene(KREDA_SOURCE_DIR "/examples/55_views/views.toml")) {
        scene.image.width = 96;
        scene.image.height = 54;
        scene.image.samples = 1;
        std::vector<const scene::View*> views;
        for (const char* name : names) views.push_back(scene::find_view(name));
        render(scene, make_plan(scene, views), buffers);
    }
    glm::vec3 at(std::size_t view, int x, int y) const {
        const raster::Image& image = buffers.views[view];
        return image.channels == 3 ? image.rgb(x, y) : glm::vec3(image.at(0, x, y));
    }

    scene::Scene scene;
    scene::RenderBuffers buffers;
};

bool close(const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(a, b) <= 1e-5f * glm::length(b) + 1e-7f;  // a handful of roundings in float
}

/// int L(l) max(n.l, 0) dl over the sky's formula, turned by the scene's rotation about +y: a grid of 0.5 degrees.
glm::dvec3 irradiance_of_sky(const scene::EnvironmentSettings& settings, const glm::dvec3& n) {
    constexpr int kRows = 360;
    const double turn = settings.rotation_deg * pi / 180.0;
    glm::dvec3 sum(0.0);
    for (int j = 0; j < kRows; ++j) {
        const double theta = (j + 0.5) * pi / kRows;
        for (int i = 0; i < 2 * kRows; ++i) {
            const double phi = (i + 0.5) * pi / kRows;
            const glm::dvec3 in_sky(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const glm::dvec3 l(std::cos(turn) * in_sky.x + std::sin(turn) * in_sky.z, in_sky.y,
                               -std::sin(turn) * in_sky.x + std::cos(turn) * in_sky.z);
            const double cosine = glm::dot(n, l);
            if (cosine > 0.0)
                sum += glm::dvec3(sky_radiance(settings.sky, glm::vec3(in_sky))) * (cosine * std::sin(theta));
        }
    }
    return sum * (pi / kRows) * (pi / kRows);
}

}  // namespace

TEST_CASE("55_views: at every pixel the terms multiply and add up to the picture") {
    const Views v({"irradiance", "fresnel", "albedo", "metallic", "prefilter", "brdf", "f0", "environment_diffuse",
                   "environment_specular", "ambient"});
    int seen[2] = {};
    for (int y = 0; y < 54; ++y) {
        for (int x = 0; x < 96; ++x) {
            if (v.at(6, x, y) == glm::vec3(0.0f)) continue;  // F0: the background
            const glm::vec3 E = v.at(0, x, y), F = v.at(1, x, y), c = v.at(2, x, y), P = v.at(4, x, y),
                            F0 = v.at(6, x, y);
            const float metallic = v.at(3, x, y).x, A = v.at(5, x, y).x, B = v.at(5, x, y).y;
            const glm::vec3 diffuse = E * (glm::vec3(1.0f) - F) * (1.0f - metallic) * c / float(pi);
            const glm::vec3 specular = P * (F0 * A + glm::vec3(B));
            REQUIRE(close(v.at(7, x, y), diffuse));
            REQUIRE(close(v.at(8, x, y), specular));
            REQUIRE(close(v.at(9, x, y), diffuse + specular));
            REQUIRE(close(v.buffers.film.rgb(x, y), diffuse + specular));
            ++seen[metallic > 0.5f ? 1 : 0];
        }
    }
    CHECK(seen[0] > 400);
    CHECK(seen[1] > 200);
}

TEST_CASE("55_views: the page multiplies right") {
    CHECK(1.85163 / pi * 0.958645 * 0.62 == doctest::Approx(documented_number("55_views", "diffuse")).epsilon(1e-4));
    CHECK(75.3915 * (0.04 * 0.997808 + 0.00156576) ==
          doctest::Approx(documented_number("55_views", "specular")).epsilon(1e-5));
}

TEST_CASE("55_views: the irradiance is the integral over the sky's formula") {
    const Views v({"normal", "irradiance"});
    for (const glm::ivec2 pixel : {glm::ivec2(70, 27), glm::ivec2(81, 20), glm::ivec2(90, 33)}) {  // on the ball
        CAPTURE(pixel.x);
        const glm::dvec3 E = irradiance_of_sky(v.scene.environment, glm::dvec3(v.at(0, pixel.x, pixel.y)));
        for (int c = 0; c < 3; ++c)
            CHECK(v.at(1, pixel.x, pixel.y)[c] == doctest::Approx(E[c]).epsilon(0.01));  // texels of 1.4 degrees
    }
}

TEST_CASE("55_views: the last column of the sheet adds up") {
    const auto panel = [](int i) { return linear_panel("55_views/sheet", 3, 3, i); };
    const raster::Image diffuse = panel(2), specular = panel(5), ambient = panel(8);
    int compared = 0;
    for (int y = 0; y < ambient.height - 14; ++y) {  // above the captions
        for (int x = 0; x < ambient.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float sum = diffuse.at(c, x, y) + specular.at(c, x, y);
                if (sum == 0.0f || sum > 0.95f) continue;                           // background, or cut off at white
                CHECK(std::abs(ambient.at(c, x, y) - sum) < 1.6f / 255.0f * 2.3f);  // three bytes of sRGB
                ++compared;
            }
        }
    }
    CHECK(compared > 1500);
}

// ------------------------------------------------------------------------------------------------ 53_brdf_map

namespace {

/// A and B as sums over directions of light, every 0.18 degrees: D and V of GGX as Walter et al. (2007) and Heitz
/// (2014) write them.
glm::dvec2 brdf_over_directions(double n_dot_v, double roughness) {
    constexpr int kSteps = 500;
    const double alpha2 = std::pow(roughness, 4.0);
    const glm::dvec3 v(std::sqrt(1.0 - n_dot_v * n_dot_v), 0.0, n_dot_v);
    glm::dvec2 sum(0.0);
    for (int j = 0; j < kSteps; ++j) {
        const double theta = (j + 0.5) * 0.5 * pi / kSteps;
        for (int i = 0; i < 2 * kSteps; ++i) {
            const double phi = (i + 0.5) * pi / kSteps;
            const glm::dvec3 l(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            const glm::dvec3 h = glm::normalize(l + v);
            const double below = h.z * h.z * (alpha2 - 1.0) + 1.0, D = alpha2 / (pi * below * below);
            const double V = 0.5 / (l.z * std::sqrt(v.z * v.z * (1.0 - alpha2) + alpha2) +
                                    v.z * std::sqrt(l.z * l.z * (1.0 - alpha2) + alpha2));
            const double F_c = std::pow(1.0 - glm::dot(v, h), 5.0);
            sum += glm::dvec2(1.0 - F_c, F_c) * (D * V * l.z * std::sin(theta));
        }
    }
    return sum * (0.5 * pi / kSteps) * (pi / kSteps);
}

/// |A + B - A' - B'| over the squares of the example's pictures.
struct EnergyError {
    double mean = 0.0, largest = 0.0;

    void add(const lighting::BrdfTerms& found, const lighting::BrdfTerms& exact) {
        const double error = std::abs(found.scale + found.bias - exact.scale - exact.bias);
        mean += error / (24.0 * 24.0);
        largest = std::max(largest, error);
    }
};

}  // namespace

TEST_CASE("53_brdf_map: quadrature over facets is the sum over all directions of light") {
    for (const double roughness : {0.5, 0.8, 1.0}) {
        for (const double n_dot_v : {0.1, 0.4, 0.9}) {
            CAPTURE(roughness);
            CAPTURE(n_dot_v);
            const lighting::BrdfTerms found = brdf_by_quadrature(n_dot_v, roughness, 128);
            const glm::dvec2 exact = brdf_over_directions(n_dot_v, roughness);
            CHECK(std::abs(found.scale - exact.x) < 5e-5);  // 4e-5 and 1e-5: what twice as many steps change
            CHECK(std::abs(found.bias - exact.y) < 5e-5);
        }
    }
}

namespace {

/// Karis 2014, "Physically Based Shading on Mobile".
lighting::BrdfTerms karis_mobile(double n_dot_v, double roughness) {
    const double x = 1.0 - roughness, y = 0.0425 - 0.0275 * roughness;
    const double a = std::min(x * x, std::exp2(-9.28 * n_dot_v)) * x + y;
    return {float(1.04 - 0.572 * roughness - 1.04 * a), float(0.022 * roughness - 0.04 + 1.04 * a), 0.0f};
}

/// Hirvonen et al. 2019, "Accurate Real-Time Specular Reflections with Radiance Caching" (Ray Tracing Gems, 32).
lighting::BrdfTerms hirvonen(double x, double roughness) {
    const double y = roughness * roughness, x2 = x * x, x3 = x2 * x, y3 = y * y * y;
    const double bias = (0.99044 - 1.28514 * x + y * (1.29678 - 0.755907 * x)) /
                        (1.0 + 2.92338 * x + 59.4188 * x3 + y * (20.3225 - 27.0302 * x + 222.592 * x3) +
                         y3 * (121.563 + 626.13 * x + 316.627 * x3));
    const double scale = (0.0365463 + 3.32707 * x + y * (9.0632 - 9.04756 * x)) /
                         (1.0 + 3.59685 * x2 - 1.36772 * x3 + y * (9.04401 - 16.3174 * x2 + 9.22949 * x3) +
                          y3 * (5.56589 + 19.7886 * x2 - 20.2123 * x3));
    return {float(scale), float(bias), 0.0f};
}

}  // namespace

TEST_CASE("53_brdf_map: map and closed forms miss quadrature by as much as the page says") {
    const lighting::BrdfMap map =
        compute_brdf_map(lighting::Distribution::ggx, lighting::Geometry::smith_correlated, 1024);
    const lighting::BrdfMap schlick =
        compute_brdf_map(lighting::Distribution::ggx, lighting::Geometry::schlick_ggx, 1024);
    EnergyError of_map, of_fit, of_karis, of_hirvonen, of_schlick;
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 24; ++x) {
            const float n_dot_v = (static_cast<float>(x) + 0.5f) / 24.0f,
                        roughness = (static_cast<float>(y) + 0.5f) / 24.0f;
            const lighting::BrdfTerms exact = brdf_by_quadrature(n_dot_v, roughness, 128);
            of_map.add(look_up_brdf(map, n_dot_v, roughness), exact);
            of_fit.add(lighting::brdf_fit(n_dot_v, roughness), exact);
            of_karis.add(karis_mobile(double{n_dot_v}, double{roughness}), exact);
            of_hirvonen.add(hirvonen(double{n_dot_v}, double{roughness}), exact);
            of_schlick.add(look_up_brdf(schlick, n_dot_v, roughness), exact);
        }
    }
    const std::vector<QuotedNumber> map_row = documented_row("53_brdf_map", "error of", "map");
    const std::vector<QuotedNumber> fit_row = documented_row("53_brdf_map", "error of", "closed form");
    CHECK(rounds_to(of_map.mean, map_row.at(0)));
    CHECK(rounds_to(of_map.largest, map_row.at(1)));
    CHECK(rounds_to(of_fit.mean, fit_row.at(0)));
    CHECK(rounds_to(of_fit.largest, fit_row.at(1)));
    const lighting::BrdfTerms grazing = brdf_by_quadrature(0.05, 0.25, 256);
    CAPTURE(grazing.scale);
    CAPTURE(grazing.bias);
    CHECK(rounds_to(double{grazing.scale}, quoted_number("53_brdf_map", "grazing_A")));
    CHECK(rounds_to(double{grazing.bias}, quoted_number("53_brdf_map", "grazing_B")));
    CAPTURE(of_karis.mean);
    CAPTURE(of_hirvonen.mean);
    CAPTURE(of_schlick.largest);
    CHECK(rounds_to(of_karis.mean, quoted_number("53_brdf_map", "karis")));
    CHECK(rounds_to(of_hirvonen.mean, quoted_number("53_brdf_map", "hirvonen")));
    CHECK(rounds_to(of_schlick.largest, quoted_number("53_brdf_map", "schlick")));
}

TEST_CASE(
    "53_brdf_map: in the picture a mirror keeps everything and a rough surface loses most where it is seen from "
    "above") {
    const raster::Image panel = linear_panel("53_brdf_map/maps", 3, 2, 0);
    const auto energy = [&](int x, int y) { return panel.at(0, x, y) + panel.at(1, x, y); };
    const int middle = panel.width / 2;
    CHECK(energy(middle, 56) > 0.9f);                               // roughness 0.2, above the caption
    CHECK(energy(middle + 34, 12) < 0.4f);                          // roughness 1, n.v = 1
    CHECK(panel.at(1, middle - 34, 54) > panel.at(1, middle, 54));  // B lives at grazing angles
}

// ------------------------------------------------------------------------------------------------ 54_split_sum

namespace {

constexpr std::array<float, 6> kTableRoughness = {0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f};

/// The error over n.v from 0.1 to 0.95 in percent, of each roughness, the mean over so many sides of the environment.
std::array<double, 6> split_sum_errors(scene::EnvironmentSettings environment, int sides, int samples) {
    std::array<double, 6> errors{};
    scene::RenderBuffers for_split, for_exact;
    for (std::size_t r = 0; r < errors.size(); ++r) {
        for (int side = 0; side < sides; ++side) {
            environment.rotation_deg = 90.0f * static_cast<float>(side);
            const scene::Scene ball = metal_ball(environment, kTableRoughness[r], 24);
            const SpecularPicture split = draw_specular(ball, for_split);
            const SpecularPicture exact = draw_specular(with_reference(ball, samples), for_exact);
            errors[r] += error_percent(split, exact, kTableRoughness[r], 0.1f, 0.95f) / sides;
        }
    }
    return errors;
}

/// An environment of the shared data, repaired; nothing if it is not there.
scene::EnvironmentSettings shared_environment(const std::string& name) {
    scene::EnvironmentSettings environment;
    raster::Image image = scene::read_image(shared_data_folder() + "/" + name);
    lighting::repair_environment(image);
    environment.image = std::make_shared<raster::Image>(std::move(image));
    return environment;
}

scene::EnvironmentSettings built_in_sky(lighting::Sky sky) {
    scene::EnvironmentSettings environment;
    environment.sky = sky;
    return environment;
}

/// Write a line of the table of docs/54_split_sum.md and hold the page to it.
void check_line(const std::string& name, const scene::EnvironmentSettings& environment) {
    std::string line = "| " + name;
    for (const double error : split_sum_errors(environment, 4, 16384)) {
        char text[16];
        std::snprintf(text, sizeof text, " | %.1f", error);
        line += text;
    }
    MESSAGE(line);
    CHECK(repository_text("docs/54_split_sum.md").find(line + " |") != std::string::npos);
}

}  // namespace

TEST_CASE("54_split_sum: the table of errors" * doctest::skip()) {  // some minutes: run with --no-skip
    check_line("gradient", built_in_sky(lighting::Sky::gradient));
    check_line("studio", built_in_sky(lighting::Sky::studio));
    check_line("sunset", built_in_sky(lighting::Sky::sunset));
    if (shared_data_folder().empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    for (const char* name : {"dawn.hdr", "city.exr", "studio.exr"}) check_line(name, shared_environment(name));
}

TEST_CASE("54_split_sum: under a smooth sky the error stays within what was measured by another program") {
    // Split sum against 160 x 160 visible facets under a smooth sky, F0 = 0.9, by a program of its own; smooth skies
    // and roughness 0.1: 1 % or less.
    const double measured[] = {1.0, 4.0, 10.9, 10.7, 9.6, 9.9};
    const std::array<double, 6> errors = split_sum_errors(built_in_sky(lighting::Sky::gradient), 1, 512);
    for (std::size_t r = 0; r < errors.size(); ++r) {
        CAPTURE(kTableRoughness[r]);
        CHECK(errors[r] < measured[r]);
        CHECK(errors[r] > 0.1);  // an error there is
    }
}

TEST_CASE("54_split_sum: in a real street the error stays within what was measured by another program") {
    if (shared_data_folder().empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    const double measured[] = {3.2, 9.2, 14.3, 30.0, 48.0, 62.0};  // the same, a room with windows
    const std::array<double, 6> errors = split_sum_errors(shared_environment("city.exr"), 1, 512);
    for (std::size_t r = 0; r < errors.size(); ++r) {
        CAPTURE(kTableRoughness[r]);
        CHECK(errors[r] < measured[r]);
    }
}

namespace {

/// int L D V F (n.l) dl of GGX with Smith's correlated G in double, over the sky's formula, a grid of 0.5 degrees.
glm::dvec3 specular_of_sky(lighting::Sky sky, const glm::dvec3& n, const glm::dvec3& v, double roughness, double F0) {
    constexpr int kRows = 360;
    const double alpha2 = std::pow(roughness, 4.0), n_dot_v = glm::dot(n, v);
    const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1.0 + alpha2 * (1.0 - c * c) / (c * c)) - 1.0); };
    glm::dvec3 sum(0.0);
    for (int j = 0; j < kRows; ++j) {
        const double theta = (j + 0.5) * pi / kRows;
        for (int i = 0; i < 2 * kRows; ++i) {
            const double phi = (i + 0.5) * pi / kRows;
            const glm::dvec3 l(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const double n_dot_l = glm::dot(n, l);
            if (n_dot_l <= 0.0) continue;
            const glm::dvec3 h = glm::normalize(l + v);
            const double n_dot_h = glm::dot(n, h), s = n_dot_h * n_dot_h * (alpha2 - 1.0) + 1.0;
            const double D = alpha2 / (pi * s * s), G = 1.0 / (1.0 + lambda(n_dot_l) + lambda(n_dot_v));
            const double F = F0 + (1.0 - F0) * std::pow(1.0 - glm::dot(v, h), 5.0);
            sum += glm::dvec3(sky_radiance(sky, glm::vec3(l))) * (D * G * F / (4.0 * n_dot_v) * std::sin(theta));
        }
    }
    return sum * (pi / kRows) * (pi / kRows);
}

}  // namespace

TEST_CASE("54_split_sum: the integral is that of the sky's formula and the split sum misses it most at the rim") {
    scene::RenderBuffers for_split, for_exact;
    const scene::Scene ball = metal_ball(built_in_sky(lighting::Sky::gradient), 0.4f, 24);
    const SpecularPicture split = draw_specular(ball, for_split);
    const SpecularPicture exact = draw_specular(with_reference(ball, 2048), for_exact);
    for (const glm::ivec2 pixel : {glm::ivec2(12, 12), glm::ivec2(6, 8), glm::ivec2(22, 14), glm::ivec2(12, 1)}) {
        CAPTURE(pixel.x);
        const auto at = [&](int view) { return for_exact.views[std::size_t(view)].rgb(pixel.x, pixel.y); };
        const glm::dvec3 sum = specular_of_sky(lighting::Sky::gradient, glm::dvec3(at(1)), glm::dvec3(at(2)), 0.4, 0.9);
        for (int c = 0; c < 3; ++c)
            CHECK(at(0)[c] == doctest::Approx(sum[c]).epsilon(0.01));  // 2048 samples of a soft sun
    }
    // By another program, for a smooth sky: 1.6 % at n.v = 0.75, 17 % at 0.25.
    CHECK(error_percent(split, exact, 0.4f, 0.7f, 0.95f) < 2.5);
    CHECK(error_percent(split, exact, 0.4f, 0.1f, 0.3f) > 6.0);
}

TEST_CASE("54_split_sum: the difference is that of the two pictures four times as bright") {
    const auto panel = [](int i) { return linear_panel("54_split_sum/balls", 2, 2, i); };
    const raster::Image split = panel(0), exact = panel(1), difference = panel(2);
    int compared = 0;
    for (int y = 0; y < split.height - 14; ++y) {  // above the captions
        for (int x = 0; x < split.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float expected = 4.0f * std::abs(split.at(c, x, y) - exact.at(c, x, y));
                if (expected > 0.9f) continue;                                // cut off at white
                CHECK(std::abs(difference.at(c, x, y) - expected) < 0.045f);  // two pictures of 8 bits, four times
                ++compared;
            }
        }
    }
    CHECK(compared > 20000);
}

TEST_CASE("54_split_sum: on the floor the sun is a streak and the split sum makes it a disc") {
    double ratio[2];
    for (int i = 0; i < 2; ++i) {
        const raster::Image image = linear_panel("54_split_sum/floor", 2, 1, i);
        constexpr int kHorizon = 62;
        float brightest = 0.0f;
        for (int y = kHorizon; y < image.height - 14; ++y) {
            for (int x = 0; x < image.width; ++x) brightest = std::max(brightest, image.at(1, x, y));
        }
        int left = image.width, right = 0, top = image.height, bottom = 0;
        for (int y = kHorizon; y < image.height - 14; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (image.at(1, x, y) < 0.6f * brightest) continue;
                left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
                bottom = std::max(bottom, y);
            }
        }
        ratio[i] = double(bottom - top + 1) / double(right - left + 1);
    }
    CAPTURE(ratio[0]);
    CAPTURE(ratio[1]);
    CHECK(ratio[0] < 1.3);
    CHECK(ratio[1] > 2.0);
}
