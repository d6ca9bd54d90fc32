// 17_textures: a ground that runs to the horizon, read nearest, bilinear and from mip maps; and close up.
// Page docs/17_textures.md | After 16_antialiasing | New: Texture, sample_level(), level_of_detail()
// Break at: sample_trilinear | Look at: level, fine, of_fine, of_coarse | Try: kTiles 10 and 200, texture_filter
#include <array>
#include <cmath>
#include <memory>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "raster/texture.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;
using raster::TextureFilter;

namespace {

constexpr float kTiles = 40.0f;   ///< how often the texture is laid on the ground, in u and in v
constexpr float kExtent = 60.0f;  ///< half the side of the ground
constexpr int kSide = 64;         ///< of the texture, in texels

/// Two by two squares, chalk and blue, with a thin orange line along the left border.
Image board_texture() {
    Image image = make_board(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool light = (2 * x / kSide + 2 * y / kSide) % 2 == 0;
            image.set_rgb(x, y, x < 4 ? kOrange : light ? kChalk : 0.35f * kBlue);
        }
    }
    return image;
}

/// Eight by eight texels that can be told apart.
Image small_texture() {
    constexpr std::array<const char*, 8> kRows = {"........", ".#....#.", ".#...#..", ".#.##...",
                                                  ".##.#...", ".#...#..", ".#....#.", "........"};
    Image image = make_board(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) image.set_rgb(x, y, kRows[std::size_t(y)][x] == '#' ? kYellow : kSlate);
    }
    return image;
}

/// A square on the ground that shows nothing but its texture, laid on it `tiles` times in each direction.
scene::Scene make_ground(glm::ivec2 size, const Image& picture, float tiles, float extent, TextureFilter filter) {
    scene::Scene scene = empty_scene(size);
    scene.image.samples = 1;
    lighting::Material material;
    material.model = lighting::ReflectionModel::unlit;
    material.maps.diffuse.texture = std::make_shared<raster::Texture>(raster::make_texture(picture));
    material.maps.filter = filter;
    material.maps.scale = glm::vec2(tiles);
    const int ground = add_shape(scene, "plane", 1, {0.0f, 0.0f, 0.0f}, material);
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = extent;
    scene.camera.position = {0.4f, 1.0f, 0.0f};
    scene.camera.target = {0.9f, 0.72f, -1.0f};
    return scene;
}

Panel draw_far(glm::ivec2 size, TextureFilter filter, int samples, const char* caption) {
    scene::Scene scene = make_ground(size, board_texture(), kTiles, kExtent, filter);
    scene.image.samples = samples;
    return captioned(scene, caption);
}

/// The level of detail at every pixel, each whole level a colour.
Panel draw_levels(glm::ivec2 size) {
    const scene::Scene scene = make_ground(size, board_texture(), kTiles, kExtent, TextureFilter::trilinear);
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("level")}), buffers);
    const std::array colors = {kBlue, kGreen, kYellow, kOrange, kRed, kChalk, kDust};
    Image image = std::move(buffers.film);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            if (image.rgb(x, y) == kBoard) continue;
            const float level = std::min(buffers.views[0].at(0, x, y), 6.0f);
            const std::size_t whole = std::min<std::size_t>(static_cast<std::size_t>(level), 5);
            image.set_rgb(x, y, glm::mix(colors[whole], colors[whole + 1], level - static_cast<float>(whole)));
        }
    }
    return {image, "level of detail"};
}

/// The pyramid: every level with its texels as large as those of level 0, 1, 2, ... are.
Panel draw_pyramid(glm::ivec2 size) {
    const raster::Texture texture = raster::make_texture(board_texture());
    Image board = make_board(size.x, size.y);
    int x = size.x / 20;
    for (int level = 0; level < texture.level_count; ++level) {
        const Image small = raster::level_image(texture, level);
        const Image large = enlarge(small, std::max(1, size.x / 2 / kSide));
        paste(board, large, x, size.y / 10);
        x += large.width + size.x / 40;
    }
    return {board, "64, 32, 16 … 1"};
}

void draw(const Options& options) {
    const int height = options.height;
    const glm::ivec2 quarter = panel_size(options.width, height, 2, 2);
    const Panel nearest = draw_far(quarter, TextureFilter::nearest, 1, "nearest");
    const Panel bilinear = draw_far(quarter, TextureFilter::bilinear, 1, "bilinear");
    const Panel trilinear = draw_far(quarter, TextureFilter::trilinear, 1, "trilinear: mip maps");
    const Panel truth = draw_far(quarter, TextureFilter::nearest, 8, "64 samples a pixel");
    save_panels(options, "filters", 2, {nearest, bilinear, trilinear, truth});

    const glm::ivec2 half = panel_size(options.width, height, 2, 1);
    save_panels(options, "levels", 2, {draw_levels(half), draw_pyramid(half)});

    std::vector<Panel> panels;
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
        scene::Scene close = make_ground(half, small_texture(), 1.0f, 1.0f, filter);
        close.camera.position = {-0.5f, 2.0f, 1.4f};
        close.camera.target = {0.0f, -0.1f, 0.05f};
        panels.push_back(captioned(close, filter == TextureFilter::nearest ? "nearest" : "bilinear"));
    }
    save_panels(options, "magnified", 2, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "17_textures", draw);
}
