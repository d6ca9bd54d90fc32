// An assignment on the bench: its scenes, its catalogue, and what any changed solution would score.
#pragma once

#include <string>
#include <vector>

#include "tools/grade/assignment/diagnose.hpp"
#include "tools/grade/assignment/score.hpp"

namespace kreda::tests {

struct Lab {
    tools::Rubric rubric;
    tools::CaseSet cases;
    tools::Catalogue catalogue;
};

/// The folders of all assignments, "A1_coverage" first.
[[nodiscard]] std::vector<std::string> assignment_folders();

/// With one hidden scene for each public one, and every pair of mistakes. Made once a process.
[[nodiscard]] const Lab& lab(const std::string& folder);

/// What a table of answers, one for each input, scores and looks like.
[[nodiscard]] tools::Answers all_answered(const std::vector<tools::StageTable>& tables);
[[nodiscard]] double points(const Lab& lab, const std::vector<tools::StageTable>& tables);
[[nodiscard]] tools::Diagnosis diagnosis(const Lab& lab, const std::vector<tools::StageTable>& tables);

/// "a, b"
[[nodiscard]] std::string names(const Lab& lab, const std::vector<std::size_t>& mistakes);

}  // namespace kreda::tests
