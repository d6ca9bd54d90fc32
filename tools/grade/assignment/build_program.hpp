// From a student's file to answers: compiled with the harness, run on the rows, read back.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/assignment/score.hpp"
#include "tools/grade/result.hpp"

namespace kreda::tools {

/// What lies beside every submission: the harness and the assignment's own header and stages.
struct GivenFiles {
    std::filesystem::path harness, main, assignment, stages;
};
[[nodiscard]] GivenFiles given_files(const Rubric& rubric);

/// The objects of main.cpp and stages.cpp, compiled once for all submissions.
struct GivenObjects {
    std::filesystem::path main, stages;
};
[[nodiscard]] GivenObjects given_objects(const Rubric& rubric);

/// How a student's file is compiled; tests try others.
struct CompileOptions {
    std::string compiler = "/usr/bin/g++";
    std::vector<std::string> flags = {"-O1", "-ffp-contract=off"};
};

/// The compiled submission, or why there is none.
struct Program {
    std::filesystem::path folder;  ///< its work folder, of the BoxFolder that was given
    std::filesystem::path file;    ///< the program; empty: `error`
    std::string error;
    std::optional<BoxTier> tier;  ///< empty: nothing was run
};

/// Compile the student's file in the box. Reads nothing else of the submission.
[[nodiscard]] Program compile_submission(const Rubric& rubric, const std::filesystem::path& submission,
                                         const BoxFolder& box, const GradeOptions& options,
                                         const CompileOptions& compile = {});

/// Run it in the box on the public tables, then on the hidden ones, and decode what it wrote. Where it breaks off,
/// every remaining function gets a run of its own, so that one crash costs one function.
[[nodiscard]] Answers run_submission(const Rubric& rubric, const Program& program, const CaseSet& cases,
                                     const GradeOptions& options);

/// Run a command of our own (the compiler on our own files), not in a box. Throws UserError with what it printed.
void run_trusted(const std::vector<std::string>& command);

/// A name for contents: 16 hexadecimal digits.
[[nodiscard]] std::string content_name(const std::string& bytes);

}  // namespace kreda::tools
