#include "raster/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"
#include "raster/shape_grid.hpp"

namespace kreda::raster {

namespace {

/// The least detail has a volume (where the shape has one), the most stays below 2^27 triangles.
struct ShapeEntry {
    std::string_view name;
    Mesh (*make)(int detail);
    int least_detail;
    int most_detail;
    int default_detail;
};

constexpr std::array kShapes = {
    ShapeEntry{"cube", make_cube, 1, 2048, 1},        ShapeEntry{"sphere", make_sphere, 4, 4096, 64},
    ShapeEntry{"torus", make_torus, 6, 4096, 64},     ShapeEntry{"torus_knot", make_torus_knot, 24, 4096, 256},
    ShapeEntry{"plane", make_plane, 1, 4096, 1},      ShapeEntry{"teapot", make_teapot, 2, 1024, 16},
    ShapeEntry{"terrain", make_terrain, 1, 4096, 64},
};

const ShapeEntry* find_shape(std::string_view name) {
    const auto* entry = std::ranges::find(kShapes, name, &ShapeEntry::name);
    return entry == kShapes.end() ? nullptr : entry;
}

/// y = h(x, z) with its two slopes: a point of a height field.
struct Height {
    double y = 0.0;
    double dy_dx = 0.0;
    double dy_dz = 0.0;
};

Height flat_height(double, double) {
    return {};
}

/// y = 0.15 sin(7x) cos(5z)
Height terrain_height(double x, double z) {
    return {0.15 * std::sin(7 * x) * std::cos(5 * z), 0.15 * 7 * std::cos(7 * x) * std::cos(5 * z),
            -0.15 * 5 * std::sin(7 * x) * std::sin(5 * z)};
}

/// A height field over [-1, 1]^2; its normal is (-dy/dx, 1, -dy/dz), made unit. v runs against z, so that a texture
/// seen from above with -z upwards is upright.
Mesh make_height_field(std::string_view name, int n, Height (*height)(double x, double z)) {
    Mesh mesh;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = -1 + 2.0 * i / n;
            const double z = -1 + 2.0 * j / n;
            const Height h = height(x, z);
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-h.dy_dx, 1.0, -h.dy_dz));
            append_vertex(mesh, {x, h.y, z}, normal, {double(i) / n, 1.0 - double(j) / n});
        }
    }
    append_grid_triangles(mesh, 0, n, n);
    close_part(mesh, name);
    return mesh;
}

}  // namespace

void append_vertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.uvs.emplace_back(uv);
}

void append_grid_triangles(Mesh& mesh, std::uint32_t first_vertex, int outer, int inner) {
    const auto append_triangle = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
        if (p != q && q != r && r != p) mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    const auto row = static_cast<std::uint32_t>(inner) + 1;
    KREDA_EXPECT(first_vertex + (static_cast<std::uint32_t>(outer) + 1) * row <= mesh.positions.size());
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(outer); ++i) {
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            const std::uint32_t a = first_vertex + i * row + j;
            const std::uint32_t b = a + row;
            const std::uint32_t c = b + 1;
            const std::uint32_t d = a + 1;
            append_triangle(a, b, c);
            append_triangle(a, c, d);
        }
    }
}

void close_part(Mesh& mesh, std::string_view name) {
    std::uint32_t first = 0;
    if (!mesh.parts.empty()) first = mesh.parts.back().first_triangle + mesh.parts.back().triangle_count;
    mesh.parts.push_back({std::string(name), first, mesh.triangle_count() - first, -1});
}

void require_detail(std::string_view shape, int detail) {
    const ShapeEntry* entry = find_shape(shape);
    KREDA_EXPECT(entry != nullptr);
    if (detail >= entry->least_detail && detail <= entry->most_detail) return;
    throw std::invalid_argument(std::string(shape) + ": detail " + std::to_string(detail) +
                                " is out of range, allowed are " + std::to_string(entry->least_detail) + " to " +
                                std::to_string(entry->most_detail));
}

Mesh make_cube(int detail) {
    require_detail("cube", detail);
    struct Face {
        glm::dvec3 normal, right, up;  // right x up = normal
    };
    constexpr double o = 0.0;
    const std::array<Face, 6> faces = {{{{1, o, o}, {o, o, -1}, {o, 1, o}},
                                        {{-1, o, o}, {o, o, 1}, {o, 1, o}},
                                        {{o, 1, o}, {1, o, o}, {o, o, -1}},
                                        {{o, -1, o}, {1, o, o}, {o, o, 1}},
                                        {{o, o, 1}, {1, o, o}, {o, 1, o}},
                                        {{o, o, -1}, {-1, o, o}, {o, 1, o}}}};
    Mesh mesh;
    for (const Face& face : faces) {
        const auto first_vertex = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i <= detail; ++i) {
            for (int j = 0; j <= detail; ++j) {
                // (2i - n) / n, not -1 + 2i/n: the mirrored coordinate is then its exact negative and the edges meet.
                const double s = double(2 * i - detail) / detail;
                const double t = double(2 * j - detail) / detail;
                const glm::dvec3 position = face.normal + s * face.right + t * face.up;
                append_vertex(mesh, position, face.normal, {double(i) / detail, double(j) / detail});
            }
        }
        append_grid_triangles(mesh, first_vertex, detail, detail);
    }
    close_part(mesh, "cube");
    return mesh;
}

Mesh make_sphere(int detail) {
    require_detail("sphere", detail);
    const int segments = detail;
    const int rings = detail / 2;
    Mesh mesh;
    for (int r = 0; r <= rings; ++r) {
        const double theta = std::numbers::pi * r / rings;
        const double y = std::cos(theta);
        const double radius = (r == 0 || r == rings) ? 0.0 : std::sin(theta);
        for (int s = 0; s <= segments; ++s) {
            const double phi = 2 * std::numbers::pi * (s % segments) / segments;  // % closes the seam exactly
            const glm::dvec3 p(radius * std::sin(phi), y, radius * std::cos(phi));
            append_vertex(mesh, p, p, {double(s) / segments, 1.0 - double(r) / rings});
        }
    }
    append_grid_triangles(mesh, 0, rings, segments);
    close_part(mesh, "sphere");
    return mesh;
}

Mesh make_torus(int detail) {
    require_detail("torus", detail);
    const int around_ring = detail;
    const int around_tube = detail / 2;
    Mesh mesh;
    for (int i = 0; i <= around_ring; ++i) {
        for (int j = 0; j <= around_tube; ++j) {
            const double u = 2 * std::numbers::pi * (i % around_ring) / around_ring;
            const double v = 2 * std::numbers::pi * (j % around_tube) / around_tube;
            const glm::dvec3 normal(std::cos(v) * std::sin(u), std::sin(v), std::cos(v) * std::cos(u));
            const glm::dvec3 ring(std::sin(u), 0.0, std::cos(u));
            append_vertex(mesh, ring + 0.4 * normal, normal, {double(i) / around_ring, double(j) / around_tube});
        }
    }
    append_grid_triangles(mesh, 0, around_ring, around_tube);
    close_part(mesh, "torus");
    return mesh;
}

Mesh make_plane(int detail) {
    require_detail("plane", detail);
    return make_height_field("plane", detail, flat_height);
}

Mesh make_terrain(int detail) {
    require_detail("terrain", detail);
    return make_height_field("terrain", detail, terrain_height);
}

std::optional<Mesh> make_shape(std::string_view name, int detail) {
    const ShapeEntry* entry = find_shape(name);
    if (entry == nullptr) return std::nullopt;
    return entry->make(detail);
}

std::span<const std::string_view> shape_names() {
    static constexpr auto kNames = [] {
        std::array<std::string_view, kShapes.size()> names;
        std::ranges::transform(kShapes, names.begin(), &ShapeEntry::name);
        return names;
    }();
    return kNames;
}

std::optional<int> default_detail(std::string_view name) {
    const ShapeEntry* entry = find_shape(name);
    if (entry == nullptr) return std::nullopt;
    return entry->default_detail;
}

}  // namespace kreda::raster
