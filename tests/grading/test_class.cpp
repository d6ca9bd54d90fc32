// A class: several submissions at a time, killed and resumed, and what is said of all together.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene/error.hpp"
#include "tests/grading/boxes.hpp"
#include "tests/grading/sample_result.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"
#include "tools/grade/class_result.hpp"
#include "tools/grade/parallel.hpp"
#include "tools/grade/result_formats.hpp"
#include "tools/grade/submission_files.hpp"

using namespace kreda::tests;
using namespace kreda::tools;
namespace fs = std::filesystem;

namespace {

const std::string kA3 = std::string(KREDA_SOURCE_DIR) + "/examples/assignments/A3_lights";

std::string solution() {
    return bytes_of(kA3 + "/teacher/solution.cpp");
}

GradeResult result_of(const std::string& name, double points, const std::string& diagnosis) {
    GradeResult result;
    result.assignment = "A1";
    result.submission = name;
    result.points = points;
    result.max_points = 4.0;
    result.diagnosis = diagnosis;
    result.tests = {{"easy", "", points > 1.0 ? 2.0 : 0.0, 2.0, points > 1.0, false, "", {}, {}, ""},
                    {"hard", "", points > 3.0 ? 2.0 : 0.0, 2.0, points > 3.0, false, "", {}, {}, ""}};
    return result;
}

const std::vector<GradeResult> kClass = {result_of("a", 0.0, "unknown"), result_of("b", 2.0, "affine\nat (1, 2)"),
                                         result_of("c", 2.0, "affine\nat (3, 4)"), result_of("d", 4.0, "")};

pid_t start_kreda(const std::vector<std::string>& args) {
    std::vector<std::string> words{KREDA_PROGRAM};
    words.insert(words.end(), args.begin(), args.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    dup2(nowhere, 2);
    execv(arguments[0], arguments.data());
    _exit(127);
}

/// A3 with limits that a solution keeps and that endless submissions reach soon.
std::string impatient_rubric(const TempFolder& folder) {
    const fs::path given = fs::path(kA3).parent_path(), copy = folder.path / "given";
    fs::create_directories(copy);
    for (const char* file : {"harness.hpp", "main.cpp"}) fs::copy_file(given / file, copy / file);
    fs::copy(kA3, copy / "A3_lights", fs::copy_options::recursive);
    std::string rubric = bytes_of(kA3 + "/rubric.toml");
    const auto replace = [&](const std::string& from, const std::string& to) {
        REQUIRE(rubric.find(from) != std::string::npos);
        rubric.replace(rubric.find(from), from.size(), to);
    };
    replace("[compile]\ncpu_seconds = 20\n", "[compile]\ncpu_seconds = 6\n");
    replace("[run]\ncpu_seconds = 4\n", "[run]\ncpu_seconds = 1\n");
    return folder.write("given/A3_lights/rubric.toml", rubric);
}

int results_in(const fs::path& out) {
    int count = 0;
    std::error_code absent;
    for (fs::directory_iterator at(out, absent), end; !absent && at != end; at.increment(absent))
        count += fs::exists(at->path() / "result.json") ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("class: counts of a small class by hand") {
    CHECK(failures_of_tests(kClass) == Counts{{"hard", 3}, {"easy", 1}});
    CHECK(diagnoses(kClass) == Counts{{"affine", 2}, {"unknown", 1}});
    CHECK(histogram(kClass) == std::vector<std::size_t>{1, 0, 0, 0, 0, 2, 0, 0, 0, 1});
    CHECK(class_csv(kClass) ==
          "submission,points,max_points,easy,hard,diagnosis,box,error\r\n"
          "a,0,4,0,0,unknown,none,\r\nb,2,4,2,0,affine,none,\r\nc,2,4,2,0,affine,none,\r\nd,4,4,2,2,,none,\r\n");
}

TEST_CASE("class: a mistake is counted once, equal or alike; the page says only where it is alike") {
    const std::vector<GradeResult> some = {result_of("a", 1.0, "looks exactly like: affine (page 13)\nmore"),
                                           result_of("b", 1.0, "looks like: affine (page 13)"),
                                           result_of("c", 1.0, "unknown")};
    CHECK(diagnoses(some) == Counts{{"affine (page 13)", 2}, {"unknown", 1}});
    const std::string page = class_html(some, {});
    CHECK(page.find("exactly like") == std::string::npos);
    CHECK(page.find("<td>looks like: affine (page 13)</td>") != std::string::npos);
    CHECK(page.find("<td>affine (page 13)</td>") != std::string::npos);
}

TEST_CASE("class: a field of the CSV is neither a formula nor several fields") {
    std::vector<GradeResult> one = {result_of("=cmd|' /C calc'!A0", 1.0, "a, \"b\"\nc")};
    const std::string csv = class_csv(one);
    CHECK(csv.find("\r\n =cmd|' /C calc'!A0,1,4,") != std::string::npos);
    CHECK(csv.find(",\"a, \"\"b\"\"\",none,") != std::string::npos);
}

TEST_CASE("class: the overview links every report and shows identical submissions") {
    const std::string page = class_html(kClass, {{"b", "c"}});
    for (const char* name : {"a", "b", "c", "d"})
        CHECK(page.find("href=\"" + std::string(name) + "/report.html\"") != std::string::npos);
    CHECK(page.find("<li>b, c</li>") != std::string::npos);
    CHECK(page.find("50 % of the points") != std::string::npos);  // (0 + 2 + 2 + 4) / 16
    CHECK(page.find("jplag") != std::string::npos);
    CHECK(page.find("dolos run") != std::string::npos);
}

TEST_CASE("class: identical to the byte means names and contents but no hidden files") {
    const TempFolder folder;
    folder.write("a/student.cpp", "one");
    folder.write("b/student.cpp", "one");
    folder.write("b/.git/index", "other");
    folder.write("c/student.cpp", "two");
    folder.write("d/other.cpp", "one");
    folder.write("e/student.cpp", "two");
    CHECK(identical_submissions(folder.path, {"a", "b", "c", "d", "e"}) ==
          std::vector<std::vector<std::string>>{{"a", "b"}, {"c", "e"}});
    CHECK(submissions_in(folder.path) == std::vector<std::string>{"a", "b", "c", "d", "e"});
    CHECK_THROWS_AS(static_cast<void>(submissions_in(folder.path / "a")), kreda::scene::UserError);
    CHECK_THROWS_AS(static_cast<void>(submissions_in(folder.path / "none")), kreda::scene::UserError);
}

TEST_CASE("class: jobs run side by side and their ends are told") {
    const TempFolder folder;
    std::vector<ParallelJob> jobs;
    for (const char* what : {"exit 0", "exit 3", "kill -9 $$", "sleep 100", "sleep 0.3", "sleep 0.3"})
        jobs.push_back({{"/bin/sh", "-c", what}, folder.path / "log"});
    std::vector<std::string> why(jobs.size(), "not told");
    const auto begin = std::chrono::steady_clock::now();
    run_parallel(jobs, 6, 2.0, [&](std::size_t i, const std::string& reason) { why[i] = reason; });
    CHECK(why ==
          std::vector<std::string>{"", "exit code 3", "was ended by signal Killed", "took longer than 2 s", "", ""});
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < 20.0);
}

TEST_CASE("class: a killed run leaves no process and goes on where it was") {
    const TempFolder folder;
    const int count = 4;
    for (int i = 0; i < count; ++i)
        folder.write("class/s" + std::to_string(i) + "/student.cpp", solution() + "// " + std::to_string(i) + "\n");
    const std::string out = folder.file("out");
    const std::vector<std::string> args = {
        "grade",  "--class", folder.file("class"), "--rubric", kA3 + "/rubric.toml", "-o", out,
        "--jobs", "1",       "--formats",          "none"};
    const pid_t first = start_kreda(args);
    for (int i = 0; i < 1200 && results_in(out) == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(first, SIGKILL);
    waitpid(first, nullptr, 0);
    const int before = results_in(out);
    CHECK(before >= 1);
    CHECK(before < count);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    CHECK_FALSE(lives(folder.file("class")));

    const Outcome second = run_kreda(args, folder.path.string());
    CHECK(second.exit_code == 0);
    // The one that was being graded may have ended between the count and the kill.
    CHECK(second.out.find("4 submissions: ") == 0);
    CHECK(second.out.find("0 graded now") == std::string::npos);
    CHECK(line_count(bytes_of(out + "/results.csv")) == 1 + count);
    CHECK(results_in(out) == count);
    CHECK(run_kreda(args, folder.path.string()).out == "4 submissions: 0 graded now, 4 before\n");

    folder.write("class/s3/student.cpp", "no C++");  // what was changed is graded again, and only that
    CHECK(run_kreda(args, folder.path.string()).out == "4 submissions: 1 graded now, 3 before\n");
    const StoredResult broken = read_result_json(bytes_of(out + "/s3/result.json"), "s3");
    CHECK(broken.result.points == 0.0);
    CHECK(broken.result.error.find("does not compile") != std::string::npos);
    CHECK(read_result_json(bytes_of(out + "/s1/result.json"), "s1").result.points > 0.0);
}

TEST_CASE("class: the script for GNU parallel grades each once and again none") {
    if (!fs::exists("/usr/bin/parallel")) {
        MESSAGE("SKIPPED: GNU parallel is not installed");
        return;
    }
    const TempFolder folder;
    for (const char* name : {"it's", "c d"})
        folder.write("class/" + std::string(name) + "/student.cpp", solution() + "// " + name + "\n");
    const std::vector<std::string> command = {"KREDA=" KREDA_PROGRAM,
                                              std::string(KREDA_SOURCE_DIR) + "/tools/grade/cluster/grade_parallel.sh",
                                              folder.file("class"),
                                              kA3 + "/rubric.toml",
                                              folder.file("out"),
                                              "--formats",
                                              "none"};
    const Outcome first = run_program("/usr/bin/env", command, folder.path.string());
    CAPTURE(first.err);
    CHECK(first.exit_code == 0);
    CHECK(first.out == "2 submissions: 0 graded now, 2 before\n");  // by parallel, then the overview
    const auto written = fs::last_write_time(folder.file("out/c d/result.json"));
    CHECK(run_program("/usr/bin/env", command, folder.path.string()).out == first.out);
    CHECK(fs::last_write_time(folder.file("out/c d/result.json")) == written);
}

TEST_CASE("class of hostile submissions: each has 0 points and the others theirs" * doctest::skip()) {
    // CTest runs it by itself ("grading: a class of hostile submissions"): it takes a minute or two.
    const TempFolder folder;
    const std::string secret = folder.write("secret.inc", "// xyzzy-the-golden-numbers\n");
    fs::create_directory(folder.file("outside"));
    fs::permissions(folder.file("outside"), fs::perms::all);
    const std::string stub = bytes_of(kA3 + "/student.cpp");
    const std::string call = "(void)a, (void)d;\n    return 0.0f;";
    REQUIRE(stub.find(call) != std::string::npos);
    std::string attacking = stub;
    attacking.replace(stub.find(call), call.size(), "(void)a, (void)d;\n    return attack();");
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(std::string(KREDA_SOURCE_DIR) + "/tests/grading/hostile")) {
        if (entry.path().extension() != ".cpp") continue;
        folder.write("class/" + entry.path().stem().string() + "/student.cpp",
                     "#define SECRET \"" + secret + "\"\n#define OUTSIDE \"" + folder.file("outside") +
                         "\"\nfloat attack();\n" + attacking + bytes_of(entry.path().string()));
        ++count;
    }
    folder.write("class/zz_right/student.cpp", solution());
    const Outcome outcome = run_kreda(
        {"grade", "--class", folder.file("class"), "--rubric", impatient_rubric(folder), "-o", folder.file("out")},
        folder.path.string());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out ==
          std::to_string(count + 1) + " submissions: " + std::to_string(count + 1) + " graded now, 0 before\n");
    for (const std::string& name : submissions_in(folder.path / "class")) {
        CAPTURE(name);
        const std::string text = bytes_of(folder.file("out/" + name + "/result.json"));
        const GradeResult result = read_result_json(text, name).result;
        CHECK(result.points == (name == "zz_right" ? result.max_points : 0.0));
        CHECK(text.find("xyzzy") == std::string::npos);
        CHECK(bytes_of(folder.file("out/" + name + "/report.html")).find("xyzzy") == std::string::npos);
    }
    CHECK(names_in(folder.file("outside")).empty());
    CHECK(bytes_of(secret) == "// xyzzy-the-golden-numbers\n");
    CHECK_FALSE(lives(folder.file("class")));
}
