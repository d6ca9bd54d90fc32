#include "scene/files/gltf_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lighting/batch/maps.hpp"
#include "raster/normals.hpp"
#include "raster/tangents.hpp"
#include "scene/files/gltf_lights.hpp"
#include "scene/files/gltf_nodes.hpp"
#include "scene/files/gltf_primitive.hpp"
#include "scene/files/obj_centre.hpp"
#include "scene/files/repeated_triangles.hpp"

namespace kreda::scene {

namespace {

constexpr std::size_t kMostVertices = std::size_t(1) << 26;
constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// The mesh as it grows. Positions stay in double until all are there: a float would lose what lies far from 0.
struct Assembly {
    const GltfFile& gltf;
    const GltfMaterials& materials;
    LeftOut left_out = {};
    std::vector<std::string> warnings = {};
    std::map<std::pair<int, std::size_t>, std::optional<GltfPrimitive>> primitives = {};  ///< by mesh and number
    std::vector<glm::dvec3> positions = {};
    raster::Mesh mesh = {};
    std::size_t bad_normals = 0;
    bool has_uvs = false;
    bool has_tangents = true;  ///< all parts that need some have some
    bool needs_tangents = false;

    const GltfPrimitive* primitive_of(int mesh_index, std::size_t number);
    void add_node(const PlacedNode& placed);
    void add_part(const PlacedNode& placed, const GltfPrimitive& primitive, const std::string& name);
    void add_vertex(const glm::dmat4& world_from_node, const glm::dmat3& normal_matrix, double side,
                    const raster::Mesh& from, std::uint32_t vertex);
};

/// Read a primitive once; a damaged one is a warning, and null.
const GltfPrimitive* Assembly::primitive_of(int mesh_index, std::size_t number) {
    const auto [found, is_new] = primitives.try_emplace({mesh_index, number});
    if (is_new) {
        const tinygltf::Mesh& from = gltf.model.meshes[static_cast<std::size_t>(mesh_index)];
        try {
            found->second = read_gltf_primitive(gltf, from.primitives[number], materials, left_out);
            bad_normals += found->second->bad_normals;
        } catch (const UserError& error) {
            warnings.push_back(std::string(error.what()) + "; primitive " + std::to_string(number) + " of mesh " +
                               token_in_quotes(from.name) + " is left out");
        }
    }
    return found->second ? &*found->second : nullptr;
}

/// Normals go with the cofactors of the transform, which are  det(M) M^-T  and exist for flattened nodes, too.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::dvec3 unit_or_up(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0, 1.0, 0.0);
}

void Assembly::add_vertex(const glm::dmat4& world_from_node, const glm::dmat3& normal_matrix, double side,
                          const raster::Mesh& from, std::uint32_t vertex) {
    positions.emplace_back(world_from_node * glm::dvec4(glm::dvec3(from.positions[vertex]), 1.0));
    const glm::dvec3 normal = unit_or_up(side * (normal_matrix * glm::dvec3(from.normals[vertex])));
    mesh.normals.emplace_back(normal);
    mesh.uvs.push_back(from.uvs.empty() ? glm::vec2(0.0f) : from.uvs[vertex]);
    glm::dvec4 tangent(raster::any_perpendicular(normal), 1.0);
    if (!from.tangents.empty()) {
        const glm::dvec4 given(from.tangents[vertex]);
        const glm::dvec3 turned = glm::dmat3(world_from_node) * glm::dvec3(given);
        if (glm::length(turned) > 0.0) tangent = glm::dvec4(glm::normalize(turned), given.w < 0.0 ? -side : side);
    }
    mesh.tangents.emplace_back(tangent);
}

/// Vertices in the order of first use: no vertex belongs to two parts. A mirroring transform turns triangles around.
void Assembly::add_part(const PlacedNode& placed, const GltfPrimitive& primitive, const std::string& name) {
    const raster::Mesh& from = primitive.mesh;
    if (from.indices.empty()) return;
    if (positions.size() + from.positions.size() > kMostVertices) {
        throw UserError(Place{gltf.text.json.file}, "has more than " + std::to_string(kMostVertices) +
                                                        " vertices where its nodes stand; draw fewer nodes");
    }
    const glm::dmat3 linear(placed.world_from_node);
    const glm::dmat3 normal_matrix = cofactors(linear);
    const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    raster::MeshPart part{name, mesh.triangle_count(), from.triangle_count(), primitive.material};
    std::vector<std::uint32_t> new_index(from.positions.size(), kNoVertex);
    for (std::size_t i = 0; i < from.indices.size(); ++i) {
        const std::size_t corner = side < 0.0 && i % 3 != 0 ? i + 3 - 2 * (i % 3) : i;  // 0, 2, 1
        const std::uint32_t vertex = from.indices[corner];
        if (new_index[vertex] == kNoVertex) {
            new_index[vertex] = static_cast<std::uint32_t>(positions.size());
            add_vertex(placed.world_from_node, normal_matrix, side, from, vertex);
        }
        mesh.indices.push_back(new_index[vertex]);
    }
    has_uvs |= !from.uvs.empty();
    const bool bends = primitive.material >= 0 &&
                       lighting::reads_normal_map(materials.materials[static_cast<std::size_t>(primitive.material)]);
    needs_tangents |= bends;
    has_tangents &= !bends || !from.tangents.empty();
    mesh.parts.push_back(std::move(part));
}

void Assembly::add_node(const PlacedNode& placed) {
    const tinygltf::Node& node = gltf.model.nodes[static_cast<std::size_t>(placed.node)];
    if (node.skin >= 0) left_out.add("skins (the mesh is drawn as it is stored)");
    for (const auto& [name, value] : node.extensions) {
        if (name != "KHR_lights_punctual") left_out.add(on_one_line(name));
    }
    if (node.mesh < 0) return;
    if (!has_element(gltf.model.meshes, node.mesh)) {
        throw gltf_error(gltf.text, "nodes", static_cast<std::size_t>(placed.node),
                         "names mesh " + std::to_string(node.mesh) + " of " + std::to_string(gltf.model.meshes.size()));
    }
    const tinygltf::Mesh& from = gltf.model.meshes[static_cast<std::size_t>(node.mesh)];
    const std::string name = node.name.empty() ? from.name : node.name;
    for (std::size_t i = 0; i < from.primitives.size(); ++i) {
        if (const GltfPrimitive* primitive = primitive_of(node.mesh, i)) add_part(placed, *primitive, name);
    }
}

/// What a file demands and we cannot do: geometry that would be missing is an error, looks are left out.
void check_extensions(const GltfFile& gltf, LeftOut& left_out) {
    static constexpr std::array<const char*, 6> kKnown = {"KHR_lights_punctual",   "KHR_materials_unlit",
                                                          "KHR_texture_transform", "KHR_mesh_quantization",
                                                          "EXT_texture_webp",      "KHR_materials_emissive_strength"};
    for (const std::string& name : gltf.model.extensionsRequired) {
        if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
        if (name.starts_with("KHR_materials_") || name == "KHR_texture_basisu") {
            left_out.add(on_one_line(name));
            continue;
        }
        throw UserError(Place{gltf.text.json.file},
                        "needs the extension " + token_in_quotes(name) +
                            ", which Kreda does not know; save the file without it (compressed meshes: "
                            "`gltf-transform copy` or Blender write plain ones)");
    }
    if (!gltf.model.animations.empty()) left_out.add("animations");
}

/// From the double positions to those of the mesh, about its own centre where it is far from 0.
void settle_positions(Assembly& assembly) {
    glm::dvec3 least(assembly.positions.front()), greatest = least;
    for (const glm::dvec3& p : assembly.positions) {
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
    const MeshFrame frame = frame_of_box(least, greatest);
    for (const glm::dvec3& p : assembly.positions)
        assembly.mesh.positions.emplace_back((p - frame.origin) / frame.unit);
    assembly.mesh.origin = frame.origin;
    assembly.mesh.unit = frame.unit;
}

void settle_normals(const MeshFileOptions& options, raster::Mesh& mesh) {
    if (options.normals == Normals::file && !options.crease) return;
    mesh.tangents.clear();
    if (options.normals == Normals::flat) {
        raster::make_flat_normals(mesh);
    } else {
        raster::make_smooth_normals(mesh, options.crease.value_or(60.0f));
    }
}

std::string left_out_line(const std::string& file, const LeftOut& left_out) {
    std::string list;
    for (const std::string& thing : left_out.things) list += (list.empty() ? "" : ", ") + thing;
    return file + ": not modelled, and left out: " + list;
}

}  // namespace

LoadedMesh load_gltf_file(const std::string& path, const MeshFileOptions& options) {
    LoadedMesh loaded;
    const GltfFile gltf = read_gltf_file(path, {folder_of(path), options.allow_outside, &loaded.other_files});
    LeftOut left_out;
    check_extensions(gltf, left_out);
    GltfMaterials materials = read_gltf_materials(gltf, left_out);
    const std::vector<PlacedNode> nodes = place_nodes(gltf);
    Assembly assembly{gltf, materials, std::move(left_out)};
    for (const PlacedNode& placed : nodes) assembly.add_node(placed);

    loaded.cameras = read_gltf_cameras(gltf, nodes, assembly.warnings);
    loaded.lights = read_gltf_lights(gltf, nodes, assembly.left_out, assembly.warnings);
    if (assembly.mesh.indices.empty()) {
        const std::string why = assembly.warnings.empty() ? "" : " (" + assembly.warnings.front() + ")";
        throw UserError(Place{path}, "holds no triangle that can be drawn" + why);
    }
    settle_positions(assembly);
    loaded.mesh = std::move(assembly.mesh);
    if (!assembly.has_uvs) loaded.mesh.uvs.clear();
    if (!assembly.needs_tangents || !assembly.has_tangents) loaded.mesh.tangents.clear();
    const std::string repeated = warning_of_repeated(drop_repeated_triangles(loaded.mesh), path);
    settle_normals(options, loaded.mesh);
    loaded.warnings = std::move(materials.warnings);
    if (!repeated.empty()) loaded.warnings.push_back(repeated);
    loaded.warnings.insert(loaded.warnings.end(), assembly.warnings.begin(), assembly.warnings.end());
    if (assembly.bad_normals > 0) {
        loaded.warnings.push_back(path + ": " + std::to_string(assembly.bad_normals) +
                                  " normals have no length; their parts are drawn with flat ones");
    }
    if (!assembly.left_out.things.empty()) loaded.warnings.push_back(left_out_line(path, assembly.left_out));
    for (const raster::MeshPart& part : loaded.mesh.parts)
        loaded.two_sided |= part.material < 0 || materials.two_sided[static_cast<std::size_t>(part.material)];
    loaded.materials = std::move(materials.materials);
    return loaded;
}

}  // namespace kreda::scene
