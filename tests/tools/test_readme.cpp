// The front page tells the truth.
#include <regex>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"

using namespace kreda::tests;

namespace {

std::string text_of(const std::string& file) {
    return bytes_of(std::string(KREDA_SOURCE_DIR) + "/" + file);
}

/// What stands between `open` and the next `close`.
std::string between(const std::string& text, const std::string& open, const std::string& close) {
    const std::size_t start = text.find(open);
    REQUIRE(start != std::string::npos);
    const std::size_t stop = text.find(close, start + open.size());
    REQUIRE(stop != std::string::npos);
    return text.substr(start + open.size(), stop - start - open.size());
}

}  // namespace

TEST_CASE("readme: its scene file renders without a word of warning") {
    const TempFolder folder;
    folder.write("my.toml", between(text_of("README.md"), "```toml\n", "```"));
    const Outcome outcome = run_kreda({"render", "my.toml"}, folder.path.string());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "wrote my.png (640 x 360)\n");
}

TEST_CASE("readme: its pot stays green-blue under every model that the model line names") {
    const TempFolder folder;
    const std::string text = between(text_of("README.md"), "```toml\n", "```");
    folder.write("my.toml", text);
    const std::string line = between(text, "\nmodel = ", "\n");
    const std::regex quoted("\"([a-z_]+)\"");
    int models = 0;
    for (auto it = std::sregex_iterator(line.begin(), line.end(), quoted); it != std::sregex_iterator();
         ++it, ++models) {
        const std::string model = (*it)[1];
        CAPTURE(model);
        const Outcome outcome =
            run_kreda({"render", "my.toml", "-o", "p.png", "--size", "64x36", "--set", "material.glaze.model=" + model},
                      folder.path.string());
        CHECK(outcome.err == "wrote p.png (64 x 36)\n");
        const glm::vec3 pot = kreda::scene::read_image(folder.file("p.png")).rgb(32, 22);
        CHECK(pot.y > 1.3f * pot.x);  // grey would be 1, and diffuse itself is 0.05 against 0.3
        CHECK(pot.z > 1.3f * pot.x);
    }
    CHECK(models == 7);
}

TEST_CASE("readme: its picture is what its scene file gives") {
    const TempFolder folder;
    const std::string scene = std::string(KREDA_SOURCE_DIR) + "/docs/images/first.toml";
    REQUIRE(run_kreda({"render", scene, "-o", "first.png", "--no-cache"}, folder.path.string()).exit_code == 0);
    CHECK(bytes_of(folder.file("first.png")) == text_of("docs/images/first.png"));
}

TEST_CASE("readme: it names every package that course installs") {
    const std::string readme = text_of("README.md"), course = text_of("course");
    std::istringstream packages(between(course, "required=(", ")") + " " + between(course, "optional=(", ")"));
    for (std::string package; packages >> package;) {
        CAPTURE(package);
        CHECK(readme.find(package) != std::string::npos);
    }
}

TEST_CASE("readme: every file and folder that it links or names is there") {
    const std::string readme = text_of("README.md");
    const std::regex named("\\]\\(([^)#]+)\\)|`([a-z_]+/[a-z_]*(?:\\.[a-z]+)?)`");
    for (auto it = std::sregex_iterator(readme.begin(), readme.end(), named); it != std::sregex_iterator(); ++it) {
        const std::string path = (*it)[1].matched ? (*it)[1].str() : (*it)[2].str();
        CAPTURE(path);
        CHECK(std::filesystem::exists(std::string(KREDA_SOURCE_DIR) + "/" + path));
    }
}
