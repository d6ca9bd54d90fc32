#include "scene/files/read_objects.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "raster/normals.hpp"
#include "raster/shapes.hpp"
#include "raster/triangle_setup.hpp"
#include "scene/files/file_key.hpp"
#include "scene/files/key_tables.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/files/toml_check.hpp"
#include "scene/join_parts.hpp"

namespace kreda::scene {

namespace {

/// A mesh that several objects may share, and where its own materials stand in Scene::materials.
struct SharedMesh {
    std::shared_ptr<const raster::Mesh> mesh;
    int first_material = 0;
};

struct ObjectReader {
    const std::string& folder;
    const ReadOptions& options;
    Placements& placements;
    Scene& scene;
    std::size_t named_materials;               ///< the [[material]]s; those of mesh files come after them
    int default_material = -1;                 ///< index, -1: not needed so far
    std::map<std::string, SharedMesh> meshes;  ///< by name and settings

    void read_object(const Value& table);
    SharedMesh mesh_of(const Value& table, const ObjectTable& read);
    SharedMesh load_file(const std::string& path, Normals normals, const std::optional<float>& crease);
    int material_named(const Value& name) const;
    int material_of_none();
};

std::vector<std::string> built_in_names() {
    const auto names = raster::shape_names();
    return {names.begin(), names.end()};
}

raster::Mesh built_in_mesh(const Value& table, const ObjectTable& read, int detail) {
    try {
        raster::Mesh mesh = *raster::make_shape(read.mesh, detail);
        if (read.normals == Normals::smooth) raster::make_smooth_normals(mesh, read.crease.value_or(60.0f));
        if (read.normals == Normals::flat) raster::make_flat_normals(mesh);
        return mesh;
    } catch (const std::invalid_argument& error) { throw UserError(place_of(table, "detail"), error.what()); }
}

SharedMesh ObjectReader::load_file(const std::string& path, Normals normals, const std::optional<float>& crease) {
    const std::shared_ptr<const LoadedMesh> loaded =
        load_mesh(options.files, path, {normals, options.allow_outside, crease});
    SharedMesh shared{{loaded, &loaded->mesh}, static_cast<int>(scene.materials.size())};
    scene.warnings.insert(scene.warnings.end(), loaded->warnings.begin(), loaded->warnings.end());
    scene.materials.insert(scene.materials.end(), loaded->materials.begin(), loaded->materials.end());
    return shared;
}

/// What `mesh` names: a built-in shape if there is one of that name, else a file.
SharedMesh ObjectReader::mesh_of(const Value& table, const ObjectTable& read) {
    const std::string& name = read.mesh;
    const std::string with_normals = " normals " + std::to_string(static_cast<int>(read.normals)) + " crease " +
                                     (read.crease ? std::to_string(*read.crease) : "");

    const std::vector<std::string> shapes = built_in_names();
    if (std::find(shapes.begin(), shapes.end(), name) != shapes.end()) {
        const int detail = read.detail.value_or(raster::default_detail(name).value());
        const std::string key = name + " detail " + std::to_string(detail) + with_normals;
        SharedMesh& shared = meshes[key];
        if (shared.mesh) return shared;
        shared.mesh = find_or_make(options.files, &LoadedFiles::shapes, key,
                                   [&](std::vector<UsedFile>&) { return built_in_mesh(table, read, detail); });
        return shared;
    }
    const std::filesystem::path path = (std::filesystem::path(folder) / name).lexically_normal();
    std::error_code error;
    if (options.files) options.files->used.push_back(use_file(path.string(), FileUse::presence));
    if (!std::filesystem::exists(path, error)) {
        const bool names_file = path.has_extension() || name.find('/') != std::string::npos;
        const std::string file =
            nearest_word(name, shapes).empty() || names_file ? did_you_mean_file(path.string()) : "";
        throw UserError(place_of(table, "mesh"),
                        "there is no mesh file " + in_quotes(path.string()) +
                            (file.empty() ? did_you_mean(name, shapes, "built-in meshes") : file));
    }
    if (read.detail) {
        throw UserError(find(table, "detail")->key_place,
                        "'detail' is for built-in meshes; " + in_quotes(name) + " is a file, its triangles are fixed");
    }
    SharedMesh& shared = meshes[path.string() + with_normals];
    if (!shared.mesh) shared = load_file(path.string(), read.normals, read.crease);
    return shared;
}

int ObjectReader::material_named(const Value& name) const {
    for (std::size_t i = 0; i < named_materials; ++i) {
        if (scene.materials[i].name == name.text) return static_cast<int>(i);
    }
    std::vector<std::string> known;
    for (std::size_t i = 0; i < named_materials; ++i) known.push_back(scene.materials[i].name);
    const std::string what = "there is no material " + in_quotes(name.text);
    if (known.empty()) throw UserError(name.place, what + "; the scene has no [[material]]");
    throw UserError(name.place, what + did_you_mean(name.text, known, "materials"));
}

/// The [[material]] called "default", else one with all constants as they are documented.
int ObjectReader::material_of_none() {
    if (default_material >= 0) return default_material;
    const auto begin = scene.materials.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(named_materials);
    const auto is_default = [](const lighting::Material& material) { return material.name == "default"; };
    const auto found = std::find_if(begin, end, is_default);
    default_material = static_cast<int>((found == end ? scene.materials.end() : found) - begin);
    if (found == end) scene.materials.emplace_back();
    return default_material;
}

std::vector<bool> hidden_parts(const Value& table, const raster::Mesh& mesh) {
    std::vector<bool> hidden(mesh.parts.size(), false);
    const Value* hide = find(table, "hide");
    if (!hide) return hidden;
    std::set<std::string> known;
    for (const raster::MeshPart& part : mesh.parts) known.insert(part.name);
    for (const Value& name : hide->items) {
        for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
            if (mesh.parts[i].name == name.text) hidden[i] = true;
        }
        if (known.contains(name.text)) continue;
        const std::string what = "the mesh has no part " + in_quotes(name.text);
        throw UserError(name.place, what + did_you_mean(name.text, {known.begin(), known.end()}, "parts"));
    }
    return hidden;
}

/// What stands for the mesh of an object that is off.
SharedMesh mesh_without_triangles() {
    const auto mesh = std::make_shared<raster::Mesh>();
    mesh->parts.resize(1);
    return {mesh, 0};
}

void ObjectReader::read_object(const Value& table) {
    ObjectTable read;
    read_keys(table, object_keys(), read);
    if (read.mesh.empty()) {
        throw UserError(place_of(table, "mesh"),
                        "an [[object]] needs a mesh, e.g. mesh = \"teapot\" or mesh = \"model.obj\"");
    }
    Object object;
    object.mesh_name = read.mesh;
    object.casts_shadow = read.casts_shadow;
    object.on = read.on;
    read.placement.scale_place = place_of(table, "scale");
    read.placement.place = place_of(table, find(table, "translate") ? "translate" : "mesh");
    placements.objects.push_back(read.placement);
    const Value* material = find(table, "material");
    const int chosen = material ? material_named(*material) : -1;
    const SharedMesh shared = read.on ? mesh_of(table, read) : mesh_without_triangles();
    object.mesh = shared.mesh;
    for (const raster::MeshPart& part : shared.mesh->parts) {
        const int own = part.material >= 0 ? shared.first_material + part.material : -1;
        const int index = chosen >= 0 ? chosen : own;
        object.part_material.push_back(index >= 0 ? index : material_of_none());
    }
    object.part_hidden = read.on ? hidden_parts(table, *shared.mesh) : std::vector<bool>{true};
    scene.objects.push_back(std::move(object));
}

}  // namespace

glm::dmat4 placed(const glm::dvec3& translate, const glm::dvec3& rotate_deg, const glm::dvec3& scale) {
    const glm::dvec3 angle = glm::radians(rotate_deg);
    const glm::dmat4 identity(1.0);
    const glm::dmat4 t = glm::translate(identity, translate);
    const glm::dmat4 rx = glm::rotate(identity, angle.x, glm::dvec3(1.0, 0.0, 0.0));
    const glm::dmat4 ry = glm::rotate(identity, angle.y, glm::dvec3(0.0, 1.0, 0.0));
    const glm::dmat4 rz = glm::rotate(identity, angle.z, glm::dvec3(0.0, 0.0, 1.0));
    return t * rz * ry * rx * glm::scale(identity, scale);
}

glm::mat4 world_from_object(glm::vec3 translate, glm::vec3 rotate_deg, glm::vec3 scale) {
    return glm::mat4(placed(glm::dvec3(translate), glm::dvec3(rotate_deg), glm::dvec3(scale)));
}

namespace {

/// Many small parts are drawn faster as one part a material.
void join_small_parts(Scene& scene) {
    constexpr std::size_t kMany = 1 << 14;
    std::size_t parts = 0;
    for (const Object& object : scene.objects) parts += object.mesh->parts.size();
    if (parts > kMany) join_parts(scene);
}

/// A sample of the picture keeps its triangle in 32 bits, as a chunk of an object's triangles and a place in it.
void limit_triangles(const Scene& scene) {
    std::uint64_t chunks = 0, triangles = 0;
    for (const Object& object : scene.objects) {
        chunks += (object.mesh->triangle_count() + raster::kTrianglesPerChunk - 1) / raster::kTrianglesPerChunk;
        triangles += object.mesh->triangle_count();
    }
    if (chunks <= raster::kMostChunks) return;
    throw UserError({scene.file}, std::to_string(scene.objects.size()) + " objects of " + std::to_string(triangles) +
                                      " triangles are more than one picture can tell apart (" + std::to_string(chunks) +
                                      " runs of up to 4096 triangles of one object; at most " +
                                      std::to_string(raster::kMostChunks) + "); join small objects into one mesh file");
}

}  // namespace

void read_objects(const Value& root, const std::string& folder, const ReadOptions& options, Placements& placements,
                  Scene& scene) {
    const Value* objects = find(root, "object");
    if (!objects) return;
    ObjectReader reader{folder, options, placements, scene, scene.materials.size(), -1, {}};
    for (const Value& table : objects->items) reader.read_object(table);
    join_small_parts(scene);
    limit_triangles(scene);
}

}  // namespace kreda::scene
