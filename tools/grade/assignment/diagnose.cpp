#include "tools/grade/assignment/diagnose.hpp"

#include <algorithm>

#include "tools/grade/assignment/place_fits.hpp"
#include "tools/grade/assignment/solved_numbers.hpp"
#include "tools/grade/assignment/variant_source.hpp"

namespace kreda::tools {

namespace {

/// A variant that leaves more of the error unexplained is no explanation; two mistakes explain much by chance, unless
/// each has tables of its own. On five sets of unseen mistakes, functions that are wrong by themselves left at most
/// 0.015 where the name was right, and 0.033 and more where most names were wrong.
constexpr double kMostMisfit = 0.17;
constexpr double kMostMisfitOfPair = 0.04;
constexpr double kMostMisfitByItself = 0.02;
/// The next mistake must leave this many times as much.
constexpr double kClearlyBetter = 3.0;
/// One of two mistakes that leaves no more than this besides what both leave is named alone.
constexpr double kAboutAsGood = 0.01;
/// Number by number: a mistake must give this share of those that are wrong, the next one no more than that; the next
/// must leave so many times as many; and what a mistake spoils must agree with what is spoilt by more than chance, in
/// bits. Chosen by leaving each way of the catalogues out in turn, and each mistake.
constexpr double kLeastExplained = 0.72;
constexpr double kLeastOfPicture = 0.95;
constexpr double kMostOfNext = 0.5;
constexpr double kLeavesMore = 3.5;
constexpr double kLeastSurprise = 7.0;

/// Which tables must be the same, from strict to lenient: all; those that are wrong (what the variant has wrong
/// besides, the submission may do elsewhere); the pictures (it may do even the wrong thing elsewhere).
enum class Demand { all, wrong, pictures };

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

/// The mean misfit over the tables that are wrong, in the submission or in the explanation alone, and a little for each
/// mistake and each free number that it takes. A table where the variant is right explains nothing.
double misfit_over(Fits& fits, const PossibleCause& e) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.is_answered(i) || !(fits.wrong[i] || fits.is_wrong(e, i))) continue;
        sum += fits.wrong[i] ? fits.misfit(e, i) : 0.5;
        ++count;
    }
    const std::size_t taken = fits.mistakes(e.variant).size() + (e.share > 0.0 ? 1 : 0);
    return (count > 0 ? sum / count : 1.0) + 0.01 * static_cast<double>(taken);
}

/// Does the variant explain the function of table i, wherever the submission has it wrong?
bool explains_function(Fits& fits, std::size_t variant, std::size_t i) {
    for (std::size_t k = 0; k < fits.wrong.size(); ++k) {
        const bool is_it = fits.wrong[k] && &fits.marking.stage(k) == &fits.marking.stage(i);
        if (is_it && fits.misfit(variant, k) > kMostMisfit) return false;
    }
    return fits.wrong[i];
}

/// How much is left unexplained of a submission that has the variant's pictures: tables of functions that it does not
/// explain everywhere, and a half for each that the variant alone has wrong.
double unexplained_by(Fits& fits, std::size_t variant) {
    double sum = 0.1 * static_cast<double>(fits.mistakes(variant).size());
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.is_answered(i)) continue;
        if (fits.wrong[i]) {
            sum += explains_function(fits, variant, i) ? fits.misfit(variant, i) : 1.0;
        } else if (fits.is_wrong(variant, i)) {
            sum += 0.5;
        }
    }
    return sum;
}

/// May a variant that has the submission's pictures be named? Not if it both leaves a function that is wrong
/// unexplained and spoils one that is right. Two mistakes make many pictures: they must explain a function of their
/// own, too.
bool may_be_named(Fits& fits, std::size_t variant) {
    bool explains = false, leaves = false, spoils = false;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.is_answered(i) || fits.marking.stage(i).picture) continue;
        const bool explained = explains_function(fits, variant, i);
        explains = explains || explained;
        leaves = leaves || (fits.wrong[i] && !explained);
        spoils = spoils || (!fits.wrong[i] && fits.is_wrong(variant, i));
    }
    return !(leaves && spoils) && (explains || fits.mistakes(variant).size() < 2);
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
    for (const Candidate& c : candidates) {
        const bool is_simpler = fits.mistakes(c.variant).size() < fits.mistakes(best.first.variant).size() &&
                                shares_mistake(fits.mistakes(c.variant), fits.mistakes(best.first.variant));
        if (is_simpler && c.misfit <= best.first.misfit + kAboutAsGood) best.first = c;
    }
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

/// The variants that are the same, as far as demanded: the one that explains most of the rest. Where only the pictures
/// are the same and another explains about as much, nothing can be said.
bool find_same(Fits& fits, Demand demand, Diagnosis& diagnosis) {
    std::vector<Candidate> same;
    for (std::size_t k = 0; k < fits.catalogue().variants.size(); ++k) {
        if (fits.mistakes(k).empty() || !is_same(fits, k, demand)) continue;
        if (demand == Demand::pictures && !may_be_named(fits, k)) continue;
        same.push_back({unexplained_by(fits, k), k});
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
        for (std::size_t k = 0; k < fits.catalogue().variants.size(); ++k) {
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

/// What is left at most of a function that is wrong although all that it calls is right. There nothing but the mistake
/// is at work, so that its own numbers must fit nearly exactly, and be as large; what calls it bends the errors.
double misfit_by_itself(Fits& fits, std::size_t variant) {
    double least = 1.0;
    for (const PossibleCause& e : fits.possible_causes(variant)) {
        double most = 0.0;
        for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
            if (!is_wrong_by_itself(fits, i)) continue;
            most = std::max(most, fits.misfit_at_size(e, i));
        }
        least = std::min(least, most);
    }
    return least;
}

/// The best fit, if it is good and nothing else fits about as well. Two mistakes need to fit better than one.
void find_nearest(Fits& fits, Diagnosis& diagnosis) {
    std::vector<Candidate> all;
    for (std::size_t k = 0; k < fits.catalogue().variants.size(); ++k) {
        if (fits.mistakes(k).empty()) continue;
        for (const PossibleCause& e : fits.possible_causes(k)) all.push_back({misfit_over(fits, e), k});
    }
    const Best best = best_of(fits, all);
    diagnosis.misfit = best.first.misfit;
    diagnosis.next_misfit = best.next.misfit;
    const std::vector<std::size_t>& named = fits.mistakes(best.first.variant);
    const bool is_judged_alone = named.size() < 2 || has_own_tables(fits, best.first.variant);
    if (diagnosis.misfit > (is_judged_alone ? kMostMisfit : kMostMisfitOfPair)) return;
    if (misfit_by_itself(fits, best.first.variant) > kMostMisfitByItself) return;
    if (diagnosis.next_misfit < kClearlyBetter * diagnosis.misfit) return;
    diagnosis.kind = Diagnosis::Kind::nearly;
    diagnosis.mistakes = named;
}

/// A mistake made in some of its places, or with consequences of its own: it gives most of the numbers that are wrong
/// where what is called is right, no other mistake gives nearly as many, and chance would not.
void find_in_places(const Fits& fits, Diagnosis& diagnosis) {
    const std::vector<PlaceFit> all = place_fits(fits);
    if (all.empty() || all[0].explained < (all[0].of_picture ? kLeastOfPicture : kLeastExplained)) return;
    const double next = all.size() > 1 ? all[1].explained : 0.0;
    if (next > kMostOfNext || 1.0 - next < kLeavesMore * (1.0 - all[0].explained)) return;
    if (all[0].reach * all[0].surprise < kLeastSurprise) return;
    diagnosis.kind = Diagnosis::Kind::nearly;
    diagnosis.mistakes = {all[0].mistake};
}

}  // namespace

Catalogue make_catalogue(const Rubric& rubric, const CaseSet& cases, bool with_pairs) {
    Catalogue catalogue;
    catalogue.mistakes = read_mistakes(rubric);
    const std::string solution = read_solution(rubric);
    catalogue.variants = make_variants(solution, catalogue.mistakes, with_pairs);
    std::vector<Variant> compiled = catalogue.variants;
    for (Family family : families_of(catalogue.mistakes)) {
        const std::string text = open_solution(solution, family, kFreeNumber);
        if (text.empty()) continue;
        family.program_variant = compiled.size();
        compiled.push_back({{}, {}, text});
        catalogue.families.push_back(family);
    }
    catalogue.program = program_of_variants(rubric, compiled);
    catalogue.answers = answers_of_program(catalogue.program, cases, catalogue.variants.size());
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
    for (const Demand demand : {Demand::all, Demand::wrong}) {
        if (find_same(fits, demand, diagnosis)) return diagnosis;
    }
    add_solved_numbers(fits);
    for (const Demand demand : {Demand::all, Demand::wrong, Demand::pictures}) {
        if (find_same(fits, demand, diagnosis)) return diagnosis;
    }
    find_nearest(fits, diagnosis);
    if (diagnosis.kind == Diagnosis::Kind::unknown) find_in_places(fits, diagnosis);
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
