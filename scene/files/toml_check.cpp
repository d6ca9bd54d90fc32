#include "scene/files/toml_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kreda::scene {

namespace {

bool is_number(const Value& value) {
    return value.kind == ValueKind::integer || value.kind == ValueKind::number;
}

/// "'near' in [camera]"
std::string subject(const KeyInfo& info) {
    return in_quotes(info.key) + " in " + table_title(info.table);
}

std::string number_text(const Value& value) {
    if (value.kind == ValueKind::integer) return std::to_string(value.integer);
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", value.number);
    return std::isnan(value.number) ? "nan" : buffer;
}

std::string describe(const Value& value) {
    switch (value.kind) {
        case ValueKind::boolean: return value.boolean ? "true" : "false";
        case ValueKind::integer:
        case ValueKind::number: return number_text(value);
        case ValueKind::text: return "the text " + in_quotes(value.text, '"');
        case ValueKind::date: return "a date or time";
        case ValueKind::table: return "a table";
        case ValueKind::array: break;
    }
    return "a list of " + std::to_string(value.items.size()) + (value.items.size() == 1 ? " value" : " values");
}

constexpr double kBeyond = 1e30;  // outside every range, inside float

/// Ranges are of floats, because that is what the scene holds: 1e-50 is not > 0 there.
bool in_range(double number, const Range& range) {
    const float x = static_cast<float>(std::clamp(number, -kBeyond, kBeyond));
    const float least = static_cast<float>(range.least);
    const float greatest = static_cast<float>(range.greatest);
    return range.open ? x > least && x < greatest : x >= least && x <= greatest;
}

void check_number(const Value& value, const KeyInfo& info, const std::string& found) {
    const bool whole = info.type == KeyType::whole || info.type == KeyType::whole_pair;
    if (whole ? value.kind != ValueKind::integer : !is_number(value)) throw_unexpected(value.place, info, found);
    const std::string sentence = subject(info) + " is " + found;
    if (!std::isfinite(value.number)) throw UserError(value.place, sentence + "; expected a finite number");
    if (std::abs(value.number) > info.range.greatest && info.range.greatest >= Range{}.greatest) {
        const char* const limit = info.range.greatest > Range{}.greatest ? "1e25" : "1e9";
        throw UserError(value.place, sentence + "; numbers beyond " + limit + " are refused");
    }
    if (!in_range(value.number, info.range)) throw_unexpected(value.place, info, found);
}

void check_numbers(const Value& value, const KeyInfo& info, std::size_t count) {
    if (value.kind != ValueKind::array || value.items.size() != count) {
        throw_unexpected(value.place, info, describe(value));
    }
    const char* const ordinals[] = {"first", "second", "third"};
    for (std::size_t i = 0; i < count; ++i) {
        check_number(value.items[i], info, describe(value.items[i]) + " in the " + ordinals[i] + " place");
    }
}

void check_word(const Value& value, const KeyInfo& info) {
    if (value.kind != ValueKind::text) throw_unexpected(value.place, info, describe(value));
    const std::vector<std::string> words(info.words.begin(), info.words.end());
    if (std::find(words.begin(), words.end(), value.text) != words.end()) return;
    const std::string sentence = subject(info) + " is " + in_quotes(value.text, '"');
    const std::string near = nearest_word(value.text, words);
    throw UserError(value.place, sentence + (near.empty() ? "" : "; did you mean " + in_quotes(near, '"') + "?") +
                                     "; expected " + type_text(info));
}

void check_text(const Value& value, const KeyInfo& info) {
    if (value.kind != ValueKind::text) throw_unexpected(value.place, info, describe(value));
    for (const unsigned char c : value.text) {
        if (c < 0x20 || c == 0x7F) { throw UserError(value.place, subject(info) + " holds a control character"); }
    }
}

void check_value(const Value& value, const KeyInfo& info) {
    const std::string found = describe(value);
    switch (info.type) {
        case KeyType::boolean:
            if (value.kind != ValueKind::boolean) throw_unexpected(value.place, info, found);
            return;
        case KeyType::whole:
        case KeyType::number: return check_number(value, info, found);
        case KeyType::whole_pair:
        case KeyType::number_pair: return check_numbers(value, info, 2);
        case KeyType::vector: return check_numbers(value, info, 3);
        case KeyType::number_or_vector:
            return is_number(value) ? check_number(value, info, found) : check_numbers(value, info, 3);
        case KeyType::vector_or_word:
            return value.kind == ValueKind::text ? check_word(value, info) : check_numbers(value, info, 3);
        case KeyType::word: return check_word(value, info);
        case KeyType::text: return check_text(value, info);
        case KeyType::texts:
            if (value.kind != ValueKind::array) throw_unexpected(value.place, info, found);
            for (const Value& item : value.items) check_text(item, info);
            return;
    }
}

[[noreturn]] void throw_unknown_key(const std::string& table, const Value& member) {
    throw UserError(member.key_place, "unknown key " + in_quotes(member.key) + " in " + table_title(table) +
                                          did_you_mean(member.key, key_names(table), "keys"));
}

void check_table(const std::string& name, const Value& table) {
    for (const Value& member : table.items) {
        const KeyInfo* info = find_key(name, member.key);
        if (!info) throw_unknown_key(name, member);
        check_value(member, *info);
    }
}

/// A key before the first table, or in none: say where it belongs if that is known.
[[noreturn]] void throw_unknown_table(const Value& member) {
    const bool is_table =
        member.kind == ValueKind::table ||
        (member.kind == ValueKind::array && !member.items.empty() && member.items.front().kind == ValueKind::table);
    if (is_table) {
        throw UserError(member.key_place, "unknown table [" + on_one_line(member.key) + "]" +
                                              did_you_mean(member.key, table_names(), "tables"));
    }
    const std::string key = in_quotes(member.key);
    for (const std::string& table : table_names()) {
        if (!find_key(table, member.key)) continue;
        throw UserError(member.key_place, key + " is outside of any table; it belongs below " + table_title(table));
    }
    throw UserError(member.key_place,
                    "unknown key " + key + " outside of any table" + did_you_mean(member.key, table_names(), "tables"));
}

bool is_written_right(const Value& member) {
    if (!is_repeated(member.key)) return member.kind == ValueKind::table;
    const auto is_table = [](const Value& item) { return item.kind == ValueKind::table; };
    return member.kind == ValueKind::array && std::all_of(member.items.begin(), member.items.end(), is_table);
}

}  // namespace

void throw_unexpected(const Place& place, const KeyInfo& info, const std::string& found) {
    const std::string sentence = subject(info) + " is " + found;
    throw UserError(place, sentence + "; expected " + type_text(info) + ", e.g. " + example_text(info));
}

void check_tables(const Value& root) {
    const std::vector<std::string> known = table_names();
    for (const Value& member : root.items) {
        if (std::find(known.begin(), known.end(), member.key) == known.end()) throw_unknown_table(member);
        if (!is_written_right(member)) {
            const std::string title = table_title(member.key);
            const bool single = member.kind == ValueKind::table;
            const std::string how = is_repeated(member.key)
                                        ? "there may be several, so it is written in double brackets"
                                        : "there is only one, so it is written in single brackets";
            const std::string found = single ? "[" + member.key + "]"
                                      : member.kind == ValueKind::array && !is_repeated(member.key)
                                          ? "[[" + member.key + "]]"
                                          : in_quotes(member.key) + " = ...";
            throw UserError(member.key_place, found + " must be " + title + ": " + how);
        }
    }
}

void check_keys(const Value& root) {
    for (const Value& member : root.items) {
        if (!is_repeated(member.key)) {
            check_table(member.key, member);
            continue;
        }
        for (const Value& item : member.items) check_table(member.key, item);
    }
}

}  // namespace kreda::scene
