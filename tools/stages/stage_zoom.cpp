// A few pixels of the picture drawn large: what the rasterizer decided, and why.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "raster/film.hpp"
#include "raster/rasterize_tile.hpp"
#include "scene/render/render.hpp"
#include "tools/draw/draw.hpp"
#include "tools/stages/stage.hpp"

namespace kreda::tools {

namespace {

using raster::Image;
using raster::ScreenTriangle;
using raster::ScreenVertex;
using scene::Frame;

/// With more triangles than this only those that are seen are outlined.
constexpr std::size_t kMaxOutlined = 60;

/// The part of the sample grid that is drawn, and how large.
struct Lens {
    const Frame& frame;
    PixelRectangle part;
    float cell;  ///< side of a pixel of the scene, in pixels of the zoomed picture

    /// From 1/256 of a sample to the zoomed picture.
    [[nodiscard]] glm::vec2 place(glm::vec2 snapped) const {
        const glm::vec2 pixel = snapped / static_cast<float>(raster::kSubpixels * frame.plan.samples);
        return (pixel - glm::vec2(part.x, part.y)) * cell;
    }
    [[nodiscard]] glm::vec2 place(const ScreenVertex& v) const {
        return place(glm::vec2(v.x, v.y));
    }
    [[nodiscard]] bool shows(glm::vec2 at) const {
        return at.x >= 0.0f && at.y >= 0.0f && at.x <= cell * static_cast<float>(part.width) &&
               at.y <= cell * static_cast<float>(part.height);
    }
};

/// Visibility of the samples of the part, row by row.
struct SeenSamples {
    int width = 0, height = 0;  ///< samples
    std::vector<std::uint32_t> triangle;
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return triangle[static_cast<std::size_t>(y * width + x)];
    }
};
SeenSamples seen_samples(const Lens& lens) {
    const int n = lens.frame.plan.samples;
    const raster::VisibilityBuffer all =
        rasterize_tiled(lens.frame.buffers.streams, lens.frame.buffers.triangles, lens.frame.plan.viewport);
    SeenSamples seen{lens.part.width * n, lens.part.height * n, {}};
    for (int y = 0; y < seen.height; ++y) {
        const std::size_t row =
            static_cast<std::size_t>(lens.part.y * n + y) * all.width + std::size_t(lens.part.x) * n;
        seen.triangle.insert(seen.triangle.end(), &all.triangle[row], &all.triangle[row] + seen.width);
    }
    return seen;
}

std::vector<ScreenTriangle> triangles_in(const Lens& lens, const SeenSamples& seen) {
    std::vector<ScreenTriangle> touching;
    const int scale = raster::kSubpixels * lens.frame.plan.samples;
    for (const raster::TriangleChunk& chunk : lens.frame.buffers.triangles.chunks) {
        for (const ScreenTriangle& t : chunk.triangles) {
            const auto& screen = lens.frame.buffers.streams.screen;
            const ScreenVertex &a = screen[t.vertex[0]], &b = screen[t.vertex[1]], &c = screen[t.vertex[2]];
            const bool outside = std::max({a.x, b.x, c.x}) < lens.part.x * scale ||
                                 std::min({a.x, b.x, c.x}) > (lens.part.x + lens.part.width) * scale ||
                                 std::max({a.y, b.y, c.y}) < lens.part.y * scale ||
                                 std::min({a.y, b.y, c.y}) > (lens.part.y + lens.part.height) * scale;
            if (!outside) touching.push_back(t);
        }
    }
    if (touching.size() <= kMaxOutlined) return touching;
    std::set<std::uint32_t> ids(seen.triangle.begin(), seen.triangle.end());
    ids.erase(raster::kNoTriangle);
    std::vector<ScreenTriangle> visible;
    for (const std::uint32_t id : ids) visible.push_back(lens.frame.buffers.triangles.triangle(id));
    return visible;
}

/// Each edge a little inside its triangle, so that both owners of a shared edge show: top and left edges own what lies
/// on them.
void draw_edges(const Lens& lens, const ScreenTriangle& triangle, Image& image) {
    const auto& screen = lens.frame.buffers.streams.screen;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenVertex& a = screen[triangle.vertex[i]];
        const ScreenVertex& b = screen[triangle.vertex[(i + 1) % 3]];
        const bool top_left = raster::is_top_left(b.x - a.x, b.y - a.y);
        const glm::vec2 from = lens.place(a), to = lens.place(b);
        const glm::vec2 along = to - from;
        const float length = std::sqrt(along.x * along.x + along.y * along.y);
        const glm::vec2 inward = glm::vec2(-along.y, along.x) * (2.0f / std::max(length, 1e-6f));
        draw_line(image, from + inward, to + inward, top_left ? 3.0f : 1.5f, top_left ? kOrange : kChalk);
    }
}

/// "12 + 78/256": a snapped coordinate in samples.
std::string snapped_text(std::int32_t value) {
    const std::int32_t whole = value >> raster::kSubpixelBits;
    return std::to_string(whole) + " + " + std::to_string(value - whole * raster::kSubpixels) + "/256";
}

/// Where text stands already: what would lie over it is left out.
class FreeRoom {
public:
    [[nodiscard]] bool take(glm::vec2 corner, glm::vec2 size) {
        for (const auto& [other, its_size] : taken_) {
            const bool apart = corner.x > other.x + its_size.x || other.x > corner.x + size.x ||
                               corner.y > other.y + its_size.y || other.y > corner.y + size.y;
            if (!apart) return false;
        }
        taken_.emplace_back(corner, size);
        return true;
    }

private:
    std::vector<std::pair<glm::vec2, glm::vec2>> taken_;
};

/// x above, y below, to the right of the vertex, or to its left where the picture ends.
void name_vertex(const Lens& lens, std::int32_t x, std::int32_t y, FreeRoom& room, Image& image) {
    const float letters = std::clamp(lens.cell / 45.0f, 1.6f, 3.0f);
    const std::string lines[2] = {snapped_text(x), snapped_text(y)};
    const glm::vec2 size(text_width(lines[0].size() > lines[1].size() ? lines[0] : lines[1], letters), 20.0f * letters);
    const glm::vec2 at = lens.place(glm::vec2(x, y));
    const bool fits = at.x + 12.0f + size.x < static_cast<float>(image.width);
    const glm::vec2 corner(fits ? at.x + 12.0f : at.x - 12.0f - size.x,
                           std::clamp(at.y - 0.5f * size.y, 0.0f, static_cast<float>(image.height) - size.y));
    if (!room.take(corner, size)) return;
    fill_rectangle(image, static_cast<int>(corner.x) - 4, static_cast<int>(corner.y) - 4, static_cast<int>(size.x) + 8,
                   static_cast<int>(size.y) + 6, kBoard);
    draw_text(image, corner, lines[0], kYellow, letters);
    draw_text(image, corner + glm::vec2(0.0f, 11.0f * letters), lines[1], kYellow, letters);
}

void draw_vertices(const Lens& lens, const std::vector<ScreenTriangle>& triangles, Image& image) {
    std::set<std::pair<std::int32_t, std::int32_t>> inside;
    for (const ScreenTriangle& t : triangles) {
        for (const std::uint32_t v : t.vertex) {
            const ScreenVertex& vertex = lens.frame.buffers.streams.screen[v];
            if (lens.shows(lens.place(vertex))) inside.insert({vertex.x, vertex.y});
        }
    }
    FreeRoom room;
    for (const auto& [x, y] : inside) {
        draw_disc(image, lens.place(glm::vec2(x, y)), std::clamp(lens.cell / 18.0f, 3.0f, 8.0f), kYellow);
        name_vertex(lens, x, y, room, image);
    }
}

void draw_grid(const Lens& lens, Image& image) {
    for (int x = 1; x < lens.part.width; ++x) {
        fill_rectangle(image, static_cast<int>(static_cast<float>(x) * lens.cell), 0, 1, image.height, kSlate);
    }
    for (int y = 1; y < lens.part.height; ++y) {
        fill_rectangle(image, 0, static_cast<int>(static_cast<float>(y) * lens.cell), image.width, 1, kSlate);
    }
}

void draw_centres(const Lens& lens, const SeenSamples& seen, Image& image) {
    const float side = lens.cell / static_cast<float>(lens.frame.plan.samples);
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) * side;
            const bool covered = seen.at(x, y) != raster::kNoTriangle;
            draw_disc(image, at, std::clamp(0.07f * side, 1.5f, 7.0f), kBoard);
            draw_disc(image, at, std::clamp(0.05f * side, 1.0f, 5.0f), covered ? kChalk : kDust);
        }
    }
}

/// One picture: each sample's square in a colour, the geometry over it.
template <class ColorOfSample>
Stage zoomed(const Lens& lens, const SeenSamples& seen, const std::vector<ScreenTriangle>& triangles, const char* name,
             const char* title, const char* meaning, ColorOfSample color) {
    const int cell = static_cast<int>(lens.cell);
    Image image = make_board(lens.part.width * cell, lens.part.height * cell);
    const float side = lens.cell / static_cast<float>(lens.frame.plan.samples);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const int i = std::min(static_cast<int>((static_cast<float>(x) + 0.5f) / side), seen.width - 1);
            const int j = std::min(static_cast<int>((static_cast<float>(y) + 0.5f) / side), seen.height - 1);
            image.set_rgb(x, y, color(i, j));
        }
    }
    draw_grid(lens, image);
    for (const ScreenTriangle& t : triangles) draw_edges(lens, t, image);
    draw_centres(lens, seen, image);
    draw_vertices(lens, triangles, image);
    char where[96];
    std::snprintf(where, sizeof where, "pixels %d,%d to %d,%d. ", lens.part.x, lens.part.y,
                  lens.part.x + lens.part.width - 1, lens.part.y + lens.part.height - 1);
    return {name,
            title,
            where + std::string(meaning),
            "orange: top and left edges, a centre on them is inside; white: the others",
            develop(image, {}),
            {},
            {}};
}

std::vector<Stage> zoom_in(const Frame& frame, const PixelRectangle& part, int width, int height) {
    const float cell = std::floor(std::min(static_cast<float>(width) / static_cast<float>(part.width),
                                           static_cast<float>(height) / static_cast<float>(part.height)));
    const Lens lens{frame, part, std::max(cell, 4.0f)};
    const SeenSamples seen = seen_samples(lens);
    const std::vector<ScreenTriangle> triangles = triangles_in(lens, seen);
    const scene::ImageSettings& i = frame.scene.image;
    const Image shown = develop(frame.buffers.film, {i.exposure, i.tone_map, i.white, i.transfer, i.gamma});
    std::vector<Stage> stages;
    stages.push_back(
        zoomed(lens, seen, triangles, "zoom_coverage", "which centres are inside", "Blue: covered.",
               [&](int x, int y) { return seen.at(x, y) == raster::kNoTriangle ? kBoard : 0.5f * kBlue; }));
    stages.push_back(zoomed(
        lens, seen, triangles, "zoom_triangles", "which triangle is seen", "A colour a triangle.", [&](int x, int y) {
            const std::uint32_t id = seen.at(x, y);
            return id == raster::kNoTriangle ? kBoard
                                             : 0.6f * color_of_number(frame.buffers.triangles.triangle(id).source);
        }));
    stages.push_back(zoomed(
        lens, seen, triangles, "zoom_final", "what the pixels show", "The colours of the picture.", [&](int x, int y) {
            const glm::vec3 c = shown.rgb(part.x + x / frame.plan.samples, part.y + y / frame.plan.samples);
            return glm::vec3(raster::linear_from_srgb(c.x), raster::linear_from_srgb(c.y),
                             raster::linear_from_srgb(c.z));
        }));
    return stages;
}

}  // namespace

std::vector<Stage> zoom_stages(const scene::Scene& scene, const PixelRectangle& part, int width, int height,
                               int threads) {
    scene::RenderBuffers buffers;
    std::vector<Stage> stages;
    render(scene, make_plan(scene), buffers, threads,
           [&](const Frame& frame) { stages = zoom_in(frame, part, width, height); });
    return stages;
}

}  // namespace kreda::tools
