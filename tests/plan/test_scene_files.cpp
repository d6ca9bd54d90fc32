// The scenes of the course: every planned pass changes a bit of each of them, and none of them is warned of.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "scene/files/read_scene.hpp"
#include "scene/plan/plan_warnings.hpp"
#include "tests/plan/ablation.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

namespace fs = std::filesystem;

/// Scene files of the examples and the assignments; a folder "teacher" and rubrics hold other tables.
std::vector<std::string> scene_files() {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(KREDA_SOURCE_DIR "/examples")) {
        const fs::path& path = entry.path();
        const bool is_scene = path.extension() == ".toml" && path.filename() != "rubric.toml" &&
                              path.parent_path().filename() != "teacher";
        if (is_scene) files.push_back(path.string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The scene, small: what a plan decides does not depend on the size, but for what is a sample large.
scene::Scene small_scene(const std::string& file) {
    scene::ReadOptions options;
    options.overrides = {"image.size=[64,48]", "image.samples=1"};
    scene::Scene scene = file.empty() ? scene::read_scene_text(scene::built_in_scene_text(), "built-in", "", options)
                                      : scene::read_scene(file, options);
    scene.environment.samples = 16;
    scene.environment.reference = std::min(scene.environment.reference, 4);
    return scene;
}

/// Scenes that are as they should not be, for the lesson: a board twice in one place, and shadow maps of few texels.
bool is_wrong_on_purpose(const std::string& file) {
    return file.ends_with("A2_depth/scenes/ties.toml") || file.find("A7_shadow_map/scenes/") != std::string::npos;
}

}  // namespace

TEST_CASE("every planned pass changes a bit of the scenes of examples and assignments and nothing is missing") {
    AblationReport report;
    ablate(small_scene(""), {}, "built-in", report);
    const std::vector<std::string> files = scene_files();
    REQUIRE(files.size() > 20);
    for (const std::string& file : files) ablate(small_scene(file), {}, file, report);
    for (const std::string& pass : report.useless) MESSAGE("changes nothing: ", pass);
    for (const std::string& pass : report.idle) MESSAGE("idle: ", pass);
    CHECK(report.useless.empty());
    CHECK(report.missing.empty());
    CHECK(static_cast<int>(report.idle.size()) <= report.passes / 50);
}

TEST_CASE("no scene of the examples and the assignments is warned of") {
    std::vector<std::string> files = scene_files();
    files.push_back("");
    for (const std::string& file : files) {
        if (is_wrong_on_purpose(file)) continue;
        CAPTURE(file);
        const scene::Scene scene = file.empty() ? scene::read_scene_text(scene::built_in_scene_text(), "built-in", "")
                                                : scene::read_scene(file);
        std::vector<std::string> warnings = plan_warnings(scene, make_plan(scene));
        warnings.insert(warnings.end(), scene.warnings.begin(), scene.warnings.end());
        const std::string first = warnings.empty() ? "" : warnings.front();
        CHECK(first.empty());
    }
}
