// Drawing on pictures: lines, discs, captions, enlarging, montages. Colours are linear RGB, positions are in pixels
// with (0, 0) in the upper left corner of the upper left pixel, whose centre is (0.5, 0.5). What lies outside is cut
// off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/image.hpp"

namespace kreda::tools {

using raster::Image;

/// Linear RGB of a colour as it is written on the web, 0xRRGGBB.
[[nodiscard]] glm::vec3 srgb(std::uint32_t rrggbb);

/// The palette of all examples: chalk on a blackboard.
inline const glm::vec3 kBoard = srgb(0x20262b);
inline const glm::vec3 kSlate = srgb(0x3b464e);
inline const glm::vec3 kDust = srgb(0x8a949b);
inline const glm::vec3 kChalk = srgb(0xf2eee4);
inline const glm::vec3 kBlue = srgb(0x6fb1e0);
inline const glm::vec3 kOrange = srgb(0xf0a35e);
inline const glm::vec3 kGreen = srgb(0x9bc77b);
inline const glm::vec3 kRed = srgb(0xe2685f);
inline const glm::vec3 kYellow = srgb(0xf2d16b);

/// An empty blackboard.
[[nodiscard]] Image make_board(int width, int height, const glm::vec3& color = kBoard);

/// A grey picture of one value a pixel, row by row from the top.
[[nodiscard]] Image grey_image(int width, int height, std::span<const float> values);

/// Three equal channels out of one; a picture of three or more stays as it is.
[[nodiscard]] Image as_rgb(const Image& image);

/// Colour of a signed value: blue below 0, board at 0, orange above; full at +-1.
[[nodiscard]] glm::vec3 signed_color(float value);

void fill_rectangle(Image& image, int x, int y, int width, int height, const glm::vec3& color);
void draw_line(Image& image, glm::vec2 from, glm::vec2 to, float width, const glm::vec3& color);
void draw_disc(Image& image, glm::vec2 center, float radius, const glm::vec3& color);
/// The pixels whose centre lies in a triangle of either orientation (raster/screen.hpp, 10_triangle).
void fill_triangle(Image& image, const glm::vec2 (&corner)[3], const glm::vec3& color);
void draw_triangle_outline(Image& image, const glm::vec2 (&corner)[3], float width, const glm::vec3& color);

/// A line of plain UTF-8; `corner` is the upper left one of its first capital letter, capitals are 7 `scale` pixels
/// high. tools/draw/type.hpp has more: formulas, sizes, boxes.
void draw_text(Image& image, glm::vec2 corner, std::string_view text, const glm::vec3& color, float scale);
/// How wide it is, in pixels.
[[nodiscard]] float text_width(std::string_view text, float scale);

/// The scale at which a caption is readable from the last row: 2 for a picture of 360 lines.
[[nodiscard]] int text_scale(int picture_height);

/// Every pixel becomes factor x factor pixels.
[[nodiscard]] Image enlarge(const Image& image, int factor);

/// The same with the borders and the centres of the small pixels drawn in.
[[nodiscard]] Image enlarge_with_grid(const Image& image, int factor);

/// A picture of width x height that holds the whole image as large as it fits, each pixel the nearest of the image's;
/// `around` fills the rest. Any number of channels up to three.
[[nodiscard]] Image fit(const Image& image, int width, int height, const glm::vec3& around = kBoard);

/// Each pixel is the mean of n x n pixels of `fine`, whose size is n times as large.
[[nodiscard]] Image box_average(const Image& fine, int n);

/// What `draw(size)` makes, n x n samples a pixel: drawn n times as large, then averaged.
template <class Draw>
[[nodiscard]] Image averaged(glm::ivec2 size, int n, Draw draw) {
    return box_average(draw(n * size), n);
}

[[nodiscard]] Image crop(const Image& image, int x, int y, int width, int height);
void paste(Image& onto, const Image& image, int x, int y);

/// Room for one of columns x rows panels on a picture of that size, with a thin gap between them.
[[nodiscard]] glm::ivec2 panel_size(int width, int height, int columns, int rows);

/// Where panel `index` of `count`, of this size, comes to lie in a montage: in the middle of its cell.
[[nodiscard]] glm::ivec2 panel_corner(int width, int height, int columns, int index, std::size_t count,
                                      glm::ivec2 panel);

/// Panels side by side, row by row, each in the middle of its cell.
[[nodiscard]] Image montage(int width, int height, int columns, const std::vector<Image>& panels,
                            const glm::vec3& division = kSlate);

}  // namespace kreda::tools
