#include "tools/scene_options.hpp"

#include <iostream>

#include <CLI/CLI.hpp>

#include "tools/mesh_scene.hpp"

namespace kreda::tools {

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("scene", options.file, "The scene file (TOML), or a mesh (OBJ) to look at; without it, a built-in teapot")
        ->type_name("SCENE.toml|MESH.obj");
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
    const auto read = [&]() -> scene::Scene {
        if (options.file.empty()) {
            return scene::read_scene_text(scene::built_in_scene_text(), "built-in scene", "", options.read);
        }
        if (is_mesh_file(options.file)) {
            const std::string text = scene_around_mesh(options.file, {scene::Normals::file, options.read.allow_outside});
            return scene::read_scene_text(text, "scene around " + options.file, "", options.read);
        }
        return scene::read_scene(options.file, options.read);
    };
    const scene::Scene scene = read();
    for (const std::string& warning : scene.warnings) warn(warning);
    return scene;
}

void warn(const std::string& message) { std::cerr << "warning: " << message << "\n"; }

}  // namespace kreda::tools
