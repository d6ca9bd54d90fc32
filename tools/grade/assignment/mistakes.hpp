// The catalogue of classic mistakes: each a small change of the reference solution, and what it answers.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/grade/assignment/rubric.hpp"

namespace kreda::tools {

/// `from` becomes `to`, once; `from` stands in the solution exactly once.
using TextChange = std::pair<std::string, std::string>;

/// One way to make a mistake. Where a number in it is free, there is a way for each of some of its values: a family.
struct Way {
    std::vector<TextChange> changes;
    std::vector<TextChange> pattern;  ///< of a family: the changes with `$` in place of the number
    double number = 0.0;
    std::size_t family = 0;  ///< the same for ways of a mistake that differ by their number alone
    bool in_pairs = true;    ///< of a family only the least and the greatest number make pairs
};

struct Mistake {
    std::string name;       ///< "normal_not_renormalised"
    std::string says;       ///< "the normal is not renormalised after interpolation"
    std::string page;       ///< of docs/: "24_shading"
    std::vector<Way> ways;  ///< other constants, other places; families one after the other, their numbers increasing
};

/// teacher/mistakes.toml beside the rubric. Throws UserError, also where a change does not fit the solution.
[[nodiscard]] std::vector<Mistake> read_mistakes(const Rubric& rubric);
/// The same from another file, made in another solution; tests have catalogues of their own.
[[nodiscard]] std::vector<Mistake> read_mistakes(const std::filesystem::path& file, const std::string& solution);

/// The ways of a mistake that differ by their number alone, wherever they stand in the catalogue.
struct Family {
    std::size_t mistake = 0;
    std::vector<TextChange> changes;  ///< with `$`
    std::size_t program_variant = 0;  ///< its number in the program of all variants
};
/// Those whose number may be one that is known only when the program runs: not where C++ wants a constant.
[[nodiscard]] std::vector<Family> families_of(const std::vector<Mistake>& mistakes);

/// A changed solution.
struct Variant {
    std::vector<std::size_t> mistakes;  ///< indices; none: the solution itself; two: a pair
    std::vector<std::size_t> ways;      ///< which way of each
    std::string text;
};

/// The solution, every way of every mistake, and with_pairs every pair of ways of two mistakes whose changes do not
/// touch, if both are in_pairs.
[[nodiscard]] std::vector<Variant> make_variants(const std::string& solution, const std::vector<Mistake>& mistakes,
                                                 bool with_pairs);

/// The solution with a family's changes, which read a variable of this name in place of the number; empty where they do
/// not fit.
[[nodiscard]] std::string open_solution(const std::string& solution, const Family& family, const std::string& variable);

/// The text with a mistake's changes; false where one does not fit any more.
[[nodiscard]] bool apply(const std::vector<TextChange>& changes, std::string& text);

/// teacher/solution.cpp beside the rubric.
[[nodiscard]] std::string read_solution(const Rubric& rubric);

}  // namespace kreda::tools
