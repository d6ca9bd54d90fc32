// Baked maps kept in a folder, so that the next render of the same environment need not bake them.
//
// One file a map. Its name and its first bytes hold a key: what the map was made from (the image's texels, or the sky's
// radiance), every setting, and what the formulas make of a small test environment. Whoever changes a formula changes
// the key, and sees the change. A file is written under a name of its own and renamed, so renders may share a folder;
// one that is cut off or damaged is baked again.
#pragma once

#include <string>

#include "scene/environment.hpp"

namespace kreda::scene {

/// ".kreda-cache", the folder beside the scene file.
inline constexpr const char* kCacheFolder = ".kreda-cache";

/// Where a scene's maps are kept: beside its file; empty for a scene that has none.
[[nodiscard]] std::string cache_folder_of(const std::string& scene_file);

struct CacheReport {
    int found = 0;             ///< maps that were in the cache
    int baked = 0;             ///< maps that were not
    std::string why_not_kept;  ///< those could not be written: why; empty: they were
};

/// As prepare_environment, bit for bit. `progress` is called only if there is something to bake.
[[nodiscard]] PreparedEnvironment cached_environment(const EnvironmentSettings& settings,
                                                     const lighting::EnvironmentNeeds& needs, const std::string& folder,
                                                     const lighting::Progress& progress, CacheReport& report);

}  // namespace kreda::scene
