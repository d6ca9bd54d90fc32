// What was read and decoded once, for scenes that are read again and again: sweeps, tuning, `kreda render --watch`.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "raster/mesh.hpp"
#include "raster/texture.hpp"
#include "scene/files/file_state.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/files/read_environment.hpp"
#include "scene/map_meshes.hpp"

namespace kreda::scene {

/// Texels of a map, and what there was to say about its file.
struct LoadedTexture {
    std::shared_ptr<const raster::Texture> texture;
    std::vector<std::string> warnings;
};

/// A thing and the files that it was made of.
template <class Thing>
struct Kept {
    std::shared_ptr<const Thing> thing;
    std::vector<UsedFile> from;
    bool is_used = false;  ///< since forget_unused()
};

template <class Thing>
using KeptByKey = std::map<std::string, Kept<Thing>>;

/// Hand it to ReadOptions::files and load_maps(): what is in it and unchanged on disk is not read again. Equal to
/// reading everything anew, warnings included.
struct LoadedFiles {
    KeptByKey<LoadedMesh> meshes;
    KeptByKey<raster::Mesh> shapes;
    KeptByKey<LoadedTexture> textures;
    KeptByKey<EnvironmentImage> environments;
    TangentMeshes tangents;
    std::vector<UsedFile> used;  ///< every path that was looked at since forget_unused()
    int reads = 0;               ///< how often a file was read and decoded
    /// While one scene is being read: what was read a moment ago serves, however new the file is.
    bool is_reading = false;
};

/// Is all of it as it was when something was made of it?
[[nodiscard]] bool still_holds(const LoadedFiles& files, const std::vector<UsedFile>& from);

/// Throw away what was not asked for since the last call.
void forget_unused(LoadedFiles& files);

/// The thing of that key if it is kept and what it was made of is unchanged; else nullptr.
template <class Thing>
[[nodiscard]] std::shared_ptr<const Thing> find_kept(LoadedFiles& files, KeptByKey<Thing> LoadedFiles::*kind,
                                                     const std::string& key) {
    const auto found = (files.*kind).find(key);
    if (found == (files.*kind).end() || !still_holds(files, found->second.from)) return nullptr;
    found->second.is_used = true;
    files.used.insert(files.used.end(), found->second.from.begin(), found->second.from.end());
    return found->second.thing;
}

template <class Thing>
void keep(LoadedFiles& files, KeptByKey<Thing> LoadedFiles::*kind, const std::string& key,
          const std::shared_ptr<const Thing>& thing, const std::vector<UsedFile>& from) {
    files.used.insert(files.used.end(), from.begin(), from.end());
    files.reads += from.empty() ? 0 : 1;
    (files.*kind)[key] = {thing, from, true};
}

/// The thing of that key, kept, or made by make(from): it adds to `from` what it reads, each path before it is read.
/// Without a store it is made each time. Throws what `make` throws.
template <class Thing, class Make>
[[nodiscard]] std::shared_ptr<const Thing> find_or_make(LoadedFiles* files, KeptByKey<Thing> LoadedFiles::*kind,
                                                        const std::string& key, Make make) {
    std::vector<UsedFile> from;
    if (!files) return std::make_shared<const Thing>(make(from));
    if (std::shared_ptr<const Thing> kept = find_kept(*files, kind, key)) return kept;
    try {
        auto thing = std::make_shared<const Thing>(make(from));
        keep(*files, kind, key, thing, from);
        return thing;
    } catch (...) {
        files->used.insert(files->used.end(), from.begin(), from.end());
        throw;
    }
}

/// load_mesh_file() through the store.
[[nodiscard]] std::shared_ptr<const LoadedMesh> load_mesh(LoadedFiles* files, const std::string& path,
                                                          const MeshFileOptions& options);

}  // namespace kreda::scene
