#include "tools/bake/bake_scene.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/files/environment_cache.hpp"
#include "tools/progress_bar.hpp"

namespace kreda::tools {

void add_cache_options(CLI::App& command, CacheOptions& options) {
    CLI::Option* folder =
        command
            .add_option("--cache", options.folder,
                        "Folder for the maps baked from the environment; by default .kreda-cache beside the scene file")
            ->type_name("DIR");
    command.add_flag("--no-cache", options.off, "Bake the environment's maps anew and keep none")->excludes(folder);
}

void bake_scene(scene::Scene& scene, const lighting::EnvironmentNeeds& needs, const CacheOptions& options) {
    if (!needs.any()) return;
    const std::string named = scene.environment.file;
    ProgressBar bar("baking " + (named.empty() ? "the sky" : std::filesystem::path(named).filename().string()));
    const std::string folder = options.folder.empty() ? scene::cache_folder_of(scene.file) : options.folder;
    if (options.off || folder.empty()) {
        scene.environment.prepared =
            std::make_shared<scene::PreparedEnvironment>(prepare_environment(scene.environment, needs, bar.progress()));
        return;
    }
    scene::CacheReport report;
    scene.environment.prepared = std::make_shared<scene::PreparedEnvironment>(
        cached_environment(scene.environment, needs, folder, bar.progress(), report));
    if (report.why_not_kept.empty()) return;
    bar.clear();
    std::cerr << "note: the baked maps are not kept: " << report.why_not_kept
              << " (--cache DIR keeps them elsewhere, --no-cache keeps none)\n";
}

}  // namespace kreda::tools
