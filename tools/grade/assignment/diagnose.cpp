#include "tools/grade/assignment/diagnose.hpp"

#include <algorithm>
#include <cmath>

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

/// What is known of a submission before variants are looked at.
struct Facts {
    std::vector<const RubricStage*> stage;  ///< one a table
    std::vector<bool> wrong;                ///< one a table: answered, and wrong
};

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

/// Does the variant answer as the submission, as far as demanded, and is anything explained by that?
bool is_same(const CaseSet& cases, const Facts& facts, const Answers& answers, const std::vector<StageTable>& variant,
             Demand demand) {
    bool explains = false;
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        if (!is_answered(answers.tables[i])) continue;
        if (demand == Demand::wrong && !facts.wrong[i]) continue;
        if (demand == Demand::pictures && !facts.stage[i]->picture) continue;
        if (!same_answers(*facts.stage[i], cases.inputs[i], answers.tables[i], variant[i], kSameShare)) return false;
        explains = explains ||
                   (facts.wrong[i] && (demand == Demand::all || says_something(answers.tables[i], cases.expected[i])));
    }
    return explains;
}

/// The mean misfit over the tables that are wrong. A table where the variant is right explains nothing.
double misfit_over(const CaseSet& cases, const Facts& facts, const Answers& answers,
                   const std::vector<StageTable>& variant) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        if (!is_answered(answers.tables[i])) continue;
        const Sums sums = sums_of(cases.inputs[i], cases.expected[i], answers.tables[i], variant[i]);
        const bool variant_alone = !facts.wrong[i] && sums.vv > 1e-6;
        if (!facts.wrong[i] && !variant_alone) continue;
        sum += facts.wrong[i] ? misfit_of(sums) : 0.5;
        ++count;
    }
    return count > 0 ? sum / count : 1.0;
}

/// The first variant, singles before pairs, that is the same.
bool find_same(const CaseSet& cases, const Facts& facts, const Answers& answers, const Catalogue& catalogue,
               Demand demand, Diagnosis& diagnosis) {
    for (std::size_t k = 0; k < catalogue.variants.size(); ++k) {
        if (catalogue.variants[k].mistakes.empty()) continue;
        if (!is_same(cases, facts, answers, catalogue.answers[k], demand)) continue;
        diagnosis = {Diagnosis::Kind::exactly, catalogue.variants[k].mistakes, 0.0};
        return true;
    }
    return false;
}

/// The best fit, if it is good and nothing else fits about as well. Two mistakes need to fit better than one.
void find_nearest(const CaseSet& cases, const Facts& facts, const Answers& answers, const Catalogue& catalogue,
                  Diagnosis& diagnosis) {
    struct Fit {
        double misfit;
        std::size_t variant;
    };
    std::vector<Fit> fits;
    for (std::size_t k = 0; k < catalogue.variants.size(); ++k) {
        const std::size_t count = catalogue.variants[k].mistakes.size();
        if (count == 0) continue;
        const double misfit = misfit_over(cases, facts, answers, catalogue.answers[k]);
        fits.push_back({misfit + 0.01 * static_cast<double>(count), k});
    }
    std::sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.misfit < b.misfit; });
    if (fits.empty()) return;
    const std::vector<std::size_t>& best = catalogue.variants[fits[0].variant].mistakes;
    // More mistakes than the best has fit better by chance: they are no rivals.
    const auto is_no_rival = [&](const Fit& fit) {
        const std::vector<std::size_t>& named = catalogue.variants[fit.variant].mistakes;
        if (named.size() > best.size()) return true;
        return std::find_first_of(best.begin(), best.end(), named.begin(), named.end()) != best.end();
    };
    const auto next = std::find_if_not(fits.begin(), fits.end(), is_no_rival);
    diagnosis.misfit = fits[0].misfit;
    diagnosis.next_misfit = next == fits.end() ? 1.0 : next->misfit;
    if (diagnosis.misfit > (best.size() == 1 ? kMostMisfit : kMostMisfitOfPair)) return;
    if (diagnosis.next_misfit < kClearlyBetter * diagnosis.misfit) return;
    diagnosis.kind = Diagnosis::Kind::nearly;
    diagnosis.mistakes = best;
}

}  // namespace

Catalogue make_catalogue(const Rubric& rubric, const CaseSet& cases, bool with_pairs) {
    Catalogue catalogue;
    catalogue.mistakes = read_mistakes(rubric);
    catalogue.variants = make_variants(read_solution(rubric), catalogue.mistakes, with_pairs);
    catalogue.answers = answers_of_variants(rubric, cases, catalogue.variants);
    return catalogue;
}

Diagnosis diagnose(const Rubric& rubric, const CaseSet& cases, const Answers& answers, const Catalogue& catalogue) {
    Facts facts;
    bool any_wrong = false;
    for (std::size_t i = 0; i < cases.inputs.size(); ++i) {
        const RubricStage& stage = *rubric.find_stage(cases.inputs[i].stage);
        const bool answered = is_answered(answers.tables[i]);
        facts.stage.push_back(&stage);
        facts.wrong.push_back(answered &&
                              !check_stage(stage, cases.inputs[i], cases.expected[i], answers.tables[i]).passed());
        any_wrong = any_wrong || facts.wrong.back() || !answered;
    }
    Diagnosis diagnosis;
    if (!any_wrong) {
        diagnosis.kind = Diagnosis::Kind::right;
        return diagnosis;
    }
    for (const Demand demand : {Demand::all, Demand::wrong, Demand::pictures}) {
        if (find_same(cases, facts, answers, catalogue, demand, diagnosis)) return diagnosis;
    }
    find_nearest(cases, facts, answers, catalogue, diagnosis);
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
