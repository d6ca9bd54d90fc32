#include "scene/plan/lit_samples.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include "lighting/batch/maps.hpp"
#include "lighting/batch/passes.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::scene {

namespace {

/// One thread's memory.
struct SampleLook {
    raster::TileVisibility visibility;
    raster::Run runs[raster::kTileSide * raster::kTileSide];
    raster::Fragments points;
    lighting::LightingChannels channels;
};

/// Does a light reach a seen sample of a material?
struct Question {
    std::size_t light = 0;
    std::uint32_t material = 0;
    bool any_normal = false;    ///< a map bends them
    std::uint8_t answered = 0;  ///< 1: yes
};

bool is_answered(Question& question) {
    return std::atomic_ref(question.answered).load(std::memory_order_relaxed) != 0;
}

/// Material by material: those of one stand together.
std::vector<Question> ask_all(const Scene& scene, const Seen& seen) {
    std::vector<Question> questions;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        for (std::size_t k = 0; k < seen.reached.size(); ++k) {
            const lighting::Material& material = scene.materials[m];
            if (!seen.reached[k][m] || !is_lit(material)) continue;
            questions.push_back({k, static_cast<std::uint32_t>(m), reads_normal_map(material)});
        }
    }
    return questions;
}

/// What the questions are answered with: the scene's lights and where it is seen from.
struct Asking {
    const RenderPlan& plan;
    const Placed& placed;
    lighting::LightingSetup setup;
    std::vector<lighting::LightSetup> lights;
    std::vector<Question> questions;
    std::vector<std::size_t> first_of_material;  ///< where its questions begin; one more: where the last end
    std::atomic<std::size_t> open{0};            ///< how many are not answered
};

void count_questions(std::size_t materials, Asking& asking) {
    asking.open = asking.questions.size();
    asking.first_of_material.assign(materials + 1, 0);
    for (const Question& question : asking.questions) ++asking.first_of_material[question.material + 1];
    for (std::size_t m = 0; m < materials; ++m) asking.first_of_material[m + 1] += asking.first_of_material[m];
}

bool any_sample_is_reached(const Question& question, int count, const lighting::LightingChannels& c) {
    for (int i = 0; i < count; ++i) {
        const bool faces = question.any_normal || c.n_dot_l.at(i) > 0.0f;
        if (faces && c.irradiance.at(i) != glm::vec3(0.0f)) return true;
    }
    return false;
}

void ask_run(Asking& asking, const raster::TileArea& area, const raster::Run& run, SampleLook& look) {
    bool is_ready = false;
    for (std::size_t q = asking.first_of_material[run.material]; q < asking.first_of_material[run.material + 1]; ++q) {
        Question& question = asking.questions[q];
        if (is_answered(question)) continue;
        if (!is_ready) {
            const raster::FragmentNeeds needs{.position = true, .normal = true, .two_sided = asking.plan.two_sided};
            interpolate_runs(asking.placed.streams, asking.placed.triangles, area, &run, 1, needs,
                             asking.plan.interpolation, look.points);
            look.points.count = run.count;
            set_directions(look.points, lighting::MaterialSetup{}, asking.setup, look.channels);
            is_ready = true;
        }
        sample_light(look.points, asking.lights[question.light], look.channels);
        if (any_sample_is_reached(question, run.count, look.channels)) {
            asking.open -= std::atomic_ref(question.answered).exchange(1) == 0 ? 1 : 0;
        }
    }
}

void ask_tile(Asking& asking, int tile, SampleLook& look) {
    if (asking.open == 0) return;
    const raster::TriangleSet& triangles = asking.placed.triangles;
    const raster::TileArea area = tile_area(triangles.grid, asking.plan.viewport, tile);
    if (!any_triangle_touches(triangles, area)) return;
    rasterize_tile(asking.placed.streams, triangles, area, look.visibility);
    const int count = collect_runs(look.visibility, area, triangles, look.runs);
    for (int r = 0; r < count; ++r) ask_run(asking, area, look.runs[r], look);
}

void ask_tiles(Asking& asking, const std::vector<int>& tile_of_material) {
    const auto first_look = std::make_unique<SampleLook>();
    std::vector<int> tiles = tile_of_material;
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    for (const int tile : tiles) {
        if (tile >= 0) ask_tile(asking, tile, *first_look);
    }
    if (asking.open == 0) return;
    const raster::TileGrid& grid = asking.placed.triangles.grid;
    const int tile_count = grid.columns * grid.rows;
#pragma omp parallel
    {
        const auto look = std::make_unique<SampleLook>();
#pragma omp for schedule(dynamic)
        for (int t = 0; t < tile_count; ++t) ask_tile(asking, t, *look);
    }
}

}  // namespace

void keep_what_reaches_samples(const Scene& scene, const RenderPlan& plan, const Placed& placed,
                               const std::vector<int>& tile_of_material, Seen& seen) {
    Asking asking{plan, placed, {}, {}, ask_all(scene, seen), {}};
    if (asking.questions.empty()) return;
    count_questions(scene.materials.size(), asking);
    asking.setup.eye = scene.camera.position;
    asking.setup.forward = view_direction(scene.camera);
    asking.setup.orthographic = scene.camera.projection == raster::Projection::orthographic;
    for (const lighting::Light& light : scene.lights) asking.lights.push_back(prepare(light));
    ask_tiles(asking, tile_of_material);
    for (Question& question : asking.questions) {
        seen.reached[question.light][question.material] = is_answered(question);
    }
}

}  // namespace kreda::scene
