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
    std::vector<std::vector<tools::StageCheck>> checks;  ///< of the catalogue's answers: [input][number]
};

/// The folders of all assignments, "A1_coverage" first.
[[nodiscard]] std::vector<std::string> assignment_folders();

/// With one hidden scene for each public one, and every pair of mistakes. Made once a process.
[[nodiscard]] const Lab& lab(const std::string& folder);

/// A table of answers for each input, held against Kreda's.
[[nodiscard]] tools::Marking marking(const Lab& lab, const std::vector<tools::StageTable>& tables);
/// The same of a variant of the catalogue; what many answer alike is checked once.
[[nodiscard]] tools::Marking marking(const Lab& lab, std::size_t variant);

/// "a, b"
[[nodiscard]] std::string names(const Lab& lab, const std::vector<std::size_t>& mistakes);

}  // namespace kreda::tests
