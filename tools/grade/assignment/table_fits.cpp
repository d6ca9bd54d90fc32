#include "tools/grade/assignment/table_fits.hpp"

#include <algorithm>
#include <cmath>

#include "tools/grade/assignment/stage_check.hpp"

namespace kreda::tools {

namespace {

/// Share of the rows that may differ between two answers that count as the same.
constexpr double kSameShare = 0.002;
/// Into so many steps the way between two neighbours of a family is divided.
constexpr int kSteps = 8;
/// The least share of a table's error that must lie where two neighbours nearly agree.
constexpr double kDecidedShare = 0.5;

/// The error of one number, made small and finite: what is far off is just far off.
double error_of(double value, double expected, double scale) {
    const double error = (value - expected) / (scale + 1e-3);
    if (!std::isfinite(error)) return 4.0;
    return std::clamp(error, -4.0, 4.0);
}

/// Calls visit(column, index of a number, greatest expected number of its row) for every number of a row without doubt.
template <class Visit>
void for_each_number(const StageTable& input, const StageTable& expected, const Visit& visit) {
    for (std::size_t c = 0; c < expected.columns.size(); ++c) {
        const StageColumn& e = expected.columns[c];
        for (std::size_t i = 0; i < e.values.size(); ++i) {
            const std::size_t row = i / e.components;
            if (!input.doubtful.empty() && input.doubtful[row]) continue;
            visit(c, i, largest(&e.values[row * e.components], e.components));
        }
    }
}

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

}  // namespace

Sums sums_of(const StageTable& input, const StageTable& expected, const StageTable& s, const StageTable& v) {
    Sums sums;
    for_each_number(input, expected, [&](std::size_t c, std::size_t i, double scale) {
        const double right = expected.columns[c].values[i];
        const double a = error_of(s.columns[c].values[i], right, scale);
        const double b = error_of(v.columns[c].values[i], right, scale);
        sums.ss += a * a;
        sums.sv += a * b;
        sums.vv += b * b;
    });
    return sums;
}

double misfit_of(const Sums& sums) {
    if (sums.ss <= 0.0 || sums.vv <= 0.0) return 1.0;
    const double a = std::clamp(sums.sv / sums.vv, 0.3, 3.0);
    return std::clamp((sums.ss - 2.0 * a * sums.sv + a * a * sums.vv) / sums.ss, 0.0, 1.0);
}

double left_of(const Sums& sums) {
    return sums.ss > 0.0 ? std::clamp((sums.ss - 2.0 * sums.sv + sums.vv) / sums.ss, 0.0, 1.0) : 1.0;
}

Fits::Fits(const Marking& m, const Catalogue& all) : marking(m), given_(all) {
    for (std::size_t i = 0; i < m.answers.size(); ++i) {
        wrong.push_back(is_answered(i) && !m.checks[i].passed());
        speaks.push_back(wrong[i] && says_something(*m.answers[i], m.cases.expected[i]));
        same_as.emplace_back(all.answers.tables[i].size());
        sums_to.emplace_back(all.answers.tables[i].size());
    }
    products.resize(m.answers.size());
    for (std::size_t k = 0; k < all.variants.size(); ++k) {
        const Variant& v = all.variants[k];
        if (v.ways.size() == 1) alone[{v.mistakes[0], v.ways[0]}] = k;
    }
}

void Fits::add_way(const Family& family, double number, std::vector<StageTable> answers) {
    if (!extended_) extended_ = std::make_unique<Catalogue>(given_);
    std::vector<Way>& ways = extended_->mistakes[family.mistake].ways;
    alone[{family.mistake, ways.size()}] = extended_->variants.size();
    extended_->variants.push_back({{family.mistake}, {ways.size()}, {}});
    ways.push_back({family.changes, family.changes, number, ways.back().family + 1, false});
    std::vector<std::size_t>& numbers = extended_->answers.number.emplace_back();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        std::vector<std::shared_ptr<const StageTable>>& tables = extended_->answers.tables[i];
        numbers.push_back(tables.size());
        tables.push_back(std::make_shared<const StageTable>(std::move(answers[i])));
        same_as[i].emplace_back();
        sums_to[i].emplace_back();
        mistake_misfits_.erase({family.mistake, i});
    }
}

bool Fits::same(std::size_t variant, std::size_t i) {
    std::optional<bool>& known = same_as[i][catalogue().answers.number[variant][i]];
    if (!known) {
        known = same_answers(marking.stage(i), marking.cases.inputs[i], *marking.answers[i],
                             catalogue().answers.of(variant, i), kSameShare);
    }
    return *known;
}

double Fits::product(std::size_t a, std::size_t b, std::size_t i) {
    const std::vector<std::vector<std::size_t>>& number = catalogue().answers.number;
    const auto [found, is_new] = products[i].try_emplace({number[a][i], number[b][i]}, 0.0);
    if (is_new) {
        found->second = sums_of(marking.cases.inputs[i], marking.cases.expected[i], catalogue().answers.of(a, i),
                                catalogue().answers.of(b, i))
                            .sv;
    }
    return found->second;
}

double Fits::misfit(std::size_t variant, std::size_t i) {
    if (same(variant, i)) return 0.0;
    double best = misfit_of(sums(variant, i));
    const Variant& v = catalogue().variants[variant];
    for (std::size_t k = 0; v.ways.size() == 2 && k < 2; ++k) {
        if (alone.find({v.mistakes[k], v.ways[k]}) == alone.end()) continue;
        const std::size_t single = alone.at({v.mistakes[k], v.ways[k]});
        if (catalogue().answers.number[single][i] != catalogue().answers.number[variant][i]) continue;
        best = std::min(best, misfit_of_mistake(v.mistakes[k], i));
    }
    return best;
}

double Fits::misfit_of_mistake(std::size_t mistake, std::size_t i) {
    const auto [found, is_new] = mistake_misfits_.try_emplace({mistake, i}, 1.0);
    for (std::size_t way = 0; is_new && way < catalogue().mistakes[mistake].ways.size(); ++way) {
        if (alone.find({mistake, way}) == alone.end()) continue;
        for (const PossibleCause& e : possible_causes(alone.at({mistake, way}))) {
            found->second = std::min(found->second, misfit(e, i));
        }
    }
    return found->second;
}

double Fits::misfit(const PossibleCause& e, std::size_t i) {
    if (e.share <= 0.0) return misfit(e.variant, i);
    if (e.anywhere) return misfit_between(e.variant, e.neighbour, i);
    const Sums &v = sums(e.variant, i), &w = sums(e.neighbour, i);
    if (v.ss <= 0.0) return 1.0;
    const double near = 1.0 - e.share, far = e.share;
    const double sv = near * v.sv + far * w.sv;
    const double vv = near * near * v.vv + 2.0 * near * far * product(e.variant, e.neighbour, i) + far * far * w.vv;
    return std::clamp((v.ss - 2.0 * sv + vv) / v.ss, 0.0, 1.0);
}

double Fits::misfit_at_size(const PossibleCause& e, std::size_t i) {
    if (e.share > 0.0 || mistakes(e.variant).size() > 1 || same(e.variant, i)) return misfit(e, i);
    return left_of(sums(e.variant, i));
}

double Fits::misfit_between(std::size_t a, std::size_t b, std::size_t i) {
    const VariantAnswers& answers = catalogue().answers;
    const auto [found, is_new] = between_misfits_.try_emplace({answers.number[a][i], answers.number[b][i], i}, 1.0);
    if (!is_new) return found->second;
    double all = 0.0, decided = 0.0, left = 0.0;
    const StageTable& expected = marking.cases.expected[i];
    for_each_number(marking.cases.inputs[i], expected, [&](std::size_t c, std::size_t k, double scale) {
        const auto error = [&](const StageTable& t) {
            return error_of(t.columns[c].values[k], expected.columns[c].values[k], scale);
        };
        const double s = error(*marking.answers[i]), v = error(answers.of(a, i)), w = error(answers.of(b, i));
        const double outside = s - std::clamp(s, std::min(v, w), std::max(v, w));
        all += s * s;
        left += outside * outside;
        // Where the neighbours are far apart, to lie between them says little.
        const bool decides = std::abs(v - w) <= 0.5 * std::max({std::abs(s), std::abs(v), std::abs(w)});
        if (decides) decided += s * s;
    });
    if (decided > kDecidedShare * all) found->second = std::min(left / decided, 1.0);
    return found->second;
}

std::vector<PossibleCause> Fits::possible_causes(std::size_t variant) const {
    std::vector<PossibleCause> all{{variant, variant, 0.0}};
    const Variant& v = catalogue().variants[variant];
    if (v.ways.size() != 1) return all;
    const std::vector<Way>& ways = catalogue().mistakes[v.mistakes[0]].ways;
    const std::size_t way = v.ways[0];
    const auto next = alone.find({v.mistakes[0], way + 1});
    if (next == alone.end() || ways[way + 1].family != ways[way].family) return all;
    for (int k = 1; k < kSteps; ++k) all.push_back({variant, next->second, static_cast<double>(k) / kSteps});
    all.push_back({variant, next->second, 0.5, true});
    return all;
}

const Sums& Fits::sums(std::size_t variant, std::size_t i) {
    std::optional<Sums>& known = sums_to[i][catalogue().answers.number[variant][i]];
    if (!known) {
        known = sums_of(marking.cases.inputs[i], marking.cases.expected[i], *marking.answers[i],
                        catalogue().answers.of(variant, i));
    }
    return *known;
}

}  // namespace kreda::tools
