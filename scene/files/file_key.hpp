// Keys of a scene file that name files.
#pragma once

#include <string>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// A name of a scene file as a path; relative ones start at `folder`.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& name);

/// The path that a key names. Throws UserError at the key's place, with the nearest name, if no such file is there.
[[nodiscard]] std::string existing_file(const Value& key, const std::string& folder);

/// "; did you mean 'x'?" with the file in the same folder whose name is nearest to that of `path`, or "".
[[nodiscard]] std::string did_you_mean_file(const std::string& path);

}  // namespace kreda::scene
