// Whatever a scene says within what it may say, its film holds light: no NaN, no infinity, nothing negative.
#include <cstdlib>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "scene/render/threads.hpp"
#include "tests/stability/extreme_maps.hpp"
#include "tests/stability/extreme_scene.hpp"

using namespace kreda;

namespace {

/// How many seeds are tried: few in CI, more when somebody asks.
int seeds() {
    const char* const wish = std::getenv("KREDA_EXTREME_SCENES");
    return wish ? std::atoi(wish) : 60;
}

/// The values of a film that are no light.
struct Odd {
    std::size_t non_finite = 0, negative = 0;
};
Odd odd_values(const raster::Image& film) {
    Odd odd;
    for (const float value : film.values) {
        odd.non_finite += raster::is_finite(value) ? 0 : 1;
        odd.negative += value < 0.0f ? 1 : 0;
    }
    return odd;
}

}  // namespace

TEST_CASE("films: random extreme scenes have neither NaN nor infinity nor negative light") {
    const scene::ThreadLimit one_thread(1);
    int read = 0, lit = 0;
    std::string refusals;
    std::vector<int> tried = {1817, 2167, 3939};  // these had negative light: fog that was computed at the vertices
    for (int seed = 1; seed <= seeds(); ++seed) tried.push_back(seed);
    for (const int seed : tried) {
        const std::string text = tests::extreme_scene(static_cast<std::uint32_t>(seed));
        scene::Scene scene;
        try {
            scene = scene::read_scene_text(text, "extreme", "");
        } catch (const scene::UserError& refused) {
            CAPTURE(text);
            CHECK(std::string(refused.what()).starts_with("extreme"));
            refusals += std::string(refused.what()) + "\n";
            continue;
        }
        ++read;
        tests::add_extreme_maps(scene, static_cast<std::uint32_t>(seed));
        raster::Image film;
        try {
            film = render(scene);
        } catch (const scene::UserError&) { continue; }  // what only the plan can know
        const Odd odd = odd_values(film);
        for (const float value : film.values) {
            lit += value > 0.0f;
            if (value > 0.0f) break;
        }
        CAPTURE(seed);
        CAPTURE(text);
        CHECK(odd.non_finite == 0);
        CHECK(odd.negative == 0);
    }
    CAPTURE(refusals);
    CHECK(2 * read > seeds());  // most are scenes, and
    CHECK(4 * lit > read);      // many of those show something
}
