// The box's limits and its words, in every tier that works here; test_hostile.cpp attacks it.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "tests/grading/boxes.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/grade/box.hpp"
#include "tools/grade/box_files.hpp"
#include "tools/grade/box_landlock.hpp"

using namespace kreda::tests;
using namespace kreda::tools;
using End = BoxOutcome::End;

namespace {

const std::vector<BoxTier> kTiers = {BoxTier::bubblewrap, BoxTier::landlock, BoxTier::unsafe};

/// A shell in a box with room for a few processes and 2 s.
BoxOutcome shell(BoxTier tier, const BoxFolder& work, const std::string& script, BoxLimits limits) {
    return run_in_box({{"/bin/sh", "-c", script}, {}, work.path(), limits, tier}, true);
}

BoxLimits small(int processes) {
    return {1.0, 2.0, std::uint64_t(256) << 20, 1 << 20, processes};
}

}  // namespace

TEST_CASE("box: exit codes and what is printed come back and the surroundings are always the same") {
    for (const BoxTier tier : kTiers) {
        if (!can_box(tier)) continue;
        CAPTURE(name_of(tier));
        const BoxFolder work;
        const BoxOutcome outcome = shell(tier, work, "echo out; echo err >&2; echo file > f; exit 7", small(1));
        CHECK(outcome.end == End::exited);
        CHECK(outcome.code == 7);
        CHECK(outcome.out == "out\n");
        CHECK(outcome.err == "err\n");
        CHECK(outcome.tier == tier);
        CHECK(read_boxed_file(work.path() / "f", 100).bytes == "file\n");
        const std::string here = work.path().string();
        CHECK(shell(tier, work, "echo $PATH:$HOME:$TMPDIR:$LANG:$USER:$KREDA_SHARED; pwd", small(1)).out ==
              "/usr/bin:/bin:" + here + ":" + here + ":C.UTF-8::\n" + here + "\n");
    }
}

TEST_CASE("box: what goes beyond a limit is told by its name") {
    for (const BoxTier tier : kTiers) {
        if (!can_box(tier)) continue;
        CAPTURE(name_of(tier));
        const BoxFolder work;
        CHECK(shell(tier, work, "exec sleep 100", small(1)).end == End::timed_out);
        BoxLimits patient = small(1);
        patient.wall_seconds = 20.0;  // the second of the processor ends first
        CHECK(shell(tier, work, "while :; do :; done", patient).end == End::timed_out);
        CHECK(shell(tier, work, "exec yes", small(1)).end == End::too_much_output);
        CHECK(shell(tier, work, "exec head -c 2000000 /dev/zero > large", small(1)).end == End::too_much_output);
        const BoxFolder several;
        const std::string files = "for i in 1 2 3 4 5; do head -c 400000 /dev/zero > f$i; done";
        CHECK(shell(tier, several, files, small(8)).end == End::too_much_output);
        const BoxOutcome memory = shell(tier, work, "exec tail /dev/zero", small(1));
        CHECK(memory.end != End::timed_out);
        CHECK(memory.code != 0);
    }
}

TEST_CASE("box: a program may not start another but a compiler may") {
    for (const BoxTier tier : {BoxTier::bubblewrap, BoxTier::landlock}) {
        if (!can_box(tier)) continue;
        CAPTURE(name_of(tier));
        const BoxFolder work;
        CHECK(shell(tier, work, "/bin/true && echo yes", small(1)).out == "");
        CHECK(shell(tier, work, "/bin/true && echo yes", small(8)).out == "yes\n");
    }
}

TEST_CASE("box: what cannot start says why") {
    for (const BoxTier tier : kTiers) {
        if (!can_box(tier)) continue;
        CAPTURE(name_of(tier));
        const BoxFolder work;
        const BoxOutcome none = run_in_box({{"/no/program"}, {}, work.path(), small(1), tier}, true);
        CHECK(none.end == End::could_not_start);
        CHECK(none.err.find("/no/program") != std::string::npos);
        const BoxOutcome absent = run_in_box({{"/bin/true"}, {"/no/file"}, work.path(), small(1), tier}, true);
        CHECK(absent.end == End::could_not_start);
        CHECK(describe(absent, small(1)).find("/no/file") != std::string::npos);
    }
}

TEST_CASE("box: without a box nothing is run unless it is asked for") {
    const BoxFolder work;
    const BoxRequest request{{"/bin/true"}, {}, work.path(), small(1), BoxTier::unsafe};
    CHECK_THROWS_AS(static_cast<void>(run_in_box(request, false)), kreda::scene::UserError);
    CHECK(run_in_box(request, true).tier == BoxTier::unsafe);
}

TEST_CASE("box: a kernel with Landlock has a box") {
    if (landlock_version() > 0) CHECK(strongest_tier().has_value());
}

TEST_CASE("box: only a plain file with one name and of a bounded size is read") {
    const TempFolder folder;
    folder.write("plain", "12345");
    std::filesystem::create_symlink("plain", folder.file("link"));
    std::filesystem::create_directory(folder.file("folder"));
    CHECK(read_boxed_file(folder.file("plain"), 5).bytes == "12345");
    CHECK(read_boxed_file(folder.file("plain"), 4).problem == "is larger than 4 bytes");
    CHECK(read_boxed_file(folder.file("link"), 5).problem == "is a link");
    CHECK(read_boxed_file(folder.file("folder"), 5).problem == "is no plain file");
    CHECK(read_boxed_file(folder.file("none"), 5).problem == "is absent");
    std::filesystem::create_hard_link(folder.file("plain"), folder.file("second"));
    CHECK(read_boxed_file(folder.file("plain"), 5).problem == "has a second name");
}
