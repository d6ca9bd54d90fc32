#include "scene/files/toml_tree.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "scene/files/scene_keys.hpp"

namespace kreda::scene {

/// Thrown where toml++ would assert.
struct TomlAssertion {};

constexpr void expect_in_toml(const auto& condition) {
    if (!static_cast<bool>(condition)) throw TomlAssertion{};
}

}  // namespace kreda::scene

// toml++ 3.3 asserts where a text such as `x = [}` is only wrong: with assertions that ends the program, without them
// (NDEBUG) it tells the compiler that it cannot happen. Here it is an exception that parse_toml turns into a message.
#undef NDEBUG
#define TOML_ASSERT(condition) kreda::scene::expect_in_toml(condition)
#include <toml++/toml.h>

namespace kreda::scene {

namespace {

constexpr std::size_t kMaxDots = 100;
constexpr std::size_t kMaxValues = 200'000;
constexpr std::size_t kMaxListed = 24;
constexpr std::size_t kLongestWord = 60;  ///< to a longer one no known word is compared

Place place_at(const toml::source_position& position, const std::string& name) {
    return {name, static_cast<int>(position.line), static_cast<int>(position.column)};
}

/// toml++ limits nested brackets but not a.a.a.a: each dot costs it one level of recursion, and the stack ends.
void refuse_endless_dotted_keys(const std::string& text, const std::string& name) {
    std::size_t dots = 0;
    int line = 1;
    char before = ' ';
    for (const char c : text) {
        const bool letter = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
        const bool part_of_key = letter || c == '"' || c == '\'';
        if (c == '.' && before != '.') {
            if (++dots > kMaxDots) throw UserError({name, line, 0}, "a key with more than 100 dots");
        } else if (!part_of_key && c != ' ' && c != '\t') {
            dots = 0;
        }
        if (c == '\n') ++line;
        if (c != ' ' && c != '\t') before = c;
    }
}

struct Converter {
    const std::string& name;
    std::size_t values = 0;

    Value convert(const toml::node& node, std::string key, Place key_place);
    void convert_array(const toml::array& array, Value& value);
    void convert_table(const toml::table& table, Value& value);
};

Value Converter::convert(const toml::node& node, std::string key, Place key_place) {
    Value value;
    value.key = std::move(key);
    value.key_place = std::move(key_place);
    value.place = place_at(node.source().begin, name);
    if (++values > kMaxValues) throw UserError(value.place, "too many values for a scene file");
    switch (node.type()) {
        case toml::node_type::table: convert_table(*node.as_table(), value); break;
        case toml::node_type::array: convert_array(*node.as_array(), value); break;
        case toml::node_type::string:
            value.kind = ValueKind::text;
            value.text = node.as_string()->get();
            break;
        case toml::node_type::integer:
            value.kind = ValueKind::integer;
            value.integer = node.as_integer()->get();
            value.number = static_cast<double>(value.integer);
            break;
        case toml::node_type::floating_point:
            value.kind = ValueKind::number;
            value.number = node.as_floating_point()->get();
            break;
        case toml::node_type::boolean:
            value.kind = ValueKind::boolean;
            value.boolean = node.as_boolean()->get();
            break;
        default: value.kind = ValueKind::date; break;
    }
    return value;
}

void Converter::convert_array(const toml::array& array, Value& value) {
    value.kind = ValueKind::array;
    for (const toml::node& item : array) value.items.push_back(convert(item, value.key, value.key_place));
}

/// toml++ sorts keys by name; messages should come in the order of the file.
void Converter::convert_table(const toml::table& table, Value& value) {
    value.kind = ValueKind::table;
    for (const auto& [key, node] : table) {
        value.items.push_back(convert(node, std::string(key.str()), place_at(key.source().begin, name)));
    }
    std::stable_sort(value.items.begin(), value.items.end(), [](const Value& a, const Value& b) {
        return std::tie(a.key_place.line, a.key_place.column) < std::tie(b.key_place.line, b.key_place.column);
    });
}

bool fails_assertion(std::string_view text) {
    try {
        const toml::table table = toml::parse(text);
    } catch (const TomlAssertion&) { return true; } catch (const toml::parse_error&) {
    }
    return false;
}

/// The character that toml++ gives no place for: the last one of the shortest beginning of the text that fails.
Place place_of_assertion(std::string_view text, const std::string& name) {
    std::size_t fine = 0;
    std::size_t fails = text.size();
    while (fails - fine > 1) {
        const std::size_t middle = fine + (fails - fine) / 2;
        (fails_assertion(text.substr(0, middle)) ? fails : fine) = middle;
    }
    const std::string_view before = text.substr(0, fine);
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    const std::string_view in_line = before.substr(line_start);
    const auto starts_character = [](unsigned char c) { return (c & 0xC0) != 0x80; };
    return {name, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
            1 + static_cast<int>(std::count_if(in_line.begin(), in_line.end(), starts_character))};
}

std::string syntax_message(const toml::parse_error& error) {
    std::string message(error.description());
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    return message;
}

/// What is commonly written instead of TOML, and how TOML writes it.
std::string syntax_remedy(std::string_view message, std::string_view line) {
    const auto says = [&](std::string_view words) { return message.find(words) != message.npos; };
    const auto holds = [&](std::string_view words) { return line.find(words) != line.npos; };
    const std::size_t first = line.find_first_not_of(" \t");
    const std::string_view start = first == line.npos ? "" : line.substr(first);
    if (holds("\xe2\x80\x9c") || holds("\xe2\x80\x9d") || holds("\xe2\x80\x99"))
        return "write straight quotes: \"...\"";
    if (start.starts_with("//") || start.starts_with("/*")) return "a comment begins with #";
    if (start.starts_with("{")) return "a scene file is TOML, not JSON: `kreda keys --example` prints one";
    if (says("expected '=', saw ':'")) return "TOML writes key = value";
    if (says("could not determine value type")) return "text needs quotes: \"...\"";
    if (says("unknown escape sequence")) return "write / between folders, or quote the path with '...'";
    if (says("expected 'true'") || says("expected 'false'")) return "TOML writes true and false in small letters";
    if (says("floating-point: expected decimal digit")) return "a digit stands on both sides of the point: 0.5, 1.0";
    return "";
}

bool redefines(const toml::parse_error& error) {
    return error.description().find("redefine") != std::string_view::npos;
}

std::string_view line_of(std::string_view text, int line) {
    for (int i = 1; i < line; ++i) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// What to do about the second [object], [[camera]] and so on; "" where the line is another one.
std::string table_written_twice(std::string_view line) {
    const std::size_t open = line.find_first_not_of(" \t");
    if (open == std::string_view::npos || line[open] != '[') return "";
    const std::size_t begin = line.find_first_not_of("[ \t", open);
    if (begin == std::string_view::npos) return "";
    const std::string name(line.substr(begin, line.find_first_of("] \t#", begin) - begin));
    const std::vector<std::string> known = table_names();
    if (std::find(known.begin(), known.end(), name) == known.end()) return "";
    if (!is_repeated(name))
        return "[" + name + "] is there twice; a scene has one: write all its keys below one of them";
    return "a second table '" + name + "': there may be several, so write each of them as " + table_title(name) +
           ", in double brackets";
}

/// The only known word that contains this one, as "fov" does in "vertical_fov"; or "".
std::string word_around(const std::string& word, const std::vector<std::string>& known) {
    const auto contains = [&](const std::string& other) { return other.find(word) != std::string::npos; };
    if (word.size() < 3 || std::count_if(known.begin(), known.end(), contains) != 1) return "";
    return *std::find_if(known.begin(), known.end(), contains);
}

}  // namespace

Value parse_toml(const std::string& text, const std::string& name) {
    refuse_endless_dotted_keys(text, name);
    try {
        const toml::table table = toml::parse(text);
        return Converter{name}.convert(table, "", {});
    } catch (const TomlAssertion&) {
        throw UserError(place_of_assertion(text, name),
                        "this is not TOML: expected a value or the right closing bracket");
    } catch (const toml::parse_error& error) {
        const Place place = place_at(error.source().begin, name);
        const std::string repeated = table_written_twice(line_of(text, place.line));
        if (redefines(error) && !repeated.empty()) throw UserError(place, repeated);
        const std::string message = syntax_message(error), remedy = syntax_remedy(message, line_of(text, place.line));
        throw UserError(place, message + (remedy.empty() ? "" : " (" + remedy + ")"));
    }
}

const Value* find(const Value& table, std::string_view key) {
    for (const Value& member : table.items) {
        if (member.key == key) return &member;
    }
    return nullptr;
}

Value* find(Value& table, std::string_view key) {
    return const_cast<Value*>(find(static_cast<const Value&>(table), key));
}

const Place& place_of(const Value& table, std::string_view key) {
    const Value* value = find(table, key);
    return value ? value->place : table.place;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known, const std::string& what) {
    std::string nearest = word.size() <= kLongestWord ? word_around(word, known) : "";
    if (nearest.empty() && word.size() <= kLongestWord) nearest = nearest_word(word, known);
    if (!nearest.empty()) return "; did you mean " + in_quotes(nearest) + "?";
    if (known.empty()) return "";
    std::string list = "; known " + what + ": ";
    for (std::size_t i = 0; i < known.size() && i < kMaxListed; ++i) {
        list += (i > 0 ? ", " : "") + on_one_line(known[i]);
    }
    return list + (known.size() > kMaxListed ? ", ..." : "");
}

}  // namespace kreda::scene
