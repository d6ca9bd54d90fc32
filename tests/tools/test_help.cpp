// What kreda says about itself.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/scene_keys.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/bench/time_report.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("help names every command and render's help every option") {
    const TempFolder folder;
    const Outcome help = run_kreda({"--help"}, folder.path.string());
    CHECK(help.exit_code == 0);
    for (const char* command : {"render", "plan", "keys", "stages"}) CHECK(help.out.find(command) != std::string::npos);
    const Outcome render = run_kreda({"render", "--help"}, folder.path.string());
    CHECK(render.exit_code == 0);
    for (const char* option : {"--output", "--size", "--samples", "--threads", "--set", "--time", "--repeat",
                               "--allow-outside", "--view", "--light"}) {
        CAPTURE(option);
        CHECK(render.out.find(option) != std::string::npos);
    }
}

TEST_CASE("plan and stages and explain take the options that change render's picture") {
    const TempFolder folder;
    for (const char* command : {"plan", "stages", "explain"}) {
        CAPTURE(command);
        const Outcome help = run_kreda({command, "--help"}, folder.path.string());
        for (const char* option : {"--size", "--samples", "--light", "--set", "--allow-outside"}) {
            CAPTURE(option);
            CHECK(help.out.find(option) != std::string::npos);
        }
    }
}

TEST_CASE("keys prints every key of the scene file with its meaning") {
    const TempFolder folder;
    const Outcome keys = run_kreda({"keys"}, folder.path.string());
    CHECK(keys.exit_code == 0);
    for (const scene::KeyInfo& key : scene::scene_keys()) {
        CAPTURE(key.key);
        CHECK(keys.out.find(scene::table_title(key.table)) != std::string::npos);
        const std::string by_default = "  " + default_text(key) + (key.default_value.empty() ? " " : "");
        CHECK(keys.out.find(by_default) != std::string::npos);
        if (!key.example.empty()) CHECK(keys.out.find("; e.g. " + example_text(key)) != std::string::npos);
        CHECK(keys.out.find(key.meaning) != std::string::npos);
    }
}

TEST_CASE("the example that keys prints is a scene file that renders") {
    const TempFolder folder;
    folder.write("my.toml", run_kreda({"keys", "--example"}, folder.path.string()).out);
    CHECK(run_kreda({"render", "my.toml", "--size", "16x9", "--samples", "1"}, folder.path.string()).exit_code == 0);
    CHECK(std::filesystem::exists(folder.file("my.png")));
}

TEST_CASE("version is one line") {
    const TempFolder folder;
    const Outcome version = run_kreda({"--version"}, folder.path.string());
    CHECK(version.exit_code == 0);
    CHECK(version.out.rfind("kreda ", 0) == 0);
    CHECK(line_count(version.out) == 1);
}

TEST_CASE("median is the middle value and of an even number the mean of the middle two") {
    CHECK(tools::median({7.0}) == 7.0);
    CHECK(tools::median({9.0, 1.0, 2.0}) == 2.0);
    CHECK(tools::median({4.0, 1.0, 100.0, 2.0}) == 3.0);
}
