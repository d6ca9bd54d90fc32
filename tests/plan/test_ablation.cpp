// Model only what a scene requires: every planned pass changes a bit, and nothing that was left out would have.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/plan/ablation.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// At most one of `share` passes may be idle with a reason.
void check(const AblationReport& report, int share) {
    for (const std::string& pass : report.useless) MESSAGE("changes nothing: ", pass);
    for (const std::string& scene : report.missing) MESSAGE("something is missing: ", scene);
    MESSAGE(report.passes, " passes left out, ", report.idle.size(), " of them idle as the plan says they may be");
    CHECK(report.useless.empty());
    CHECK(report.missing.empty());
    for (const std::string& pass : report.idle) MESSAGE("idle: ", pass);
    CHECK(static_cast<int>(report.idle.size()) <= report.passes / share);
}

void ablate_films(std::uint32_t first, std::uint32_t count) {
    AblationReport report;
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        ablate(random_plan_scene(seed), {}, "scene " + std::to_string(seed), report);
    }
    check(report, 50);
}

/// Each scene with some of the views that it can show.
void ablate_views(std::uint32_t first, std::uint32_t count) {
    AblationReport report;
    std::size_t number = 0;
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        const scene::Scene scene = random_plan_scene(seed);
        const scene::RenderPlan all = make_plan_for(scene, scene::PlanRequest{.prune = false});
        for (scene::View view : scene::all_views()) {
            if (!can_show(all, scene, view) || number++ % 4 != 0) continue;
            if (view.value) view.background = -777.0f;  // no view holds it: so it shows where one was not written
            ablate(scene, {.views = {&view}, .film = false},
                   "scene " + std::to_string(seed) + ", " + std::string(view.name), report);
        }
    }
    check(report, 40);  // one quantity alone is black more often than their sum
}

}  // namespace

TEST_CASE("every planned pass changes a bit of the film and nothing left out would have: 60 random scenes") {
    ablate_films(0, 60);
}

TEST_CASE("every planned pass changes a bit of the view that is asked for: 40 random scenes") {
    ablate_views(1000, 40);
}

TEST_CASE("rare: every planned pass changes a bit of the film and nothing left out would have: 500 random scenes" *
          doctest::skip()) {
    ablate_films(2000, 500);
}

TEST_CASE("what runs and is measured is the plan's list: 40 random scenes") {
    for (std::uint32_t seed = 3000; seed < 3040; ++seed) {
        const scene::Scene scene = random_plan_scene(seed);
        const scene::RenderPlan plan = make_plan(scene);
        scene::RenderBuffers buffers;
        const scene::RenderStatistics statistics = render(scene, plan, buffers, 1);
        std::vector<std::string> planned, measured;
        for (const scene::PlannedPass& pass : plan.passes) planned.push_back(pass.name);
        for (const auto& [name, ms] : statistics.times.stages) measured.push_back(name);
        CHECK(planned == measured);
        std::vector<std::string> names = planned;
        std::sort(names.begin(), names.end());
        CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    }
}
