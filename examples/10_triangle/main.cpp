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
    return raster::edge_function(a.x, a.y, b.x, b.y, x * raster::kSubpixels + raster::kPixelCentre,
                                 y * raster::kSubpixels + raster::kPixelCentre);
}

void draw_outline(Image& image, const Triangle& triangle, int cell, const char* names) {
    glm::vec2 corner[3];
    for (int i = 0; i < 3; ++i)
        corner[i] = glm::vec2(triangle[i].x, triangle[i].y) * (float(cell) / raster::kSubpixels);
    draw_triangle_outline(image, corner, 0.07f * float(cell), kChalk);
    for (int i = 0; i < 3; ++i) {
        draw_disc(image, corner[i], 0.13f * float(cell), kYellow);
        draw_text(image, int(corner[i].x) + cell / 4, int(corner[i].y) + cell / 4, std::string(1, names[i]), kYellow,
                  std::max(cell / 20, 1));
    }
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
    Image picture = enlarge_with_grid(pixels, cell);
    draw_outline(picture, kCorner, cell, "abc");
    save(options, "coverage", picture);
}

/// The sign of an edge function says on which side of the edge a point lies; E / area2 is a barycentric coordinate.
void draw_edge_functions(const Options& options) {
    const char* const captions[4] = {"E_ab", "E_bc", "E_ca", "all three > 0"};
    const auto [a, b, c] = kCorner;
    const auto area2 = static_cast<float>(raster::edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    std::vector<Image> panels(4, make_board(kColumns, kRows));
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            const glm::vec3 weight =
                glm::vec3(edge_at_centre(a, b, x, y), edge_at_centre(b, c, x, y), edge_at_centre(c, a, x, y)) / area2;
            for (int i = 0; i < 3; ++i) panels[i].set_rgb(x, y, signed_color(weight[i]));
            const bool inside = weight.x > 0.0f && weight.y > 0.0f && weight.z > 0.0f;
            if (inside) panels[3].set_rgb(x, y, weight.x * kGreen + weight.y * kBlue + weight.z * kOrange);
        }
    }
    const int cell = panel_size(options.width, options.height, 2, 2).x / kColumns;
    for (int i = 0; i < 4; ++i) {
        panels[i] = enlarge_with_grid(panels[i], cell);
        draw_outline(panels[i], kCorner, cell, "abc");
        draw_caption(panels[i], captions[i], text_scale(options.height));
    }
    save(options, "edge_functions", montage(options.width, options.height, 2, panels));
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
Image draw_rule(TieRule rule, const char* caption, glm::ivec2 size) {
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
    draw_outline(large, {p, q, r}, cell, "pqr");
    draw_outline(large, {p, r, s}, cell, "prs");
    Image panel = make_board(size.x, size.y);
    paste(panel, large, (size.x - large.width) / 2, (size.y - large.height) / 2);
    draw_caption(panel, caption, size.x / 104);
    return panel;
}

void draw(const Options& options) {
    draw_coverage(options);
    draw_edge_functions(options);
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 1);
    save(options, "top_left_rule",
         montage(options.width, options.height, 3,
                 {draw_rule(TieRule::nobody, "E > 0: gaps", size), draw_rule(TieRule::everybody, "E >= 0: twice", size),
                  draw_rule(TieRule::top_left, "top-left: once", size)}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "10_triangle", draw);
}
