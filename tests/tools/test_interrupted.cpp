// Runs that are cut off, by kill -9 or a full disk: what stands under a file's name is whole, or the old one.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
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

/// Start kreda in a folder, its words to a file. most_bytes > 0: it cannot write a larger file.
pid_t start_kreda(const std::vector<std::string>& args, const std::string& folder, rlim_t most_bytes = 0,
                  const std::string& words_to = "/dev/null") {
    std::vector<char*> words = {const_cast<char*>(KREDA_PROGRAM)};
    for (const std::string& arg : args) words.push_back(const_cast<char*>(arg.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int file = open(words_to.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
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

struct Command {
    std::vector<std::string> args;
    double seconds = 0.12;  ///< what it takes, more or less
};
using Commands = std::vector<Command>;

Commands usual_commands() {
    return {{{"render", "a.toml", "-o", "a.png"}},
            {{"bake", "studio", "-o", "baked", "--samples", "32"}},
            {{"stages", "a.toml", "-o", "stages"}},
            {{"measure", "fresnel_table", "--quick", "-o", "measured"}}};
}

/// Run it to its end, which is no error.
double seconds_of(const Command& command, const std::string& folder) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome whole = run_kreda(command.args, folder);
    CAPTURE(whole.err);
    CHECK(whole.exit_code == 0);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Kill the commands in turn, each at a random moment.
void kill_often(const Commands& commands, int count, const std::string& folder) {
    std::mt19937 random(9);
    int hit = 0;
    for (int i = 0; i < count; ++i) {
        const Command& command = commands[static_cast<std::size_t>(i) % commands.size()];
        const pid_t child = start_kreda(command.args, folder);
        usleep(static_cast<useconds_t>(1e6 * command.seconds * static_cast<double>(random() >> 8) * 0x1p-24));
        kill(child, SIGKILL);
        hit += exit_code_of(child) == 128 + SIGKILL ? 1 : 0;
        check_files(folder);
    }
    MESSAGE(hit << " of " << count << " were hit while they ran");
}

/// By their path in the folder: pictures, kept maps and the marks, without the time that marking took.
std::map<std::string, std::string> results_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> results;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool is_marks = name == "result.json";
        const bool is_result = name.ends_with(".png") || name.ends_with(".exr") || name.ends_with(".map") || is_marks;
        if (name.starts_with(".") || !is_result) continue;
        std::string bytes = bytes_of(entry.path().string());
        const std::size_t time = is_marks ? bytes.find("\"seconds\"") : std::string::npos;
        if (time != std::string::npos) bytes.erase(time, bytes.find('\n', time) - time);
        results[std::filesystem::relative(entry.path(), folder).string()] = bytes;
    }
    return results;
}

}  // namespace

TEST_CASE("interrupted: kill -9 at any moment leaves whole files and caches that can be used") {
    const TempFolder folder;
    folder.write("a.toml", kScene);
    Commands commands = usual_commands();
    kill_often(commands, kills(), folder.path.string());
    for (const Command& command : commands) CHECK(seconds_of(command, folder.path.string()) > 0.0);
}

// What compiles takes longer than all others together, so this has a test of its own in CTest: `./course test all`.
TEST_CASE("long: kill -9 at 200 moments of commands and of grading leaves what an undisturbed run leaves" *
          doctest::skip()) {
    const std::string work = KREDA_SOURCE_DIR "/examples/assignments/A1_coverage";
    Commands commands = usual_commands();
    commands.push_back({{"grade", work, "--rubric", work + "/rubric.toml", "-o", "graded"}});
    const TempFolder undisturbed, folder;
    for (const TempFolder* const one : {&undisturbed, &folder}) {
        one->write("a.toml", kScene);
        setenv("KREDA_GRADE_CACHE", one->file("grade_cache").c_str(), 1);
        if (one == &folder) kill_often(commands, kills() / 2, folder.path.string());  // caches are empty at first
        for (Command& command : commands) command.seconds = seconds_of(command, one->path.string());
    }
    for (Command& command : commands) command.seconds = seconds_of(command, folder.path.string());  // with caches
    kill_often(commands, kills() / 2, folder.path.string());
    for (const Command& command : commands) (void)seconds_of(command, folder.path.string());
    const auto expected = results_in(undisturbed.path), found = results_in(folder.path);
    CHECK(expected.size() > 10);
    REQUIRE(expected.contains("graded/result.json"));
    INFO("a machine that is so busy that the compiler reaches its limit shows nothing here");
    REQUIRE(expected.at("graded/result.json").find("took longer than") == std::string::npos);
    for (const auto& [name, bytes] : expected) {
        CAPTURE(name);
        CHECK(found.contains(name));
        CHECK((found.contains(name) && found.at(name) == bytes));
    }
}

TEST_CASE("interrupted: a disk that is full is one line and leaves the old picture") {
    const TempFolder folder;
    folder.write("a.toml", kScene);
    const std::string place = folder.path.string();
    REQUIRE(run_kreda({"render", "a.toml", "-o", "a.png"}, place).exit_code == 0);
    const std::string old = bytes_of(folder.file("a.png"));
    REQUIRE(old.size() > 1000);
    const std::string words = folder.file(".words");
    CHECK(exit_code_of(start_kreda({"render", "a.toml", "-o", "a.png", "--no-cache"}, place, 500, words)) == 2);
    CHECK(bytes_of(words) == "a.png: cannot be written: is the disk full, or the folder protected?\n");
    CHECK(bytes_of(folder.file("a.png")) == old);
    for (const Command& command : usual_commands()) {
        CAPTURE(command.args[0]);
        CHECK(exit_code_of(start_kreda(command.args, place, 500, words)) == 2);
        CHECK(bytes_of(words).find("cannot be written: is the disk full") != std::string::npos);
        check_files(place);
    }
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
