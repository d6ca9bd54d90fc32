// Stages up to the pixel: wireframe, coverage, overdraw, triangle numbers, barycentric coordinates.
#include <algorithm>
#include <array>
#include <cmath>

#include "raster/film.hpp"
#include "raster/fragment_loop.hpp"
#include "raster/overdraw.hpp"
#include "scene/render/render.hpp"
#include "tools/draw/draw.hpp"
#include "tools/explain/probe.hpp"
#include "tools/stages/stage.hpp"

namespace kreda::tools {

namespace {

using raster::Image;
using raster::ScreenTriangle;
using scene::Frame;

/// More vertices than this would cover the picture.
constexpr std::size_t kMaxDots = 20000;

/// Where a vertex lies in the picture, in pixels.
glm::vec2 place_of(const Frame& frame, std::uint32_t vertex) {
    const raster::ScreenVertex& v = frame.buffers.streams.screen[vertex];
    return glm::vec2(v.x, v.y) / static_cast<float>(raster::kSubpixels * frame.plan.samples);
}

template <class Visit>
void for_each_triangle(const Frame& frame, Visit visit) {
    for (const raster::TriangleChunk& chunk : frame.buffers.triangles.chunks) {
        for (const ScreenTriangle& triangle : chunk.triangles) visit(triangle);
    }
}

std::size_t triangle_count(const Frame& frame) {
    std::size_t count = 0;
    for (const raster::TriangleChunk& chunk : frame.buffers.triangles.chunks) count += chunk.triangles.size();
    return count;
}

/// Vertices of the meshes come first; those that the clipper made are behind them.
std::uint32_t mesh_vertex_count(const Frame& frame) {
    std::uint32_t count = 0;
    for (const raster::MeshInstance& instance : frame.buffers.instances) {
        count += static_cast<std::uint32_t>(instance.mesh->positions.size());
    }
    return count;
}

Image board(const Frame& frame) {
    return make_board(frame.scene.image.width, frame.scene.image.height);
}

Stage stage_of(std::string name, std::string title, std::string meaning, const Image& linear) {
    return {std::move(name), std::move(title), std::move(meaning), "", develop(linear, {}), {}, {}};
}

Stage wireframe(const Frame& frame) {
    Image image = board(frame);
    const std::uint32_t from_meshes = mesh_vertex_count(frame);
    bool any_clipped = false;
    for_each_triangle(frame, [&](const ScreenTriangle& t) {
        const bool clipped = t.vertex[0] >= from_meshes;
        any_clipped |= clipped;
        const glm::vec2 corner[3] = {place_of(frame, t.vertex[0]), place_of(frame, t.vertex[1]),
                                     place_of(frame, t.vertex[2])};
        draw_triangle_outline(image, corner, 1.0f, clipped ? kOrange : kChalk);
    });
    Stage stage =
        stage_of("wireframe", "wireframe", "the triangles that reached the screen, culled and clipped", image);
    if (any_clipped) stage.legend = "orange: pieces that the clipper made";
    return stage;
}

/// Pixel values that are means over the pixel's samples of a number known at every sample.
template <class AtSample>
Image mean_over_samples(const Frame& frame, AtSample at_sample) {
    const int n = frame.plan.samples;
    Image mean = raster::make_image(frame.scene.image.width, frame.scene.image.height, 1);
    for (int y = 0; y < mean.height * n; ++y) {
        for (int x = 0; x < mean.width * n; ++x) {
            mean.at(0, x / n, y / n) +=
                at_sample(static_cast<std::size_t>(y) * mean.width * n + x) / static_cast<float>(n * n);
        }
    }
    return mean;
}

Stage coverage(const Frame& frame, const std::vector<std::uint32_t>& overdraw) {
    const Image share = mean_over_samples(frame, [&](std::size_t i) { return overdraw[i] > 0 ? 1.0f : 0.0f; });
    Image image = board(frame);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float s = share.at(0, x, y);
            image.set_rgb(x, y, (1.0f - s) * kBoard + s * 0.5f * kBlue);
        }
    }
    const bool with_vertices = 3 * triangle_count(frame) <= kMaxDots;
    if (with_vertices) {
        for_each_triangle(frame, [&](const ScreenTriangle& t) {
            for (const std::uint32_t v : t.vertex) draw_disc(image, place_of(frame, v), 1.2f, kYellow);
        });
    }
    Stage stage = stage_of("coverage", "coverage", "pixels whose sample centres lie in a triangle", image);
    stage.legend = with_vertices ? "blue: covered; yellow: vertices" : "blue: covered";
    stage.values = share;
    stage.components = {"covered"};
    return stage;
}

/// 0 board, then blue, green, yellow, orange, red for 5 and more.
glm::vec3 heat(float count) {
    const std::array<glm::vec3, 6> ramp = {kBoard, 0.6f * kBlue, kGreen, kYellow, kOrange, kRed};
    const float at = std::clamp(count, 0.0f, 5.0f);
    const auto below = static_cast<std::size_t>(std::min(at, 4.0f));
    const float t = at - static_cast<float>(below);
    return (1.0f - t) * ramp[below] + t * ramp[below + 1];
}

Stage overdraw_stage(const Frame& frame, const std::vector<std::uint32_t>& overdraw) {
    Image counts = mean_over_samples(frame, [&](std::size_t i) { return static_cast<float>(overdraw[i]); });
    Image image = board(frame);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) image.set_rgb(x, y, heat(counts.at(0, x, y)));
    }
    Stage stage = stage_of("overdraw", "overdraw", "how many triangles lie over a sample, whatever their depth", image);
    stage.legend = "blue 1, green 2, yellow 3, orange 4, red 5 and more";
    stage.values = std::move(counts);
    stage.components = {"triangles"};
    return stage;
}

/// The frame's triangles, each with three corners of its own that carry the numbers (1,0,0), (0,1,0), (0,0,1).
struct UnsharedTriangles {
    raster::VertexStreams streams;
    raster::TriangleSet triangles;
};
UnsharedTriangles unshare(const Frame& frame) {
    UnsharedTriangles own{{}, frame.buffers.triangles};
    for (raster::TriangleChunk& chunk : own.triangles.chunks) {
        for (ScreenTriangle& triangle : chunk.triangles) {
            for (int i = 0; i < 3; ++i) {
                glm::vec3 weight(0.0f);
                weight[i] = 1.0f;
                own.streams.color.push_back(weight);
                own.streams.screen.push_back(
                    frame.buffers.streams.screen[triangle.vertex[static_cast<std::size_t>(i)]]);
                triangle.vertex[static_cast<std::size_t>(i)] =
                    static_cast<std::uint32_t>(own.streams.screen.size() - 1);
            }
        }
    }
    return own;
}

Stage barycentrics(const Frame& frame) {
    const UnsharedTriangles own = unshare(frame);
    const int n = frame.plan.samples;
    Image b = raster::make_image(frame.scene.image.width, frame.scene.image.height, 3);
    for_each_fragment(own.streams, own.triangles, frame.plan.viewport, {.color = true}, frame.plan.interpolation,
                      [&](int x, int y, const raster::Fragments& f, int i) {
                          b.set_rgb(x / n, y / n, b.rgb(x / n, y / n) + f.color.at(i) / static_cast<float>(n * n));
                      });
    const bool affine = frame.plan.interpolation == raster::AttributeInterpolation::affine;
    return {
        "barycentrics",
        "barycentric coordinates",
        std::string("weights of the corners a, b, c as red, green and blue, ") + (affine ? "affine" : "in perspective"),
        "",
        develop(b, {}),
        b,
        {"b_a", "b_b", "b_c"}};
}

/// Numbers of the triangle and the object that the pixel's first sample shows.
Stage triangle_numbers(const Frame& frame) {
    const int n = frame.plan.samples;
    const scene::ImageSettings& size = frame.scene.image;
    const raster::VisibilityBuffer seen =
        rasterize_tiled(frame.buffers.streams, frame.buffers.triangles, frame.plan.viewport);
    Image numbers = raster::make_image(size.width, size.height, 2);
    std::fill(numbers.values.begin(), numbers.values.end(), -1.0f);
    Image image = board(frame);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t id =
                seen.triangle[static_cast<std::size_t>(y) * n * size.width * n + std::size_t(x) * n];
            if (id == raster::kNoTriangle) continue;
            const std::uint32_t number = frame.buffers.triangles.triangle(id).source;
            const SourceTriangle source = find_source(frame.buffers.instances, number);
            image.set_rgb(x, y, color_of_number(number));
            numbers.at(0, x, y) = static_cast<float>(source.object);
            numbers.at(1, x, y) = static_cast<float>(source.triangle);
        }
    }
    return {"triangles",
            "triangle numbers",
            "which triangle is seen: the visibility buffer, a colour a triangle",
            "",
            develop(image, {}),
            numbers,
            {"object", "triangle"}};
}

}  // namespace

glm::vec3 color_of_number(std::uint32_t number) {
    std::uint32_t h = number * 2654435761u;
    h ^= h >> 15;
    const auto share = [](std::uint32_t bits) { return 0.15f + 0.75f * static_cast<float>(bits & 255u) / 255.0f; };
    return {share(h), share(h >> 8), share(h >> 16)};
}

void visit_geometry_stages(const Frame& frame, const StageVisitor& visit) {
    if (frame.scene.objects.empty()) return;
    const std::vector<std::uint32_t> overdraw =
        count_overdraw(frame.buffers.streams, frame.buffers.triangles, frame.plan.viewport);
    visit(wireframe(frame));
    visit(coverage(frame, overdraw));
    visit(overdraw_stage(frame, overdraw));
    visit(triangle_numbers(frame));
    visit(barycentrics(frame));
}

}  // namespace kreda::tools
