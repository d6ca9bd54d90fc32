// A picture in 8 bits is the film of the same scene, developed and rounded: no pixel differs by a code.
#include <doctest/doctest.h>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/render/render.hpp"
#include "tests/plan/plan_scenes.hpp"

using namespace kreda;

TEST_CASE("a picture in 8 bits is the developed film, and keeps no film: 20 random scenes") {
    for (std::uint32_t seed = 700; seed < 720; ++seed) {
        CAPTURE(seed);
        const scene::Scene scene = tests::random_plan_scene(seed);
        raster::FilmReport report;
        const raster::Image film = render(scene);
        const raster::Image developed = develop(film, film_settings(scene.image), &report);
        scene::RenderBuffers buffers;
        const auto frame = render(scene, make_plan_for(scene, {.bytes = true}), buffers, 2);
        CHECK(buffers.film.values.empty());
        REQUIRE(buffers.bytes.values.size() == developed.values.size());
        std::size_t differ = 0, lit = 0;
        for (std::size_t i = 0; i < developed.plane_size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t at = c * developed.plane_size() + i;
                differ += buffers.bytes.values[3 * i + c] != scene::byte_from_encoded(developed.values[at]);
                lit += film.values[at] != 0.0f;
            }
        }
        CHECK(differ == 0);
        CHECK(frame.shown.any_light == (lit > 0));
        CHECK(frame.shown.report.negative == report.negative);
        CHECK(frame.shown.report.infinite == report.infinite);
        CHECK(frame.shown.report.not_a_number == report.not_a_number);
    }
}
