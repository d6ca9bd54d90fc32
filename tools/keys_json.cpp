#include "tools/keys_json.hpp"

#include <nlohmann/json.hpp>

#include "scene/files/scene_keys.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(scene::KeyType type) {
    switch (type) {
        case scene::KeyType::boolean: return "boolean";
        case scene::KeyType::whole: return "whole";
        case scene::KeyType::whole_pair: return "whole_pair";
        case scene::KeyType::number: return "number";
        case scene::KeyType::number_pair: return "number_pair";
        case scene::KeyType::vector: return "vector";
        case scene::KeyType::number_or_vector: return "number_or_vector";
        case scene::KeyType::vector_or_word: return "vector_or_word";
        case scene::KeyType::word: return "word";
        case scene::KeyType::text: return "text";
        case scene::KeyType::texts: return "texts";
    }
    return "";
}

/// What stands in the table of keys as TOML; null where nothing stands, and where words stand for it ("measured").
Json json_of_toml(std::string_view written) {
    if (written.empty()) return nullptr;
    try {
        return as_json(scene::parse_toml("value = " + std::string(written), "value").items.front());
    } catch (const scene::UserError&) { return nullptr; }
}

}  // namespace

nlohmann::ordered_json as_json(const scene::Value& value) {
    switch (value.kind) {
        case scene::ValueKind::boolean: return value.boolean;
        case scene::ValueKind::integer: return value.integer;
        case scene::ValueKind::number: return value.number;
        case scene::ValueKind::text:
        case scene::ValueKind::date: return value.text;
        case scene::ValueKind::array: {
            Json array = Json::array();
            for (const scene::Value& item : value.items) array.push_back(as_json(item));
            return array;
        }
        case scene::ValueKind::table: break;
    }
    Json table = Json::object();
    for (const scene::Value& member : value.items) table[member.key] = as_json(member);
    return table;
}

nlohmann::ordered_json keys_as_json() {
    Json keys = Json::array();
    for (const scene::KeyInfo& info : scene::scene_keys()) {
        Json key;
        key["table"] = info.table;
        key["repeated"] = scene::is_repeated(info.table);
        key["key"] = info.key;
        key["type"] = name_of(info.type);
        key["meaning"] = info.meaning;
        key["expects"] = scene::type_text(info);
        key["words"] = info.words;
        key["default"] = json_of_toml(info.default_value);
        key["example"] = json_of_toml(info.example);
        key["least"] = info.range.least;
        key["greatest"] = info.range.greatest;
        key["open"] = info.range.open;
        keys.push_back(key);
    }
    return keys;
}

}  // namespace kreda::tools
