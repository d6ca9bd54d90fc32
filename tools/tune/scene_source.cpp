#include "tools/tune/scene_source.hpp"

#include <algorithm>
#include <sstream>

#include "raster/platform.hpp"
#include "scene/files/scene_keys.hpp"

namespace kreda::tools {

namespace {

using scene::KeyInfo;
using scene::UserError;
using scene::Value;

std::string without_quotes(const std::string& text) {
    const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return is_quoted ? text.substr(1, text.size() - 2) : text;
}

const Value* table_in(const Value& root, const std::string& table, int which) {
    const Value* found = find(root, table);
    if (!found || which < 0) return found;
    const auto index = static_cast<std::size_t>(which);
    return index < found->items.size() ? &found->items[index] : nullptr;
}

/// As a file has it: words in quotes.
std::string written(const Setting& setting) {
    const KeyInfo* info = scene::find_key(setting.table, setting.key);
    KREDA_EXPECT(info != nullptr);
    return info->type == scene::KeyType::word ? "\"" + setting.value + "\"" : setting.value;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Where the value that begins at `from` ends: a word in quotes, or a number or bool.
std::size_t end_of_value(const std::string& line, std::size_t from) {
    if (line[from] == '"' || line[from] == '\'') {
        const std::size_t close = line.find(line[from], from + 1);
        return close == std::string::npos ? line.size() : close + 1;
    }
    return std::min(line.find_first_of(" \t,#}\r", from), line.size());
}

void replace_value(std::vector<std::string>& lines, const Value& old, const Change& change) {
    std::string& line = lines[static_cast<std::size_t>(old.place.line - 1)];
    const auto from = static_cast<std::size_t>(old.place.column - 1);
    const std::size_t end = end_of_value(line, from);
    const std::string rest = line.substr(end);
    line = line.substr(0, from) + written(change.setting) + rest;
    if (!change.comment.empty()) line += (rest.find('#') == std::string::npos ? "  # " : "; ") + change.comment;
}

std::string line_of(const Change& change) {
    return change.setting.key + " = " + written(change.setting) +
           (change.comment.empty() ? "" : "  # " + change.comment);
}

/// Below the table's header, which opens with a bracket.
void insert_line(std::vector<std::string>& lines, const SceneSource& source, const Value& table, const Change& change) {
    const int header = table.place.line;
    const std::string& line = lines[static_cast<std::size_t>(header - 1)];
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] != '[') {
        throw UserError({source.name, header, 1}, "write this table below a line of its own, [" + change.setting.table +
                                                      "], so that a key can be added to it: " + line_of(change));
    }
    lines[static_cast<std::size_t>(header - 1)] += "\n" + line_of(change);
}

}  // namespace

std::string override_of(const Setting& setting) {
    const std::string which = setting.which < 0 ? "" : "." + std::to_string(setting.which);
    return setting.table + which + "." + setting.key + "=" + setting.value;
}

scene::Scene read_with(const SceneSource& source, const std::vector<Setting>& settings) {
    scene::ReadOptions options = source.read;
    for (const Setting& setting : settings) options.overrides.push_back(override_of(setting));
    return scene::read_scene_text(source.text, source.name, source.folder, options);
}

std::string value_in(const SceneSource& source, const std::string& table, int which, const std::string& key) {
    const Value root = scene::parse_toml(source.text, source.name);
    const Value* holder = table_in(root, table, which);
    const Value* value = holder ? find(*holder, key) : nullptr;
    if (!value) return without_quotes(scene::find_key(table, key)->default_value);
    if (value->kind == scene::ValueKind::text) return value->text;
    if (value->kind == scene::ValueKind::boolean) return value->boolean ? "true" : "false";
    return std::to_string(value->integer);
}

std::string changed_text(const SceneSource& source, const std::vector<Change>& changes) {
    const Value root = scene::parse_toml(source.text, source.name);
    std::vector<std::string> lines = lines_of(source.text), added;
    for (const Change& change : changes) {
        const Setting& setting = change.setting;
        const Value* table = table_in(root, setting.table, setting.which);
        const Value* old = table ? find(*table, setting.key) : nullptr;
        if (old) {
            replace_value(lines, *old, change);
        } else if (table) {
            insert_line(lines, source, *table, change);
        } else {
            const std::string header = "\n[" + setting.table + "]";
            if (std::find(added.begin(), added.end(), header) == added.end()) added.push_back(header);
            added.insert(std::find(added.begin(), added.end(), header) + 1, line_of(change));
        }
    }
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    for (const std::string& line : added) text += line + "\n";
    return text;
}

}  // namespace kreda::tools
