#include "tools/grade/assignment/rubric.hpp"

#include <set>

#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/table_reader.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

RubricStage read_stage(const scene::Value& table) {
    TableReader reader(table, "[[stage]]");
    RubricStage stage;
    reader.require("name");
    reader.read("name", stage.name);
    reader.read("formula", stage.formula);
    reader.read("page", stage.page);
    reader.read("equation", stage.equation, 0, 99);
    reader.read("absolute", stage.absolute, 0.0, 1.0);
    reader.read("relative", stage.relative, 0.0, 1.0);
    reader.read("calls", stage.calls);
    reader.read("picture", stage.picture);
    reader.read("encoded", stage.encoded);
    reader.done();
    return stage;
}

RubricTest read_test(const scene::Value& table, const Rubric& rubric) {
    TableReader reader(table, "[[test]]");
    RubricTest test;
    reader.require("name");
    reader.require("stage");
    reader.read("name", test.name);
    reader.read("teaches", test.teaches);
    reader.read("stage", test.stage);
    reader.read("scene", test.scene);
    reader.read("points", test.points, 0.0, 1000.0);
    reader.read("hidden", test.hidden);
    reader.read("work", test.work);
    reader.read("most_work", test.most_work, 0.0, 1e6);
    reader.done();
    if (rubric.find_stage(test.stage) == nullptr) {
        reader.complain("stage", "there is no [[stage]] of the name " + scene::in_quotes(test.stage));
    }
    bool is_there = test.scene.empty();
    for (const fs::path& scene : rubric.scenes) is_there = is_there || scene.stem() == test.scene;
    if (!is_there) reader.complain("scene", "no file of 'scenes' is named " + test.scene + ".toml");
    return test;
}

void read_limits(const scene::Value* table, BoxLimits& limits, const std::string& what) {
    if (table == nullptr) return;
    TableReader reader(*table, what);
    double memory_mb = static_cast<double>(limits.memory_bytes) / (1 << 20);
    double output_mb = static_cast<double>(limits.output_bytes) / (1 << 20);
    reader.read("cpu_seconds", limits.cpu_seconds, 0.1, 3600.0);
    reader.read("wall_seconds", limits.wall_seconds, 0.1, 3600.0);
    reader.read("memory_mb", memory_mb, 16.0, 65536.0);
    reader.read("output_mb", output_mb, 1.0, 4096.0);
    reader.read("processes", limits.processes, 1, 256);
    reader.done();
    limits.memory_bytes = static_cast<std::uint64_t>(memory_mb) << 20;
    limits.output_bytes = static_cast<std::uint64_t>(output_mb) << 20;
}

void read_picture_limits(const scene::Value* table, CompareLimits& limits) {
    if (table == nullptr) return;
    TableReader reader(*table, "[picture]");
    reader.read("differing_percent", limits.differing_percent, 0.0, 100.0);
    reader.read("more_than_a_step", limits.more_than_a_step, 0, 1 << 28);
    reader.read("blob", limits.blob, 0, 1 << 28);
    reader.done();
}

}  // namespace

const RubricStage* Rubric::find_stage(const std::string& name) const {
    for (const RubricStage& stage : stages) {
        if (stage.name == name) return &stage;
    }
    return nullptr;
}

Rubric read_rubric(const fs::path& file) {
    const scene::Value root = scene::parse_toml(read_text(file.string()), file.string());
    TableReader reader(root, "the rubric");
    Rubric rubric;
    rubric.file = fs::absolute(file);
    rubric.compile = {20.0, 60.0, std::uint64_t(2) << 30, std::uint64_t(64) << 20, 16};
    rubric.run = {10.0, 30.0, std::uint64_t(1) << 30, std::uint64_t(64) << 20, 1};
    std::vector<std::string> scenes;
    for (const char* key : {"assignment", "title", "scenes", "stage", "test"}) reader.require(key);
    reader.read("assignment", rubric.assignment);
    reader.read("title", rubric.title);
    reader.read("deadline", rubric.deadline);
    reader.read("student_file", rubric.student_file);
    reader.read("scenes", scenes);
    if (find_assignment(rubric.assignment) == nullptr) reader.complain("assignment", "expected \"A1\" to \"A8\"");
    if (fs::path(rubric.student_file).filename() != rubric.student_file) {
        reader.complain("student_file", "expected the name of a file, without folders");
    }
    for (const std::string& scene : scenes) rubric.scenes.push_back(rubric.folder() / scene);
    for (const scene::Value* stage : reader.tables("stage")) rubric.stages.push_back(read_stage(*stage));
    std::set<std::string> names;
    for (const scene::Value* test : reader.tables("test")) {
        rubric.tests.push_back(read_test(*test, rubric));
        if (!names.insert(rubric.tests.back().name).second) {
            throw scene::UserError(test->place, "two tests have the name '" + rubric.tests.back().name + "'");
        }
    }
    read_picture_limits(reader.table("picture"), rubric.picture);
    read_limits(reader.table("compile"), rubric.compile, "[compile]");
    read_limits(reader.table("run"), rubric.run, "[run]");
    reader.done();
    return rubric;
}

}  // namespace kreda::tools
