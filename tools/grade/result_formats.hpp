// A result in the words of the systems that teachers use. Everything is text that may be shown to the student at once:
// of hidden tests only the name and the points are told, after the due date where the system can wait.
#pragma once

#include <string>

#include "tools/grade/result.hpp"

namespace kreda::tools {

/// results.json for Gradescope.    gradescope-autograders.readthedocs.io, "Autograder Specifications", "Output format"
[[nodiscard]] std::string gradescope_json(const GradeResult& result);

/// results.json for PrairieLearn, with the pictures of failed tests as far as its limit of 1 MB lets them in.
/// docs.prairielearn.com, "External grading", "Grading results"
[[nodiscard]] std::string prairielearn_json(const GradeResult& result);

/// For GitHub Classroom's autograding-grading-reporter: what its JSON is before base 64, ...
[[nodiscard]] std::string classroom_json(const GradeResult& result);
/// ... and the line of base 64 that an action puts into its output `result`.
[[nodiscard]] std::string classroom_text(const GradeResult& result);

/// What vpl_evaluate prints for Moodle's VPL: comments, then the grade of 0 to 100.
/// vpl.dis.ulpgc.es, "Advanced features"; no line of a student's can become a grade.
[[nodiscard]] std::string vpl_text(const GradeResult& result);

/// JUnit XML, one test case a test.    github.com/testmoapp/junitxml
[[nodiscard]] std::string junit_xml(const GradeResult& result);

/// Everything but the pictures, to read again. `key` names what was graded: another key, another result.
[[nodiscard]] std::string result_json(const GradeResult& result, const std::string& key);

struct StoredResult {
    GradeResult result;
    std::string key;
};

/// Throws UserError when it is no such text; `name` stands for the file.
[[nodiscard]] StoredResult read_result_json(const std::string& text, const std::string& name);

}  // namespace kreda::tools
