#include "tools/view/view_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "lighting/batch/maps.hpp"
#include "scene/files/obj_text.hpp"
#include "tools/mesh_scene.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code failed;
    return fs::is_regular_file(path, failed);
}

void check_image(const fs::path& path) {
    const std::string ending = scene::in_lower_case(path.extension().string());
    for (const char* known : {".png", ".jpg", ".jpeg", ".tga", ".bmp", ".hdr"}) {
        if (ending == known) return;
    }
    throw scene::UserError(scene::Place{path.string()},
                           "cannot be read in a browser; convert it to .png, .jpg, .tga, .bmp or .hdr");
}

std::set<fs::path> paths_of(const scene::Scene& scene, const fs::path& folder, const scene::LoadedFiles& loaded) {
    std::set<fs::path> meshes, images;
    for (const scene::Object& object : scene.objects) {
        const fs::path mesh = folder / object.mesh_name;
        if (is_mesh_file(object.mesh_name) && is_file(mesh)) meshes.insert(mesh);
    }
    for (const lighting::Material& material : scene.materials) {
        for (const lighting::MapUse& use : lighting::map_uses()) {
            const std::string& file = (material.maps.*use.map).file;
            if (!file.empty()) images.insert(file);
        }
    }
    if (!scene.environment.file.empty()) images.insert(folder / scene.environment.file);
    for (const fs::path& image : images) check_image(image);
    std::set<fs::path> paths = images;
    paths.insert(meshes.begin(), meshes.end());
    for (const scene::UsedFile& used : loaded.used) {
        const bool is_material_file = scene::in_lower_case(fs::path(used.path).extension().string()) == ".mtl";
        if (is_material_file && is_file(used.path)) paths.insert(used.path);
    }
    return paths;
}

/// As many folders as relative paths climb out of the scene's: "up/up".
fs::path page_folder(const std::vector<fs::path>& relative) {
    std::ptrdiff_t most = 0;
    for (const fs::path& path : relative) most = std::max(most, std::count(path.begin(), path.end(), fs::path("..")));
    fs::path folder;
    for (; most > 0; --most) folder /= "up";
    return folder;
}

/// Does the scene name a file by the whole way to it?
bool names_whole_paths(const scene::Scene& scene) {
    const auto is_whole = [](const scene::Object& object) { return fs::path(object.mesh_name).is_absolute(); };
    return std::any_of(scene.objects.begin(), scene.objects.end(), is_whole) ||
           fs::path(scene.environment.file).is_absolute();
}

}  // namespace

CarriedScene files_of_scene(const scene::Scene& scene, const std::string& path, const scene::LoadedFiles& loaded) {
    if (path.empty()) return {};
    const fs::path folder = fs::path(path).parent_path();
    std::set<fs::path> paths = paths_of(scene, folder, loaded);
    paths.insert(path);
    const fs::path whole_folder = fs::absolute(folder.empty() ? "." : folder).lexically_normal();
    const bool is_whole = !is_mesh_file(path) && names_whole_paths(scene);
    std::vector<fs::path> names;
    for (const fs::path& file : paths) {
        const fs::path whole = fs::absolute(file).lexically_normal();
        names.push_back(is_whole ? whole : whole.lexically_relative(whole_folder));
    }
    CarriedScene carried;
    const fs::path in_page = is_whole ? whole_folder : page_folder(names);
    carried.path = fs::path(path).filename().string();
    carried.folder = in_page.string();
    for (std::size_t i = 0; const fs::path& file : paths) {
        carried.files.push_back({(in_page / names[i]).lexically_normal().string(), file.string()});
        ++i;
    }
    return carried;
}

}  // namespace kreda::tools
