#include "tools/scene_options.hpp"

#include <iostream>

#include <CLI/CLI.hpp>

namespace kreda::tools {

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("scene", options.file, "The scene file (TOML); without it, a built-in teapot")
        ->type_name("SCENE.toml");
    command
        .add_option("--set", options.read.overrides,
                    "Override a value of the scene: camera.position=[0,1,4], light.0.intensity=2, "
                    "material.gold.shininess=64; as often as you like")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_flag("--allow-outside", options.read.allow_outside,
                     "Let OBJ and MTL files name files outside their own folder");
}

scene::Scene load_scene(const SceneOptions& options) {
    scene::Scene scene = options.file.empty()
                             ? scene::read_scene_text(scene::built_in_scene_text(), "built-in scene", "", options.read)
                             : scene::read_scene(options.file, options.read);
    for (const std::string& warning : scene.warnings) warn(warning);
    return scene;
}

void warn(const std::string& message) { std::cerr << "warning: " << message << "\n"; }

}  // namespace kreda::tools
