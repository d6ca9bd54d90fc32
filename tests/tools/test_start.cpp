// What a process of kreda loads: OpenImageIO brings 200 libraries, so only an image file may ask for it.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Run kreda while the loader of the C library tells on stderr which files it opens.
Outcome run_with_loader_talking(const std::vector<std::string>& args, const TempFolder& folder) {
    setenv("LD_DEBUG", "files", 1);
    const Outcome outcome = run_kreda(args, folder.path.string());
    unsetenv("LD_DEBUG");
    return outcome;
}

bool mentions(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A ball; `material` and `more` are lines of TOML.
void write_ball(const TempFolder& folder, const std::string& material, const std::string& more = "") {
    folder.write("ball.toml", "[image]\nsize = [24, 16]\n[camera]\nposition = [0, 0, 3]\n[[light]]\n" + more +
                                  "[[material]]\nname = \"m\"\n" + material +
                                  "[[object]]\nmesh = \"sphere\"\nmaterial = \"m\"\ndetail = 8\n");
}

}  // namespace

TEST_CASE("start: without image files no command loads OpenImageIO, and a texture does") {
    const TempFolder folder;
    write_ball(folder, "", "[environment]\nsky = \"studio\"\n");
    const std::vector<std::vector<std::string>> commands = {{"--help"},
                                                            {"keys"},
                                                            {"plan", "ball.toml"},
                                                            {"explain", "ball.toml", "--pixel", "12,8"},
                                                            {"render", "ball.toml"}};
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command.front());
        const Outcome outcome = run_with_loader_talking(command, folder);
        CHECK(outcome.exit_code == 0);
        if (!mentions(outcome.err, "libstdc++")) {
            MESSAGE("SKIPPED: this loader does not say what it loads");
            return;
        }
        CHECK_FALSE(mentions(outcome.err, "OpenImageIO"));
        CHECK_FALSE(mentions(outcome.err, "libkreda_images"));
    }
    scene::write_png(folder.file("grey.png"), raster::make_image(2, 2, 3));
    write_ball(folder, "diffuse_map = \"grey.png\"\n");
    const Outcome outcome = run_with_loader_talking({"render", "ball.toml"}, folder);
    CHECK(outcome.exit_code == 0);
    CHECK(mentions(outcome.err, "OpenImageIO"));
}

TEST_CASE("start: a module that cannot be loaded is one line with the remedy, and matters to images only") {
    namespace fs = std::filesystem;
    const TempFolder folder;
    fs::create_directories(folder.path / "bin");
    fs::copy_file(KREDA_PROGRAM, folder.path / "bin" / "kreda");
    folder.write("bin/libkreda_images.so", "no library");
    write_ball(folder, "diffuse_map = \"grey.png\"\n");
    scene::write_png(folder.file("grey.png"), raster::make_image(2, 2, 3));
    const Outcome outcome = run_program(folder.file("bin/kreda"), {"render", "ball.toml"}, folder.path.string());
    CHECK(outcome.exit_code == 2);
    CHECK(line_count(outcome.err) == 1);
    CHECK(mentions(outcome.err, "grey.png"));
    CHECK(mentions(outcome.err, "install the package libopenimageio"));
    CHECK_FALSE(fs::exists(folder.path / "ball.png"));
    CHECK(run_program(folder.file("bin/kreda"), {"render", "--size", "8x8"}, folder.path.string()).exit_code == 0);
}
