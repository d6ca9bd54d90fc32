// Submissions that mean harm (tests/grading/hostile/), in every box that works here. See hostile/README.md.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/grading/boxes.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/grade/box.hpp"
#include "tools/grade/box_files.hpp"

using namespace kreda::tests;
using namespace kreda::tools;
namespace fs = std::filesystem;

namespace {

constexpr const char* kToken = "xyzzy-the-golden-numbers";

/// What no submission may read, and where none may write, though the file system's modes would allow both.
struct Target {
    TempFolder folder;
    std::string secret = folder.write("secret.inc", std::string("// ") + kToken + "\n");
    std::string outside = folder.file("outside");

    Target() {
        fs::create_directory(outside);
        fs::permissions(outside, fs::perms::all);
        fs::permissions(folder.path, fs::perms::all);
    }
    void check_untouched() const {
        CHECK(bytes_of(secret) == std::string("// ") + kToken + "\n");
        CHECK(names_in(outside).empty());
        CHECK(names_in(folder.path.string()) == std::vector<std::string>{"outside", "secret.inc"});
        for (const char* place : {"/tmp", "/var/tmp", "/dev/shm", "/", "/usr", "/etc"})
            CHECK_FALSE(fs::exists(fs::path(place) / "kreda_hostile"));
    }
};

/// These aim at the compiler, which stops at them; the others must compile, or they would attack nothing.
const std::vector<std::string> kForTheCompiler = {"constexpr_bomb", "embed_folder",  "error_flood",
                                                  "huge_program",   "incbin_secret", "include_endless",
                                                  "include_secret", "macro_bomb",    "template_bomb"};

std::vector<fs::path> hostile_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(std::string(KREDA_SOURCE_DIR) + "/tests/grading/hostile")) {
        if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// System V's shared memory and message queues: how many lines the kernel lists.
int shared_things() {
    return line_count(bytes_of("/proc/sysvipc/shm")) + line_count(bytes_of("/proc/sysvipc/msg"));
}

void check_quiet(const BoxOutcome& outcome, const BoxLimits& limits) {
    CAPTURE(describe(outcome, limits));
    CAPTURE(outcome.out.substr(0, 400));
    CHECK(outcome.out.find(kToken) == std::string::npos);
    CHECK(outcome.err.find(kToken) == std::string::npos);
    CHECK(outcome.out.find("leak:") == std::string::npos);
    CHECK(outcome.out.size() + outcome.err.size() <= 2 * limits.output_bytes + 2);
    CHECK(outcome.wall_seconds < limits.wall_seconds + 2.0);  // a busy machine needs a while to kill
    CHECK(outcome.end != BoxOutcome::End::could_not_start);
}

/// Compile and run one of them as a submission is; what can be seen of it is checked.
void attack(const fs::path& file, BoxTier tier, const Target& target) {
    std::string box_path;
    {
        const BoxFolder box;
        box_path = box.path().string();
        const fs::path given = box.path() / "given", compile = box.path() / "compile", work = box.path() / "work";
        for (const fs::path& folder : {given, compile, work}) fs::create_directory(folder);
        std::ofstream(given / "student.cpp")
            << "#define SECRET \"" << target.secret << "\"\n#define OUTSIDE \"" << target.outside << "\"\n"
            << bytes_of(file.string()) << "\nint main() { return attack() > 2.0f; }\n";
        BoxRequest build{{"/usr/bin/g++", "-std=c++20", "-w", (given / "student.cpp").string(), "-o", "program"},
                         {given},
                         compile,
                         {4.0, 15.0, std::uint64_t(1) << 30, std::uint64_t(32) << 20, 16},
                         tier};
        const BoxOutcome built = run_in_box(build, false);
        check_quiet(built, build.limits);
        CHECK_FALSE(lives(box_path));
        const bool is_built = built.end == BoxOutcome::End::exited && built.code == 0;
        const std::string name = file.stem().string();
        if (std::find(kForTheCompiler.begin(), kForTheCompiler.end(), name) == kForTheCompiler.end()) CHECK(is_built);
        const BoxedFile program = read_boxed_file(compile / "program", build.limits.output_bytes);
        if (is_built && program.problem.empty()) {
            std::ofstream(given / "program", std::ios::binary) << program.bytes;
            chmod((given / "program").c_str(), 0755);
            BoxRequest run{{(given / "program").string()},
                           {given / "program"},
                           work,
                           {1.0, 1.5, std::uint64_t(256) << 20, std::uint64_t(4) << 20, 1},
                           tier};
            const BoxOutcome ran = run_in_box(run, false);
            check_quiet(ran, run.limits);
            CHECK_FALSE(lives(box_path));
            CHECK(read_boxed_file(work / "outputs.bin", 1 << 20).bytes.find(kToken) == std::string::npos);
        }
    }
    CHECK_FALSE(fs::exists(box_path));
    target.check_untouched();
}

/// All of them, one after the other, each in the box that box_of(its number) names.
template <class BoxOf>
void attack_all(const BoxOf& box_of) {
    const std::vector<fs::path> files = hostile_files();
    CHECK(files.size() >= 25);
    const int shared_before = shared_things();
    const Target target;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string name = files[i].stem().string(), box = name_of(box_of(i));
        CAPTURE(name);
        CAPTURE(box);
        attack(files[i], box_of(i), target);
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));  // late_writer writes after 0.7 s
    target.check_untouched();
    CHECK(shared_things() == shared_before);
}

}  // namespace

// CTest runs this one alone ("grading: hostile submissions do no harm").
TEST_CASE("hostile: each does no harm in one of the boxes" * doctest::skip()) {
    std::vector<BoxTier> boxes;
    for (const BoxTier tier : {BoxTier::bubblewrap, BoxTier::landlock}) {
        if (can_box(tier)) boxes.push_back(tier);
    }
    if (!boxes.empty()) attack_all([&](std::size_t i) { return boxes[i % boxes.size()]; });
}

// Rare: twice as many.
TEST_CASE("hostile submissions do no harm in bubblewrap" * doctest::skip()) {
    if (can_box(BoxTier::bubblewrap)) attack_all([](std::size_t) { return BoxTier::bubblewrap; });
}

TEST_CASE("hostile submissions do no harm behind Landlock" * doctest::skip()) {
    if (can_box(BoxTier::landlock)) attack_all([](std::size_t) { return BoxTier::landlock; });
}

TEST_CASE("hostile: the target can be harmed without a box") {
    // Otherwise the tests above would show nothing.
    const Target target;
    CHECK(bytes_of(target.secret).find(kToken) != std::string::npos);
    const BoxFolder work;
    BoxRequest request{{"/bin/sh", "-c", "cat " + target.secret + "; echo x > " + target.outside + "/mine"},
                       {},
                       work.path(),
                       {1.0, 5.0, std::uint64_t(1) << 30, 1 << 20, 8},
                       BoxTier::unsafe};
    const BoxOutcome outcome = run_in_box(request, true);
    CHECK(outcome.out.find(kToken) != std::string::npos);
    CHECK(names_in(target.outside) == std::vector<std::string>{"mine"});
}
