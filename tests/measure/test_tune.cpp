// What tune promises is kept.
#include <string>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/plan/plan_cost.hpp"
#include "tests/measure/tuned_scenes.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/measure/picture.hpp"
#include "tools/tune/front.hpp"

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

TEST_CASE("tune: a budget of time has the exact picture where there is time for it and refuses what nothing can keep") {
    const SceneFolder folder;
    const tools::SceneSource source = folder.source(kTunedScenes[0]);
    tools::TuneOptions options = within(0.0);
    options.max_error.reset();
    options.cost_by = tools::CostBy::time;
    options.budget_ms = 1e6;
    CHECK(tools::tune(source, {}, options).achieved.worst == 0.0);
    options.budget_ms = 1e-4;
    CHECK_THROWS_WITH_AS((void)tools::tune(source, {}, options), doctest::Contains("--budget-ms"), scene::UserError);
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

namespace {

constexpr TunedScene kBruteForce = {"a fogged microfacet ball", R"(
[image]
size = [32, 18]
samples = 3
[camera]
position = [0, 1, 4]
target = [0, 0, 0]
[[light]]
direction = [-1, -2, -1]
intensity = 3
[fog]
mode = "exp"
density = 0.15
[[material]]
name = "ball"
model = "cook_torrance"
albedo = [0.8, 0.3, 0.2]
roughness = 0.4
[[object]]
mesh = "sphere"
detail = 32
material = "ball"
)"};

/// The next set, as a number with a digit for each term; false after the last.
bool next_set(const std::vector<tools::Term>& terms, std::vector<int>& chosen) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
        if (++chosen[t] < static_cast<int>(terms[t].options.size())) return true;
        chosen[t] = 0;
    }
    return false;
}

/// Cost by the plan and error against the oracles' picture, both as they are.
tools::KnapsackChoice true_choice(const tools::SceneSource& source, const std::vector<tools::Term>& terms,
                                  const std::vector<int>& chosen, const raster::Image& exact,
                                  scene::RenderBuffers& buffers) {
    const scene::Scene scene = read_with(source, settings_of(terms, chosen));
    const raster::Image picture = tools::draw_picture(scene, buffers, 1).encoded;
    return {total_operations(make_plan(scene)), tools::budget_of(tools::code_error(picture, exact)), chosen};
}

}  // namespace

/// All sets of the terms of a scene, rendered: what the best front really is.
TEST_CASE("ten thousand sets of settings: 60 renders find nearly all of what all sets are worth" * doctest::skip()) {
    constexpr int kMostRenders = 60;
    constexpr double kCornerError = 8.0;  // codes: worse than this is no choice
    const SceneFolder folder;
    scene::LoadedFiles files;
    tools::SceneSource source = folder.source(kBruteForce);
    source.read.files = &files;
    tools::TuneOptions options = within(2.0);
    options.oracle_seconds = 0.0;  // no more samples than the scene's: the number of all sets is what takes time
    std::vector<tools::Term> terms =
        tools::terms_of(source, {"material.energy_compensation"}).terms;  // its tables take long
    tools::DrawnSets drawn;
    limit_oracle(source, terms, options, drawn);
    tools::MeasuredTerms measured = measure_terms(source, terms, options, drawn);
    std::vector<std::vector<bool>> allowed;
    for (const tools::Term& term : terms) allowed.emplace_back(term.options.size(), true);
    const tools::FrontSubject subject{source, terms, options, drawn, measured};
    std::vector<tools::Candidate> candidates = find_candidates(subject, allowed);
    predict(subject, candidates);
    explore(subject, candidates, kMostRenders - measured.renders, kCornerError);
    CHECK(measured.renders <= kMostRenders);

    scene::RenderBuffers buffers;
    const scene::Scene truth = read_with(source, settings_of(terms, oracles(terms)));
    const raster::Image exact = tools::draw_picture(truth, buffers, 1).encoded;
    const double corner_cost = total_operations(make_plan(truth));
    std::vector<tools::KnapsackChoice> found, all;
    for (const tools::DrawnProbe& probe : measured.errors.drawn) {
        found.push_back(true_choice(source, terms, probe.chosen, exact, buffers));
        // What was predicted of a set that was drawn is what it costs.
        CHECK(predicted_cost(subject, probe.chosen) == doctest::Approx(1e-6 * found.back().cost));
    }
    std::vector<int> chosen(terms.size(), 0);
    do all.push_back(true_choice(source, terms, chosen, exact, buffers));
    while (next_set(terms, chosen));
    CHECK(all.size() >= 10'000);
    const double share = hypervolume(found, corner_cost, kCornerError) / hypervolume(all, corner_cost, kCornerError);
    MESSAGE(all.size() << " sets, " << measured.renders << " renders, share " << share);
    CHECK(share >= 0.95);
    CHECK(share <= 1.0);
}
