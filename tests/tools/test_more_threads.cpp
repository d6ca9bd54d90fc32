// Simulated threads: schedules worked out by hand, and a frame whose tiles tell how long they took.
#include <doctest/doctest.h>

#include <numeric>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tools/bench/more_threads.hpp"

using namespace kreda;

TEST_CASE("more threads: each piece goes to the thread that is free first, in order") {
    CHECK(tools::makespan({3, 1, 1, 1}, 1) == 6.0);
    CHECK(tools::makespan({3, 1, 1, 1}, 2) == 3.0);  // the second thread takes all three small ones
    CHECK(tools::makespan({1, 1, 1, 3}, 2) == 4.0);  // the large one comes last: 1 + 3
    CHECK(tools::makespan({2, 2, 2}, 2) == 4.0);     // one thread has two
    CHECK(tools::makespan({5, 1, 1}, 64) == 5.0);    // never shorter than the longest piece
    CHECK(tools::makespan({}, 4) == 0.0);
}

TEST_CASE("more threads: what comes before the tiles is shared evenly") {
    CHECK(tools::simulated_ms({8.0, {3, 1, 1, 1}}, 2) == 4.0 + 3.0);
    CHECK(tools::simulated_ms({8.0, {3, 1, 1, 1}}, 4) == 2.0 + 3.0);
}

TEST_CASE("more threads: a frame says of each tile how long it took, and nothing where nobody asks") {
    const scene::Scene scene =
        scene::read_scene_text("[image]\nsize = [200, 130]\n[[light]]\n[[object]]\nmesh = \"sphere\"\n", "test", "");
    const scene::RenderPlan plan = make_plan(scene);
    scene::RenderBuffers buffers;
    render(scene, plan, buffers, 1);
    CHECK(buffers.tile_ms.empty());
    buffers.tile_ms.assign(12, 0.0);  // 4 x 3 tiles of 64
    const double total = render(scene, plan, buffers, 1).times.total_ms;
    for (const double ms : buffers.tile_ms) CHECK(ms > 0.0);
    CHECK(std::accumulate(buffers.tile_ms.begin(), buffers.tile_ms.end(), 0.0) <= total);
}
