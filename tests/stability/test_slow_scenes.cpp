// Scene files with random changes: whatever they come to say, it is drawn or refused soon.
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "scene/render/threads.hpp"
#include "tests/scene/damaged_text.hpp"

using namespace kreda;

namespace {

struct SceneText {
    std::string text, name, folder;
};

/// The example scenes, and where their files lie.
std::vector<SceneText> example_scenes() {
    std::vector<SceneText> scenes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(KREDA_SOURCE_DIR "/examples")) {
        if (entry.path().extension() != ".toml") continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const bool is_scene = text.str().find("[[object]]") != std::string::npos;
        if (is_scene) scenes.push_back({text.str(), entry.path().string(), entry.path().parent_path().string()});
    }
    return scenes;
}

/// Random changes of scene files.
class SceneChanges {
public:
    explicit SceneChanges(unsigned seed) : random_(seed), damage_(seed) {}

    [[nodiscard]] std::string of(std::string text) {
        for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
            const std::size_t kind = below(4);
            if (kind == 0) text = damage_.of(text);
            if (kind == 1) text = with_other_number(text);
            if (kind >= 2) text = with_repeated_table(text);
        }
        return text;
    }

private:
    [[nodiscard]] std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }

    /// A number behind a '=' or a ',' becomes one at the end of some range.
    [[nodiscard]] std::string with_other_number(std::string text) {
        const char* const ends[] = {"0", "1", "64", "1024", "0.0", "1e-9", "1e9", "-1.0", "0.5", "180.0"};
        const std::size_t from = text.find_first_of("=,", below(text.size()));
        const std::size_t digit = from == text.npos ? from : text.find_first_of("0123456789", from);
        if (digit == text.npos) return text;
        const std::size_t end = std::min(text.find_first_not_of("0123456789.e-", digit), text.size());
        return text.replace(digit, end - digit, ends[below(std::size(ends))]);
    }

    /// A table of a list, [[light]] or [[object]], stands there up to a hundred times.
    [[nodiscard]] std::string with_repeated_table(const std::string& text) {
        const std::size_t begin = text.find("\n[[", below(text.size()));
        if (begin == text.npos) return text;
        const std::size_t end = std::min(text.find("\n[", begin + 1), text.size());
        std::string repeated;
        for (std::size_t times = below(100); times > 0; --times) repeated += text.substr(begin, end - begin);
        return text.substr(0, begin) + repeated + text.substr(begin);
    }

    std::mt19937 random_;
    tests::DamagedText damage_;
};

/// Processor time of reading and drawing it, seconds; `is_drawn`: it was not refused.
double seconds_of(const SceneText& scene, bool& is_drawn) {
    scene::ReadOptions options;
    options.overrides = {"image.size=[64, 48]"};
    const std::clock_t begin = std::clock();
    try {
        (void)render(scene::read_scene_text(scene.text, "changed", scene.folder, options));
        is_drawn = true;
    } catch (const scene::UserError&) { is_drawn = false; }
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// How many are tried: few in each run, KREDA_CHANGED_SCENES where somebody asks.
int changed_scenes() {
    const char* const wish = std::getenv("KREDA_CHANGED_SCENES");
    return wish ? std::atoi(wish) : 60;
}

/// A scene that says much takes long as it is told: a hundred lights with shadow maps do. Sanitizers take ten times.
double most_seconds() {
#ifdef KREDA_SANITIZED
    return 100.0;
#else
    return 10.0;
#endif
}

}  // namespace

TEST_CASE("slow scenes: example scenes with random changes are drawn or refused in ten seconds") {
    const scene::ThreadLimit one_thread(1);
    const std::vector<SceneText> scenes = example_scenes();
    REQUIRE(scenes.size() > 20);
    SceneChanges changes(5);
    int drawn = 0;
    double longest = 0.0;
    std::string longest_scene;
    for (int i = 0; i < changed_scenes(); ++i) {
        SceneText scene = scenes[static_cast<std::size_t>(i) * 7 % scenes.size()];
        scene.text = changes.of(scene.text);
        CAPTURE(scene.name);
        CAPTURE(scene.text);
        bool is_drawn = false;
        const double seconds = seconds_of(scene, is_drawn);
        CHECK(seconds < most_seconds());
        drawn += is_drawn;
        if (seconds > longest) longest_scene = scene.text;
        longest = std::max(longest, seconds);
    }
    CHECK(5 * drawn > changed_scenes());
    MESSAGE(drawn << " drawn, " << longest << " s at most");
    if (std::getenv("KREDA_CHANGED_SCENES")) MESSAGE("the longest:\n" << longest_scene);
}
