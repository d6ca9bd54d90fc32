#include "shadows/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "raster/mesh_checks.hpp"
#include "raster/scalar_math.hpp"
#include "shadows/light_ray.hpp"

namespace kreda::shadows {

namespace {

/// A triangle of the occluder.
struct Face {
    std::array<std::uint32_t, 3> vertex{};  ///< in the order of its indices
    std::array<std::uint32_t, 3> point{};   ///< first_vertex_of_point of each, counter-clockwise seen from outside
    double light_height = 0.0;              ///< > 0 where the light sees the front
    std::uint32_t piece = 0;
};

/// A piece of the mesh that hangs together.
struct Piece {
    bool is_closed = true;
    double signed_volume = 0.0;  ///< six times it; > 0 if the fronts are outside
    double solid_angle = 0.0;    ///< that its faces fill around the light, 4 pi for each time they enclose it
};

/// A side of a face between two points, low first: +1 where the face runs from low to high, -1 the other way.
struct DirectedEdge {
    std::uint64_t key = 0;
    int direction = 1;
    std::uint32_t face = 0;
};

/// For each vertex the first one that stands at the same place: what uv seams and creases have split is one point
/// again.
std::vector<std::uint32_t> first_vertex_of_point(const Occluder& occluder) {
    std::vector<std::uint32_t> point = raster::weld_by_position(occluder.positions);
    std::vector<std::uint32_t> first;  // points are numbered by first appearance
    for (std::uint32_t v = 0; v < point.size(); ++v) {
        if (point[v] == first.size()) first.push_back(v);
        point[v] = first[point[v]];
    }
    return point;
}

std::vector<Face> make_faces(const Occluder& occluder, const glm::dvec4& light) {
    const std::vector<std::uint32_t> point = first_vertex_of_point(occluder);
    std::vector<Face> faces;
    for (std::size_t i = 0; i + 2 < occluder.indices.size(); i += 3) {
        Face face;
        face.vertex = {occluder.indices[i], occluder.indices[i + 1], occluder.indices[i + 2]};
        for (int k = 0; k < 3; ++k) face.point[k] = point[face.vertex[k]];
        const glm::dvec3 a(occluder.positions[face.vertex[0]]);
        const glm::dvec3 b(occluder.positions[face.vertex[1]]);
        const glm::dvec3 c(occluder.positions[face.vertex[2]]);
        face.light_height = glm::dot(glm::cross(b - a, c - a), toward_light(light, a));
        if (occluder.clockwise) {
            std::swap(face.point[1], face.point[2]);
            face.light_height = -face.light_height;
        }
        const bool is_line =
            face.point[0] == face.point[1] || face.point[1] == face.point[2] || face.point[2] == face.point[0];
        if (std::isfinite(face.light_height) && !is_line) faces.push_back(face);
    }
    return faces;
}

/// All edges of the faces that `wanted` picks, sorted: those of one pair of points lie together.
template <class Wanted>
std::vector<DirectedEdge> sorted_edges(const std::vector<Face>& faces, Wanted wanted) {
    std::vector<DirectedEdge> edges;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const int turn = wanted(faces[f]);  // 0: not wanted, -1: turned over
        if (turn == 0) continue;
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t from = faces[f].point[k], to = faces[f].point[(k + 1) % 3];
            edges.push_back({std::min(from, to) << 32 | std::max(from, to), from < to ? turn : -turn, f});
        }
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const DirectedEdge& a, const DirectedEdge& b) { return a.key < b.key; });
    return edges;
}

/// Calls visit(edges of the pair, sum of their directions) for each pair of points.
template <class Visit>
void for_each_pair(std::span<const DirectedEdge> edges, Visit visit) {
    while (!edges.empty()) {
        std::size_t count = 0;
        int sum = 0;
        for (; count < edges.size() && edges[count].key == edges[0].key; ++count) sum += edges[count].direction;
        visit(edges.first(count), sum);
        edges = edges.subspan(count);
    }
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// Solid angle of a triangle seen from the origin, signed: > 0 if seen from its back.   Van Oosterom & Strackee 1983
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double numerator = glm::dot(a, glm::cross(b, c));
    const double denominator = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2.0 * std::atan2(numerator, denominator);
}

/// Give each face its piece, and say what is known of each.
std::vector<Piece> find_pieces(const Occluder& occluder, const glm::dvec4& light, std::vector<Face>& faces) {
    std::vector<std::uint32_t> parent(faces.size());
    std::iota(parent.begin(), parent.end(), 0u);
    std::vector<Piece> pieces(faces.size());
    const std::vector<DirectedEdge> edges = sorted_edges(faces, [](const Face&) { return 1; });
    for_each_pair(edges, [&](std::span<const DirectedEdge> pair, int) {
        for (const DirectedEdge& edge : pair) parent[root_of(parent, edge.face)] = root_of(parent, pair[0].face);
    });
    for (std::uint32_t f = 0; f < faces.size(); ++f) faces[f].piece = root_of(parent, f);
    for_each_pair(edges, [&](std::span<const DirectedEdge> pair, int sum) {
        if (sum != 0) pieces[faces[pair[0].face].piece].is_closed = false;
    });
    for (const Face& face : faces) {
        const auto corner = [&](int k) { return glm::dvec3(occluder.positions[face.point[k]]); };
        Piece& piece = pieces[face.piece];
        piece.signed_volume += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
        if (light.w == 0.0) continue;
        const glm::dvec3 l(light);
        piece.solid_angle += solid_angle(corner(0) - l, corner(1) - l, corner(2) - l);
    }
    return pieces;
}

}  // namespace

VolumeShape make_shadow_volume(const Occluder& occluder, const glm::dvec4& light) {
    std::vector<Face> faces = make_faces(occluder, light);
    const std::vector<Piece> pieces = find_pieces(occluder, light, faces);
    const auto has_outline = [&](const Piece& piece) {
        return piece.is_closed && std::abs(piece.solid_angle) < 1.0;  // it is 0 or a multiple of 4 pi
    };
    /// 1: a cap as it stands, -1: a cap turned over, 0: none.
    const auto cap = [&](const Face& face) {
        if (face.light_height == 0.0) return 0;
        const Piece& piece = pieces[face.piece];
        const int turn = face.light_height > 0.0 ? 1 : -1;
        const int outside = piece.signed_volume >= 0.0 ? 1 : -1;
        return !has_outline(piece) || turn == outside ? turn : 0;
    };
    VolumeShape shape;
    for (const Face& face : faces) {
        if (!pieces[face.piece].is_closed) ++shape.open_triangles;
        if (cap(face) != 0) shape.caps.push_back({face.vertex, (cap(face) < 0) != occluder.clockwise});
    }
    const std::vector<DirectedEdge> edges = sorted_edges(faces, cap);
    for_each_pair(edges, [&](std::span<const DirectedEdge> pair, int sum) {
        const auto low = static_cast<std::uint32_t>(pair[0].key >> 32);
        const auto high = static_cast<std::uint32_t>(pair[0].key & 0xffffffffu);
        if (sum > 0) shape.sides.push_back({low, high, sum});
        if (sum < 0) shape.sides.push_back({high, low, -sum});
    });
    return shape;
}

}  // namespace kreda::shadows
