// 16_antialiasing: one sample says all or nothing; n x n samples say how much of a pixel is covered.
// Page docs/16_antialiasing.md | After 10_triangle | New: ImageSettings::samples
// Break at: mean_of_samples | Look at: n, sum | Try: samples 8, kSpokes 60
#include <cmath>
#include <memory>
#include <string>

#include <glm/geometric.hpp>

#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr int kSpokes = 18;
constexpr int kPixels = 52;                ///< the star is drawn small, then enlarged: a side of the small picture
constexpr float kHeight = 2.1f;            ///< of the view; the star's is 2
constexpr int kCloseX = 40, kCloseY = 17;  ///< the pixel where the close-up starts

/// A star of thin triangles from the centre to radius 1, in the plane z = 0.
raster::Mesh make_star() {
    raster::Mesh mesh;
    for (int i = 0; i < kSpokes; ++i) {
        const double step = 2.0 * 3.14159265358979 / kSpokes;
        const double from = (i + 0.15) * step, to = (i + 0.65) * step;
        mesh.positions.insert(mesh.positions.end(), {glm::vec3(0.0f), glm::vec3(std::cos(from), std::sin(from), 0.0),
                                                     glm::vec3(std::cos(to), std::sin(to), 0.0)});
        for (int k = 0; k < 3; ++k) mesh.indices.push_back(static_cast<std::uint32_t>(3 * i + k));
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f, 0.0f, 1.0f));
    mesh.parts = {{"star", 0, kSpokes, -1}};
    return mesh;
}

/// Chalk on a board: the ambient light alone, so that a covered sample is exactly chalk.
scene::Scene make_scene(const raster::Mesh& mesh, int samples) {
    scene::Scene scene;
    scene.image.width = scene.image.height = kPixels;
    scene.image.samples = samples;
    scene.image.background = kBoard;
    scene.camera.position = {0.0f, 0.0f, 4.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = kHeight;
    scene.ambient = glm::vec3(1.0f);
    scene.materials.resize(1);
    scene.materials[0].phong = {.ambient = kChalk, .diffuse = glm::vec3(0.0f), .specular = glm::vec3(0.0f)};
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(mesh);
    object.part_material = {0};
    scene.objects.push_back(object);
    return scene;
}

/// A part of the star under the magnifying glass, with its true outline and the places of the samples.
Image draw_close(const Image& image, const raster::Mesh& star, int samples, int cell, glm::ivec2 size) {
    const Image close = enlarge(crop(image, kCloseX, kCloseY, size.x / cell + 1, size.y / cell + 1), cell);
    Image panel = crop(close, 0, 0, size.x, size.y);
    const auto place = [&](std::uint32_t corner) {
        const glm::vec2 in_pixels =
            float(kPixels) * (0.5f + glm::vec2(star.positions[corner]) * glm::vec2(1, -1) / kHeight);
        return (in_pixels - glm::vec2(kCloseX, kCloseY)) * float(cell);
    };
    for (std::uint32_t i = 0; i < star.positions.size(); i += 3) {
        draw_triangle_outline(panel, {place(i), place(i + 1), place(i + 2)}, 0.04f * float(cell), kBlue);
    }
    const float step = float(cell) / float(samples);
    for (int y = 0; y * step < float(size.y); ++y) {
        for (int x = 0; x * step < float(size.x); ++x) {
            draw_disc(panel, step * (glm::vec2(x, y) + 0.5f), 0.035f * float(cell), kOrange);
        }
    }
    return panel;
}

void draw(const Options& options) {
    const raster::Mesh star = make_star();
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 1);
    std::vector<Panel> stars, close;
    for (const int samples : {1, 2, 4}) {
        const Image image = render(make_scene(star, samples));
        const std::string caption = std::to_string(samples * samples) + (samples == 1 ? " sample" : " samples");
        Image panel = make_board(size.x, size.y);
        const Image large = enlarge(image, size.x / kPixels);
        paste(panel, large, (size.x - large.width) / 2, (size.y - large.height) / 2);
        stars.emplace_back(panel, caption);
        close.emplace_back(draw_close(image, star, samples, size.y / 9, size), caption);
    }
    save_panels(options, "star", 3, stars);
    save_panels(options, "samples", 3, close);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "16_antialiasing", draw);
}
