#include "tools/explain/explain.hpp"
#include "raster/shading_points.hpp"

#include <algorithm>
#include <optional>

#include "raster/shading_points.hpp"
#include "scene/error.hpp"
#include "scene/render/render.hpp"
#include "scene/render/walk_passes.hpp"

namespace kreda::tools {

namespace {

using scene::Frame;
using scene::RenderPlan;

/// The number of the tile that holds a sample, and with it all samples of its pixel.
int tile_with(const raster::TileGrid& grid, int x, int y) {
    return grid.tile_of(y) * grid.columns + grid.tile_of(x);
}

raster::TileArea area_of_tile(const Frame& frame, int tile) {
    return tile_area(frame.buffers.triangles.grid, frame.plan.viewport, tile);
}

/// The plan of the picture, and every channel that the scene can show.
RenderPlan plan_with_views(const scene::Scene& scene) {
    const RenderPlan plan = make_plan_for(scene, scene::PlanRequest{.prune = false});
    std::vector<const scene::View*> views;
    for (const scene::View& view : scene::all_views()) {
        if (can_show(plan, scene, view)) views.push_back(&view);
    }
    return make_plan(scene, views);
}

void explain_plan(const scene::Scene& scene, Derivation& derivation) {
    Section section{"plan", "the plan: what this scene requires", {}};
    Table table{"passes", {"pass", "reason"}, {}};
    for (const scene::PlannedPass& pass : make_plan(scene).passes) table.rows.push_back({pass.name, pass.reason});
    section.put(table);
    derivation.sections.push_back(section);
}

/// Offsets of a pixel's samples, from the middle outwards.
std::vector<glm::ivec2> samples_from_middle(int n) {
    std::vector<glm::ivec2> offsets;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) offsets.emplace_back(i, j);
    }
    const auto from_middle = [n](glm::ivec2 s) {
        const glm::ivec2 d = 2 * s - (n - 1);
        return d.x * d.x + d.y * d.y;
    };
    std::stable_sort(offsets.begin(), offsets.end(),
                     [&](glm::ivec2 a, glm::ivec2 b) { return from_middle(a) < from_middle(b); });
    return offsets;
}

/// The sample that is told in full: the one that was asked for, else the covered one nearest to the pixel's middle.
glm::ivec2 choose_sample(const PixelRequest& request, int n, const std::vector<SampleFacts>& samples) {
    if (request.sample_x >= 0) return {request.sample_x, request.sample_y};
    const std::vector<glm::ivec2> offsets = samples_from_middle(n);
    const auto covered = std::find_if(offsets.begin(), offsets.end(), [&](glm::ivec2 s) {
        return samples[static_cast<std::size_t>(s.y * n + s.x)].nearest >= 0;
    });
    return covered == offsets.end() ? offsets.front() : *covered;
}

void explain_samples(const PixelRequest& request, int n, const std::vector<SampleFacts>& samples, glm::ivec2 chosen,
                     Derivation& derivation) {
    Section section{
        "samples", "the samples of pixel (" + std::to_string(request.x) + ", " + std::to_string(request.y) + ")", {}};
    Table table{"samples", {"sample", "at", "sees", "radiance"}, {}};
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const SampleFacts& s = samples[static_cast<std::size_t>(j * n + i)];
            const std::string sees =
                s.nearest < 0
                    ? "background"
                    : triangle_text(s.frame, find_source(s.frame.buffers.instances, s.seen().triangle.source));
            const glm::vec2 at = (glm::vec2(s.x, s.y) + 0.5f) / static_cast<float>(n);
            table.rows.push_back(
                {std::to_string(i) + "," + std::to_string(j), vector_text(at), sees, vector_text(s.radiance)});
        }
    }
    section.put(table);
    section.say("What follows is told of sample " + std::to_string(chosen.x) + "," + std::to_string(chosen.y) +
                ", on the grid of samples. --sample I,J asks for another one.");
    derivation.sections.push_back(section);
}

void explain_sample(const SampleFacts& sample, Derivation& derivation) {
    if (sample.nearest < 0) return explain_absence(sample, derivation);
    explain_triangle(sample, derivation);
    explain_coverage(sample, derivation);
    explain_depth(sample, derivation);
    explain_interpolation(sample, derivation);
    explain_shading(sample, derivation);
    explain_fog(sample, derivation);
    explain_channels(sample, derivation);
}

/// By shading.rate, which of the tile's samples are lit in place of which; nullptr: each is lit itself.
std::unique_ptr<raster::ShadingPoints> shading_points_of(const Frame& frame, const raster::TileArea& area) {
    if (frame.plan.shading_rate == 1) return nullptr;
    const auto scratch = std::make_unique<scene::TileScratch>();
    auto points = std::make_unique<raster::ShadingPoints>();
    rasterize_tile(frame.buffers.streams, frame.buffers.triangles, area, scratch->visibility);
    collect_shading_points(scratch->visibility, area, frame.buffers.triangles, frame.plan.shading_rate, scratch->runs,
                           *points);
    return points;
}

/// Where the colour of sample (x, y) comes from.
glm::ivec2 lit_for(const raster::ShadingPoints* points, const raster::TileArea& area, int x, int y) {
    if (!points) return {x, y};
    const int point = points->of[(y - area.y) * raster::kTileSide + x - area.x];
    return {area.x + point % raster::kTileSide, area.y + point / raster::kTileSide};
}

void explain_shading_rate(const scene::RenderPlan& plan, int x, int y, const SampleFacts& lit, Derivation& derivation) {
    if (plan.shading_rate == 1) return;
    const std::string side = std::to_string(plan.shading_rate);
    Section section{"shading_rate", "the point that is lit", {}};
    section.say("shading.rate = " + side + ": of the samples of a triangle in a block of " + side + " x " + side +
                " one is lit. Sample (" + std::to_string(x) + ", " + std::to_string(y) +
                ") of the whole picture has the colour of sample (" + std::to_string(lit.x) + ", " +
                std::to_string(lit.y) + "), which the rest is about.");
    derivation.sections.push_back(section);
}

Explanation explain_in(const Frame& frame, const PixelRequest& request) {
    const int n = frame.plan.samples;
    const raster::TileArea area =
        area_of_tile(frame, tile_with(frame.buffers.triangles.grid, request.x * n, request.y * n));
    const auto points = shading_points_of(frame, area);
    std::vector<SampleFacts> samples;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const glm::ivec2 lit = lit_for(points.get(), area, request.x * n + i, request.y * n + j);
            samples.push_back(look_at_sample(frame, lit.x, lit.y));
        }
    }
    const glm::ivec2 chosen = choose_sample(request, n, samples);
    const SampleFacts& sample = samples[static_cast<std::size_t>(chosen.y * n + chosen.x)];

    Explanation explanation;
    Derivation& derivation = explanation.derivation;
    const std::string& file = frame.scene.file;
    derivation.title = "Pixel (" + std::to_string(request.x) + ", " + std::to_string(request.y) + ") of " +
                       (file.empty() ? "the built-in scene" : file) + ", " + std::to_string(frame.scene.image.width) +
                       " x " + std::to_string(frame.scene.image.height);
    explain_plan(frame.scene, derivation);
    if (n > 1) explain_samples(request, n, samples, chosen, derivation);
    explain_shading_rate(frame.plan, request.x * n + chosen.x, request.y * n + chosen.y, sample, derivation);
    explain_sample(sample, derivation);
    std::vector<glm::vec3> radiance;
    for (const SampleFacts& s : samples) radiance.push_back(s.radiance);
    explain_film(frame.scene.image, radiance, explanation);
    explanation.covered = sample.nearest >= 0;
    return explanation;
}

}  // namespace

SampleFacts look_at_sample(const Frame& frame, int x, int y) {
    SampleFacts sample{frame, x, y, {}, -1, nullptr, frame.scene.image.background};
    if (!frame.buffers.triangles.chunks.empty()) {
        sample.covers = triangles_over(frame.buffers.streams, frame.buffers.triangles, x, y);
    }
    sample.nearest = nearest_of(sample.covers);
    const int tile = tile_with(frame.buffers.triangles.grid, x, y);
    const raster::TileArea area = area_of_tile(frame, tile);
    sample.passes = std::make_unique<scene::TileScratch>();
    fit_scratch(frame.plan, *sample.passes);
    if (sample.nearest < 0) {  // what the tile shows there, whatever the background is
        render_tile(frame, tile, *sample.passes);
        const int place = (y - area.y) * raster::kTileSide + x - area.x;
        for (int c = 0; c < 3; ++c) sample.radiance[c] = sample.passes->color.plane[c][place];
        return sample;
    }
    const raster::Run run{static_cast<std::uint16_t>(x - area.x),
                          static_cast<std::uint16_t>(y - area.y),
                          1,
                          1,
                          sample.seen().triangle.material,
                          sample.seen().id};
    work_batch(frame, area, batch_passes_of(frame.tile_passes), &run, 1, *sample.passes);
    sample.radiance = sample.passes->lighting->radiance.at(0);
    return sample;
}

void check_request(const scene::ImageSettings& image, const PixelRequest& request) {
    const auto inside = [](int value, int size) { return value >= 0 && value < size; };
    if (!inside(request.x, image.width) || !inside(request.y, image.height)) {
        throw scene::UserError("--pixel " + std::to_string(request.x) + "," + std::to_string(request.y) +
                               ": outside the picture; expected X from 0 to " + std::to_string(image.width - 1) +
                               " and Y from 0 to " + std::to_string(image.height - 1) +
                               " (0,0 is the upper left pixel)");
    }
    if (request.sample_x < 0) return;
    if (!inside(request.sample_x, image.samples) || !inside(request.sample_y, image.samples)) {
        throw scene::UserError("--sample " + std::to_string(request.sample_x) + "," + std::to_string(request.sample_y) +
                               ": this picture has " + std::to_string(image.samples) + " x " +
                               std::to_string(image.samples) + " samples a pixel; expected numbers from 0 to " +
                               std::to_string(image.samples - 1));
    }
}

Explanation explain_pixel(const scene::Scene& scene, const PixelRequest& request, int threads) {
    check_request(scene.image, request);
    const RenderPlan plan = plan_with_views(scene);
    scene::RenderBuffers buffers;
    buffers.tiles = {tile_with(raster::make_tile_grid(plan.viewport, plan.samples), request.x * plan.samples,
                               request.y * plan.samples)};  // the rest of the picture is not asked for
    std::optional<Explanation> explanation;
    render(scene, plan, buffers, threads, [&](const Frame& frame) { explanation = explain_in(frame, request); });
    return *explanation;
}

std::string triangle_text(const Frame& frame, const SourceTriangle& source) {
    const scene::Object& object = frame.scene.objects[source.object];
    const std::string& part = object.mesh->parts[source.part].name;
    std::string text = "object " + std::to_string(source.object) + " (" + object.mesh_name + ")";
    if (object.mesh->parts.size() > 1) text += ", part " + std::to_string(source.part);
    if (object.mesh->parts.size() > 1 && !part.empty()) text += " \"" + part + "\"";
    return text + ", triangle " + std::to_string(source.triangle);
}

}  // namespace kreda::tools
