// The Utah teapot, Martin Newell 1975: 32 bicubic Bezier patches.
//
// Newell's control points are not 306 free numbers. Rim, body, lid and bottom are profiles turned around the axis, and
// handle and spout are rings mirrored at the plane z = 0. So the tables below hold one line a ring of control points,
// in Newell's units (the pot is 3.15 high), and the rings are written out from them. (Listings of the 306 points in
// circulation break this symmetry at the inner rim by typing errors: 0.78 or 0.874 for 0.784.)
#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "raster/shape_grid.hpp"
#include "raster/shapes.hpp"

namespace kreda::raster {

namespace {

constexpr double kNewellHeight = 3.15;

/// A horizontal ring of 12 control points, four quarter circles. reach is the length of the tangent arm of a quarter:
/// Newell took 0.56 radius (the best circle has 0.5523), but 0.45 for the knob.
struct TurnedRing {
    double radius, height, reach;
};

/// A ring of 6 control points across the plane z = 0: an inner and an outer point in it, the other four at
/// z = +-half_width beside them.
struct MirroredRing {
    double x_inner, height_inner, x_outer, height_outer, half_width;
};

// From the bottom's centre up the outside: three rings more for each row of patches.
constexpr TurnedRing kBottom[] = {{0.0, 0.0, 0.0}, {1.425, 0.0, 0.798}, {1.5, 0.075, 0.84}, {1.5, 0.15, 0.84}};
constexpr TurnedRing kBody[] = {{1.5, 0.15, 0.84}, {1.5, 0.225, 0.84},  {2.0, 0.45, 1.12}, {2.0, 0.9, 1.12},
                                {2.0, 1.35, 1.12}, {1.75, 1.875, 0.98}, {1.5, 2.4, 0.84}};
constexpr TurnedRing kRim[] = {{1.5, 2.4, 0.84}, {1.4375, 2.53125, 0.805}, {1.3375, 2.53125, 0.749}, {1.4, 2.4, 0.784}};
constexpr TurnedRing kLid[] = {{1.3, 2.4, 0.728}, {1.3, 2.55, 0.728}, {0.4, 2.55, 0.224}, {0.2, 2.7, 0.112},
                               {0.0, 2.85, 0.0},  {0.8, 3.15, 0.45},  {0.0, 3.15, 0.0}};

// From the upper end down the handle, and from the pot to the mouth of the spout.
constexpr MirroredRing kHandle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
                                    {-2.7, 2.025, -3.0, 2.25, 0.3}, {-2.7, 1.8, -3.0, 1.8, 0.3},
                                    {-2.7, 1.575, -3.0, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                    {-2.0, 0.9, -1.9, 0.6, 0.3}};
constexpr MirroredRing kSpout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
                                   {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
                                   {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                                   {2.8, 2.4, 3.2, 2.4, 0.15}};

/// Four control points of a cubic Bezier curve; a patch is four such curves.
using Curve = std::array<glm::dvec3, 4>;

struct CurvePoint {
    glm::dvec3 position, derivative;
};

/// P(t) = sum of B_k(t) P_k with the Bernstein polynomials B = (1-t)^3, 3t(1-t)^2, 3t^2(1-t), t^3, and
/// P'(t) = 3 sum of b_k(t) (P_{k+1} - P_k) with b = (1-t)^2, 2t(1-t), t^2.
/// At t = 0 and t = 1 the result is exactly P_0 and P_3: neighbouring patches meet without a gap.
CurvePoint bezier(const Curve& p, double t) {
    const double s = 1 - t;
    const glm::dvec3 position = s * s * s * p[0] + 3 * t * s * s * p[1] + 3 * t * t * s * p[2] + t * t * t * p[3];
    const glm::dvec3 derivative = 3.0 * (s * s * (p[1] - p[0]) + 2 * t * s * (p[2] - p[1]) + t * t * (p[3] - p[2]));
    return {position, derivative};
}

/// The control points of one part: rings from v = 0 to v = 1, each closed by its first point. Patch (segment, row) owns
/// points 3 segment .. 3 segment + 3 of the rings 3 row .. 3 row + 3; neighbours share their border points.
using ControlNet = std::vector<std::vector<glm::dvec3>>;

/// Four quarters of Bezier circles from -x over +z: the texture seam hides under the handle.
std::vector<glm::dvec3> ring_points(const TurnedRing& ring) {
    constexpr std::array<glm::dvec3, 5> kDirections = {
        {{-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {-1.0, 0.0, 0.0}}};
    const glm::dvec3 center(0.0, ring.height, 0.0);
    std::vector<glm::dvec3> points = {center + ring.radius * kDirections[0]};
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const glm::dvec3 from = kDirections[quarter];
        const glm::dvec3 to = kDirections[quarter + 1];
        points.push_back(center + ring.radius * from + ring.reach * to);
        points.push_back(center + ring.reach * from + ring.radius * to);
        points.push_back(center + ring.radius * to);
    }
    return points;
}

/// Inner to outer on the side of +z, then back on the side of -z.
std::vector<glm::dvec3> ring_points(const MirroredRing& ring) {
    const glm::dvec3 inner(ring.x_inner, ring.height_inner, 0.0);
    const glm::dvec3 outer(ring.x_outer, ring.height_outer, 0.0);
    const glm::dvec3 side(0.0, 0.0, ring.half_width);
    return {inner, inner + side, outer + side, outer, outer - side, inner - side, inner};
}

template <std::size_t N, class Ring>
ControlNet control_net(const Ring (&rings)[N]) {
    ControlNet net;
    for (const Ring& ring : rings) net.push_back(ring_points(ring));
    return net;
}

/// The unit normal of the patch whose rows of control points are `rows`, and the point, at (u along a row, v across).
/// N = dP/du x dP/dv. Where a row shrinks to a point (lid, bottom), dP/du = 0 there and grows as (v - v0) d2P/dudv:
/// the limit of the normal's direction is +-d2P/dudv x dP/dv, plus at v = 0 and minus at v = 1.
void append_patch_point(Mesh& mesh, const std::array<Curve, 4>& rows, double u, double v, glm::dvec2 uv) {
    Curve points, du_points;  // the curve of constant u, and its derivative by u
    for (std::size_t k = 0; k < 4; ++k) {
        const CurvePoint row = bezier(rows[k], u);
        points[k] = row.position;
        du_points[k] = row.derivative;
    }
    const CurvePoint p = bezier(points, v);
    const CurvePoint dp_du = bezier(du_points, v);
    const bool is_pole = glm::dot(dp_du.position, dp_du.position) < 1e-20;  // exactly 0 in fact, elsewhere above 0.01
    const glm::dvec3 along_u = !is_pole ? dp_du.position : v < 0.5 ? dp_du.derivative : -dp_du.derivative;
    const glm::dvec3 normal = glm::normalize(glm::cross(along_u, p.derivative));
    append_vertex(mesh, p.position / kNewellHeight, normal, uv);
}

std::array<Curve, 4> patch_rows(const ControlNet& net, int segment, int patch_row) {
    std::array<Curve, 4> rows;
    for (std::size_t k = 0; k < 4; ++k) {
        const std::vector<glm::dvec3>& ring = net[static_cast<std::size_t>(3 * patch_row) + k];
        std::copy_n(ring.begin() + 3 * segment, 4, rows[k].begin());
    }
    return rows;
}

/// Appends one part, detail x detail quads a patch. Vertices are shared inside the part except at its texture seam.
void append_part(Mesh& mesh, std::string_view name, const ControlNet& net, int detail) {
    const auto first_vertex = static_cast<std::uint32_t>(mesh.positions.size());
    const int segments = static_cast<int>(net[0].size() / 3);
    const int patches_across = static_cast<int>(net.size() / 3);
    const int columns = segments * detail;
    const int rows = patches_across * detail;
    for (int i = 0; i <= columns; ++i) {
        const int segment = std::min(i / detail, segments - 1);
        for (int j = 0; j <= rows; ++j) {
            const int patch_row = std::min(j / detail, patches_across - 1);
            const double u = double(i - segment * detail) / detail;
            const double v = double(j - patch_row * detail) / detail;
            const glm::dvec2 uv(double(i) / columns, double(j) / rows);
            append_patch_point(mesh, patch_rows(net, segment, patch_row), u, v, uv);
        }
    }
    append_grid_triangles(mesh, first_vertex, columns, rows);
    close_part(mesh, name);
}

}  // namespace

Mesh make_teapot(int detail) {
    require_detail("teapot", detail);
    Mesh mesh;
    append_part(mesh, "bottom", control_net(kBottom), detail);
    append_part(mesh, "body", control_net(kBody), detail);
    append_part(mesh, "rim", control_net(kRim), detail);
    append_part(mesh, "lid", control_net(kLid), detail);
    append_part(mesh, "handle", control_net(kHandle), detail);
    append_part(mesh, "spout", control_net(kSpout), detail);
    return mesh;
}

}  // namespace kreda::raster
