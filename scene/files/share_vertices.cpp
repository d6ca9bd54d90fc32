#include "scene/files/share_vertices.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace kreda::scene {

namespace {

struct CornerOfPart {
    ObjCorner corner;
    std::uint32_t part = 0;
    bool operator==(const CornerOfPart&) const = default;
};

struct CornerHash {
    std::size_t operator()(const CornerOfPart& key) const {
        const ObjCorner& c = key.corner;
        std::uint64_t h = std::uint64_t{key.part} << 32 | static_cast<std::uint32_t>(c.position);
        h = h * 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(c.uv);
        h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u + static_cast<std::uint32_t>(c.normal);
        h = (h ^ (h >> 32)) * 0x94d049bb133111ebu;
        return h ^ (h >> 29);
    }
};

/// The vertices of corners that were there before, position by position: neighbours in a file name neighbours, so the
/// list of a position lies in the cache where a hash table would not. What does not fit into a short list is in one.
class VerticesOfCorners {
public:
    explicit VerticesOfCorners(std::size_t positions) : first_(positions, kNone) {}

    /// The vertex of a corner; `next` where it is new.
    std::uint32_t find_or_add(const CornerOfPart& key, std::uint32_t next) {
        std::uint32_t* link = &first_[std::size_t(key.corner.position)];
        for (int length = 0; length < kLongest; ++length) {
            if (*link == kNone) {
                *link = next;
                listed_.resize(std::size_t{next} + 1);
                listed_[next] = {key, kNone};
                return next;
            }
            if (listed_[*link].key == key) return *link;
            link = &listed_[*link].next;
        }
        return others_.try_emplace(key, next).first->second;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr int kLongest = 8;
    struct Listed {
        CornerOfPart key;
        std::uint32_t next = kNone;
    };
    std::vector<std::uint32_t> first_;  ///< of each position
    std::vector<Listed> listed_;        ///< by vertex
    std::unordered_map<CornerOfPart, std::uint32_t, CornerHash> others_;
};

}  // namespace

raster::Mesh share_vertices(const MeshArrays& arrays, const CornerTriangles& triangles) {
    const auto has = [&](int ObjCorner::*index) {
        return std::any_of(triangles.corners.begin(), triangles.corners.end(),
                           [&](const ObjCorner& c) { return c.*index >= 0; });
    };
    const bool has_uvs = has(&ObjCorner::uv), has_normals = has(&ObjCorner::normal);
    raster::Mesh mesh;
    mesh.parts = triangles.parts;
    mesh.indices.reserve(triangles.corners.size());
    VerticesOfCorners vertices(arrays.positions.size());
    for (std::uint32_t p = 0; p < mesh.parts.size(); ++p) {
        const raster::MeshPart& part = mesh.parts[p];
        const auto corners = std::span(triangles.corners).subspan(3 * std::size_t(part.first_triangle));
        for (const ObjCorner& c : corners.first(3 * std::size_t(part.triangle_count))) {
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const std::uint32_t vertex = vertices.find_or_add({c, p}, next);
            mesh.indices.push_back(vertex);
            if (vertex != next) continue;
            mesh.positions.push_back(arrays.positions[std::size_t(c.position)]);
            if (has_uvs) mesh.uvs.push_back(c.uv >= 0 ? arrays.uvs[std::size_t(c.uv)] : glm::vec2(0.0f));
            if (has_normals) mesh.normals.push_back(arrays.normals[std::size_t(c.normal)]);
        }
    }
    return mesh;
}

}  // namespace kreda::scene
