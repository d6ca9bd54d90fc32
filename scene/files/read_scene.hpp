// Scene files: TOML in, plain data out; every complaint has file, line, column and a remedy.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::scene {

struct LoadedFiles;

struct ReadOptions {
    bool allow_outside = false;          ///< OBJ and MTL files may name files outside their own folder
    std::vector<std::string> overrides;  ///< "--set": "camera.position=[0,1,4]", "material.gold.shininess=9"
    bool maps_later = false;             ///< load_maps() follows, once it is known which maps are read
    LoadedFiles* files = nullptr;        ///< what is kept from one reading to the next; nullptr: nothing is
};

/// Read, check and load a scene with all its meshes. Throws UserError.
[[nodiscard]] Scene read_scene(const std::string& path, const ReadOptions& options = {});

/// The same from text; `name` stands for the file in messages, relative paths start at `folder`.
[[nodiscard]] Scene read_scene_text(const std::string& text, const std::string& name, const std::string& folder,
                                    const ReadOptions& options = {});

/// What `kreda render` without a scene shows: the text of a small scene file, good to start one's own from.
[[nodiscard]] std::string built_in_scene_text();

}  // namespace kreda::scene
