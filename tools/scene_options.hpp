// What every command that reads a scene takes from the command line.
#pragma once

#include <string>

#include "scene/files/read_scene.hpp"

namespace CLI {
class App;
}

namespace kreda::tools {

struct SceneOptions {
    std::string file;         ///< empty: the built-in scene
    scene::ReadOptions read;  ///< --set, --allow-outside
};

void add_scene_options(CLI::App& command, SceneOptions& options);

/// Read the scene, or the built-in one; its warnings go to stderr. Throws UserError.
[[nodiscard]] scene::Scene load_scene(const SceneOptions& options);

/// "640x360" -> "[640,360]", what --set image.size wants. Throws UserError.
[[nodiscard]] std::string size_value(const std::string& text);

/// One line on stderr.
void warn(const std::string& message);

}  // namespace kreda::tools
