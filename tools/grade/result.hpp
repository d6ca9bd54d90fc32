// What grading one submission gives: plain data that every report is written from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/compare/measurement.hpp"
#include "tools/grade/box.hpp"

namespace kreda::tools {

/// A picture of a test: label "student", "expected" or "difference", or any other.
struct ResultImage {
    std::string label;
    std::vector<unsigned char> png;
};

struct TestResult {
    std::string name;     ///< "03 highlight", unique in its assignment
    std::string teaches;  ///< one line: what it tests
    double points = 0.0;
    double max_points = 0.0;
    bool passed = false;
    bool hidden = false;
    std::string message;  ///< plain text; its first line is short
    std::vector<Measurement> measurements;
    std::vector<ResultImage> images;
    std::string command;  ///< repeats it; empty where nothing does
};

struct GradeResult {
    std::string assignment;  ///< "A3 lights and Phong"
    std::string submission;  ///< the folder's name
    double points = 0.0;     ///< the sum of the tests'
    double max_points = 0.0;
    std::optional<BoxTier> tier;  ///< empty: nothing of it was run
    std::vector<TestResult> tests;
    std::string diagnosis;  ///< "looks exactly like: ..." or "unknown"; empty where everything passed
    std::string error;      ///< why nothing could be tested (it does not compile); empty otherwise
    double seconds = 0.0;   ///< how long grading took
    std::string viva;       ///< questions about this submission, as Markdown; empty unless they were asked for
    std::string viva_key;   ///< the same with the answers
    std::string deadline;   ///< the rubric's, as it stands; empty: none is told
};

/// The name of the box, or "none".
[[nodiscard]] inline std::string box_of(const GradeResult& result) {
    return result.tier ? name_of(*result.tier) : "none";
}

/// How the command line wants it graded.
struct GradeOptions {
    std::vector<std::filesystem::path> hidden;  ///< folders of hidden scenes
    bool allow_unsafe = false;
    std::optional<BoxTier> tier;  ///< of BoxRequest
    int viva = 0;                 ///< how many questions about the submission
};

}  // namespace kreda::tools
