// kreda plan --json, and what is said of a scene that nothing needs.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/render_output.hpp"

using namespace kreda::tests;

namespace {

constexpr const char* kBall = R"(
[image]
size = [48, 32]
[camera]
position = [0, 0, 4]
[[light]]
direction = [0, -1, -1]
[[material]]
name = "clay"
model = "lambert"
diffuse = [0.5, 0.4, 0.3]
[[object]]
mesh = "sphere"
material = "clay"
)";

Outcome run_with(const std::string& more, std::vector<std::string> args) {
    const TempFolder folder;
    folder.write("ball.toml", kBall + more);
    args.insert(args.begin() + 1, "ball.toml");
    return run_kreda(args, folder.path.string());
}

/// The only warning of `kreda plan`, or all that was said.
std::string warning_of(const std::string& more) {
    const Outcome outcome = run_with(more, {"plan"});
    CHECK(outcome.exit_code == 0);
    CHECK(line_count(outcome.err) == 1);
    return outcome.err;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("plan --json: the passes of the text, in order, with bytes and costs, and what is left out") {
    const Outcome text = run_with("", {"plan", "--why-not"});
    const Outcome outcome = run_with("", {"plan", "--json"});
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    const nlohmann::json json = nlohmann::json::parse(outcome.out);
    std::size_t at = 0;
    for (const nlohmann::json& pass : json.at("passes")) {
        const std::size_t found = text.out.find(". " + pass.at("name").get<std::string>() + ": ", at);
        REQUIRE(found != std::string::npos);
        at = found;
    }
    for (const nlohmann::json& pass : json.at("left_out")) {
        CHECK(holds(text.out, "-  " + pass.at("name").get<std::string>() + ": left out, "));
    }
    const nlohmann::json& film = json.at("passes").back();
    CHECK(film.at("name") == "film");
    CHECK(film.at("runs") == "tile");
    CHECK(film.at("buffers").at(0).at("bytes") == 48 * 32 * 3 * (kreda::tools::kBuiltForDebugger ? 4 : 1));
    CHECK(film.at("cost").at("count") == 48 * 32);
}

TEST_CASE("plan and its JSON say what is seen first and which maps are read for it") {
    const std::string behind = "[[object]]\nmesh = \"cube\"\ntranslate = [0, 0, 20]\n";
    const Outcome text = run_with(behind, {"plan", "--quiet", "--why-not"});
    CHECK(
        holds(text.out, "seen, found from the meshes alone: 1 of 2 objects, 1 of 2 materials; the maps of 0 of them"));
    CHECK(holds(text.out, "none of its 12 triangles is seen: "));
    const nlohmann::json seen = nlohmann::json::parse(run_with(behind, {"plan", "--quiet", "--json"}).out).at("seen");
    CHECK(seen.at("objects").at(0).at("samples") == seen.at("samples"));
    CHECK(seen.at("objects").at(1).at("samples") == 0);
    CHECK(seen.at("objects").at(1).contains("why_unseen"));
}

/// Names of the planned passes of the ball with more in its file.
std::string passes_with(const std::string& more, std::vector<std::string> args = {}) {
    args.insert(args.begin(), {"plan", "--quiet", "--json"});
    std::string names;
    const Outcome outcome = run_with(more, args);
    REQUIRE(outcome.exit_code == 0);
    const nlohmann::json json = nlohmann::json::parse(outcome.out);
    for (const auto& pass : json.at("passes")) { names += pass.at("name").get<std::string>() + "; "; }
    return names;
}

TEST_CASE("what changes no bit of a picture has no pass: lights off and unlit and unseen and weighed with 0") {
    const std::string lamp = "[[light]]\nshadow = true\n", sky = "[environment]\nsky = \"studio\"\n";
    CHECK_FALSE(holds(passes_with(lamp + "on = false\n"), "light 1"));
    const std::string unlit = passes_with(lamp, {"--set", "material.clay.model=unlit", "--set", "light.0.shadow=true"});
    CHECK_FALSE(holds(unlit, "shadow map"));
    CHECK_FALSE(holds(unlit, "light 0"));
    CHECK(holds(passes_with(sky), "bake irradiance"));
    CHECK_FALSE(holds(passes_with(sky + "intensity = 0\n"), "bake"));
    const std::string behind = "[[object]]\nmesh = \"sphere\"\ntranslate = [0, 0, 20]\nmaterial = \"gold\"\n";
    const std::string gold = "[[material]]\nname = \"gold\"\nmodel = \"cook_torrance\"\n";
    CHECK_FALSE(holds(passes_with(sky + gold + behind), "bake prefiltered levels"));
    const std::string before =
        "[[object]]\nmesh = \"sphere\"\nmaterial = \"gold\"\ntranslate = [0, 0, 1]\n"
        "scale = 1.5\n";
    CHECK(holds(passes_with(sky + gold + before), "bake prefiltered levels"));
    CHECK_FALSE(holds(passes_with(sky + gold + "ao = 0\n" + before), "bake prefiltered levels"));
    CHECK_FALSE(holds(passes_with(sky + gold + "metallic = 1\n" + before), "bake irradiance"));
}

TEST_CASE("roughness 0 alone bakes the sharp levels of the environment") {
    const std::string mirror =
        "[environment]\nsky = \"studio\"\n[[material]]\nname = \"mirror\"\nroughness = 0\n"
        "model = \"cook_torrance\"\n[[object]]\nmesh = \"sphere\"\nmaterial = \"mirror\"\n"
        "translate = [0, 0, 1]\nscale = 1.5\n";
    const auto json = nlohmann::json::parse(run_with(mirror, {"plan", "--quiet", "--json"}).out);
    for (const auto& pass : json.at("passes")) {
        if (pass.at("name") == "bake prefiltered levels") CHECK(holds(pass.at("reason"), "levels 0 to 1"));
    }
}

TEST_CASE("a map that no seen material reads is not decoded: a broken one is not noticed") {
    const std::string worn =
        "[[material]]\nname = \"far\"\ndiffuse_map = \"broken.png\"\n"
        "[[object]]\nmesh = \"sphere\"\nmaterial = \"far\"\n";
    const auto outcome_at = [&](const std::string& place) {
        const TempFolder folder;
        folder.write("ball.toml", kBall + worn + "translate = " + place + "\n");
        folder.write("broken.png", "no picture at all");
        return run_kreda({"render", "ball.toml", "--quiet", "-o", "a.png"}, folder.path.string());
    };
    CHECK(outcome_at("[0, 0, 20]").exit_code == 0);
    const Outcome seen = outcome_at("[0, 0, 1]");
    CHECK(seen.exit_code != 0);
    CHECK(holds(seen.err, "broken.png"));
}

TEST_CASE("plan and render --time name the same passes in the same order") {
    const Outcome plan = run_with("", {"plan", "--json"});
    const Outcome time = run_with("", {"render", "--time"});
    REQUIRE(time.exit_code == 0);
    std::vector<std::string> planned, measured;
    const auto json = nlohmann::json::parse(plan.out);
    for (const auto& pass : json.at("passes")) planned.push_back(pass.at("name"));
    const auto stages = nlohmann::ordered_json::parse(time.out).at("stages");
    for (const auto& stage : stages.items()) measured.push_back(stage.key());
    CHECK(planned == measured);
    CHECK(planned.size() >= 8);
}

TEST_CASE("a view asks only for what leads to it") {
    const auto stages = [](const std::string& view) {
        return run_with("[environment]\nsky = \"studio\"\n", {"render", "--time", "--no-cache", "--view", view}).out;
    };
    const std::string depth = stages("depth"), normal = stages("normal");
    CHECK(holds(depth, "\"view depth\""));
    for (const char* pass : {"bake", "light", "interpolate", "paint"})
        CHECK_FALSE(holds(depth, "\"" + std::string(pass)));
    CHECK(holds(normal, "\"interpolate\""));
    CHECK(holds(normal, "\"surface\""));
    for (const char* pass : {"bake", "light 0", "environment"}) CHECK_FALSE(holds(normal, "\"" + std::string(pass)));
}

TEST_CASE("a scene that is as it should be is warned of by no command; each of these says one line") {
    CHECK(run_with("", {"plan"}).err.empty());
    const std::string light = "[[light]]\ntype = \"spot\"\nposition = [0, 9, 0]\ndirection = [0, 1, 0]\n";
    CHECK(holds(warning_of(light), "light.1 reaches nothing that is seen"));
    CHECK(holds(warning_of("[[light]]\nintensity = 0\n"), "light.1 sends nothing"));
    CHECK(holds(warning_of("[[material]]\nname = \"spare\"\n"), "no object wears the material \"spare\""));
    const auto object = [](const std::string& keys) { return "[[object]]\nmesh = \"cube\"\n" + keys; };
    CHECK(holds(warning_of(object("translate = [0, 0, 20]\n")),
                "object.1 (cube): nothing of it is seen: it lies behind"));
    CHECK(holds(warning_of(object("translate = [0, 0, -9e4]\n")), "beyond camera.far"));
    CHECK(holds(warning_of(object("translate = [50, 0, 0]\n")), "beside the picture"));
    CHECK(holds(warning_of(object("scale = 0.2\n")), "others stand before it"));
    const std::string spare =
        "[[object]]\nmesh = \"cube\"\nscale = 0.3\ntranslate = [1.2, 0, 0]\nmaterial = \"more\"\n";
    const std::string unread =
        spare + "[[material]]\nname = \"more\"\nmodel = \"cook_torrance\"\ndiffuse = [1, 1, 1]\n";
    CHECK(holds(warning_of(unread), "ball.toml:"));
    CHECK(holds(warning_of(unread),
                "'diffuse' in [[material]] is not read by model = \"cook_torrance\"; its colour is albedo"));
    const std::string bytes = spare + "[[material]]\nname = \"more\"\ndiffuse = [128, 115, 102]\n";
    CHECK(holds(warning_of(bytes), "'diffuse' looks like bytes of 0..255"));
    CHECK(holds(warning_of(bytes), "[0.216, 0.171, 0.133]"));  // ((128/255 + 0.055) / 1.055)^2.4 and so on
}

TEST_CASE("--quiet says nothing and --strict makes a warning an error before anything is written") {
    const std::string dark = "[[light]]\nintensity = 0\n";
    const Outcome quiet = run_with(dark, {"render", "--quiet", "-o", "a.png"});
    CHECK(quiet.exit_code == 0);
    CHECK_FALSE(holds(quiet.err, "warning"));
    const TempFolder folder;
    folder.write("ball.toml", kBall + dark);
    const Outcome strict = run_kreda({"render", "ball.toml", "--strict", "-o", "a.png"}, folder.path.string());
    CHECK(strict.exit_code == 2);
    CHECK(holds(strict.err, "--strict: 1 warning is an error"));
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"ball.toml"});
    CHECK(run_with("", {"render", "--strict", "-o", "a.png"}).exit_code == 0);
}

TEST_CASE("a black picture is warned of") {
    const Outcome outcome = run_with("[ambient]\ncolor = [0, 0, 0]\n", {"render", "--set", "light.0.on=false"});
    CHECK(holds(outcome.err, "the picture is black"));
}
