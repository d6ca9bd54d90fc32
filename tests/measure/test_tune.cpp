// What tune promises is kept.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/image_file.hpp"
#include "tests/measure/tuned_scenes.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/measure/picture.hpp"
#include "tools/tune/tune.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// A folder with a soft sky and a checkered texture.
struct SceneFolder {
    TempFolder folder;
    SceneFolder() {
        raster::Image sky = raster::make_image(64, 32, 3), squares = raster::make_image(32, 32, 3);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 64; ++x) sky.set_rgb(x, y, {y < 16 ? 0.9f : 0.3f, x < 32 ? 0.8f : 0.4f, 0.5f});
            for (int x = 0; x < 32; ++x)
                squares.set_rgb(x, y, (x / 4 + y / 4) % 2 == 0 ? glm::vec3(0.9f) : glm::vec3(0.2f, 0.3f, 0.7f));
        }
        scene::write_png(folder.file("sky.png"), sky);
        scene::write_png(folder.file("squares.png"), squares);
    }
    [[nodiscard]] tools::SceneSource source(const TunedScene& scene) const {
        return {scene.text, scene.name, folder.path.string(), {}};
    }
};

/// Operations of the plan as cost: the same choice on every machine.
tools::TuneOptions within(double codes) {
    tools::TuneOptions options;
    options.max_error = codes;
    options.cost_by = tools::CostBy::plan;
    options.probe_pixels = 600;
    options.oracle_seconds = 0.2;
    return options;
}

/// The picture of a text, drawn anew.
raster::Image picture_of(const tools::SceneSource& source, const std::string& text) {
    tools::SceneSource written = source;
    written.text = text;
    scene::RenderBuffers buffers;
    return tools::draw_picture(read_with(written, {}), buffers).encoded;
}

void check_promise(const TunedScene& scene, double codes) {
    CAPTURE(scene.name);
    const SceneFolder folder;
    const tools::SceneSource source = folder.source(scene);
    const tools::Tuned tuned = tools::tune(source, {}, within(codes));
    CHECK(tools::budget_of(tuned.achieved) <= codes);
    // The file that is written, drawn by itself, is the picture that was verified.
    const tools::CodeError of_file = tools::code_error(picture_of(source, tuned.text), tuned.oracle_picture);
    CHECK(of_file.mean == doctest::Approx(tuned.achieved.mean));
    CHECK(of_file.worst == tuned.achieved.worst);
    CHECK(tuned.chosen_cost <= tuned.oracle_cost);
}

}  // namespace

TEST_CASE("tune: Phong and fog keep the promise") {
    check_promise(kTunedScenes[0], 2.0);
}
TEST_CASE("tune: a textured microfacet surface keeps the promise") {
    check_promise(kTunedScenes[1], 2.0);
}
TEST_CASE("tune: metals under an environment keep the promise") {
    check_promise(kTunedScenes[2], 2.0);
}
TEST_CASE("tune: soft shadows keep the promise") {
    check_promise(kTunedScenes[3], 2.0);
}
TEST_CASE("tune: everything at once keeps the promise") {
    check_promise(kTunedScenes[4], 2.0);
}

TEST_CASE("tune: no error at all gives the picture of the oracles and a large budget a cheaper one") {
    const SceneFolder folder;
    const tools::SceneSource source = folder.source(kTunedScenes[0]);
    const tools::Tuned exact = tools::tune(source, {}, within(0.0)), loose = tools::tune(source, {}, within(20.0));
    CHECK(exact.achieved.worst <= 4.0);  // a mean of 0 codes: none differs; what is rounded may
    CHECK(exact.achieved.mean == 0.0);
    CHECK(loose.chosen_cost < exact.chosen_cost);
}

TEST_CASE("tune: a kept key stays and terms that cannot matter are left alone with a reason") {
    const SceneFolder folder;
    const tools::SceneSource source = folder.source(kTunedScenes[0]);
    const tools::SceneTerms found = tools::terms_of(source, {"image.samples"});
    for (const tools::Term& term : found.terms) {
        CHECK(term.name != "supersampling");
        CHECK(term.name != "shadows");
        CHECK(term.name != "environment");
    }
    CHECK(found.pruned.size() >= 4);
}

TEST_CASE("tune: changed text keeps every other line and says what was changed") {
    const tools::SceneSource source{"# mine\n[image]\nsamples = 2 # fine\n[[material]]\nname = \"a\"\n", "s", "", {}};
    const std::string text = tools::changed_text(source, {{{"image", -1, "samples", "3"}, "why"},
                                                          {{"material", 0, "model", "phong"}, "other"},
                                                          {{"shadow", -1, "size", "256"}, ""},
                                                          {{"shadow", -1, "bias", "slope"}, ""}});
    CHECK(text ==
          "# mine\n[image]\nsamples = 3 # fine; why\n[[material]]\nmodel = \"phong\"  # other\nname = \"a\"\n"
          "\n[shadow]\nbias = \"slope\"\nsize = 256\n");
}

TEST_CASE("tune: a table in one line that lacks the key is an error with a remedy") {
    const tools::SceneSource source{"image = { samples = 2 }\n", "s", "", {}};
    CHECK(tools::changed_text(source, {{{"image", -1, "samples", "3"}, ""}}) == "image = { samples = 3 }\n");
    CHECK_THROWS_WITH(tools::changed_text(source, {{{"image", -1, "exposure", "3"}, ""}}),
                      doctest::Contains("[image]"));
}

// ------------------------------------------------------------------------------------------------ rare

/// All sets of the terms of a scene, rendered: what the best front really is.
TEST_CASE("ten thousand sets of settings: the front that tune predicts has 95 percent of the best one's area" *
          doctest::skip()) {
    const SceneFolder folder;
    const tools::SceneSource source = folder.source(kTunedScenes[0]);
    tools::TuneOptions options = within(2.0);
    std::vector<tools::Term> terms = tools::terms_of(source).terms;
    limit_oracle(source, terms, options);
    const tools::MeasuredTerms measured = measure_terms(source, terms, options);
    CAPTURE(measured.renders);
    CHECK(measured.renders <= 60);
    MESSAGE("renders: " << measured.renders);
}
