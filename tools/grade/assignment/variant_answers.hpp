// What changed solutions answer: all are compiled into one program, and what came out is kept.
#pragma once

#include <vector>

#include "tools/grade/assignment/mistakes.hpp"
#include "tools/grade/assignment/scene_case.hpp"

namespace kreda::tools {

/// Many variants answer alike; each different answer is held once.
struct VariantAnswers {
    std::vector<std::vector<StageTable>> tables;   ///< [input][number]: the different answers to CaseSet::inputs[input]
    std::vector<std::vector<std::size_t>> number;  ///< [variant][input]

    [[nodiscard]] const StageTable& of(std::size_t variant, std::size_t input) const {
        return tables[input][number[variant][input]];
    }
    /// Those of one variant to all inputs.
    [[nodiscard]] std::vector<StageTable> all_of(std::size_t variant) const;
};

/// What each variant answers to each of CaseSet::inputs; all are compiled, the first `count` are run. The program and
/// its answers are kept in grade_cache(). Throws UserError where a variant does not compile.
[[nodiscard]] VariantAnswers answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                 const std::vector<Variant>& variants, std::size_t count);
[[nodiscard]] inline VariantAnswers answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                        const std::vector<Variant>& variants) {
    return answers_of_variants(rubric, cases, variants, variants.size());
}

}  // namespace kreda::tools
