// 10_triangle: which pixels does a triangle cover? Three edge functions and a rule for ties.
// Page docs/10_triangle.md | After - | New: edge_function(), is_top_left(), covers_sample()
// Break at: covers_sample | Look at: p_x, p_y, least_ab, inside_ab | Try: move kCorner by 0.25, swap two corners
#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "raster/rasterize_reference.hpp"

using namespace kreda;
using namespace kreda::examples;
using raster::ScreenVertex;
using Triangle = std::array<ScreenVertex, 3>;

namespace {

/// A screen vertex from a position in pixels, y down. The rasterizer knows multiples of 1/256 pixel only.
constexpr ScreenVertex vertex(double x, double y) {
    return {static_cast<int>(x * raster::kSubpixels), static_cast<int>(y * raster::kSubpixels), 0.5f, 1.0f};
}

constexpr int kColumns = 16, kRows = 9;
constexpr Triangle kCorner = {vertex(1.25, 7.75), vertex(5.25, 0.75), vertex(14.5, 6.0)};

std::int64_t edge_at_centre(const ScreenVertex& a, const ScreenVertex& b, int x, int y) {
    return raster::edge_function(a.x, a.y, b.x, b.y, raster::centre_of(x), raster::centre_of(y));
}

glm::vec2 on_picture(const ScreenVertex& corner, int cell) {
    return glm::vec2(corner.x, corner.y) * (float(cell) / raster::kSubpixels);
}

void draw_outline(Image& image, const Triangle& triangle, int cell) {
    const glm::vec2 corner[3] = {on_picture(triangle[0], cell), on_picture(triangle[1], cell),
                                 on_picture(triangle[2], cell)};
    draw_triangle_outline(image, corner, 0.07f * float(cell), kChalk);
    for (const glm::vec2& place : corner) draw_disc(image, place, 0.13f * float(cell), kYellow);
}

/// The corner's name to the lower right of it; that of a, in the lower left of the picture, to its left.
Label name_of(const ScreenVertex& corner, int cell, char name, int picture_height) {
    const float size = std::max(0.6f * float(cell), caption_size(picture_height));
    const std::string symbol = {'$', name, '$'};
    const glm::vec2 away = name == 'a' ? glm::vec2(-0.85f, -0.5f) : glm::vec2(0.2f, 0.8f);
    return {on_picture(corner, cell) + size * away, symbol, kYellow, size};
}

/// A pixel is covered if its centre lies on the inner side of all three edges.
void draw_coverage(const Options& options) {
    raster::VertexStreams streams;
    streams.screen.assign(kCorner.begin(), kCorner.end());
    raster::VisibilityBuffer buffer(kColumns, kRows);
    rasterize_triangle(streams, {{0, 1, 2}}, 0, buffer);
    Image pixels = make_board(kColumns, kRows);
    for (int i = 0; i < kColumns * kRows; ++i) {
        if (buffer.triangle[i] != raster::kNoTriangle) pixels.set_rgb(i % kColumns, i / kColumns, 0.5f * kBlue);
    }
    const int cell = options.width / kColumns;
    Panel panel(enlarge_with_grid(pixels, cell));
    draw_outline(panel.image, kCorner, cell);
    for (int i = 0; i < 3; ++i) panel.labels.push_back(name_of(kCorner[i], cell, "abc"[i], options.height));
    panel.is_drawing = true;
    save_panel(options, "coverage", panel);
}

/// The sign of an edge function says on which side of the edge a point lies; E / area2 is a barycentric coordinate.
void draw_edge_functions(const Options& options) {
    const char* const captions[4] = {"$E_{ab}$", "$E_{bc}$", "$E_{ca}$", "all three > 0"};
    const auto [a, b, c] = kCorner;
    const auto area2 = static_cast<float>(raster::edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    std::vector<Panel> panels(4, make_board(kColumns, kRows));
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            const glm::vec3 weight =
                glm::vec3(edge_at_centre(a, b, x, y), edge_at_centre(b, c, x, y), edge_at_centre(c, a, x, y)) / area2;
            for (int i = 0; i < 3; ++i) panels[i].image.set_rgb(x, y, signed_color(weight[i]));
            const bool inside = weight.x > 0.0f && weight.y > 0.0f && weight.z > 0.0f;
            if (inside) panels[3].image.set_rgb(x, y, weight.x * kGreen + weight.y * kBlue + weight.z * kOrange);
        }
    }
    const int cell = panel_size(options.width, options.height, 2, 2).x / kColumns;
    for (int i = 0; i < 4; ++i) {
        panels[i] = {enlarge_with_grid(panels[i].image, cell), captions[i]};
        draw_outline(panels[i].image, kCorner, cell);
        for (int k = 0; k < 3; ++k) { panels[i].labels.push_back(name_of(kCorner[k], cell, "abc"[k], options.height)); }
    }
    save_panels(options, "edge_functions", 2, as_drawings(std::move(panels)));
}

/// Who owns a pixel centre that lies exactly on an edge?
enum class TieRule { nobody, everybody, top_left };

bool covers(const Triangle& triangle, TieRule rule, int x, int y) {
    for (int i = 0; i < 3; ++i) {
        const auto& [a, b] = std::pair(triangle[i], triangle[(i + 1) % 3]);
        const bool top_left = rule == TieRule::top_left && raster::is_top_left(b.x - a.x, b.y - a.y);
        const std::int64_t least = rule == TieRule::everybody || top_left ? 0 : 1;
        if (edge_at_centre(a, b, x, y) < least) return false;
    }
    return true;
}

/// Two triangles share a diagonal that runs exactly through pixel centres: how often is each pixel drawn?
Panel draw_rule(TieRule rule, const char* caption, glm::ivec2 size, int picture_height) {
    constexpr ScreenVertex p = vertex(1.5, 1.5), q = vertex(6.5, 1.5), r = vertex(6.5, 6.5), s = vertex(1.5, 6.5);
    const glm::vec3 color_of_count[3] = {kBoard, 0.5f * kBlue, kRed};
    Image pixels = make_board(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            pixels.set_rgb(x, y, color_of_count[covers({p, q, r}, rule, x, y) + covers({p, r, s}, rule, x, y)]);
        }
    }
    const int cell = size.x / 8;
    Image large = enlarge_with_grid(pixels, cell);
    draw_outline(large, {p, q, r}, cell);
    draw_outline(large, {p, r, s}, cell);
    const glm::ivec2 corner((size.x - large.width) / 2, (size.y - large.height) / 2);
    Panel panel(make_board(size.x, size.y), caption);
    paste(panel.image, large, corner.x, corner.y);
    for (const auto& [vertex, name] : {std::pair(p, 'p'), std::pair(q, 'q'), std::pair(r, 'r'), std::pair(s, 's')}) {
        panel.labels.push_back(name_of(vertex, cell, name, picture_height));
        panel.labels.back().start += glm::vec2(corner);
    }
    return panel;
}

void draw(const Options& options) {
    draw_coverage(options);
    draw_edge_functions(options);
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 1);
    save_panels(options, "top_left_rule", 3,
                as_drawings({draw_rule(TieRule::nobody, "$E$ > 0: gaps", size, options.height),
                             draw_rule(TieRule::everybody, "$E$ ≥ 0: twice", size, options.height),
                             draw_rule(TieRule::top_left, "top-left: once", size, options.height)}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "10_triangle", draw);
}
