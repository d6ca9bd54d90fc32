#include "scene/files/loaded_files.hpp"

namespace kreda::scene {

namespace {

template <class Thing>
void forget_unused(KeptByKey<Thing>& kept) {
    std::erase_if(kept, [](const auto& entry) { return !entry.second.is_used; });
    for (auto& [key, entry] : kept) entry.is_used = false;
}

}  // namespace

void forget_unused(LoadedFiles& files) {
    forget_unused(files.meshes);
    forget_unused(files.shapes);
    forget_unused(files.textures);
    forget_unused(files.environments);
    std::erase_if(files.tangents, [](const auto& entry) { return entry.second.from.use_count() == 1; });
    files.used.clear();
}

std::shared_ptr<const LoadedMesh> load_mesh(LoadedFiles* files, const std::string& path,
                                            const MeshFileOptions& options) {
    const std::string key = canonical_path(path) + " normals " + std::to_string(static_cast<int>(options.normals)) +
                            " crease " + (options.crease ? std::to_string(*options.crease) : "") +
                            (options.allow_outside ? " outside" : "");
    return find_or_make(files, &LoadedFiles::meshes, key, [&](std::vector<UsedFile>& from) {
        from.push_back(use_file(path));
        LoadedMesh loaded = load_mesh_file(path, options);
        from.insert(from.end(), loaded.other_files.begin(), loaded.other_files.end());
        return loaded;
    });
}

}  // namespace kreda::scene
