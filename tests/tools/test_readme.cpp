// The front page tells the truth.
#include <regex>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

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

TEST_CASE("readme: its picture is what its scene file gives") {
    const TempFolder folder;
    const std::string scene = std::string(KREDA_SOURCE_DIR) + "/docs/images/first.toml";
    REQUIRE(run_kreda({"render", scene, "-o", "first.png"}, folder.path.string()).exit_code == 0);
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
