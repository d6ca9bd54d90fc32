// What else is given as a mesh or a scene: told by its name, with the way from there to an OBJ.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "scene/files/mesh_file.hpp"
#include "scene/files/obj_text.hpp"

namespace kreda::scene {

namespace {

struct Format {
    std::string_view extension;
    std::string_view name;
};

/// All of them can be opened by Blender; those of assimp's `assimp export` are marked below.
constexpr std::array<Format, 17> kMeshes = {{{".ply", "a PLY mesh"},
                                             {".stl", "an STL mesh"},
                                             {".fbx", "an FBX scene"},
                                             {".dae", "a COLLADA scene"},
                                             {".3ds", "a 3D Studio scene"},
                                             {".off", "an OFF mesh"},
                                             {".x3d", "an X3D scene"},
                                             {".wrl", "a VRML scene"},
                                             {".3mf", "a 3MF mesh"},
                                             {".lwo", "a LightWave mesh"},
                                             {".blend", "a Blender file"},
                                             {".usd", "a USD scene"},
                                             {".usda", "a USD scene"},
                                             {".usdc", "a USD scene"},
                                             {".usdz", "a USD scene"},
                                             {".abc", "an Alembic scene"},
                                             {".max", "a 3ds Max file"}}};

constexpr std::array<std::string_view, 10> kImages = {".png", ".jpg", ".jpeg", ".tga",  ".tif",
                                                      ".bmp", ".hdr", ".exr",  ".webp", ".tiff"};
constexpr std::array<std::string_view, 8> kArchives = {".zip", ".gz", ".7z", ".rar", ".tar", ".xz", ".bz2", ".zst"};

bool assimp_reads(std::string_view extension) {
    constexpr std::array<std::string_view, 10> kRead = {".ply", ".stl", ".fbx", ".dae", ".3ds",
                                                        ".off", ".x3d", ".wrl", ".3mf", ".lwo"};
    return std::find(kRead.begin(), kRead.end(), extension) != kRead.end();
}

}  // namespace

std::string other_format(const std::string& path) {
    const std::filesystem::path file(path);
    const std::string extension = in_lower_case(file.extension().string());
    const auto is_one_of = [&](const auto& list) {
        return std::find(list.begin(), list.end(), extension) != list.end();
    };
    if (is_one_of(kImages))
        return "is an image; Kreda draws scenes (TOML) and meshes (OBJ, glTF), images are their maps";
    if (is_one_of(kArchives)) return "is an archive; unpack it first, Kreda reads meshes as OBJ or glTF";
    if (extension == ".mtl") return "holds the materials of an OBJ file; give the OBJ file itself";
    const auto mesh =
        std::find_if(kMeshes.begin(), kMeshes.end(), [&](const Format& f) { return f.extension == extension; });
    if (mesh == kMeshes.end()) return "";
    const std::string obj = file.stem().string() + ".obj";
    return "is " + std::string(mesh->name) +
           "; Kreda reads meshes as OBJ or glTF: export one with Blender (File, Export)" +
           (assimp_reads(extension) ? " or with `assimp export " + file.filename().string() + " " + obj + "`" : "");
}

}  // namespace kreda::scene
