// Points: the tests of a rubric on a set of answers, wherever those come from.
#pragma once

#include <string>
#include <vector>

#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/assignment/scene_case.hpp"
#include "tools/grade/assignment/stage_check.hpp"
#include "tools/grade/result.hpp"

namespace kreda::tools {

/// Answers to CaseSet::inputs in their order; a table without columns was not answered, and `why` says why not.
struct Answers {
    std::vector<StageTable> tables;
    std::vector<std::string> why;
};

[[nodiscard]] inline bool is_answered(const StageTable& table) {
    return !table.columns.empty();
}

/// Every test that the cases allow: hidden ones only where there are hidden scenes. with_pictures: student, expected
/// and difference as PNG.
[[nodiscard]] std::vector<TestResult> score(const Rubric& rubric, const CaseSet& cases, const Answers& answers,
                                            bool with_pictures);

/// Whole points of the tests.
[[nodiscard]] double points_of(const std::vector<TestResult>& tests);
[[nodiscard]] double max_points_of(const std::vector<TestResult>& tests);

/// "attenuate right, spot_cone right; mirror_vector(...) ...": the stages in order up to the first that is wrong; empty
/// where all are right.
[[nodiscard]] std::string first_wrong_stage(const Rubric& rubric, const CaseSet& cases, const Answers& answers);

}  // namespace kreda::tools
