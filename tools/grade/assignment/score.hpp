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

/// A set of answers that was held against Kreda's, each table once. It refers to what it was made of.
struct Marking {
    const Rubric& rubric;
    const CaseSet& cases;
    std::vector<const StageTable*> answers;  ///< one a table of inputs; null: not answered
    std::vector<std::string> why;            ///< why not
    std::vector<StageCheck> checks;          ///< one a table; of those that were not answered nothing

    [[nodiscard]] const RubricStage& stage(std::size_t i) const;
    [[nodiscard]] bool is_right(std::size_t i) const {
        return answers[i] != nullptr && checks[i].passed();
    }
};
[[nodiscard]] Marking make_marking(const Rubric& rubric, const CaseSet& cases, const Answers& answers);

/// Every test that the cases allow: hidden ones only where there are hidden scenes. with_pictures: student, expected
/// and difference as PNG.
[[nodiscard]] std::vector<TestResult> score(const Marking& marking, bool with_pictures);

/// Whole points of the tests.
[[nodiscard]] double points_of(const std::vector<TestResult>& tests);
[[nodiscard]] double max_points_of(const std::vector<TestResult>& tests);

/// The points that score() gives, without the words.
[[nodiscard]] double points_of(const Marking& marking);

/// "attenuate right, spot_cone right; mirror_vector(...) ...": the stages in order up to the first that is wrong; empty
/// where all are right.
[[nodiscard]] std::string first_wrong_stage(const Marking& marking);

}  // namespace kreda::tools
