// The catalogue of classic mistakes: each a small change of the reference solution, and what it answers.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/grade/assignment/rubric.hpp"
#include "tools/grade/assignment/scene_case.hpp"

namespace kreda::tools {

/// `from` becomes `to`, once; `from` stands in the solution exactly once.
using TextChange = std::pair<std::string, std::string>;

struct Mistake {
    std::string name;  ///< "normal_not_renormalised"
    std::string says;  ///< "the normal is not renormalised after interpolation"
    std::string page;  ///< of docs/: "24_shading"
    /// Ways to make it: other constants, other places. The first is the one that pairs are made of.
    std::vector<std::vector<TextChange>> ways;
};

/// teacher/mistakes.toml beside the rubric. Throws UserError, also where a change does not fit the solution.
[[nodiscard]] std::vector<Mistake> read_mistakes(const Rubric& rubric);
/// The same from another file; tests have catalogues of their own.
[[nodiscard]] std::vector<Mistake> read_mistakes(const Rubric& rubric, const std::filesystem::path& file);

/// A changed solution.
struct Variant {
    std::vector<std::size_t> mistakes;  ///< indices; none: the solution itself; two: a pair
    std::string text;
};

/// The solution, every way of every mistake, and with_pairs every pair whose changes do not touch.
[[nodiscard]] std::vector<Variant> make_variants(const std::string& solution, const std::vector<Mistake>& mistakes,
                                                 bool with_pairs);

/// The text with a mistake's changes; false where one does not fit any more.
[[nodiscard]] bool apply(const std::vector<TextChange>& changes, std::string& text);

/// What each variant answers to each of CaseSet::inputs. All are compiled into one program, which is kept together with
/// what it answered in grade_cache(). Throws UserError where a variant does not compile.
[[nodiscard]] std::vector<std::vector<StageTable>> answers_of_variants(const Rubric& rubric, const CaseSet& cases,
                                                                       const std::vector<Variant>& variants);

/// teacher/solution.cpp beside the rubric.
[[nodiscard]] std::string read_solution(const Rubric& rubric);

}  // namespace kreda::tools
