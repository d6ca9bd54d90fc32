#include "tools/kept_frames.hpp"

#include <algorithm>

namespace kreda::tools {

void bake_kept(scene::Scene& scene, const scene::RenderPlan& plan, const CacheOptions& cache, KeptFrames& kept) {
    constexpr std::size_t kMost = 4;  // of some ten megabytes each
    if (!plan.environment.any()) return;
    const auto found = std::find_if(kept.baked.begin(), kept.baked.end(), [&](const auto& prepared) {
        return serves(*prepared, scene.environment, plan.environment);
    });
    if (found != kept.baked.end()) {
        scene.environment.prepared = *found;
        return;
    }
    bake_scene(scene, plan.environment, cache);
    if (kept.baked.size() == kMost) kept.baked.erase(kept.baked.begin());
    kept.baked.push_back(scene.environment.prepared);
}

}  // namespace kreda::tools
