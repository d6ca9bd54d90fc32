// kreda measure and kreda tune as a user meets them.
#include <string>

#include <doctest/doctest.h>

#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/measure/experiment.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr const char* kScene =
    "[image]\nsize = [16, 9]\n[[light]]\n[[material]]\nname = \"a\"\n"
    "[[object]]\nmesh = \"sphere\"\ndetail = 16\nmaterial = \"a\"\n";

}  // namespace

TEST_CASE("measure: list names every experiment and a wrong name is answered with the right one") {
    const TempFolder folder;
    const Outcome list = run_kreda({"measure", "list"}, folder.path.string());
    CHECK(list.exit_code == 0);
    for (const tools::Experiment& experiment : tools::experiments()) {
        CAPTURE(experiment.name);
        CHECK(list.out.find(experiment.name) != std::string::npos);
    }
    CHECK(list.out.find("material.fresnel") != std::string::npos);
    const Outcome wrong = run_kreda({"measure", "fresnl"}, folder.path.string());
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err == "kreda measure: there is no experiment 'fresnl'; did you mean 'fresnel'?\n");
}

TEST_CASE("tune: writes the scene and four pictures and a scene that renders") {
    const TempFolder folder;
    folder.write("s.toml", kScene);
    const Outcome outcome = run_kreda(
        {"tune", "s.toml", "--max-error", "3", "--cost", "plan", "--keep", "image.samples"}, folder.path.string());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.find("promised: 3.00 codes") != std::string::npos);
    CHECK(bytes_of(folder.file("s_tuned.toml")).find("# promised") != std::string::npos);
    for (const char* name : {"chosen.png", "oracle.png", "front.png", "who_spent_it.png"}) {
        CHECK(std::filesystem::exists(folder.path / "s_tuned" / name));
    }
    CHECK(run_kreda({"render", "s_tuned.toml"}, folder.path.string()).exit_code == 0);
}

TEST_CASE("tune: what cannot be is one line with a remedy and leaves nothing") {
    const TempFolder folder;
    folder.write("s.toml", kScene);
    folder.write("files/s.toml", std::string(kScene) + "[[object]]\nmesh = \"t.obj\"\nmaterial = \"a\"\n");
    folder.write("files/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::vector<std::vector<std::string>> refused = {
        {"tune", "s.toml"},
        {"tune", "s.toml", "--max-error", "1", "--budget-ms", "5"},
        {"tune", "s.toml", "--max-error", "1", "--keep", "image.sample"},
        {"tune", "s.toml", "--budget-ms", "5", "--cost", "plan"},
        {"tune", "none.toml", "--max-error", "1"},
        {"tune", "files/s.toml", "--max-error", "1", "-o", "elsewhere.toml"}};
    for (const std::vector<std::string>& arguments : refused) {
        const Outcome outcome = run_kreda(arguments, folder.path.string());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
    }
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"files", "s.toml"});
}
