#include "tools/grade/assignment/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/grade/assignment/stage_check.hpp"

namespace kreda::tools {

namespace {

/// Share of the rows that may differ between two answers that count as the same.
constexpr double kSameShare = 0.002;
/// A variant that leaves more of the error unexplained is no explanation; two mistakes explain much by chance.
constexpr double kMostMisfit = 0.17;
constexpr double kMostMisfitOfPair = 0.04;
/// The next mistake must leave this many times as much.
constexpr double kClearlyBetter = 2.0;

/// The error of one number, made small and finite: what is far off is just far off.
double error_of(double value, double expected, double scale) {
    const double error = (value - expected) / (scale + 1e-3);
    if (!std::isfinite(error)) return 4.0;
    return std::clamp(error, -4.0, 4.0);
}

/// How the errors of a submission (s) and of a variant (v) lie to each other, over one table.
struct Sums {
    double ss = 0.0, sv = 0.0, vv = 0.0;
};

Sums sums_of(const StageTable& input, const StageTable& expected, const StageTable& s, const StageTable& v) {
    Sums sums;
    for (std::size_t c = 0; c < expected.columns.size(); ++c) {
        const StageColumn& e = expected.columns[c];
        for (std::size_t i = 0; i < e.values.size(); ++i) {
            const std::size_t row = i / e.components;
            if (!input.doubtful.empty() && input.doubtful[row]) continue;
            double scale = 0.0;
            for (std::size_t k = 0; k < e.components; ++k) {
                scale = std::max(scale, std::abs(e.values[row * e.components + k]));
            }
            const double a = error_of(s.columns[c].values[i], e.values[i], scale);
            const double b = error_of(v.columns[c].values[i], e.values[i], scale);
            sums.ss += a * a;
            sums.sv += a * b;
            sums.vv += b * b;
        }
    }
    return sums;
}

/// |s - a v|^2 / |s|^2 with the best a > 0; the error may be larger or smaller than the variant's, within limits.
double misfit_of(const Sums& sums) {
    if (sums.ss <= 0.0 || sums.vv <= 0.0) return 1.0;
    const double a = std::clamp(sums.sv / sums.vv, 0.3, 3.0);
    return std::clamp((sums.ss - 2.0 * a * sums.sv + a * a * sums.vv) / sums.ss, 0.0, 1.0);
}

/// Which tables must be the same, from strict to lenient: all; those that are wrong (what the variant has wrong
/// besides, the submission may do elsewhere); the pictures (it may do even the wrong thing elsewhere).
enum class Demand { all, wrong, pictures };

/// One and the same wrong answer in every row is no evidence: many mistakes leave a black picture.
bool says_something(const StageTable& answers, const StageTable& expected) {
    for (std::size_t k = 0; k < answers.columns.size(); ++k) {
        const StageColumn& c = answers.columns[k];
        if (c.values == expected.columns[k].values) continue;
        for (std::size_t i = c.components; i < c.values.size(); ++i) {
            if (c.values[i] != c.values[i % c.components] && std::isfinite(c.values[i])) return true;
        }
    }
    return false;
}

/// A submission beside the catalogue, table by table. Variants share their answers: each is looked at once, when it is
/// asked for.
struct Fits {
    const Marking& marking;
    const Catalogue& catalogue;
    std::vector<bool> wrong, speaks;  ///< [input]: the submission is wrong; in a way that says something
    std::vector<std::vector<std::optional<bool>>> same_as;  ///< [input][number], as in VariantAnswers
    std::vector<std::vector<std::optional<Sums>>> sums_to;

    Fits(const Marking& m, const Catalogue& all);
    [[nodiscard]] const std::vector<std::size_t>& mistakes(std::size_t variant) const {
        return catalogue.variants[variant].mistakes;
    }
    [[nodiscard]] bool is_answered(std::size_t i) const {
        return marking.answers[i] != nullptr;
    }
    /// Does the variant answer every row of this table as the submission does?
    [[nodiscard]] bool same(std::size_t variant, std::size_t i);
    [[nodiscard]] const Sums& sums(std::size_t variant, std::size_t i);
    /// Share of the submission's error that the variant leaves unexplained; 0 where they are the same.
    [[nodiscard]] double misfit(std::size_t variant, std::size_t i) {
        return same(variant, i) ? 0.0 : misfit_of(sums(variant, i));
    }
    [[nodiscard]] bool is_wrong(std::size_t variant, std::size_t i) {
        return sums(variant, i).vv > 1e-6;
    }
};

Fits::Fits(const Marking& m, const Catalogue& all) : marking(m), catalogue(all) {
    for (std::size_t i = 0; i < m.answers.size(); ++i) {
        wrong.push_back(is_answered(i) && !m.checks[i].passed());
        speaks.push_back(wrong[i] && says_something(*m.answers[i], m.cases.expected[i]));
        same_as.emplace_back(all.answers.tables[i].size());
        sums_to.emplace_back(all.answers.tables[i].size());
    }
}

bool Fits::same(std::size_t variant, std::size_t i) {
    std::optional<bool>& known = same_as[i][catalogue.answers.number[variant][i]];
    if (!known) {
        known = same_answers(marking.stage(i), marking.cases.inputs[i], *marking.answers[i],
                             catalogue.answers.of(variant, i), kSameShare);
    }
    return *known;
}

const Sums& Fits::sums(std::size_t variant, std::size_t i) {
    std::optional<Sums>& known = sums_to[i][catalogue.answers.number[variant][i]];
    if (!known) {
        known = sums_of(marking.cases.inputs[i], marking.cases.expected[i], *marking.answers[i],
                        catalogue.answers.of(variant, i));
    }
    return *known;
}

/// Does the variant answer as the submission, as far as demanded, and is anything explained by that?
bool is_same(Fits& fits, std::size_t variant, Demand demand) {
    bool explains = false;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.is_answered(i)) continue;
        if (demand == Demand::wrong && !fits.wrong[i]) continue;
        if (demand == Demand::pictures && !fits.marking.stage(i).picture) continue;
        if (!fits.same(variant, i)) return false;
        explains = explains || (demand == Demand::all ? fits.wrong[i] : fits.speaks[i]);
    }
    return explains;
}

/// The mean misfit over the tables that are wrong, in the submission or in the variant alone, and a little for each
/// mistake that it takes. A table where the variant is right explains nothing. One that is explained badly counts as
/// not explained at all if `all_or_nothing`: a second mistake is no better for being a little like it.
double misfit_over(Fits& fits, std::size_t variant, bool all_or_nothing) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.is_answered(i)) continue;
        if (!fits.wrong[i] && !fits.is_wrong(variant, i)) continue;
        const double misfit = fits.wrong[i] ? fits.misfit(variant, i) : 0.5;
        sum += all_or_nothing && fits.wrong[i] && misfit > kMostMisfit ? 1.0 : misfit;
        ++count;
    }
    return (count > 0 ? sum / count : 1.0) + 0.01 * static_cast<double>(fits.mistakes(variant).size());
}

bool shares_mistake(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

struct Candidate {
    double misfit;
    std::size_t variant;
};

/// The best of some variants, and the best of those that are its rivals: that name neither of its mistakes.
struct Best {
    Candidate first{2.0, 0}, next{1.0, 0};
    bool has_rival = false;
};

Best best_of(const Fits& fits, std::vector<Candidate> candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.misfit < b.misfit; });
    Best best;
    if (candidates.empty()) return best;
    best.first = candidates[0];
    const std::vector<std::size_t>& named = fits.mistakes(best.first.variant);
    for (const Candidate& c : candidates) {
        // More mistakes than the best has fit better by chance: they are no rivals.
        const std::vector<std::size_t>& others = fits.mistakes(c.variant);
        if (others.size() > named.size() || shares_mistake(named, others)) continue;
        best.next = c;
        best.has_rival = true;
        break;
    }
    return best;
}

/// The variants that are the same, as far as demanded. Where they need not be the same in all, the one that explains
/// most of the rest; if another explains about as much, nothing can be said.
bool find_same(Fits& fits, Demand demand, Diagnosis& diagnosis) {
    std::vector<Candidate> same;
    for (std::size_t k = 0; k < fits.catalogue.variants.size(); ++k) {
        if (!fits.mistakes(k).empty() && is_same(fits, k, demand)) same.push_back({misfit_over(fits, k, true), k});
    }
    if (same.empty()) return false;
    const Best best = best_of(fits, same);
    const bool is_clear = !best.has_rival || best.next.misfit >= kClearlyBetter * best.first.misfit;
    if (demand == Demand::pictures && !is_clear) return false;
    diagnosis = {Diagnosis::Kind::exactly, fits.mistakes(best.first.variant), 0.0};
    return true;
}

/// Is there a table for each of two mistakes that it alone makes wrong, and does the pair explain those? Then each is
/// judged by tables of its own, as if it were alone.
bool has_own_tables(Fits& fits, std::size_t variant) {
    const std::vector<std::size_t>& pair = fits.mistakes(variant);
    const auto is_wrong_alone = [&](std::size_t mistake, std::size_t i) {
        for (std::size_t k = 0; k < fits.catalogue.variants.size(); ++k) {
            if (fits.mistakes(k) == std::vector<std::size_t>{mistake} && fits.is_wrong(k, i)) return true;
        }
        return false;
    };
    bool own[2] = {false, false};
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.wrong[i] || fits.misfit(variant, i) > kMostMisfit) continue;
        const bool wrong[2] = {is_wrong_alone(pair[0], i), is_wrong_alone(pair[1], i)};
        if (wrong[0] != wrong[1]) own[wrong[0] ? 0 : 1] = true;
    }
    return own[0] && own[1];
}

/// The best fit, if it is good and nothing else fits about as well. Two mistakes need to fit better than one.
void find_nearest(Fits& fits, Diagnosis& diagnosis) {
    std::vector<Candidate> all;
    for (std::size_t k = 0; k < fits.catalogue.variants.size(); ++k) {
        if (!fits.mistakes(k).empty()) all.push_back({misfit_over(fits, k, false), k});
    }
    const Best best = best_of(fits, all);
    diagnosis.misfit = best.first.misfit;
    diagnosis.next_misfit = best.next.misfit;
    const std::vector<std::size_t>& named = fits.mistakes(best.first.variant);
    const bool is_lenient = named.size() == 1 || has_own_tables(fits, best.first.variant);
    if (diagnosis.misfit > (is_lenient ? kMostMisfit : kMostMisfitOfPair)) return;
    if (diagnosis.next_misfit < kClearlyBetter * diagnosis.misfit) return;
    diagnosis.kind = Diagnosis::Kind::nearly;
    diagnosis.mistakes = named;
}

}  // namespace

Catalogue make_catalogue(const Rubric& rubric, const CaseSet& cases, bool with_pairs) {
    Catalogue catalogue;
    catalogue.mistakes = read_mistakes(rubric);
    catalogue.variants = make_variants(read_solution(rubric), catalogue.mistakes, with_pairs);
    catalogue.answers = answers_of_variants(rubric, cases, catalogue.variants);
    return catalogue;
}

Diagnosis diagnose(const Marking& marking, const Catalogue& catalogue) {
    Diagnosis diagnosis;
    bool all_right = true;
    for (std::size_t i = 0; i < marking.answers.size(); ++i) all_right = all_right && marking.is_right(i);
    if (all_right) {
        diagnosis.kind = Diagnosis::Kind::right;
        return diagnosis;
    }
    Fits fits(marking, catalogue);
    for (const Demand demand : {Demand::all, Demand::wrong, Demand::pictures}) {
        if (find_same(fits, demand, diagnosis)) return diagnosis;
    }
    find_nearest(fits, diagnosis);
    return diagnosis;
}

std::string diagnosis_text(const Diagnosis& diagnosis, const Catalogue& catalogue) {
    if (diagnosis.kind == Diagnosis::Kind::right) return "";
    if (diagnosis.kind == Diagnosis::Kind::unknown) return "unknown";
    std::string text = diagnosis.kind == Diagnosis::Kind::exactly ? "looks exactly like: " : "looks like: ";
    for (std::size_t i = 0; i < diagnosis.mistakes.size(); ++i) {
        const Mistake& mistake = catalogue.mistakes[diagnosis.mistakes[i]];
        text +=
            (i > 0 ? "; and " : "") + mistake.says + " (page " + mistake.page.substr(0, mistake.page.find('_')) + ")";
    }
    return text;
}

}  // namespace kreda::tools
