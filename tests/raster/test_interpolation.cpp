// Attributes across a triangle: perspective against long double for any ratio of w, affine as predicted, runs and
// batches.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "raster/fragments.hpp"
#include "raster/rasterize_tile.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

/// A corner by its place on the screen, in samples, and its w.
struct Corner {
    glm::vec2 screen;
    float w;
};

/// One triangle with w from `corner`, and u = 1 at the first corner, v = 1 at the second, both 0 at the third.
Drawing perspective_triangle(const Viewport& viewport, const Corner (&corner)[3]) {
    Drawing drawing;
    drawing.viewport = viewport;
    drawing.clip_from_world = clip_from_pixels(viewport, 0.5f, 4e6f);
    for (const Corner& c : corner) drawing.mesh.positions.push_back({c.screen * c.w, c.w});
    drawing.mesh.indices = {0, 1, 2};
    drawing.mesh.uvs = {{1, 0}, {0, 1}, {0, 0}};
    finish(drawing.mesh);
    return drawing;
}

/// Calls visit(x, y, fragments, lane) for every covered sample, with u, v (and color, where the streams have it).
template <class Visit>
void for_each_fragment(const Drawing& drawing, const Drawn& drawn, const FragmentNeeds& needs,
                       AttributeInterpolation interpolation, Visit&& visit) {
    const auto tile = std::make_unique<TileVisibility>();
    const auto fragments = std::make_unique<Fragments>();
    std::vector<Run> runs(kTileSide * kTileSide);
    const TileGrid& grid = drawn.set.grid;
    for (int t = 0; t < grid.columns * grid.rows; ++t) {
        const TileArea area = tile_area(grid, drawing.viewport, t);
        rasterize_tile(drawn.streams, drawn.set, area, *tile);
        const int run_count = collect_runs(*tile, area, drawn.set, runs.data());
        for (int r = 0; r < run_count; ++r) {
            interpolate_runs(drawn.streams, drawn.set, area, &runs[static_cast<std::size_t>(r)], 1, needs,
                             interpolation, *fragments);
            const Run& run = runs[static_cast<std::size_t>(r)];
            REQUIRE(fragments->count == run.count);
            for (int i = 0; i < run.count; ++i) visit(area.x + run.x + i, area.y + run.y, *fragments, i);
        }
    }
}

/// u and v in long double, from the snapped corners (exact integers) and the true w.
struct ExactUv {
    long double u, v;
};

ExactUv exact_uv(const ScreenVertex* s, const Corner (&corner)[3], int x, int y, bool perspective) {
    const std::int64_t p_x = x * kSubpixels + kPixelCentre, p_y = y * kSubpixels + kPixelCentre;
    long double q[3], sum = 0.0L;
    for (int i = 0; i < 3; ++i) {
        const ScreenVertex& a = s[(i + 1) % 3];
        const ScreenVertex& b = s[(i + 2) % 3];
        q[i] =
            static_cast<long double>(edge_function(a.x, a.y, b.x, b.y, p_x, p_y)) / (perspective ? corner[i].w : 1.0f);
        sum += q[i];
    }
    return {q[0] / sum, q[1] / sum};
}

struct Errors {
    double worst = 0.0;
    int samples = 0;
};

Errors uv_errors(const Viewport& viewport, const Corner (&corner)[3], AttributeInterpolation interpolation) {
    const Drawing drawing = perspective_triangle(viewport, corner);
    VertexNeeds needs;
    needs.uv = true;
    const Drawn drawn = set_up(drawing, needs);
    REQUIRE(drawn.counts.clipped == 0);
    FragmentNeeds wanted;
    wanted.uv = true;
    Errors errors;
    const bool perspective = interpolation == AttributeInterpolation::perspective;
    for_each_fragment(drawing, drawn, wanted, interpolation, [&](int x, int y, const Fragments& f, int i) {
        const ExactUv exact = exact_uv(drawn.streams.screen.data(), corner, x, y, perspective);
        errors.worst = std::max({errors.worst, static_cast<double>(std::abs(f.u.at(i) - exact.u)),
                                 static_cast<double>(std::abs(f.v.at(i) - exact.v))});
        ++errors.samples;
    });
    return errors;
}

}  // namespace

TEST_CASE("Perspective interpolation is within 5e-7 of long double for w ratios from 1 to a million") {
    const Viewport viewport{1920, 1080};
    for (const float ratio : {1.0f, 10.0f, 100.0f, 1e4f, 1e6f}) {
        Random random(9);
        for (int i = 0; i < 3; ++i) {
            CAPTURE(ratio);
            const auto place = [&] {
                const float x = random.real(0, 1920), y = random.real(0, 1080);
                return glm::vec2(x, y);
            };
            const Corner corner[3] = {{place(), 1.0f}, {place(), ratio}, {place(), std::sqrt(ratio)}};
            const Errors errors = uv_errors(viewport, corner, AttributeInterpolation::perspective);
            CHECK(errors.samples > 1000);
            CHECK(errors.worst <=
                  5e-7);  // 2.3e-7 measured in a prototype: E, 1/w, the sum and the quotient round once each
        }
    }
}

TEST_CASE("Affine interpolation is within 5e-7 of the screen-space weights") {
    const Corner corner[3] = {{{10.25f, 20.5f}, 1.0f}, {{600.75f, 77.0f}, 9.0f}, {{200.0f, 400.0f}, 3.0f}};
    const Errors errors = uv_errors({640, 480}, corner, AttributeInterpolation::affine);
    CHECK(errors.samples > 50000);
    CHECK(errors.worst <= 5e-7);
}

TEST_CASE("Middle of an edge with w 1 and 3: perspective 1/4 and affine 1/2") {
    // u runs from 0 (w = 1) to 1 (w = 3). In the middle of the screen edge: (1/2 * 1/3) / (1/2 * 1/1 + 1/2 * 1/3) =
    // 1/4.
    const Viewport viewport{16, 16};
    const Corner corner[3] = {{{12.5f, 2.5f}, 3.0f}, {{4.5f, 14.5f}, 2.0f}, {{4.5f, 2.5f}, 1.0f}};
    const Drawing drawing = perspective_triangle(viewport, corner);
    VertexNeeds needs;
    needs.uv = true;
    const Drawn drawn = set_up(drawing, needs);
    FragmentNeeds wanted;
    wanted.uv = true;
    int seen = 0;
    for (const auto interpolation : {AttributeInterpolation::perspective, AttributeInterpolation::affine}) {
        const double expected = interpolation == AttributeInterpolation::perspective ? 0.25 : 0.5;
        for_each_fragment(drawing, drawn, wanted, interpolation, [&](int x, int y, const Fragments& f, int i) {
            if (x != 8 || y != 2) return;
            ++seen;
            CHECK(std::abs(f.u.at(i) - expected) < 1.2e-7);
            CHECK(f.v.at(i) == 0.0f);
        });
    }
    CHECK(seen == 2);
}

TEST_CASE("Corner on a pixel centre has that corner's attribute exactly") {
    const Viewport viewport{16, 16};
    const Corner corner[3] = {{{13.5f, 3.5f}, 7.0f}, {{3.5f, 12.5f}, 1e3f}, {{3.5f, 3.5f}, 0.75f}};
    const Drawing drawing = perspective_triangle(viewport, corner);
    VertexNeeds needs;
    needs.uv = true;
    const Drawn drawn = set_up(drawing, needs);
    FragmentNeeds wanted;
    wanted.uv = true;
    int seen = 0;
    for_each_fragment(drawing, drawn, wanted, AttributeInterpolation::perspective,
                      [&](int x, int y, const Fragments& f, int i) {
                          if (x != 3 || y != 3) return;  // the top left corner: the only one that its own rule draws
                          ++seen;
                          CHECK(f.u.at(i) == 0.0f);
                          CHECK(f.v.at(i) == 0.0f);
                      });
    CHECK(seen == 1);
}

TEST_CASE("Constant attribute comes back within its roundings whatever w and others stay in their range") {
    const Viewport viewport{300, 200};
    Random random(10);
    for (int k = 0; k < 40; ++k) {
        const auto place = [&] {
            const float x = random.real(0, 300), y = random.real(0, 200);
            return glm::vec2(x, y);
        };
        const Corner corner[3] = {
            {place(), std::exp2(random.real(0, 20))}, {place(), std::exp2(random.real(0, 20))}, {place(), 1.0f}};
        const Drawing drawing = perspective_triangle(viewport, corner);
        VertexNeeds needs;
        needs.uv = needs.color = needs.fog = true;
        Drawn drawn = set_up(drawing, needs);
        const float constant = random.real(0.5f, 1.0f);
        // Seven roundings at most: the sum of q (2), its inverse, q / sum, the product with a, and the sum (2). Each is
        // 2^-24; nearly always they cancel to one or two.
        const float tolerance = 7 * 0x1p-24f * constant;
        std::fill(drawn.streams.color.begin(), drawn.streams.color.end(), glm::vec3(constant, 0.0f, -constant));
        std::fill(drawn.streams.fog.begin(), drawn.streams.fog.end(), constant);
        FragmentNeeds wanted;
        wanted.uv = wanted.color = wanted.fog = true;
        int wrong = 0;
        for_each_fragment(
            drawing, drawn, wanted, AttributeInterpolation::perspective, [&](int, int, const Fragments& f, int i) {
                const glm::vec3 color = f.color.at(i);
                wrong += std::abs(color.x - constant) <= tolerance && color.y == 0.0f ? 0 : 1;
                wrong += color.z == -color.x && f.fog.at(i) == color.x ? 0 : 1;
                // Weights that should sum to 1 may exceed it by their rounding.
                wrong += f.u.at(i) >= 0.0f && f.v.at(i) >= 0.0f && f.u.at(i) + f.v.at(i) <= 1.0f + 3e-7f ? 0 : 1;
            });
        CHECK(wrong == 0);
    }
}

TEST_CASE("Runs: each covered sample is in exactly one run of its own triangle and batches line up behind each other") {
    const OneThread one_thread;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        const Drawing drawing = random_scene(seed);
        VertexNeeds needs;
        needs.position_world = true;
        const Drawn drawn = set_up(drawing, needs);
        FragmentNeeds wanted;
        wanted.position = true;
        const auto tile = std::make_unique<TileVisibility>();
        const auto alone = std::make_unique<Fragments>(), together = std::make_unique<Fragments>();
        std::vector<Run> runs(kTileSide * kTileSide);
        for (int t = 0; t < drawn.set.grid.columns * drawn.set.grid.rows; ++t) {
            const TileArea area = tile_area(drawn.set.grid, drawing.viewport, t);
            rasterize_tile(drawn.streams, drawn.set, area, *tile);
            std::vector<std::uint32_t> painted(kTileSide * kTileSide, kNoTriangle);
            const int run_count = collect_runs(*tile, area, drawn.set, runs.data());
            int wrong = 0, batch_end = 0, lanes = 0;
            for (int r = 0; r < run_count; ++r) {
                const Run& run = runs[static_cast<std::size_t>(r)];
                if (lanes + run.count <= kBatchCapacity && batch_end == r) lanes += run.count, ++batch_end;
                for (int i = 0; i < run.count; ++i) {
                    std::uint32_t& sample = painted[static_cast<std::size_t>(run.y * kTileSide + run.x + i)];
                    wrong += sample != kNoTriangle ? 1 : 0;
                    sample = run.triangle;
                }
                wrong += run.material != drawn.set.triangle(run.triangle).material ? 1 : 0;
            }
            for (int y = 0; y < area.height; ++y) {
                for (int x = 0; x < area.width; ++x) {
                    const int s = y * kTileSide + x;
                    wrong += painted[static_cast<std::size_t>(s)] != tile->triangle[s] ? 1 : 0;
                }
            }
            interpolate_runs(drawn.streams, drawn.set, area, runs.data(), batch_end, wanted,
                             AttributeInterpolation::perspective, *together);
            REQUIRE(together->count == lanes);
            int first = 0;
            for (int r = 0; r < batch_end; ++r) {
                interpolate_runs(drawn.streams, drawn.set, area, &runs[static_cast<std::size_t>(r)], 1, wanted,
                                 AttributeInterpolation::perspective, *alone);
                for (int i = 0; i < alone->count; ++i)
                    wrong += alone->position.at(i) != together->position.at(first + i) ? 1 : 0;
                first += alone->count;
            }
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("Clipped triangle interpolates as if it had not been clipped") {
    // A floor through the near plane: the world position at each sample is where its ray meets the floor.
    Drawing drawing;
    drawing.viewport = {120, 90};
    Camera camera;
    camera.position = {0.3f, 1.0f, 0.2f};
    camera.target = {0.5f, 0.6f, -1.0f};
    camera.near = 0.25f;
    drawing.clip_from_world = clip_from_world(camera, 120.0f / 90.0f);
    add_triangle(drawing.mesh, {-60, 0, 20}, {60, 0, 20}, {0, 0, -90});
    finish(drawing.mesh);
    VertexNeeds needs;
    needs.position_world = true;
    const Drawn drawn = set_up(drawing, needs);
    REQUIRE(drawn.counts.clipped == 1);
    FragmentNeeds wanted;
    wanted.position = true;
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(drawing.clip_from_world));
    double worst = 0.0;
    int samples = 0;
    for_each_fragment(
        drawing, drawn, wanted, AttributeInterpolation::perspective, [&](int x, int y, const Fragments& f, int i) {
            const glm::dvec4 far_point =
                world_from_clip * glm::dvec4((x + 0.5) / 60.0 - 1.0, 1.0 - (y + 0.5) / 45.0, 0.9, 1.0);
            const glm::dvec3 ray = glm::dvec3(far_point) / far_point.w - glm::dvec3(camera.position);
            const double t = -double{camera.position.y} / ray.y;
            const glm::dvec3 hit = glm::dvec3(camera.position) + t * ray;
            const double distance = glm::length(hit - glm::dvec3(camera.position));
            worst = std::max(worst, glm::length(glm::dvec3(f.position.at(i)) - hit) / (distance * distance));
            ++samples;
        });
    // Corners are moved by up to 1/512 sample of 0.011 radians; on the floor, seen from height 1, that is distance^2
    // times as much, for the edges of three or four corners.
    MESSAGE("largest error / distance^2: " << worst);
    CHECK(samples > 3000);
    CHECK(worst < 4 * 0.011 / 512);
}

namespace {

/// The worst error of the four steps of uv, relative to the larger of 1e-3 and the true step.
Errors step_errors(const Viewport& viewport, const Corner (&corner)[3]) {
    const Drawing drawing = perspective_triangle(viewport, corner);
    VertexNeeds needs;
    needs.uv = true;
    const Drawn drawn = set_up(drawing, needs);
    FragmentNeeds wanted;
    wanted.uv = wanted.uv_steps = true;
    Errors errors;
    const ScreenVertex* s = drawn.streams.screen.data();
    for_each_fragment(
        drawing, drawn, wanted, AttributeInterpolation::perspective, [&](int x, int y, const Fragments& f, int i) {
            const ExactUv here = exact_uv(s, corner, x, y, true);
            const ExactUv right = exact_uv(s, corner, x + 1, y, true);
            const ExactUv below = exact_uv(s, corner, x, y + 1, true);
            const long double exact[4] = {right.u - here.u, right.v - here.v, below.u - here.u, below.v - here.v};
            const float got[4] = {f.du_dx.at(i), f.dv_dx.at(i), f.du_dy.at(i), f.dv_dy.at(i)};
            for (int k = 0; k < 4; ++k) {
                const double scale = std::max(1e-3, static_cast<double>(std::abs(exact[k])));
                const double error = static_cast<double>(std::abs(got[k] - exact[k])) / scale;
                errors.worst = std::max(errors.worst, error);
            }
            ++errors.samples;
        });
    return errors;
}

}  // namespace

TEST_CASE("Steps of uv are what the plane of the triangle has at the neighbour even beyond its edge") {
    Random random(17);
    for (const float ratio : {1.0f, 3.0f, 20.0f}) {
        CAPTURE(ratio);
        for (int i = 0; i < 10; ++i) {
            const auto place = [&] {
                const float x = random.real(0, 320), y = random.real(0, 200);
                return glm::vec2(x, y);
            };
            const Corner corner[3] = {{place(), 1.0f}, {place(), ratio}, {place(), std::sqrt(ratio)}};
            const Errors errors = step_errors({320, 200}, corner);
            // u_i - u loses at most an ulp of 1, 1.2e-7, against steps counted from 1e-3; the quotient rounds like u's.
            CHECK(errors.worst < 5e-4);
        }
    }
}

TEST_CASE("Neighbour beyond the horizon of a plane is finite and very far away") {
    // w grows from 1 to 1e6 downwards over twenty rows: what is below the lowest corner lies behind the eye.
    const Corner corner[3] = {{{5.5f, 10.5f}, 1.0f}, {{60.5f, 10.5f}, 1.0f}, {{30.5f, 30.5f}, 1e6f}};
    const Drawing drawing = perspective_triangle({64, 64}, corner);
    VertexNeeds needs;
    needs.uv = true;
    const Drawn drawn = set_up(drawing, needs);
    FragmentNeeds wanted;
    wanted.uv = wanted.uv_steps = true;
    int seen = 0;
    float farthest = 0.0f;
    for_each_fragment(drawing, drawn, wanted, AttributeInterpolation::perspective,
                      [&](int, int, const Fragments& f, int i) {
                          ++seen;
                          REQUIRE(is_finite(f.du_dx.at(i)));
                          REQUIRE(is_finite(f.dv_dy.at(i)));
                          farthest = std::max(farthest, std::abs(f.du_dy.at(i)));
                      });
    CHECK(seen > 100);
    CHECK(farthest > 1.0f);
}
