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
/// wrong, and one way to make a mistake; in how many they are wrong alike; and in how many the submission's is what the
/// way gave for the number before, as happens where there are only a few different numbers. All, spoilt and alike are
/// counted apart where zero is right: a test that always says yes spoils every no.
struct Counts {
    std::array<double, 2> all{}, spoilt{}, alike{};  ///< where zero is right, and elsewhere
    double wrong = 0.0, by_chance = 0.0;
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

void count(const Fits& fits, std::size_t i, const StageTable& answers, std::size_t column, std::size_t component,
           Counts& counts) {
    const StageTable& input = fits.marking.cases.inputs[i];
    const RubricStage& stage = fits.marking.stage(i);
    const StageColumn& right = fits.marking.cases.expected[i].columns[column];
    const std::size_t n = right.components;
    double before = NAN;
    for (std::size_t row = 0; row < input.rows; ++row) {
        if (!input.doubtful.empty() && input.doubtful[row]) continue;
        const double allowed = allowed_error(largest(&right.values[row * n], n), stage);
        const double e = right.values[row * n + component];
        const double s = fits.marking.answers[i]->columns[column].values[row * n + component];
        const double v = answers.columns[column].values[row * n + component];
        const bool wrong = is_off(s, e, allowed), spoilt = is_off(v, e, allowed);
        const std::size_t kind = e == 0.0 ? 0 : 1;
        counts.all[kind] += 1.0;
        counts.wrong += wrong ? 1.0 : 0.0;
        counts.spoilt[kind] += spoilt ? 1.0 : 0.0;
        counts.alike[kind] += wrong && spoilt && !is_off(s, v, kAgree * allowed) ? 1.0 : 0.0;
        counts.by_chance += wrong && !std::isnan(before) && !is_off(s, before, kAgree * allowed) ? 1.0 : 0.0;
        if (spoilt) before = v;
    }
}

double sum(const std::array<double, 2>& counts) {
    return counts[0] + counts[1];
}

/// Bits: how improbable it is that so many numbers agree by chance.
double surprise_of(const Counts& c) {
    double bits = 0.0;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        if (c.alike[kind] <= 0.0) continue;
        const double chance = c.spoilt[kind] / c.all[kind] * (c.by_chance + 1.0) / (c.wrong + 1.0);
        bits += c.alike[kind] * -std::log2(std::min(chance, 1.0));
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
                    count(fits, i, answers, c, k,
                          counts[{&fits.marking.stage(i), c, k, answers.columns[c].components}][way]);
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
                return sum(a.second.alike) < sum(b.second.alike);
            });
            const Counts& c = best->second;
            wrong += c.wrong;
            fit.of_picture = fit.of_picture || component.stage->picture;
            // Colours and directions have three components, which a mistake spoils together.
            const bool is_one_of_three = component.of == 3 && c.wrong <= 0.0;
            is_partial = is_partial || (is_one_of_three && std::all_of(ways.begin(), ways.end(), [](const auto& way) {
                                            return sum(way.second.spoilt) > 0.0;
                                        }));
            // Many mistakes leave a surface unlit: what stays the same from pixel to pixel is no evidence.
            const double c_alike = sum(c.alike);
            const bool is_flat = component.stage->picture && c.by_chance > 0.5 * c_alike;
            if (c_alike <= 0.0 || is_flat) continue;
            alike += c_alike;
            spoilt += sum(c.spoilt);
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
