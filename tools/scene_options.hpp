// What every command that reads a scene takes from the command line.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/files/read_scene.hpp"
#include "scene/plan/plan.hpp"

namespace CLI {
class App;
}

namespace kreda::tools {

struct SceneOptions {
    std::string file;         ///< empty: the built-in scene
    scene::ReadOptions read;  ///< --set, --allow-outside
    std::string size;         ///< "640x360"; empty: what the scene says
    int samples = 0;          ///< 0: what the scene says
    int light = -1;           ///< draw with this light alone; -1: with all that are on
    bool quiet = false;       ///< warnings are not printed
    bool strict = false;      ///< a warning is an error
};

/// SCENE, --set, --allow-outside, --size, --samples, --light, --quiet, --strict: the commands that take them look at
/// the same picture.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// --threads N, 0 where it is not given.
void add_threads_option(CLI::App& command, int& threads);

/// Read the scene, or the built-in one; its warnings go to stderr. Throws UserError.
[[nodiscard]] scene::Scene load_scene(const SceneOptions& options);

/// A scene, and the plan of what is asked for.
struct PlannedScene {
    scene::Scene scene;
    scene::RenderPlan plan;
};

/// Read a scene, change it by `adapt`, and plan it in two steps: its maps are loaded once it is known which of them are
/// read; all of them where a view looks at one. Warnings about any of this go to stderr. Throws UserError.
[[nodiscard]] PlannedScene load_and_plan(
    const SceneOptions& options, const scene::PlanRequest& request,
    const std::function<void(scene::Scene&)>& adapt = [](scene::Scene&) {});

/// One line on stderr.
void warn(const std::string& message);

/// Warnings about a scene: a line each on stderr. With --quiet none is printed; with --strict they are an error: throws
/// UserError after the last.
void warn_of_scene(const std::vector<std::string>& warnings, const SceneOptions& options);

}  // namespace kreda::tools
