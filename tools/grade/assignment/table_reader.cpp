#include "tools/grade/assignment/table_reader.hpp"

#include <algorithm>
#include <fstream>
#include <vector>

#include "tools/explain/derivation.hpp"

namespace kreda::tools {

using scene::Value;
using scene::ValueKind;

const Value* TableReader::find(const std::string& key, ValueKind kind, const char* expected) {
    known_.push_back(key);
    const Value* value = scene::find(table_, key);
    if (value == nullptr) return nullptr;
    const bool fits = value->kind == kind || (kind == ValueKind::number && value->kind == ValueKind::integer);
    if (!fits) complain(key, std::string("expected ") + expected);
    return value;
}

void TableReader::read(const std::string& key, std::string& result) {
    if (const Value* value = find(key, ValueKind::text, "a text in quotes")) result = value->text;
}

void TableReader::read(const std::string& key, double& result, double least, double most) {
    const Value* value = find(key, ValueKind::number, "a number");
    if (value == nullptr) return;
    if (!(value->number >= least && value->number <= most)) {
        complain(key, "expected a number from " + number_text(least) + " to " + number_text(most));
    }
    result = value->number;
}

void TableReader::read(const std::string& key, int& result, int least, int most) {
    const Value* value = find(key, ValueKind::integer, "a whole number");
    if (value == nullptr) return;
    if (value->integer < least || value->integer > most) {
        complain(key, "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    result = static_cast<int>(value->integer);
}

void TableReader::read(const std::string& key, bool& result) {
    if (const Value* value = find(key, ValueKind::boolean, "true or false")) result = value->boolean;
}

void TableReader::read(const std::string& key, std::vector<std::string>& result) {
    const Value* single = scene::find(table_, key);
    if (single != nullptr && single->kind == ValueKind::text) {
        known_.push_back(key);
        result = {single->text};
        return;
    }
    const Value* value = find(key, ValueKind::array, "texts in [ ]");
    if (value == nullptr) return;
    result.clear();
    for (const Value& item : value->items) {
        if (item.kind != ValueKind::text) complain(key, "expected texts in quotes");
        result.push_back(item.text);
    }
}

void TableReader::read(const std::string& key, std::vector<double>& result) {
    const Value* value = find(key, ValueKind::array, "numbers in [ ]");
    if (value == nullptr) return;
    result.clear();
    for (const Value& item : value->items) {
        if (item.kind != ValueKind::number && item.kind != ValueKind::integer) complain(key, "expected numbers");
        result.push_back(item.kind == ValueKind::integer ? static_cast<double>(item.integer) : item.number);
    }
}

std::vector<const Value*> TableReader::tables(const std::string& key) {
    std::vector<const Value*> result;
    const Value* value = find(key, ValueKind::array, ("[[" + key + "]]").c_str());
    if (value == nullptr) return result;
    for (const Value& item : value->items) {
        if (item.kind != ValueKind::table) complain(key, "expected [[" + key + "]]");
        result.push_back(&item);
    }
    return result;
}

const Value* TableReader::table(const std::string& key) {
    return find(key, ValueKind::table, ("[" + key + "]").c_str());
}

void TableReader::require(const std::string& key) const {
    if (scene::find(table_, key) != nullptr) return;
    throw scene::UserError(table_.place, what_ + " misses the key '" + key + "'");
}

void TableReader::done() const {
    for (const Value& member : table_.items) {
        if (std::find(known_.begin(), known_.end(), member.key) != known_.end()) continue;
        throw scene::UserError(member.key_place, "unknown key " + scene::in_quotes(member.key) + " in " + what_ +
                                                     scene::did_you_mean(member.key, known_, "keys"));
    }
}

void TableReader::complain(const std::string& key, const std::string& message) const {
    throw scene::UserError(scene::place_of(table_, key), "'" + key + "' in " + what_ + ": " + message);
}

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text;
    std::vector<char> part(1 << 20);  // a catalogue's answers are hundreds of megabytes: not byte by byte
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0) {
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof()) throw scene::UserError(scene::Place{path}, "cannot be read; does it exist?");
    return text;
}

}  // namespace kreda::tools
