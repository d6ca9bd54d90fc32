#include "scene/files/overrides.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "scene/files/toml_check.hpp"

namespace kreda::scene {

namespace {

/// camera.position=... : table "camera", key "position".   material.gold.diffuse=... : also which = "gold".
struct Override {
    Place place;
    std::string table, which, key, value;
};

constexpr const char* kForms = "; expected TABLE.KEY=VALUE, light.0.KEY=VALUE or material.NAME.KEY=VALUE";

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    const std::size_t last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// A material's name may hold dots itself, so `which` is all between the first dot and the last.
Override split(const std::string& text) {
    const Place place{"--set " + on_one_line(text), 0, 0};
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UserError(place, std::string("there is no '='") + kForms);
    const std::string path = trimmed(text.substr(0, equals));
    const std::size_t first = path.find('.');
    if (first == std::string::npos) throw UserError(place, std::string("there is no '.' before the '='") + kForms);
    const std::size_t last = path.rfind('.');
    Override result{place, path.substr(0, first), "", path.substr(last + 1), trimmed(text.substr(equals + 1))};
    if (last > first) result.which = path.substr(first + 1, last - first - 1);
    if (result.key.empty() || result.value.empty()) {
        throw UserError(place, std::string(result.key.empty() ? "there is no key" : "there is no value") + kForms);
    }
    return result;
}

void set_places(Value& value, const Place& place) {
    value.place = value.key_place = place;
    for (Value& item : value.items) set_places(item, place);
}

/// A TOML value, or a bare word such as gouraud, which stands for "gouraud".
Value parse_value(const Override& override) {
    Value value;
    value.kind = ValueKind::text;
    value.text = override.value;
    const bool starts_toml = std::string("[{\"'").find(override.value.front()) != std::string::npos;
    try {
        Value root = parse_toml("value = " + override.value, "value");
        if (root.items.size() == 1) value = std::move(root.items.front());
    } catch (const UserError& error) {
        if (starts_toml) throw UserError(override.place, error.what());
    }
    value.key = override.key;
    set_places(value, override.place);
    return value;
}

std::optional<std::size_t> number_in(const std::string& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::string material_name(const Value& material) {
    const Value* name = find(material, "name");
    return name ? name->text : "";
}

[[noreturn]] void throw_no_such(const Override& override, const std::vector<Value>& items) {
    const std::string what = "there is no " + override.table + " " + in_quotes(override.which);
    if (!number_in(override.which) && override.table == "material") {
        std::vector<std::string> names;
        for (const Value& material : items) names.push_back(material_name(material));
        throw UserError(override.place, what + did_you_mean(override.which, names, "materials"));
    }
    std::string numbers = "; the scene has none";
    if (!items.empty()) numbers = "; the scene has 0 to " + std::to_string(items.size() - 1);
    throw UserError(override.place, what + numbers);
}

/// The one of [[light]], [[material]] or [[object]] that is meant.
Value& pick(Value& array, const Override& override) {
    for (Value& item : array.items) {
        if (override.table == "material" && material_name(item) == override.which) return item;
    }
    const std::optional<std::size_t> number = number_in(override.which);
    if (!number || *number >= array.items.size()) throw_no_such(override, array.items);
    return array.items[*number];
}

Value& table_of(Value& root, const Override& override) {
    const std::vector<std::string> names = table_names();
    if (std::find(names.begin(), names.end(), override.table) == names.end()) {
        const std::string what = "unknown table " + in_quotes(override.table);
        throw UserError(override.place, what + did_you_mean(override.table, names, "tables"));
    }
    const bool repeated = is_repeated(override.table);
    if (repeated && override.which.empty()) {
        throw UserError(override.place, "which one? write " + override.table + ".0." + override.key);
    }
    if (!repeated && !override.which.empty()) throw UserError(override.place, std::string("too many dots") + kForms);
    Value* table = find(root, override.table);
    if (!table) {
        Value added;
        added.kind = repeated ? ValueKind::array : ValueKind::table;
        added.key = override.table;
        added.place = added.key_place = override.place;
        table = &root.items.emplace_back(std::move(added));
    }
    return repeated ? pick(*table, override) : *table;
}

/// Of a file and a built-in sky one gives the light: the one that is set last.
void remove_other_light(Value& table, const std::string& key) {
    if (table.key != "environment" || (key != "file" && key != "sky")) return;
    std::erase_if(table.items, [&](const Value& item) { return item.key == (key == "file" ? "sky" : "file"); });
}

}  // namespace

void apply_overrides(Value& root, const std::vector<std::string>& overrides) {
    for (const std::string& text : overrides) {
        const Override override = split(text);
        Value& table = table_of(root, override);
        Value value = parse_value(override);
        remove_other_light(table, value.key);
        if (Value* old = find(table, value.key)) {
            *old = std::move(value);
        } else {
            table.items.push_back(std::move(value));
        }
    }
}

}  // namespace kreda::scene
