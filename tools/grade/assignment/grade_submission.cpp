#include "tools/grade/assignment/grade_submission.hpp"

#include <chrono>

#include "tools/grade/assignment/viva.hpp"

namespace kreda::tools {

namespace {

/// The command that repeats a test on the student's machine.
std::string command_of(const Rubric& rubric, const std::filesystem::path& folder) {
    return "kreda grade " + folder.string() + " --rubric " + rubric.file.string();
}

void grade_answers(const Rubric& rubric, const CaseSet& cases, const Answers& answers, GradeResult& result) {
    const Marking marking = make_marking(rubric, cases, answers);
    result.tests = score(marking, true);
    if (points_of(result.tests) == max_points_of(result.tests)) return;
    if (std::filesystem::exists(rubric.folder() / "teacher" / "mistakes.toml")) {  // students have no catalogue
        const Catalogue catalogue = make_catalogue(rubric, cases);
        result.diagnosis = diagnosis_text(diagnose(marking, catalogue), catalogue);
    }
    const std::string first = first_wrong_stage(marking);
    if (!first.empty()) result.diagnosis += (result.diagnosis.empty() ? "" : "\n") + first;
}

void add_viva(const Rubric& rubric, const CaseSet& cases, const std::filesystem::path& folder, const Answers& answers,
              const GradeOptions& options, GradeResult& result) {
    const auto questions = make_viva(rubric, cases, folder, answers, options.viva, options);
    const std::string title = result.assignment + ": questions to " + result.submission;
    result.viva = viva_sheet(title, questions);
    result.viva_key = viva_key(title, questions);
}

/// Without a program every test has 0 points.
void grade_nothing(const Rubric& rubric, const CaseSet& cases, GradeResult& result) {
    Answers answers{std::vector<StageTable>(cases.inputs.size()),
                    std::vector<std::string>(cases.inputs.size(), "there is no program to test")};
    result.tests = score(make_marking(rubric, cases, answers), false);
}

}  // namespace

GradeResult grade_submission(const Rubric& rubric, const CaseSet& cases, const std::filesystem::path& folder,
                             const GradeOptions& options, const CompileOptions& compile) {
    const auto begin = std::chrono::steady_clock::now();
    GradeResult result;
    result.assignment = rubric.assignment + " " + rubric.title;
    result.submission = std::filesystem::absolute(folder / "").parent_path().filename().string();
    result.deadline = rubric.deadline;
    const BoxFolder box;
    const Program program = compile_submission(rubric, folder, box, options, compile);
    result.tier = program.tier;
    result.error = program.error;
    if (program.file.empty()) {
        grade_nothing(rubric, cases, result);
    } else {
        const Answers answers = run_submission(rubric, program, cases, options);
        grade_answers(rubric, cases, answers, result);
        if (options.viva > 0) add_viva(rubric, cases, folder, answers, options, result);
    }
    for (TestResult& test : result.tests) {
        if (!test.hidden) test.command = command_of(rubric, folder);
    }
    result.points = points_of(result.tests);
    result.max_points = max_points_of(result.tests);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

GradeResult grade_submission(const Rubric& rubric, const std::filesystem::path& folder, const GradeOptions& options) {
    return grade_submission(rubric, make_cases(rubric, options.hidden), folder, options);
}

}  // namespace kreda::tools
