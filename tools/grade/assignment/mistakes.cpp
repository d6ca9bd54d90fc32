#include "tools/grade/assignment/mistakes.hpp"

#include <algorithm>
#include <functional>
#include <sstream>

#include "tools/grade/assignment/table_reader.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostParts = 4;

/// 0.25 -> "0.25f", 9 -> "9.0f"
std::string literal(double value) {
    std::ostringstream text;
    text << value;
    return text.str() + (text.str().find_first_of(".e") == std::string::npos ? ".0f" : "f");
}

/// The changes with a text for each `$` of what becomes of the solution's.
std::vector<TextChange> with_text(std::vector<TextChange> changes, const std::string& text) {
    for (TextChange& change : changes) {
        for (std::size_t at; (at = change.second.find('$')) != std::string::npos;) {
            change.second.replace(at, 1, text);
        }
    }
    return changes;
}

std::vector<TextChange> read_changes(TableReader& reader) {
    std::vector<std::string> from, to;
    reader.require("from");
    reader.require("to");
    reader.read("from", from);
    reader.read("to", to);
    if (from.size() != to.size()) reader.complain("to", "expected as many texts as in 'from'");
    std::vector<TextChange> changes;
    for (std::size_t i = 0; i < from.size(); ++i) changes.emplace_back(from[i], to[i]);
    return changes;
}

void check_fits(const std::vector<TextChange>& changes, const std::string& solution, const TableReader& reader) {
    for (const TextChange& change : changes) {
        const std::size_t at = solution.find(change.first);
        const bool once = at != std::string::npos && solution.find(change.first, at + 1) == std::string::npos;
        if (!once) reader.complain("from", "this text must stand in the solution exactly once: " + change.first);
    }
}

/// One way, or a family of them: one for each number.
void add_family(const std::vector<TextChange>& changes, const std::vector<double>& values, bool in_pairs,
                std::vector<Way>& ways) {
    const std::size_t family = ways.empty() ? 0 : ways.back().family + 1;
    if (values.empty()) ways.push_back({changes, {}, 0.0, family, in_pairs});
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == values.size();
        ways.push_back({with_text(changes, literal(values[i])), changes, values[i], family, in_pairs && is_end});
    }
}

/// The same for each choice of the changes, all of them first. A mistake made in a part of its places makes no pairs:
/// there would be too many.
void add_parts(const std::vector<TextChange>& changes, const std::vector<double>& values, bool in_pairs,
               std::vector<Way>& ways) {
    const unsigned all = (1u << changes.size()) - 1u;
    for (unsigned chosen = all; chosen > 0; --chosen) {
        std::vector<TextChange> part;
        for (std::size_t i = 0; i < changes.size(); ++i) {
            if ((chosen >> i & 1u) != 0) part.push_back(changes[i]);
        }
        add_family(part, values, in_pairs && chosen == all, ways);
    }
}

/// With `values` a family, with `parts` the same for each choice of the changes.
void read_ways(TableReader& reader, const std::string& solution, std::vector<Way>& ways) {
    const std::vector<TextChange> changes = read_changes(reader);
    check_fits(changes, solution, reader);
    std::vector<double> values;
    reader.read("values", values);
    const auto has_number = [](const TextChange& change) { return change.second.find('$') != std::string::npos; };
    if (std::any_of(changes.begin(), changes.end(), has_number) == values.empty()) {
        reader.complain("to", "expected '$' where the numbers of 'values' are to stand, and nowhere else");
    }
    if (std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) != values.end()) {
        reader.complain("values", "expected increasing numbers");
    }
    bool in_pairs = true;
    reader.read("pairs", in_pairs);
    bool has_parts = false;
    reader.read("parts", has_parts);
    const bool all_have = std::all_of(changes.begin(), changes.end(), has_number) || values.empty();
    if (has_parts && (!all_have || changes.size() < 2 || changes.size() > kMostParts)) {
        reader.complain("parts", "expected two to four texts in 'from', and with 'values' a '$' for each of them");
    }
    if (has_parts) return add_parts(changes, values, in_pairs, ways);
    add_family(changes, values, in_pairs, ways);
}

Mistake read_mistake(const scene::Value& table, const std::string& solution) {
    TableReader reader(table, "[[mistake]]");
    Mistake mistake;
    for (const char* key : {"name", "says", "page"}) reader.require(key);
    reader.read("name", mistake.name);
    reader.read("says", mistake.says);
    reader.read("page", mistake.page);
    read_ways(reader, solution, mistake.ways);
    for (const scene::Value* other : reader.tables("also")) {
        TableReader way(*other, "[[mistake.also]]");
        read_ways(way, solution, mistake.ways);
        way.done();
    }
    reader.done();
    return mistake;
}

}  // namespace

std::string read_solution(const Rubric& rubric) {
    return read_text((rubric.folder() / "teacher" / "solution.cpp").string());
}

std::vector<Mistake> read_mistakes(const fs::path& file, const std::string& solution) {
    const scene::Value root = scene::parse_toml(read_text(file.string()), file.string());
    TableReader reader(root, "the catalogue");
    std::vector<Mistake> mistakes;
    for (const scene::Value* table : reader.tables("mistake")) mistakes.push_back(read_mistake(*table, solution));
    reader.done();
    return mistakes;
}

std::vector<Mistake> read_mistakes(const Rubric& rubric) {
    return read_mistakes(rubric.folder() / "teacher" / "mistakes.toml", read_solution(rubric));
}

std::vector<Family> families_of(const std::vector<Mistake>& mistakes) {
    std::vector<Family> families;
    const auto is_constant = [](const TextChange& change) {
        return change.second.find('$') != std::string::npos && change.second.find("constexpr") != std::string::npos;
    };
    for (std::size_t m = 0; m < mistakes.size(); ++m) {
        for (const Way& way : mistakes[m].ways) {
            if (way.pattern.empty() || std::any_of(way.pattern.begin(), way.pattern.end(), is_constant)) continue;
            const bool is_known = std::any_of(families.begin(), families.end(), [&](const Family& f) {
                return f.mistake == m && f.changes == way.pattern;
            });
            if (!is_known) families.push_back({m, way.pattern, 0});
        }
    }
    return families;
}

std::string open_solution(const std::string& solution, const Family& family, const std::string& variable) {
    std::string text = solution;
    const std::vector<TextChange> changes = with_text(family.changes, variable);
    return apply(changes, text) ? text : std::string();
}

bool apply(const std::vector<TextChange>& changes, std::string& text) {
    for (const TextChange& change : changes) {
        const std::size_t at = text.find(change.first);
        if (at == std::string::npos || text.find(change.first, at + 1) != std::string::npos) return false;
        text.replace(at, change.first.size(), change.second);
    }
    return true;
}

std::vector<Variant> make_variants(const std::string& solution, const std::vector<Mistake>& mistakes, bool with_pairs) {
    std::vector<Variant> variants{{{}, {}, solution}};
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        for (std::size_t way = 0; way < mistakes[i].ways.size(); ++way) {
            Variant variant{{i}, {way}, solution};
            if (apply(mistakes[i].ways[way].changes, variant.text)) variants.push_back(variant);
        }
    }
    const std::size_t singles = variants.size();
    const auto way_of = [&](std::size_t k) -> const Way& {
        return mistakes[variants[k].mistakes[0]].ways[variants[k].ways[0]];
    };
    for (std::size_t a = 1; with_pairs && a < singles; ++a) {
        for (std::size_t b = a + 1; b < singles; ++b) {
            const std::size_t i = variants[a].mistakes[0], j = variants[b].mistakes[0];
            if (i == j || !way_of(a).in_pairs || !way_of(b).in_pairs) continue;
            Variant pair{{i, j}, {variants[a].ways[0], variants[b].ways[0]}, variants[a].text};
            if (apply(way_of(b).changes, pair.text)) variants.push_back(pair);
        }
    }
    return variants;
}

}  // namespace kreda::tools
