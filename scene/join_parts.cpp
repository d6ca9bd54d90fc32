#include "scene/join_parts.hpp"

#include <map>
#include <utility>

namespace kreda::scene {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// What parts must have in common to become one.
using MaterialLook = std::pair<int, bool>;  // material, hidden

std::vector<MaterialLook> looks_of(const Object& object) {
    std::vector<MaterialLook> looks;
    for (std::size_t p = 0; p < object.part_material.size(); ++p) {
        looks.emplace_back(object.part_material[p], p < object.part_hidden.size() && object.part_hidden[p]);
    }
    return looks;
}

/// The parts of each look, looks in the order of their first part.
std::vector<std::vector<std::size_t>> parts_by_look(const std::vector<MaterialLook>& looks) {
    std::map<MaterialLook, std::size_t> place;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t p = 0; p < looks.size(); ++p) {
        const auto [found, is_new] = place.try_emplace(looks[p], groups.size());
        if (is_new) groups.emplace_back();
        groups[found->second].push_back(p);
    }
    return groups;
}

/// Copy vertices in the order of first use: those of a part stay an unbroken range.
void copy_vertices(const raster::Mesh& from, raster::Mesh& to) {
    std::vector<std::uint32_t> new_index(from.positions.size(), kNone);
    for (std::uint32_t& index : to.indices) {
        const std::uint32_t old = index;
        if (new_index[old] == kNone) {
            new_index[old] = static_cast<std::uint32_t>(to.positions.size());
            to.positions.push_back(from.positions[old]);
            if (!from.normals.empty()) to.normals.push_back(from.normals[old]);
            if (!from.uvs.empty()) to.uvs.push_back(from.uvs[old]);
            if (!from.tangents.empty()) to.tangents.push_back(from.tangents[old]);
        }
        index = new_index[old];
    }
}

raster::Mesh joined(const raster::Mesh& mesh, const std::vector<std::vector<std::size_t>>& groups) {
    raster::Mesh result;
    result.indices.reserve(mesh.indices.size());
    for (const std::vector<std::size_t>& group : groups) {
        raster::MeshPart part = mesh.parts[group.front()];
        part.first_triangle = result.triangle_count();
        for (const std::size_t p : group) {
            const auto first = mesh.indices.begin() + 3 * static_cast<std::ptrdiff_t>(mesh.parts[p].first_triangle);
            result.indices.insert(result.indices.end(), first,
                                  first + 3 * static_cast<std::ptrdiff_t>(mesh.parts[p].triangle_count));
        }
        part.triangle_count = result.triangle_count() - part.first_triangle;
        result.parts.push_back(part);
    }
    copy_vertices(mesh, result);
    return result;
}

}  // namespace

void join_parts(Scene& scene) {
    using Key = std::pair<std::shared_ptr<const raster::Mesh>, std::vector<MaterialLook>>;
    std::map<Key, std::shared_ptr<const raster::Mesh>> made;
    for (Object& object : scene.objects) {
        const std::vector<MaterialLook> looks = looks_of(object);
        const std::vector<std::vector<std::size_t>> groups = parts_by_look(looks);
        if (groups.size() == object.mesh->parts.size()) continue;
        std::shared_ptr<const raster::Mesh>& mesh = made[{object.mesh, looks}];
        if (!mesh) mesh = std::make_shared<raster::Mesh>(joined(*object.mesh, groups));
        object.mesh = mesh;
        object.part_material.clear();
        object.part_hidden.clear();
        for (const std::vector<std::size_t>& group : groups) {
            object.part_material.push_back(looks[group.front()].first);
            object.part_hidden.push_back(looks[group.front()].second);
        }
    }
}

}  // namespace kreda::scene
