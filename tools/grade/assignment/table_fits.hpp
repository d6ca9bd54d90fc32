// A submission's answers beside those of the catalogue, table by table.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "tools/grade/assignment/mistakes.hpp"
#include "tools/grade/assignment/score.hpp"
#include "tools/grade/assignment/variant_answers.hpp"

namespace kreda::tools {

/// The catalogue of an assignment with what every variant answers to these cases.
struct Catalogue {
    std::vector<Mistake> mistakes;
    std::vector<Variant> variants;
    VariantAnswers answers;
    std::vector<Family> families;   ///< of ways with a free number
    std::filesystem::path program;  ///< runs them with any number; empty: there is none
};

/// How the errors of a submission (s) and of a variant (v) lie to each other, over one table.
struct Sums {
    double ss = 0.0, sv = 0.0, vv = 0.0;
};

/// Over all numbers of the rows without doubt.
[[nodiscard]] Sums sums_of(const StageTable& input, const StageTable& expected, const StageTable& s,
                           const StageTable& v);
/// |s - v|^2 / |s|^2: the share of the error that is left where it may not be larger or smaller than the variant's.
[[nodiscard]] double left_of(const Sums& sums);

/// |s - a v|^2 / |s|^2 with the best a > 0; the error may be larger or smaller than the variant's, within limits.
[[nodiscard]] double misfit_of(const Sums& sums);

/// What may explain a submission: a variant, or something between two neighbours of one family, whose free number was
/// not among those that were tried. Its answers lie on the straight way between theirs, or (where they jump, as at the
/// place of a hard edge) each anywhere between the two.
struct PossibleCause {
    std::size_t variant = 0, neighbour = 0;
    double share = 0.0;     ///< 0: the variant itself, up to 1: its neighbour
    bool anywhere = false;  ///< each answer for itself, not all with the same share
};

/// A submission beside the catalogue, table by table. Variants share their answers: each is looked at once, when it is
/// asked for.
struct Fits {
    const Marking& marking;
    std::vector<bool> wrong, speaks;  ///< [input]: the submission is wrong; in a way that says something
    std::vector<std::vector<std::optional<bool>>> same_as;  ///< [input][number], as in VariantAnswers
    std::vector<std::vector<std::optional<Sums>>> sums_to;
    std::vector<std::map<std::pair<std::size_t, std::size_t>, double>> products;  ///< [input]: two answers' errors
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> alone;             ///< mistake and way -> its variant

    Fits(const Marking& m, const Catalogue& all);
    /// What was given, and the ways that were added.
    [[nodiscard]] const Catalogue& catalogue() const {
        return extended_ ? *extended_ : given_;
    }
    /// A new way of a family's mistake: another number, and what it answers to all inputs.
    void add_way(const Family& family, double number, std::vector<StageTable> answers);
    [[nodiscard]] const std::vector<std::size_t>& mistakes(std::size_t variant) const {
        return catalogue().variants[variant].mistakes;
    }
    [[nodiscard]] bool is_answered(std::size_t i) const {
        return marking.answers[i] != nullptr;
    }
    /// Does the variant answer every row of this table as the submission does?
    [[nodiscard]] bool same(std::size_t variant, std::size_t i);
    [[nodiscard]] const Sums& sums(std::size_t variant, std::size_t i);
    /// Share of the submission's error that the variant leaves unexplained; 0 where they are the same. On a table that
    /// only one of two mistakes spoils, any way to make that one will do.
    [[nodiscard]] double misfit(std::size_t variant, std::size_t i);
    [[nodiscard]] bool is_wrong(std::size_t variant, std::size_t i) {
        return sums(variant, i).vv > 1e-6;
    }
    [[nodiscard]] double misfit(const PossibleCause& e, std::size_t i);
    /// The same where the error may not be larger or smaller than the variant's; a pair's may.
    [[nodiscard]] double misfit_at_size(const PossibleCause& e, std::size_t i);
    [[nodiscard]] bool is_wrong(const PossibleCause& e, std::size_t i) {
        return is_wrong(e.variant, i) || (e.share > 0.0 && is_wrong(e.neighbour, i));
    }
    /// The variant, and what lies between it and the next of its family, if there is one.
    [[nodiscard]] std::vector<PossibleCause> possible_causes(std::size_t variant) const;

private:
    const Catalogue& given_;
    std::unique_ptr<Catalogue> extended_;  ///< shares the answers with what was given
    /// The best of all ways to make a mistake.
    [[nodiscard]] double misfit_of_mistake(std::size_t mistake, std::size_t i);
    std::map<std::pair<std::size_t, std::size_t>, double> mistake_misfits_;
    std::map<std::array<std::size_t, 3>, double> between_misfits_;
    /// Of answers that each lie between those of two variants.
    [[nodiscard]] double misfit_between(std::size_t a, std::size_t b, std::size_t i);
    [[nodiscard]] double product(std::size_t a, std::size_t b, std::size_t i);
};

}  // namespace kreda::tools
