#include "tools/grade/assignment/solved_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/grade/assignment/place_fits.hpp"

namespace kreda::tools {

namespace {

/// At most so many mistakes with a free number are looked into, the nearest ones first; after two rounds fewer.
constexpr std::size_t kMostSearches = 12;
constexpr std::size_t kMostAfterTwoRounds = 4;
/// Each round divides what is left between two numbers into so many steps, and keeps the two beside the best.
constexpr int kParts = 8;
constexpr int kRounds = 7;
/// So many rows of a table are enough to tell one number from another.
constexpr std::size_t kMostRows = 1500;
/// Functions that call a wrong one count so much: they decide between numbers that are the same where it is at work.
constexpr double kShareOfCallers = 0.01;
/// A solved number that leaves more is no way of the mistake.
constexpr double kMostLeft = 0.05;

/// Some rows of a table, evenly spread.
StageTable some_rows(const StageTable& table, const std::vector<std::size_t>& rows) {
    StageTable part{table.stage, table.scene, rows.size(), {}, {}, {}, table.exact};
    for (const StageColumn& c : table.columns) {
        StageColumn& column = part.columns.emplace_back(StageColumn{c.name, c.components, c.per_row, {}});
        if (!c.per_row) column.values = c.values;
        for (const std::size_t row : rows) {
            const auto begin = c.values.begin() + static_cast<std::ptrdiff_t>(row * c.components);
            if (c.per_row)
                column.values.insert(column.values.end(), begin, begin + static_cast<std::ptrdiff_t>(c.components));
        }
    }
    return part;
}

/// The functions that are wrong, at some rows.
struct Sample {
    std::vector<std::size_t> table;  ///< their numbers
    std::vector<bool> by_itself;     ///< wrong although all that they call is right
    std::vector<StageTable> inputs, expected, answers;
};

Sample sample_of(const Fits& fits) {
    Sample sample;
    for (std::size_t i = 0; i < fits.wrong.size(); ++i) {
        if (!fits.wrong[i]) continue;
        const StageTable& input = fits.marking.cases.inputs[i];
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < input.rows; ++row) {
            if (input.doubtful.empty() || !input.doubtful[row]) rows.push_back(row);
        }
        const std::size_t step = rows.size() / kMostRows + 1;
        for (std::size_t k = 0; k * step < rows.size(); ++k) rows[k] = rows[k * step];
        rows.resize((rows.size() + step - 1) / step);
        sample.table.push_back(i);
        sample.by_itself.push_back(is_wrong_by_itself(fits, i));
        sample.inputs.push_back(some_rows(input, rows));
        sample.expected.push_back(some_rows(fits.marking.cases.expected[i], rows));
        sample.answers.push_back(some_rows(*fits.marking.answers[i], rows));
    }
    return sample;
}

/// The mean of what is left of the errors, over the functions that a number spoils, and a little for those that call
/// them. Far off may leave more than all.
struct Left {
    std::array<double, 2> sum{}, count{};
    void add(const Sums& s, bool by_itself) {
        if (s.vv <= 1e-6) return;
        sum[by_itself ? 0 : 1] += s.ss > 0.0 ? (s.ss - 2.0 * s.sv + s.vv) / s.ss : 1.0;
        count[by_itself ? 0 : 1] += 1.0;
    }
    [[nodiscard]] double mean() const {
        const double callers = count[1] > 0.0 ? sum[1] / count[1] : 0.0;
        return (count[0] > 0.0 ? sum[0] / count[0] : 1.0) + kShareOfCallers * callers;
    }
};

/// A number of a family, and what it leaves.
struct Tried {
    double number = 0.0, left = 0.0;
    [[nodiscard]] bool operator<(const Tried& other) const {
        return number < other.number;
    }
};

/// A family of the catalogue, and where its best number is looked for.
struct Search {
    std::size_t family;  ///< of Catalogue::families
    double low, high;
    Tried best;
};

/// The listed numbers of a family, in increasing order.
std::vector<Tried> listed_numbers(Fits& fits, const Sample& sample, const Family& family) {
    std::vector<Tried> listed;
    const std::vector<Way>& ways = fits.catalogue().mistakes[family.mistake].ways;
    for (std::size_t way = 0; way < ways.size(); ++way) {
        const auto variant = fits.alone.find({family.mistake, way});
        if (ways[way].pattern != family.changes || variant == fits.alone.end()) continue;
        Left left;
        for (std::size_t t = 0; t < sample.table.size(); ++t) {
            left.add(fits.sums(variant->second, sample.table[t]), sample.by_itself[t]);
        }
        listed.push_back({ways[way].number, left.mean()});
    }
    std::sort(listed.begin(), listed.end());
    const auto same = [](const Tried& a, const Tried& b) { return a.number == b.number; };
    listed.erase(std::unique(listed.begin(), listed.end(), same), listed.end());
    return listed;
}

void keep_nearest(std::vector<Search>& searches, std::size_t most) {
    std::stable_sort(searches.begin(), searches.end(),
                     [](const Search& a, const Search& b) { return a.best.left < b.best.left; });
    searches.resize(std::min(searches.size(), most));
}

/// The families that come nearest with a listed number, and the numbers beside that; half a step beyond the ends, where
/// a mistake may become another one (a power of 1).
std::vector<Search> searches_of(Fits& fits, const Sample& sample) {
    std::vector<Search> all;
    for (std::size_t f = 0; f < fits.catalogue().families.size(); ++f) {
        const std::vector<Tried> listed = listed_numbers(fits, sample, fits.catalogue().families[f]);
        if (listed.size() < 2) continue;
        const auto best = std::min_element(listed.begin(), listed.end(),
                                           [](const Tried& a, const Tried& b) { return a.left < b.left; });
        const bool is_first = best == listed.begin(), is_last = best + 1 == listed.end();
        const double low = is_first ? 1.5 * best->number - 0.5 * (best + 1)->number : (best - 1)->number;
        const double high = is_last ? 1.5 * best->number - 0.5 * (best - 1)->number : (best + 1)->number;
        all.push_back({f, low, high, *best});
    }
    keep_nearest(all, kMostSearches);
    return all;
}

/// One round of all searches: one run of the program.
void divide(const Catalogue& catalogue, const Sample& sample, std::vector<Search>& searches) {
    std::vector<NumberedRun> runs;
    for (const Search& s : searches) {
        for (int k = 1; k < kParts; ++k) {
            runs.push_back({catalogue.families[s.family].program_variant, s.low + (s.high - s.low) * k / kParts});
        }
    }
    const auto answers = answers_with_numbers(catalogue.program, sample.inputs, sample.expected, runs);
    for (std::size_t i = 0; i < searches.size(); ++i) {
        Search& s = searches[i];
        for (int k = 1; k < kParts; ++k) {
            const std::size_t run = i * (kParts - 1) + static_cast<std::size_t>(k) - 1;
            Left left;
            for (std::size_t t = 0; t < sample.table.size(); ++t) {
                left.add(sums_of(sample.inputs[t], sample.expected[t], sample.answers[t], answers[run][t]),
                         sample.by_itself[t]);
            }
            if (left.mean() < s.best.left) s.best = {runs[run].number, left.mean()};
        }
        const double step = (s.high - s.low) / kParts;
        s.low = std::max(s.low, s.best.number - step);
        s.high = std::min(s.high, s.best.number + step);
    }
}

}  // namespace

void add_solved_numbers(Fits& fits) {
    if (fits.catalogue().program.empty()) return;
    const Sample sample = sample_of(fits);
    if (std::none_of(sample.by_itself.begin(), sample.by_itself.end(), [](bool b) { return b; })) return;
    std::vector<Search> searches = searches_of(fits, sample);
    for (int round = 0; round < kRounds && !searches.empty(); ++round) {
        divide(fits.catalogue(), sample, searches);
        if (round == 1) keep_nearest(searches, kMostAfterTwoRounds);
    }
    std::vector<NumberedRun> runs;
    std::vector<std::size_t> solved;
    for (const Search& s : searches) {
        if (s.best.left > kMostLeft) continue;
        runs.push_back({fits.catalogue().families[s.family].program_variant, s.best.number});
        solved.push_back(s.family);
    }
    if (runs.empty()) return;
    const CaseSet& cases = fits.marking.cases;
    auto answers = answers_with_numbers(fits.catalogue().program, cases.inputs, cases.expected, runs);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        fits.add_way(fits.catalogue().families[solved[k]], runs[k].number, std::move(answers[k]));
    }
}

}  // namespace kreda::tools
