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

/// With every pair of mistakes, or without. Made once a process.
[[nodiscard]] const Lab& lab(const std::string& folder, bool with_pairs = true);

/// A table of answers for each input, held against Kreda's.
[[nodiscard]] tools::Marking marking(const Lab& lab, const std::vector<tools::StageTable>& tables);
/// The same of a variant of the catalogue; what many answer alike is checked once.
[[nodiscard]] tools::Marking marking(const Lab& lab, std::size_t variant);

/// The catalogue as it would be without the ways for which leaves_out(mistake, way) holds, and their pairs.
template <class LeavesOut>
tools::Catalogue without(const tools::Catalogue& all, const LeavesOut& leaves_out) {
    tools::Catalogue left{all.mistakes, {}, {all.answers.tables, {}}, all.families, all.program};
    for (std::size_t k = 0; k < all.variants.size(); ++k) {
        const tools::Variant& v = all.variants[k];
        bool has = false;
        for (std::size_t j = 0; j < v.ways.size(); ++j) has = has || leaves_out(v.mistakes[j], v.ways[j]);
        if (has) continue;
        left.variants.push_back(v);
        left.answers.number.push_back(all.answers.number[k]);
    }
    return left;
}

/// "a, b"
[[nodiscard]] std::string names(const Lab& lab, const std::vector<std::size_t>& mistakes);

}  // namespace kreda::tests
