// The pictures of 41_microfacets to 45_other_models, and 91_fresnel_speed, against closed forms and other programs.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/fresnel_views.hpp"
#include "examples/paint.hpp"
#include "lighting/spectrum.hpp"
#include "raster/shapes.hpp"
#include "tools/measure/fresnel_methods.hpp"

using namespace kreda;
using namespace kreda::tests;
using namespace kreda::examples;
using namespace kreda::tools;
using std::numbers::pi;

namespace {

/// One code of sRGB's 8 bits near white, in linear light.
constexpr float kCode = 2.3f / 255.0f;

int captions_top(const raster::Image& panel) {
    return panel.height - 14;  // a caption is 13 rows high in a picture of 180 rows
}

/// Smallest box around the pixels whose green is above `limit`, in the left upper part of a panel.
struct Box {
    int left = 10000, right = -1, top = 10000, bottom = -1;
    [[nodiscard]] int width() const {
        return right - left + 1;
    }
    [[nodiscard]] int height() const {
        return bottom - top + 1;
    }
};
Box bright_box(const raster::Image& image, int right_end, float limit) {
    Box box;
    for (int y = 0; y < captions_top(image); ++y) {
        for (int x = 0; x < right_end; ++x) {
            if (image.at(1, x, y) < limit) continue;
            box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
        }
    }
    return box;
}

/// Greatest mean difference of two panels above their captions.
double mean_distance(const raster::Image& a, const raster::Image& b) {
    double sum = 0.0;
    for (int y = 0; y < captions_top(a); ++y) {
        for (int x = 0; x < a.width; ++x) sum += glm::distance(a.rgb(x, y), b.rgb(x, y));
    }
    return sum / (a.width * captions_top(a));
}

}  // namespace

TEST_CASE("41_microfacets: GGX's curve passes 12 degrees where its formula says and peaks at the page's number") {
    CHECK(1.0 / (pi * 0.09) == doctest::Approx(documented_number("41_microfacets", "peak")).epsilon(2e-3));
    // tan^2 12 = 0.0452, cos^4 12 = 0.9154: D = 0.09 / (pi 0.9154 (0.09 + 0.0452)^2) = 1.713
    CHECK(golden_value("41_microfacets/distributions", "GGX", 12.0) == doctest::Approx(1.713).epsilon(5e-4));
    CHECK(golden_value("41_microfacets/distributions", "GGX", 0.0) == doctest::Approx(1.0 / (pi * 0.09)).epsilon(1e-5));
}

TEST_CASE("41_microfacets: where no facet is seen from both sides nothing is reflected") {
    for (int row = 0; row < 2; ++row) {
        const raster::Image G = linear_panel("41_microfacets/terms", 4, 2, 4 * row + 1);
        const raster::Image product = linear_panel("41_microfacets/terms", 4, 2, 4 * row + 3);
        int dark = 0, lit = 0;
        for (int y = 0; y < captions_top(G); ++y) {
            for (int x = 0; x < G.width; ++x) {
                if (G.at(0, x, y) == 0.0f) dark += product.rgb(x, y) == glm::vec3(0.0f) ? 1 : -1'000'000;
                lit += product.at(2, x, y) > 0.5f;
            }
        }
        CHECK(dark > 300);
        CHECK(lit > 50);
    }
}

TEST_CASE("42_cook_torrance: in the white furnace a rough ball keeps one minus the logarithm of two") {
    // Seen from above, alpha = 1, E = 1 - ln 2 (closed form), before a background of 1/2.
    const double expected = 0.5 * (1.0 - std::log(2.0));
    CHECK(2.0 * expected == doctest::Approx(documented_number("42_cook_torrance", "one_bounce")).epsilon(2e-3));
    for (const int row : {0, 1}) {  // Schlick-GGX is Smith at roughness 1
        const raster::Image image = linear_panel("42_cook_torrance/furnace", 1, 3, row);
        const int x = image.width / 2 + int(std::lround(2.0 * 2.2 * image.height / 2.4));  // the fifth ball's middle
        CHECK(std::abs(image.at(0, x, image.height / 2) - expected) < 0.01);  // 400 lamps for a sphere of light: 1 %
    }
}

TEST_CASE("42_cook_torrance: with the second lobe the balls vanish in the furnace and without it they do not") {
    const raster::Image full = linear_panel("42_cook_torrance/furnace", 1, 3, 2);
    const raster::Image single = linear_panel("42_cook_torrance/furnace", 1, 3, 1);
    double worst = 0.0, darkest = 1.0;
    for (int y = 0; y < captions_top(full); ++y) {
        for (int x = 0; x < full.width; ++x) {
            worst = std::max(worst, std::abs(full.at(1, x, y) - 0.5));
            darkest = std::min(darkest, double{single.at(1, x, y)});
        }
    }
    CHECK(worst < 0.03);  // 400 lamps for a sphere of light: most at the rim of the smoothest ball
    CHECK(darkest < 0.2);
}

TEST_CASE("43_metals: the swatches are the colours that another program computed") {
    // Linear sRGB of the whole spectrum, 1 nm steps, and of three wavelengths; gold's red beyond 1 is shown as 1.
    const glm::vec3 full[] = {{1.0f, 0.7284f, 0.3646f},
                              {0.9894f, 0.9840f, 0.9778f},
                              {0.9317f, 0.6227f, 0.5223f},
                              {0.9073f, 0.9159f, 0.9223f},
                              {0.6789f, 0.6395f, 0.5836f}};
    const glm::vec3 three[] = {{0.9678f, 0.7202f, 0.4067f},
                               {0.9923f, 0.9831f, 0.9790f},
                               {0.9511f, 0.6050f, 0.5578f},
                               {0.9002f, 0.9163f, 0.9201f},
                               {0.6881f, 0.6354f, 0.6035f}};
    const raster::Image image = linear_panel("43_metals/metals", 1, 3, 0);
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const int left = i * image.width / 5;
        CHECK(glm::distance(image.rgb(left + image.width * 3 / 50, image.height / 2), full[i]) < kCode);
        CHECK(glm::distance(image.rgb(left + image.width * 7 / 50, image.height / 2), three[i]) < kCode);
    }
}

TEST_CASE("43_metals: two colours of the whole spectrum are better than three wavelengths on the average") {
    for (const char* name : {"gold", "silver", "copper", "aluminium", "platinum"}) {
        CAPTURE(std::string(name));
        const lighting::MeasuredMaterial& metal = *lighting::find_measured(name);
        const lighting::ThreeChannelIndex index = lighting::three_channel_index(metal);
        const glm::vec3 f0 = lighting::spectral_fresnel(metal, 1.0f);
        const glm::vec3 f82 = lighting::spectral_fresnel(metal, 1.0f / 7.0f);
        double two = 0.0, three = 0.0;
        int better = 0;
        for (int a = 0; a < 90; ++a) {
            const float c = static_cast<float>(std::cos((a + 0.5) * 3.14159265358979 / 180.0));
            const glm::vec3 exact = lighting::spectral_fresnel(metal, c);
            glm::vec3 two_colours;
            for (int i = 0; i < 3; ++i) {
                two_colours[i] = lighting::fresnel_f82(c, f0[i], lighting::f82_coefficient(f0[i], f82[i]));
            }
            const auto percent = [&](const glm::vec3& color) {
                const glm::vec3 error = glm::abs(color - exact) / exact;
                return 100.0 * (error.x + error.y + error.z) / 3.0;
            };
            const double of_two = percent(two_colours);
            const double of_three = percent(lighting::fresnel_conductor(c, index.n, index.k));
            two += of_two / 90.0;
            three += of_three / 90.0;
            better += of_two < of_three;
            if (a < 45) CHECK(of_two < of_three);
        }
        const glm::vec3 head_on = glm::abs(lighting::f0_from_index(index.n, index.k) - f0) / f0;
        const std::vector<QuotedNumber> of_wavelengths = documented_row("43_metals", "error at 0", name);
        CHECK(rounds_to(100.0 * (head_on.x + head_on.y + head_on.z) / 3.0, of_wavelengths.at(0)));
        CHECK(rounds_to(three, of_wavelengths.at(1)));
        const std::vector<QuotedNumber> of_methods = documented_row("43_metals", "F82 from the spectrum", name);
        CHECK(rounds_to(two, of_methods.at(0)));
        CHECK(rounds_to(three, of_methods.at(1)));
        CHECK(two < three);
        CHECK((better == 90) == (std::string(name) == "gold"));
    }
}

TEST_CASE("45_other_models: the highlight lies across the grain") {
    const auto panel = [](int i) { return linear_panel("45_other_models/models", 4, 2, i); };
    // Left of the middle there is the main lamp's highlight alone.
    const Box plain = bright_box(panel(0), 50, 0.35f), upright = bright_box(panel(1), 50, 0.35f),
              level = bright_box(panel(2), 39, 0.35f);
    CHECK(std::abs(plain.width() - plain.height()) <= plain.width() / 2);
    CHECK(upright.width() > 2 * upright.height());
    CHECK(level.height() > 2 * level.width());
    CHECK(documented_number("45_other_models", "across") > 6.0 * documented_number("45_other_models", "along"));
}

TEST_CASE("45_other_models: Beckmann and Gauss and Blinn-Phong look alike and GGX does not") {
    const auto panel = [](int i) { return linear_panel("45_other_models/models", 4, 2, i); };
    const double alike = std::max(mean_distance(panel(5), panel(6)), mean_distance(panel(5), panel(7)));
    CHECK(mean_distance(panel(4), panel(5)) > 2.0 * alike);
}

TEST_CASE("91_fresnel_speed: a ball from afar has the errors weighted by the sine of the double angle") {
    // A ball shows the angle theta on an area proportional to sin 2 theta. By a program of its own, percent:
    struct Row {
        const char* name;
        double schlick, corrected, f82;
    };
    raster::Camera camera;
    camera.projection = raster::Projection::orthographic;
    camera.position = {0.0f, 0.0f, 4.0f};
    std::vector<float> cosines;
    for_each_surface_point(raster::make_sphere(512), camera, {400, 400}, [&](int, int, const SurfacePoint& p) {
        cosines.push_back(std::max(glm::dot(p.n, p.v), 0.0f));
    });
    for (const Row& row : {Row{"gold", 1.09, 0.98, 0.94}, Row{"platinum", 4.04, 2.13, 0.77},
                           Row{"water", 10.7, 9.8, 13.8}, Row{"diamond", 3.57, 2.9, 4.7}}) {
        CAPTURE(std::string(row.name));
        const lighting::ThreeChannelIndex index = lighting::published_index(row.name);
        const std::vector<double> errors = mean_errors_percent(fresnel_curves(index), index, cosines);
        CHECK(errors[1] == doctest::Approx(row.schlick).epsilon(0.01));  // 125,000 pixels; digits of the list
        CHECK(errors[2] == doctest::Approx(row.corrected).epsilon(0.015));
        CHECK(errors[4] == doctest::Approx(row.f82).epsilon(0.015));
    }
}

TEST_CASE("91_fresnel_speed: cube and knot from 180 sides have the page's errors and the cube the thesis' to a fifth") {
    const std::vector<Subject> subjects = comparison_subjects();
    const std::vector<float> cube = cosines_of_views(subjects[0].mesh, {96, 72});
    const std::vector<float> knot = cosines_of_views(subjects[1].mesh, {96, 72});
    struct Row {
        const char* name;
        double published;
    };
    for (const Row& row : {Row{"gold", 0.59}, Row{"platinum", 2.4}, Row{"water", 7.7}, Row{"diamond", 2.62}}) {
        CAPTURE(std::string(row.name));
        const lighting::ThreeChannelIndex index = lighting::published_index(row.name);
        const std::vector<FresnelCurve> curves = fresnel_curves(index);
        const std::vector<double> of_cube = mean_errors_percent(curves, index, cube);
        const std::vector<double> of_knot = mean_errors_percent(curves, index, knot);
        const std::vector<double> found = {of_cube[1], of_knot[1], of_cube[2], of_knot[2], of_knot[4]};
        const std::vector<QuotedNumber> quoted = documented_row("91_fresnel_speed", "mean error in pictures", row.name);
        REQUIRE(quoted.size() == found.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            CAPTURE(i);
            CAPTURE(found[i]);
            CHECK(rounds_to(found[i], quoted[i]));
        }
        CHECK(of_cube[1] == doctest::Approx(row.published).epsilon(0.2));
    }
}

TEST_CASE("91_fresnel_speed: every view looks at the middle from two units away and no two are the same") {
    std::set<float> seen;
    for (int view = 0; view < 180; ++view) {
        const raster::Camera camera = comparison_camera(view);
        CHECK(glm::length(camera.position) == doctest::Approx(2.0).epsilon(1e-6));
        CHECK(glm::dot(camera.position, glm::normalize(glm::vec3(1.0f))) ==
              doctest::Approx(-2.0 / std::sqrt(3.0)).epsilon(1e-5));
        seen.insert(camera.position.x + 10.0f * camera.position.y);
    }
    CHECK(seen.size() == 180);
}

TEST_CASE("91_fresnel_speed: the last panel is the relative difference of the first two inside the mask") {
    for (int row = 0; row < 2; ++row) {
        const auto panel = [&](int i) { return linear_panel("91_fresnel_speed/comparison", 4, 2, 4 * row + i); };
        const raster::Image exact = panel(0), schlick = panel(1), mask = panel(2), error = panel(3);
        int compared = 0;
        for (int y = 0; y < captions_top(exact); ++y) {
            for (int x = 0; x < exact.width; ++x) {
                if (mask.at(0, x, y) == 0.0f) CHECK(error.rgb(x, y) == glm::vec3(0.0f));
                if (mask.at(0, x, y) < 1.0f) continue;
                const float relative = 4.0f * std::abs(schlick.at(0, x, y) - exact.at(0, x, y)) / exact.at(0, x, y);
                if (relative > 0.9f) continue;                          // cut off at white
                CHECK(std::abs(error.at(0, x, y) - relative) < 0.12f);  // two pictures of 8 bits, four times as bright
                ++compared;
            }
        }
        CHECK(compared > 300);
    }
}
