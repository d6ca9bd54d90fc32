// Laws about the pictures of 64 to 67: where boxes and a ball keep a lamp from a table is solved here by hand, in
// double.
#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/table_scene.hpp"
#include "raster/film.hpp"
#include "raster/shapes.hpp"
#include "shadows/silhouette.hpp"

using namespace kreda;
using namespace kreda::tests;
using glm::dvec2, glm::dvec3;

namespace {

struct View {
    dvec3 eye{1.7, 2.2, 4.0}, target{-0.1, 0.5, 0.0};
    double fov_deg = 32.0;
    int width = 320, height = 180;
};

/// Through a point of the picture, in pixels.
dvec3 direction_through(const View& view, dvec2 pixel) {
    const dvec3 forward = glm::normalize(view.target - view.eye);
    const dvec3 right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0)));
    const dvec3 up = glm::cross(right, forward);
    const double reach = std::tan(glm::radians(0.5 * view.fov_deg));
    const double x = (2.0 * pixel.x - view.width) / view.height, y = 1.0 - 2.0 * pixel.y / view.height;
    return forward + reach * (x * right + y * up);
}

/// Does p + t d meet the box for some t in (0, end)?                                 Kay & Kajiya 1986
bool meets_box(dvec3 centre, dvec3 half, dvec3 p, dvec3 d, double end) {
    double t_in = 0.0, t_out = end;
    for (int k = 0; k < 3; ++k) {
        const double a = (centre[k] - half[k] - p[k]) / d[k], b = (centre[k] + half[k] - p[k]) / d[k];
        t_in = std::max(t_in, std::min(a, b));
        t_out = std::min(t_out, std::max(a, b));
    }
    return t_in < t_out;
}

bool meets_ball(dvec3 centre, double radius, dvec3 p, dvec3 d, double end) {
    const double t = std::clamp(glm::dot(centre - p, d) / glm::dot(d, d), 0.0, end);
    return glm::length(p + t * d - centre) < radius;
}

/// How many of the three things on the table the way p + t d, t < end, runs through.
int things_met(dvec3 p, dvec3 d, double end) {
    using namespace examples;
    return meets_box(kBoxCentre, kBoxHalfSize, p, d, end) + meets_ball(kBallCentre, double{kBallRadius}, p, d, end) +
           meets_box(kPillarCentre, kPillarHalfSize, p, d, end);
}

/// What is seen through a point of the picture: -1 for anything but the bare table, else how many things keep the lamp
/// from it.
int shadows_on_table(const View& view, dvec2 pixel) {
    const dvec3 d = direction_through(view, pixel);
    const double t = -view.eye.y / d.y;
    const dvec3 p = view.eye + t * d;
    const bool on_table = std::abs(p.x) < examples::kTableHalfSize.x && std::abs(p.z) < examples::kTableHalfSize.y;
    if (t <= 0.0 || !on_table || things_met(view.eye, d, t) > 0) return -1;
    return things_met(p, dvec3(examples::kLampPosition) - p, 1.0);
}

/// The same if it is the same all around, up to `reach` pixels from the pixel's centre; else -1. The ball is a mesh of
/// 48 segments, up to 0.3 (1 - cos(pi / 48)) = 0.0006 smaller than the ball here: a tenth of a pixel.
int surely(const View& view, int x, int y, double reach) {
    const dvec2 centre(x + 0.5, y + 0.5);
    const int count = shadows_on_table(view, centre);
    for (const dvec2 corner : {dvec2(-1, -1), dvec2(1, -1), dvec2(-1, 1), dvec2(1, 1), dvec2(0, 1), dvec2(0, -1),
                               dvec2(1, 0), dvec2(-1, 0)}) {
        if (shadows_on_table(view, centre + reach * corner) != count) return -1;
    }
    return count;
}

double linear(float encoded) {
    return double{raster::linear_from_srgb(encoded)};
}

/// The table's colour in the shadow is its ambient term; in the light at least three times as much.
bool is_dark(const raster::Image& picture, int x, int y) {
    return linear(picture.at(0, x, y)) < 0.3 * double{examples::kDust.x};
}

/// Pixels of the bare table that are on the wrong side of the shadow's edge; `seen` counts all of them.
int wrong_on_table(const raster::Image& picture, const View& view, int left, double reach, int bottom, int& seen) {
    int wrong = 0;
    for (int y = 0; y < view.height - bottom; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const int count = surely(view, x, y, reach);
            if (count < 0) continue;
            ++seen;
            wrong += is_dark(picture, left + x, y) != (count > 0);
        }
    }
    return wrong;
}

/// The counter's colours: grey 0, blue 1, orange 2.
int counted(const raster::Image& picture, int x, int y) {
    const float r = picture.at(0, x, y), b = picture.at(2, x, y);
    return b > r + 0.2f ? 1 : r > b + 0.2f ? 2 : 0;
}

/// Share of red and blue pixels of a panel of 67_methods_compared among those that see something, in percent.
double wrong_in_panel(int panel) {
    const raster::Image picture = linear_panel("67_methods_compared/errors.png", 3, 2, panel);
    int wrong = 0, seen = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 c = picture.rgb(x, y);
            seen += c.x + c.y + c.z > 0.2f;  // neither background nor the caption's board
            wrong += std::abs(c.x - c.z) > 0.2f;
        }
    }
    return 100.0 * wrong / seen;
}

}  // namespace

TEST_CASE("64 planar shadows: the table is dark where something stands before the lamp") {
    int seen = 0;
    CHECK(wrong_on_table(golden("64_planar_shadows/planar.png"), {}, 0, 0.7, 0, seen) == 0);
    CHECK(seen > 8000);
}

TEST_CASE("64 planar shadows: the height of the lamp over the pillar is the one on the page") {
    const double w = double{examples::kLampPosition.y} - examples::kPillarCentre.y - examples::kPillarHalfSize.y;
    CHECK(w == doctest::Approx(documented_number("64_planar_shadows", "w")).epsilon(1e-5));
}

TEST_CASE("65 shadow volumes: the counter on the table is the number of things before the lamp") {
    const raster::Image picture = golden("65_shadow_volumes/counter.png");
    int wrong = 0, of_count[4] = {};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int count = surely({}, x, y, 0.2);
            if (count < 0) continue;
            ++of_count[count];
            wrong += counted(picture, x, y) != count;
        }
    }
    CHECK(wrong == 0);
    CHECK(of_count[0] > 5000);
    CHECK(of_count[1] > 1000);
    CHECK(of_count[2] > 100);
}

TEST_CASE("65 shadow volumes: caps and silhouette of the box are those on the page") {
    raster::Mesh box = raster::make_cube(1);
    for (glm::vec3& p : box.positions) p = examples::kBoxCentre + examples::kBoxHalfSize * p;
    const shadows::VolumeShape shape =
        shadows::find_volume({box.positions, box.indices, false}, glm::dvec4(dvec3(examples::kLampPosition), 1.0));
    CHECK(static_cast<double>(shape.caps.size()) == documented_number("65_shadow_volumes", "caps"));
    CHECK(static_cast<double>(shape.sides.size()) == documented_number("65_shadow_volumes", "edges"));
}

TEST_CASE("66 irregular z-buffer: its edges are where they are by hand and the map's are not") {
    const glm::ivec2 size = examples::panel_size(320, 180, 2, 1);
    const View view{{1.7, 2.2, 4.0}, {-0.75, 0.05, 0.1}, 17.0, size.x, size.y};
    const raster::Image picture = golden("66_irregular_z_buffer/edges.png");
    int seen = 0;
    CHECK(wrong_on_table(picture, view, size.x + 4, 0.25, 14, seen) == 0);
    CHECK(wrong_on_table(picture, view, 0, 0.25, 14, seen) > 30);
    CHECK(seen > 10000);
}

TEST_CASE("67 methods compared: shares of wrong pixels are those on the page") {
    // The page counts all pixels of a panel, the picture has a caption over some: nearly the same share.
    CHECK(wrong_in_panel(0) == doctest::Approx(documented_number("67_methods_compared", "map_256")).epsilon(0.1));
    CHECK(wrong_in_panel(1) == doctest::Approx(documented_number("67_methods_compared", "map_1024")).epsilon(0.1));
    CHECK(wrong_in_panel(2) == doctest::Approx(documented_number("67_methods_compared", "map_2048")).epsilon(0.1));
    CHECK(wrong_in_panel(3) == doctest::Approx(documented_number("67_methods_compared", "planar")).epsilon(0.1));
    CHECK(wrong_in_panel(4) < 0.05);  // a pixel or two
    CHECK(wrong_in_panel(5) == 0.0);
}
