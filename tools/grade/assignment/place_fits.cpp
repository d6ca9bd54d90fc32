#include "tools/grade/assignment/place_fits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace kreda::tools {

namespace {

/// Two numbers agree up to this many times what a number may be off.
constexpr double kAgree = 4.0;

bool is_off(double value, double expected, double allowed) {
    const bool finite = std::isfinite(value);
    if (!finite || !std::isfinite(expected)) return finite != std::isfinite(expected);
    return std::abs(value - expected) > allowed;
}

/// Does the function of table i call that of table k? A picture calls all that stand before it.
bool calls(const Fits& fits, std::size_t i, std::size_t k) {
    const RubricStage &stage = fits.marking.stage(i), &other = fits.marking.stage(k);
    if (stage.calls.empty()) return stage.picture && &other < &stage;
    return std::find(stage.calls.begin(), stage.calls.end(), other.name) != stage.calls.end();
}

/// One component of one result of a function, over the tables of all scenes: how many numbers the submission has
/// wrong, and one way to make a mistake; and in how many they are wrong alike. `met`: of the latter, where the way
/// gives the submission's number in some other row, too, in which the right one is zero (or is not) as in this row: so
/// often it would be met by chance. `before`: the same of the row before.
struct Counts {
    double wrong = 0.0, spoilt = 0.0, before = 0.0;
    std::array<double, 2> alike{}, met{};  ///< where zero is right, and elsewhere
};

/// All ways of a mistake on one component.
struct Component {
    const RubricStage* stage;
    std::size_t column, index, of;
    [[nodiscard]] bool operator<(const Component& o) const {
        return std::tie(stage, column, index) < std::tie(o.stage, o.column, o.index);
    }
};
using WayCounts = std::map<std::size_t, Counts>;

/// One component of a result in all rows: the numbers that are compared.
struct ComponentRows {
    const StageTable& input;
    const RubricStage& stage;
    const StageColumn &right, &submitted, &made;
    std::size_t component;

    [[nodiscard]] bool is_doubtful(std::size_t row) const {
        return !input.doubtful.empty() && input.doubtful[row];
    }
    [[nodiscard]] double of(const StageColumn& column, std::size_t row) const {
        return column.values[row * right.components + component];
    }
    [[nodiscard]] double allowed(std::size_t row) const {
        return allowed_error(largest(&right.values[row * right.components], right.components), stage);
    }
    /// Is zero right in a row?
    [[nodiscard]] bool is_zero(std::size_t row) const {
        return of(right, row) == 0.0;
    }
};

/// Another row of the same kind, far away, by a fixed rule; the row itself where none is found.
std::size_t other_row(const ComponentRows& n, std::size_t row) {
    const std::size_t begin = (row * 7919 + 13) % n.input.rows;
    for (std::size_t k = 0; k < 64; ++k) {
        const std::size_t other = (begin + k) % n.input.rows;
        if (other != row && !n.is_doubtful(other) && n.is_zero(other) == n.is_zero(row)) return other;
    }
    return row;
}

void count(const ComponentRows& n, Counts& counts) {
    double before = NAN;
    for (std::size_t row = 0; row < n.input.rows; ++row) {
        if (n.is_doubtful(row)) continue;
        const double allowed = n.allowed(row), e = n.of(n.right, row), s = n.of(n.submitted, row),
                     v = n.of(n.made, row);
        const bool wrong = is_off(s, e, allowed), spoilt = is_off(v, e, allowed);
        const auto is_alike = [&](double other) { return !is_off(s, other, kAgree * allowed); };
        counts.wrong += wrong ? 1.0 : 0.0;
        counts.spoilt += spoilt ? 1.0 : 0.0;
        counts.before += wrong && !std::isnan(before) && is_alike(before) ? 1.0 : 0.0;
        if (spoilt) before = v;
        if (!wrong || !spoilt || !is_alike(v)) continue;
        const std::size_t kind = n.is_zero(row) ? 0 : 1;
        counts.alike[kind] += 1.0;
        counts.met[kind] += is_alike(n.of(n.made, other_row(n, row))) ? 1.0 : 0.0;
    }
}

double alike_of(const Counts& c) {
    return c.alike[0] + c.alike[1];
}

/// Bits: how improbable it is that so many numbers agree by chance.
double surprise_of(const Counts& c) {
    double bits = 0.0;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        bits += c.alike[kind] * -std::log2((c.met[kind] + 1.0) / (c.alike[kind] + 1.0));
    }
    return bits;
}

std::map<Component, WayCounts> counts_of(const Fits& fits, std::size_t mistake) {
    std::map<Component, WayCounts> counts;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!is_wrong_by_itself(fits, i)) continue;
        for (std::size_t way = 0; way < fits.catalogue().mistakes[mistake].ways.size(); ++way) {
            const auto variant = fits.alone.find({mistake, way});
            if (variant == fits.alone.end()) continue;
            const StageTable& answers = fits.catalogue().answers.of(variant->second, i);
            for (std::size_t c = 0; c < answers.columns.size(); ++c) {
                for (std::size_t k = 0; k < answers.columns[c].components; ++k) {
                    const ComponentRows rows{fits.marking.cases.inputs[i],
                                             fits.marking.stage(i),
                                             fits.marking.cases.expected[i].columns[c],
                                             fits.marking.answers[i]->columns[c],
                                             answers.columns[c],
                                             k};
                    count(rows, counts[{&fits.marking.stage(i), c, k, answers.columns[c].components}][way]);
                }
            }
        }
    }
    return counts;
}

}  // namespace

bool is_wrong_by_itself(const Fits& fits, std::size_t i) {
    if (!fits.wrong[i]) return false;
    for (std::size_t k = 0; k < fits.wrong.size(); ++k) {
        if (fits.wrong[k] && calls(fits, i, k)) return false;
    }
    return true;
}

std::vector<PlaceFit> place_fits(const Fits& fits) {
    std::vector<PlaceFit> found;
    for (std::size_t m = 0; m < fits.catalogue().mistakes.size(); ++m) {
        PlaceFit fit{m};
        double wrong = 0.0, alike = 0.0, spoilt = 0.0;
        bool is_partial = false;
        for (const auto& [component, ways] : counts_of(fits, m)) {
            const auto best = std::max_element(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
                return alike_of(a.second) < alike_of(b.second);
            });
            const Counts& c = best->second;
            wrong += c.wrong;
            fit.of_picture = fit.of_picture || component.stage->picture;
            // Colours and directions have three components, which a mistake spoils together.
            const bool is_one_of_three = component.of == 3 && c.wrong <= 0.0;
            is_partial = is_partial || (is_one_of_three && std::all_of(ways.begin(), ways.end(), [](const auto& way) {
                                            return way.second.spoilt > 0.0;
                                        }));
            // Many mistakes leave a surface unlit: what stays the same from pixel to pixel is no evidence.
            const double c_alike = alike_of(c);
            const bool is_flat = component.stage->picture && c.before > 0.5 * c_alike;
            if (c_alike <= 0.0 || is_flat) continue;
            alike += c_alike;
            spoilt += c.spoilt;
            fit.surprise += surprise_of(c);
        }
        fit.explained = wrong > 0.0 && !is_partial ? alike / wrong : 0.0;
        fit.reach = spoilt > 0.0 ? alike / spoilt : 0.0;
        found.push_back(fit);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const PlaceFit& a, const PlaceFit& b) { return a.explained > b.explained; });
    return found;
}

}  // namespace kreda::tools
