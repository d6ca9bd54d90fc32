// What changed solutions answer: all are compiled into one program, and what came out is kept.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "tools/grade/assignment/mistakes.hpp"
#include "tools/grade/assignment/scene_case.hpp"

namespace kreda::tools {

/// Many variants answer alike; each different answer is held once.
struct VariantAnswers {
    std::vector<std::vector<std::shared_ptr<const StageTable>>>
        tables;                                    ///< [input][number]: the different answers to CaseSet::inputs[input]
    std::vector<std::vector<std::size_t>> number;  ///< [variant][input]

    [[nodiscard]] const StageTable& of(std::size_t variant, std::size_t input) const {
        return *tables[input][number[variant][input]];
    }
    /// Those of one variant to all inputs.
    [[nodiscard]] std::vector<StageTable> all_of(std::size_t variant) const;
};

/// The program that holds all variants, kept in grade_cache(). Throws UserError where one does not compile.
[[nodiscard]] std::filesystem::path program_of_variants(const Rubric& rubric, const std::vector<Variant>& variants);

/// A variant of a program, while its free number is this one.
struct NumberedRun {
    std::size_t variant = 0;
    double number = 0.0;
};
/// What they answer to some inputs: [run][input].
[[nodiscard]] std::vector<std::vector<StageTable>> answers_with_numbers(const std::filesystem::path& program,
                                                                        const std::vector<StageTable>& inputs,
                                                                        const std::vector<StageTable>& expected,
                                                                        const std::vector<NumberedRun>& runs);

/// What the first `count` variants of a program answer to each of CaseSet::inputs; kept in grade_cache(), too.
[[nodiscard]] VariantAnswers answers_of_program(const std::filesystem::path& program, const CaseSet& cases,
                                                std::size_t count);
/// All are compiled, the first `count` are run. Throws UserError where a variant does not compile.
[[nodiscard]] inline VariantAnswers answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                        const std::vector<Variant>& variants, std::size_t count) {
    return answers_of_program(program_of_variants(rubric, variants), cases, count);
}
[[nodiscard]] inline VariantAnswers answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                        const std::vector<Variant>& variants) {
    return answers_of_variants(rubric, cases, variants, variants.size());
}

}  // namespace kreda::tools
