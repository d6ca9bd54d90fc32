#include "tools/view/scene_text.hpp"

#include <nlohmann/json.hpp>

#include "scene/files/scene_keys.hpp"
#include "tools/keys_json.hpp"

namespace kreda::tools {

namespace {

/// Numbers, words and arrays of them are written in TOML as in JSON, which gives as many digits as bring the number
/// back.
void append_table(const scene::Value& table, std::string_view name, std::string& text) {
    text += (text.empty() ? "" : "\n") + scene::table_title(name) + "\n";
    for (const scene::Value& member : table.items) text += member.key + " = " + as_json(member).dump() + "\n";
}

}  // namespace

std::string text_of_scene(const scene::Value& root) {
    std::string text;
    for (const scene::Value& table : root.items) {
        if (table.kind == scene::ValueKind::array) {
            for (const scene::Value& item : table.items) append_table(item, table.key, text);
        } else {
            append_table(table, table.key, text);
        }
    }
    return text;
}

}  // namespace kreda::tools
