// The page of `kreda view`: the one that the preset `web` built, with a scene in it.
#pragma once

#include <string>
#include <vector>

#include "tools/view/view_files.hpp"

namespace kreda::tools {

/// Where the page without a scene may be: in ../share/kreda from the running program (so `cmake --install` leaves it),
/// and in the folder of the build `web`.
[[nodiscard]] std::vector<std::string> view_page_places();

/// The first of these that is there. Throws UserError, which says what to install and build.
[[nodiscard]] std::string read_view_page(const std::vector<std::string>& places);

/// How the page begins.
struct PageStart {
    std::vector<std::string> overrides;  ///< "--set"
    std::vector<std::string> controls;   ///< keys that stand first: "fog.density", "material.0.roughness"
};

/// The page with this scene and its files in it.
[[nodiscard]] std::string page_with_scene(std::string page, const CarriedScene& scene, const PageStart& start);

}  // namespace kreda::tools
