// What frames that follow each other share: files are read once, maps baked once, and what a change does not touch is
// not computed again.
#pragma once

#include <memory>
#include <vector>

#include "scene/files/loaded_files.hpp"
#include "scene/render/render.hpp"
#include "tools/bake/bake_scene.hpp"

namespace kreda::tools {

struct KeptFrames {
    scene::LoadedFiles files;                                              ///< for ReadOptions::files
    scene::RenderBuffers buffers;                                          ///< with keeps_results
    std::vector<std::shared_ptr<const scene::PreparedEnvironment>> baked;  ///< the last few

    KeptFrames() {
        buffers.keeps_results = true;
    }
};

/// bake_scene(), unless the maps were baked for a frame before.
void bake_kept(scene::Scene& scene, const scene::RenderPlan& plan, const CacheOptions& cache, KeptFrames& kept);

}  // namespace kreda::tools
