// Runs that are cut off, by kill -9 or a full disk: what stands under a file's name is whole, or the old one.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <doctest/doctest.h>

#include "run_kreda.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda::tests;

namespace {

constexpr const char* kScene =
    "[image]\nsize = [96, 64]\n[environment]\nsky = \"studio\"\nsamples = 32\n"
    "[[material]]\nname = \"m\"\nmodel = \"cook_torrance\"\n[[object]]\nmesh = \"sphere\"\nmaterial = \"m\"\n";

int kills() {
    const char* const wish = std::getenv("KREDA_KILLS");
    return wish ? std::atoi(wish) : 20;
}

/// Start kreda in a folder, its words lost. most_bytes > 0: it cannot write a larger file.
pid_t start_kreda(const std::vector<std::string>& args, const std::string& folder, rlim_t most_bytes = 0) {
    std::vector<char*> words = {const_cast<char*>(KREDA_PROGRAM)};
    for (const std::string& arg : args) words.push_back(const_cast<char*>(arg.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    const rlimit limit{most_bytes, most_bytes};
    if (most_bytes > 0) setrlimit(RLIMIT_FSIZE, &limit);
    if (most_bytes > 0) std::signal(SIGXFSZ, SIG_IGN);
    if (chdir(folder.c_str()) == 0) execv(KREDA_PROGRAM, words.data());
    _exit(127);
}

int exit_code_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// How a whole text file of this kind ends; "" for kinds that may end anyhow.
std::string end_of(const std::string& name) {
    if (name.ends_with(".json")) return "}";
    if (name.ends_with(".svg")) return "</svg>";
    if (name.ends_with(".html")) return "</html>";
    return "";
}

/// Every picture under a final name can be read, every text is there to its end. What a killed process left has another
/// name, ".NAME.NUMBER.tmp".
void check_files(const std::string& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string(), path = entry.path().string();
        if (name.starts_with(".")) continue;
        CAPTURE(path);
        const bool is_picture = name.ends_with(".png") || name.ends_with(".exr");
        if (is_picture) CHECK_NOTHROW((void)kreda::scene::read_image(path));
        if (end_of(name).empty()) continue;
        std::string text = bytes_of(path);
        text.erase(text.find_last_not_of(" \n") + 1);
        CHECK(text.ends_with(end_of(name)));
    }
}

}  // namespace

TEST_CASE("interrupted: kill -9 at any moment leaves whole files and caches that can be used") {
    std::mt19937 random(9);
    std::vector<std::vector<std::string>> commands = {{"render", "a.toml", "-o", "a.png"},
                                                      {"bake", "studio", "-o", "baked", "--samples", "32"},
                                                      {"stages", "a.toml", "-o", "stages"},
                                                      {"measure", "fresnel_table", "--quick", "-o", "measured"}};
    const std::string work = KREDA_SOURCE_DIR "/examples/assignments/A1_coverage";
    const bool is_long = kills() >= 100;  // what compiles takes longer than all others together
    if (is_long) commands.push_back({"grade", work, "--rubric", work + "/rubric.toml", "-o", "graded"});
    const TempFolder folder;
    folder.write("a.toml", kScene);
    const std::string place = folder.path.string();
    for (int i = 0; i < kills(); ++i) {
        const pid_t child = start_kreda(commands[static_cast<std::size_t>(i) % commands.size()], place);
        usleep(static_cast<useconds_t>(random() % (is_long ? 1'000'000 : 120'000)));
        kill(child, SIGKILL);
        (void)exit_code_of(child);
        check_files(place);
    }
    for (const std::vector<std::string>& command : commands) {
        const Outcome whole = run_kreda(command, place);
        CAPTURE(whole.err);
        CHECK(whole.exit_code == 0);
    }
}

TEST_CASE("interrupted: a disk that is full is one line and leaves the old picture") {
    const TempFolder folder;
    folder.write("a.toml", kScene);
    const std::string place = folder.path.string();
    REQUIRE(run_kreda({"render", "a.toml", "-o", "a.png"}, place).exit_code == 0);
    const std::string old = bytes_of(folder.file("a.png"));
    REQUIRE(old.size() > 1000);
    CHECK(exit_code_of(start_kreda({"render", "a.toml", "-o", "a.png"}, place, 500)) == 2);
    CHECK(bytes_of(folder.file("a.png")) == old);
}

TEST_CASE("interrupted: two that write one picture at once leave one whole picture") {
    const TempFolder folder;
    folder.write("a.toml", kScene);
    const std::vector<std::string> command = {"render", "a.toml", "-o", "a.png", "--no-cache"};
    const pid_t one = start_kreda(command, folder.path.string()), other = start_kreda(command, folder.path.string());
    CHECK(exit_code_of(one) == 0);
    CHECK(exit_code_of(other) == 0);
    check_files(folder.path.string());
    CHECK(names_in(folder.path.string()) == std::vector<std::string>{"a.png", "a.toml"});
}
