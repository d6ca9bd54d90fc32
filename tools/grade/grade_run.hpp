// Grading one submission, or a class of them: what the command line asks for becomes files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/grade/result.hpp"

namespace kreda::tools {

/// What `kreda grade` was asked to do.
struct GradeRun {
    std::filesystem::path folder;  ///< of the submission, or of the class
    std::filesystem::path rubric;
    std::filesystem::path out;
    std::vector<std::string> formats;  ///< of grade_formats()
    GradeOptions options;
    int jobs = 0;                 ///< of a class: submissions at a time; 0: one a core
    double most_seconds = 600.0;  ///< of a class: a grader that takes longer is ended
};

/// "gradescope", "prairielearn", "classroom", "vpl", "junit"
[[nodiscard]] const std::vector<std::string>& grade_formats();

/// Names what is graded, by what and for what: equal keys give equal results.
[[nodiscard]] std::string grade_key(const GradeRun& run);

/// Write the reports and results of one submission; result.json, which says that all is there, comes last. Throws
/// UserError.
void write_results(const GradeRun& run, const GradeResult& result);

/// The result in run.out, if it is one of this key.
[[nodiscard]] std::optional<GradeResult> result_of_before(const GradeRun& run);

/// Grade the submission and write; what it got.
GradeResult grade_one(const GradeRun& run);

/// What became of a class.
struct ClassSummary {
    std::size_t submissions = 0;
    std::size_t graded = 0;  ///< now; the others were graded before
    std::size_t failed = 0;  ///< graders that ended without a result: a fault of ours or of the machine
};

/// Grade every folder in run.folder that has no result of the same key in run.out yet, each by a process of its own,
/// and write results.csv and index.html. Nothing that a submission does ends it. Throws UserError.
ClassSummary grade_class(const GradeRun& run);

}  // namespace kreda::tools
