// The class run of grade_run.hpp.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <set>
#include <thread>

#include "scene/error.hpp"
#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/class_result.hpp"
#include "tools/grade/grade_run.hpp"
#include "tools/grade/parallel.hpp"
#include "tools/grade/result_formats.hpp"
#include "tools/grade/submission_files.hpp"
#include "tools/progress_bar.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNoResult = "no result: ";  ///< the key of what is to be graded again

GradeRun run_of(const GradeRun& run, const std::string& name) {
    GradeRun one = run;
    one.folder = run.folder / name;
    one.out = run.out / name;
    return one;
}

std::optional<StoredResult> stored_result(const fs::path& out) {
    const fs::path file = out / "result.json";
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        return read_result_json(text, file.string());
    } catch (const scene::UserError&) {
        return std::nullopt;  // another version, or no result: it is graded again
    }
}

/// This program, asked for one submission.
ParallelJob job_of(const GradeRun& one) {
    std::vector<std::string> words = {fs::read_symlink("/proc/self/exe").string(),
                                      "grade",
                                      one.folder.string(),
                                      "--rubric",
                                      one.rubric.string(),
                                      "-o",
                                      one.out.string()};
    for (const fs::path& hidden : one.options.hidden) {
        words.push_back("--hidden");
        words.push_back(hidden.string());
    }
    words.push_back("--formats");
    std::string formats;
    for (const std::string& format : one.formats) formats += (formats.empty() ? "" : ",") + format;
    words.push_back(formats.empty() ? "none" : formats);
    if (one.options.allow_unsafe) words.push_back("--unsafe");
    if (one.options.tier) {
        words.push_back("--box");
        words.push_back(name_of(*one.options.tier));
    }
    return {words, one.out / "grader.txt"};
}

std::string last_line_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string last;
    for (std::string line; std::getline(stream, line);) last = line.empty() ? last : line;
    return last;
}

/// What stands in the table for a submission whose grader broke off.
void write_failure(const GradeRun& one, const std::string& why) {
    GradeResult result;
    result.submission = one.folder.filename().string();
    result.error = "the grader broke off (" + why + "): " + last_line_of(one.out / "grader.txt");
    write_file((one.out / "result.json").string(), result_json(result, kNoResult + why));
}

/// A submission that could not be graded has the assignment and the points of the others.
void complete(std::vector<GradeResult>& results) {
    const auto whole = std::find_if(results.begin(), results.end(), [](const auto& r) { return r.max_points > 0.0; });
    if (whole == results.end()) return;
    const std::string assignment = whole->assignment;
    const double max_points = whole->max_points;
    for (GradeResult& result : results) {
        if (result.max_points > 0.0) continue;
        result.assignment = assignment;
        result.max_points = max_points;
    }
}

void write_overview(const GradeRun& run, const std::vector<std::string>& names) {
    std::vector<GradeResult> results;
    for (const std::string& name : names) {
        std::optional<StoredResult> stored = stored_result(run.out / name);
        if (!stored) continue;
        stored->result.submission = name;
        results.push_back(stored->result);
    }
    complete(results);
    write_file((run.out / "results.csv").string(), class_csv(results));
    write_file((run.out / "index.html").string(), class_html(results, identical_submissions(run.folder, names)));
}

int jobs_of(const GradeRun& run) {
    return run.jobs > 0 ? run.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

ClassSummary grade_class(const GradeRun& wish) {
    GradeRun run = wish;
    run.folder = fs::absolute(run.folder);
    run.rubric = fs::absolute(run.rubric);
    run.out = fs::absolute(run.out);
    for (fs::path& hidden : run.options.hidden) hidden = fs::absolute(hidden);
    static_cast<void>(read_rubric(run.rubric));  // what is wrong with it is said once, not for each submission
    const std::vector<std::string> names = submissions_in(run.folder);
    make_folder(run.out.string());
    remove_stale_box_folders();
    ClassSummary summary{names.size(), 0, 0};
    std::vector<GradeRun> open;
    std::vector<ParallelJob> jobs;
    for (const std::string& name : names) {
        const GradeRun one = run_of(run, name);
        if (result_of_before(one)) continue;
        make_folder(one.out.string());
        std::error_code ignored;
        fs::remove(one.out / "result.json", ignored);
        open.push_back(one);
        jobs.push_back(job_of(one));
    }
    ProgressBar bar("grading " + std::to_string(names.size()) + " submissions");
    const std::size_t before = names.size() - open.size();
    run_parallel(jobs, jobs_of(run), run.most_seconds, [&](std::size_t i, const std::string& why) {
        const bool is_graded = stored_result(open[i].out).has_value();
        if (!is_graded) write_failure(open[i], why.empty() ? "without a word" : why);
        ++(is_graded ? summary.graded : summary.failed);
        bar.show(double(before + summary.graded + summary.failed) / double(names.size()));
    });
    bar.clear();
    write_overview(run, names);
    return summary;
}

}  // namespace kreda::tools
