// A scene file as text: read with other values, and written with them.
#pragma once

#include <string>
#include <vector>

#include "scene/files/read_scene.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::tools {

struct SceneSource {
    std::string text;
    std::string name;    ///< in messages
    std::string folder;  ///< where relative paths start
    scene::ReadOptions read;
};

/// A key and what is to stand there: table "material", which 0, key "fresnel". which = -1: the table is not repeated.
struct Setting {
    std::string table;
    int which = -1;
    std::string key;
    std::string value;  ///< a word or a number, without quotes

    bool operator==(const Setting&) const = default;
};

/// "material.0.fresnel=exact"
[[nodiscard]] std::string override_of(const Setting& setting);

/// The scene with these values. Throws UserError where they do not go together.
[[nodiscard]] scene::Scene read_with(const SceneSource& source, const std::vector<Setting>& settings);

/// What the scene says of a key, or what holds without it; words without quotes.
[[nodiscard]] std::string value_in(const SceneSource& source, const std::string& table, int which,
                                   const std::string& key);

/// A setting, and what is to be said beside it.
struct Change {
    Setting setting;
    std::string comment;
};

/// The text with the changes, everything else as it was. Throws UserError where a table stands in one line and lacks
/// the key.
[[nodiscard]] std::string changed_text(const SceneSource& source, const std::vector<Change>& changes);

}  // namespace kreda::tools
