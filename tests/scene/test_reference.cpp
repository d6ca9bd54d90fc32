// environment.reference: the integral by samples of the lobe and of the light, against quadrature over all texels.
#include <cmath>
#include <numbers>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/environment_image.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::scene;
using std::numbers::pi;

namespace {

/// A ball under a blue sky with a sun a degree and a half wide that sends four times the light of the whole sky.
Scene ball_under_sun(const std::string& material, int samples) {
    Scene scene = read_scene_text(
        "[image]\nsize = [24, 24]\n[camera]\nposition = [0, 0, 4]\nprojection = \"orthographic\"\n"
        "height = 2\n[ambient]\ncolor = [0, 0, 0]\n[environment]\nsky = \"gradient\"\nrotation = 30\nreference = " +
            std::to_string(samples) +
            "\n[[object]]\nmesh = \"sphere\"\ndetail = 96\nmaterial = \"m\"\n[[material]]\nname = \"m\"\n" + material,
        "test", "");
    raster::Image image = raster::make_image(512, 256, 3);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) image.set_rgb(x, y, {0.3f, 0.4f, 0.6f});
    }
    for (int y = 70; y < 72; ++y) {
        for (int x = 160; x < 162; ++x) image.set_rgb(x, y, {24000.0f, 22000.0f, 19000.0f});
    }
    scene.environment.image = std::make_shared<raster::Image>(image);
    return scene;
}

struct Picture {
    raster::Image diffuse, specular, error, normal;
};

Picture draw_reference(const Scene& scene, int threads = 0) {
    RenderBuffers buffers;
    const auto views = {find_view("environment_diffuse"), find_view("environment_specular"),
                        find_view("environment_error"), find_view("normal")};
    render(scene, make_plan(scene, views), buffers, threads);
    return {buffers.views[0], buffers.views[1], buffers.views[2], buffers.views[3]};
}

/// int L(l) weight(l) dl in double: 3 x 3 points in every texel of the map that the picture is lit by.
template <class Weight>
glm::dvec3 quadrature(const Scene& scene, Weight weight) {
    const PreparedEnvironment prepared = prepare_environment(scene.environment, make_plan(scene).environment);
    const lighting::CubeMap& map = prepared.maps.prefiltered;
    const int points = 3 * map.levels[0].size;
    const double turn = scene.environment.rotation_deg * pi / 180.0;
    glm::dvec3 sum(0.0);
    for (int face = 0; face < lighting::kCubeFaces; ++face) {
        for (int y = 0; y < points; ++y) {
            for (int x = 0; x < points; ++x) {
                const glm::vec3 d = lighting::texel_direction(points, face, x, y);
                const glm::dvec3 m = glm::normalize(glm::dvec3(d));
                const glm::dvec3 l(m.x * std::cos(turn) + m.z * std::sin(turn), m.y,
                                   m.z * std::cos(turn) - m.x * std::sin(turn));
                const double w = weight(l);
                if (w == 0.0) continue;
                sum += glm::dvec3(sample_level(map, 0, d)) * (w * lighting::texel_solid_angle(points, x, y));
            }
        }
    }
    return sum;
}

/// D V F (n.l) of GGX, Smith's correlated V and Schlick's F for F0 = 1 and v = +z.
double white_metal(const glm::dvec3& n, const glm::dvec3& l, double alpha) {
    const glm::dvec3 v(0.0, 0.0, 1.0), h = glm::normalize(l + v);
    const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h), a2 = alpha * alpha;
    if (nl <= 0.0 || nv <= 0.0) return 0.0;
    const double s = nh * nh * (a2 - 1.0) + 1.0;
    const double V = 0.5 / (nl * std::sqrt(nv * nv * (1.0 - a2) + a2) + nv * std::sqrt(nl * nl * (1.0 - a2) + a2));
    return a2 / (pi * s * s) * V * nl;
}

const glm::ivec2 kPixels[] = {{12, 12}, {8, 7}, {17, 5}, {4, 14}, {19, 18}};

const std::string kLambert = "model = \"lambert\"\ndiffuse = [1, 1, 1]\n";

std::string metal(const std::string& roughness) {
    return "model = \"cook_torrance\"\nalbedo = [1, 1, 1]\nmetallic = 1\ngeometry = \"smith_correlated\"\nroughness "
           "= " +
           roughness + "\n";
}

double luminance(const glm::dvec3& c) {
    return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace

TEST_CASE("reference: a white Lambert ball under a small sun is within one percent of quadrature") {
    const Scene scene = ball_under_sun(kLambert, 2048);
    const Picture picture = draw_reference(scene);
    for (const glm::ivec2& pixel : kPixels) {
        CAPTURE(pixel.x);
        const glm::dvec3 n(picture.normal.rgb(pixel.x, pixel.y));
        const auto cosine = [&](const glm::dvec3& l) { return std::max(glm::dot(n, l), 0.0) / pi; };
        const double exact = luminance(quadrature(scene, cosine));
        const double seen = luminance(picture.diffuse.rgb(pixel.x, pixel.y));
        CHECK(std::abs(seen / exact - 1.0) < 0.01);
        CHECK(std::abs(seen - exact) < 3.0 * picture.error.at(0, pixel.x, pixel.y) + 0.002 * exact);
        CHECK(picture.error.at(0, pixel.x, pixel.y) < 0.03 * exact);  // what it says of itself
    }
}

TEST_CASE("reference: a glossy metal under a small sun is quadrature from smooth to rough") {
    for (const auto& [text, bound] : {std::pair{"0.3", 0.03}, {"0.6", 0.02}, {"1", 0.02}}) {
        const std::string roughness = text;
        const double alpha = std::pow(std::stod(roughness), 2);
        const Scene scene = ball_under_sun(metal(roughness), 2048);
        const Picture picture = draw_reference(scene);
        for (const glm::ivec2& pixel : kPixels) {
            CAPTURE(roughness);
            CAPTURE(pixel.x);
            const glm::dvec3 n(picture.normal.rgb(pixel.x, pixel.y));
            const glm::dvec3 exact = quadrature(scene, [&](const glm::dvec3& l) { return white_metal(n, l, alpha); });
            const double seen = luminance(picture.specular.rgb(pixel.x, pixel.y));
            CHECK(std::abs(seen / luminance(exact) - 1.0) < bound);
        }
    }
}

TEST_CASE("reference: more samples come nearer and the stated error falls") {
    const Picture few = draw_reference(ball_under_sun(kLambert, 64)),
                  many = draw_reference(ball_under_sun(kLambert, 4096));
    for (const glm::ivec2& pixel : kPixels) {
        CHECK(many.error.at(0, pixel.x, pixel.y) < 0.25f * few.error.at(0, pixel.x, pixel.y));
    }
}

TEST_CASE("reference: the same bits with one thread and with four") {
    const Scene scene = ball_under_sun(metal("0.4"), 64);
    CHECK(draw_reference(scene, 1).specular.values == draw_reference(scene, 4).specular.values);
    CHECK(draw_reference(scene, 1).error.values == draw_reference(scene, 4).error.values);
}
