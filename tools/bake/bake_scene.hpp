// Baking a scene's environment before it is drawn: from the cache where it is there, with a bar where it takes a while.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace CLI {
class App;
}

namespace kreda::tools {

struct CacheOptions {
    std::string folder;  ///< empty: beside the scene file
    bool off = false;
};

/// --cache DIR and --no-cache.
void add_cache_options(CLI::App& command, CacheOptions& options);

/// Make the maps that a plan of this scene requires (RenderPlan::environment), if any. A cache that cannot be written
/// is a word on stderr.
void bake_scene(scene::Scene& scene, const lighting::EnvironmentNeeds& needs, const CacheOptions& options);

}  // namespace kreda::tools
