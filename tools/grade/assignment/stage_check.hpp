// One function's answers held against Kreda's, row by row.
#pragma once

#include <cstddef>
#include <string>

#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/assignment/scene_case.hpp"

namespace kreda::tools {

struct StageCheck {
    std::size_t rows = 0;        ///< without the doubtful ones
    std::size_t wrong = 0;       ///< of those
    std::size_t not_finite = 0;  ///< rows with NaN or infinity where a number was expected, doubtful ones included
    std::size_t worst = 0;       ///< the row that is farthest off, if any is wrong
    std::size_t column = 0;      ///< and which of its results

    [[nodiscard]] bool passed() const {
        return wrong == 0 && not_finite == 0;
    }
};

[[nodiscard]] StageCheck check_stage(const RubricStage& stage, const StageTable& input, const StageTable& expected,
                                     const StageTable& answers);

/// Do both tables answer every row alike, up to `share` of the rows that are not doubtful?
[[nodiscard]] bool same_answers(const RubricStage& stage, const StageTable& input, const StageTable& a,
                                const StageTable& b, double share);

/// What is wrong, as a sentence with numbers: "mirror_vector(n = (0, 1, 0), l = (...)) at pixel (72, 80) of two_lamps:
/// yours gives r = (...), the lecture (...); r = 2 (n.l) n - l, equation (2) of page 22".
[[nodiscard]] std::string describe_wrong_row(const RubricStage& stage, const StageTable& input,
                                             const StageTable& expected, const StageTable& answers,
                                             const StageCheck& check);

/// "(2) of page 22 (docs/22_phong_terms.md)", "page 22 (docs/22_phong_terms.md)"
[[nodiscard]] std::string page_text(const std::string& page, int equation);

}  // namespace kreda::tools
