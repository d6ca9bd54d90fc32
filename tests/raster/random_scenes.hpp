// Random scenes for the tests of the rasterizer: every kind of triangle that has ever made a hole in a picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include "raster/camera.hpp"
#include "raster/mesh.hpp"
#include "raster/triangle_setup.hpp"

namespace kreda::tests {

using namespace kreda::raster;

/// The same numbers on every machine: the standard fixes the engine's bits, not what its distributions make of them.
/// (Several in one call are asked for in braces, from left to right; within parentheses each compiler has its order.)
class Random {
public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    /// An integer in [low, high].
    int integer(int low, int high) {
        return low + static_cast<int>(bits_() % static_cast<std::uint32_t>(high - low + 1));
    }
    /// A number in [low, high).
    float real(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits_() >> 8) * 0x1p-24f);
    }
    glm::vec3 in_box(float radius) {
        const float x = real(-radius, radius), y = real(-radius, radius), z = real(-radius, radius);
        return {x, y, z};
    }

private:
    std::mt19937 bits_;
};

/// Thousands of tiny pictures are drawn faster by one thread: waking the others costs more than their help.
class OneThread {
#if defined(_OPENMP)
public:
    OneThread() : before_(omp_get_max_threads()) {
        omp_set_num_threads(1);
    }
    ~OneThread() {
        omp_set_num_threads(before_);
    }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    int before_;
#else
public:
    OneThread() {}
#endif
};

/// One mesh and everything that decides what its picture is.
struct Drawing {
    Mesh mesh;
    glm::mat4 clip_from_world{1.0f};
    Viewport viewport;  ///< in samples
    CullMode cull = CullMode::none;
    int samples = 1;  ///< a pixel, in x and in y
};

/// A drawing after the set-up of its triangles.
struct Drawn {
    VertexStreams streams;
    TriangleSet set;
    TriangleCounts counts;
};

inline Drawn set_up(const Drawing& drawing, const VertexNeeds& needs = {}) {
    Drawn drawn;
    std::vector<MeshInstance> instances(1);
    instances[0].mesh = &drawing.mesh;
    instances[0].part_material.assign(drawing.mesh.parts.size(), 0);
    lay_out_vertices(instances, needs, drawn.streams);
    transform_vertices(instances, drawing.clip_from_world, drawing.viewport, drawn.streams);
    drawn.counts = setup_triangles(instances, drawing.clip_from_world, drawing.viewport, drawing.cull, drawing.samples,
                                   drawn.streams, drawn.set);
    return drawn;
}

/// clip <- pixels: a point (x, y, z) lands on the screen at x samples from the left and y from the top, at window depth
/// z. The float error is below 2e-5 samples for images up to 200 wide, so points of the 1/256 grid are hit exactly.
inline glm::mat4 clip_from_pixels(const Viewport& viewport) {
    glm::mat4 m(0.0f);
    m[0][0] = 2.0f / static_cast<float>(viewport.width);
    m[1][1] = -2.0f / static_cast<float>(viewport.height);
    m[2][2] = 2.0f;
    m[3] = {-1.0f, 1.0f, -1.0f, 1.0f};
    return m;
}

/// The same in perspective: the point (x w, y w, w) lands at (x, y) with that w; the near plane is w = near.
inline glm::mat4 clip_from_pixels(const Viewport& viewport, float near, float far) {
    glm::mat4 m(0.0f);
    m[0][0] = 2.0f / static_cast<float>(viewport.width);
    m[1][1] = -2.0f / static_cast<float>(viewport.height);
    m[2] = {-1.0f, 1.0f, (far + near) / (far - near), 1.0f};
    m[3][2] = -2.0f * far * near / (far - near);
    return m;
}

inline void add_triangle(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& corner : {a, b, c}) mesh.positions.push_back(corner);
    for (std::uint32_t i = 0; i < 3; ++i) mesh.indices.push_back(first + i);
}

/// All triangles as one part, as the set-up wants it.
inline void finish(Mesh& mesh) {
    mesh.parts = {{"all", 0, mesh.triangle_count(), -1}};
}

/// columns x rows quads over (columns + 1) (rows + 1) vertices, which are already in the mesh, row by row.
inline void add_grid_triangles(Mesh& mesh, int columns, int rows) {
    const auto vertex = [&](int x, int y) { return static_cast<std::uint32_t>(y * (columns + 1) + x); };
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const std::uint32_t a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x + 1, y + 1), d = vertex(x, y + 1);
            if ((x + y) % 2 == 0) {
                mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
            } else {
                mesh.indices.insert(mesh.indices.end(), {a, b, d, b, c, d});
            }
        }
    }
}

inline Camera random_camera(Random& random) {
    Camera camera;
    camera.position = random.in_box(4.0f);
    camera.target = camera.position + glm::vec3{random.real(-1, 1), random.real(-0.9f, 0.9f), 1.1f};
    camera.vertical_fov_deg = random.real(10.0f, 140.0f);
    camera.near = random.real(0.01f, 0.5f);
    camera.far = random.real(3.0f, 1000.0f);
    camera.projection = random.integer(0, 4) == 0 ? Projection::orthographic : Projection::perspective;
    return camera;
}

/// Triangles of any size everywhere around the camera: in view, beside it, behind it, through every clip plane.
inline void add_soup(Random& random, Drawing& drawing, float size) {
    drawing.clip_from_world = clip_from_world(random_camera(random), 1.4f);
    const int count = random.integer(1, 40);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre = random.in_box(8.0f);
        const float radius = size * random.real(0.01f, 1.0f);
        const glm::vec3 a = random.in_box(radius), b = random.in_box(radius), c = random.in_box(radius);
        add_triangle(drawing.mesh, centre + a, centre + b, centre + c);
    }
}

/// An indexed, bumpy grid in perspective: every inner edge is shared.
inline void add_shared_grid(Random& random, Drawing& drawing) {
    drawing.clip_from_world = clip_from_world(random_camera(random), 1.4f);
    const int columns = random.integer(1, 12), rows = random.integer(1, 12);
    const float scale = random.real(0.2f, 3.0f);
    for (int y = 0; y <= rows; ++y) {
        for (int x = 0; x <= columns; ++x) {
            const float height = random.real(-0.5f, 0.5f);
            drawing.mesh.positions.push_back({scale * static_cast<float>(x - columns / 2), height * scale,
                                              scale * static_cast<float>(y - rows / 2)});
        }
    }
    add_grid_triangles(drawing.mesh, columns, rows);
}

/// A point of the 1/256 grid, some way beyond the image on each side, or a pixel centre, or a corner between pixels.
inline glm::vec3 random_pixel_point(Random& random, const Viewport& viewport) {
    const int margin = 20;
    const float x = static_cast<float>(random.integer(-margin, viewport.width + margin));
    const float y = static_cast<float>(random.integer(-margin, viewport.height + margin));
    const float z = random.real(-0.1f, 1.1f);
    switch (random.integer(0, 2)) {
        case 0: return {x + 0.5f, y + 0.5f, z};
        case 1: return {x, y, z};
        default:
            return {x + static_cast<float>(random.integer(0, 255)) / 256.0f,
                    y + static_cast<float>(random.integer(0, 255)) / 256.0f, z};
    }
}

/// A closed fan of triangles around one point.
inline void add_fan(Random& random, Drawing& drawing) {
    const glm::vec3 hub = random_pixel_point(random, drawing.viewport);
    const int spokes = random.integer(3, 24);
    const float radius = random.real(0.5f, 200.0f);
    drawing.mesh.positions.push_back(hub);
    for (int i = 0; i < spokes; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(spokes);
        const float x = std::round(radius * std::cos(angle)), y = std::round(radius * std::sin(angle));
        drawing.mesh.positions.push_back(hub + glm::vec3(x, y, random.real(-0.2f, 0.2f)));
    }
    const auto rim = [&](int i) { return static_cast<std::uint32_t>(1 + i % spokes); };
    for (int i = 0; i < spokes; ++i) drawing.mesh.indices.insert(drawing.mesh.indices.end(), {0u, rim(i), rim(i + 1)});
}

/// Long triangles a few 1/256 samples thick.
inline void add_slivers(Random& random, Drawing& drawing) {
    const int count = random.integer(1, 60);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = random_pixel_point(random, drawing.viewport);
        const glm::vec3 b = random_pixel_point(random, drawing.viewport);
        const float t = random.real(0.0f, 1.0f);
        const glm::vec3 off{static_cast<float>(random.integer(-3, 3)) / 256.0f,
                            static_cast<float>(random.integer(-3, 3)) / 256.0f, random.real(-0.3f, 0.3f)};
        add_triangle(drawing.mesh, a, b, a + t * (b - a) + off);
    }
}

/// Many triangles of 1/256 to 2 samples.
inline void add_sub_pixel(Random& random, Drawing& drawing) {
    const int count = random.integer(10, 200);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = random_pixel_point(random, drawing.viewport);
        const float size = random.real(1.0f / 256.0f, 2.0f);
        const glm::vec3 b = a + random.in_box(size), c = a + random.in_box(size);
        add_triangle(drawing.mesh, a, b, c);
    }
}

/// Triangles in one plane over each other, some drawn twice and turned: equal depths must be decided by order.
inline void add_coplanar(Random& random, Drawing& drawing) {
    const float z = random.real(0.3f, 0.7f), z_x = random.real(-1e-3f, 1e-3f), z_y = random.real(-1e-3f, 1e-3f);
    const bool level = random.integer(0, 1) == 0;
    const int count = random.integer(2, 20);
    const auto in_plane = [&](glm::vec3 p) { return glm::vec3(p.x, p.y, level ? z : z + z_x * p.x + z_y * p.y); };
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = in_plane(random_pixel_point(random, drawing.viewport));
        const glm::vec3 b = in_plane(random_pixel_point(random, drawing.viewport));
        const glm::vec3 c = in_plane(random_pixel_point(random, drawing.viewport));
        add_triangle(drawing.mesh, a, b, c);
        if (random.integer(0, 2) == 0) add_triangle(drawing.mesh, b, c, a);
        if (random.integer(0, 2) == 0) add_triangle(drawing.mesh, b, a, c);
    }
}

/// Rectangles of two triangles whose corners lie on pixel centres or between pixels.
inline void add_rectangles(Random& random, Drawing& drawing) {
    const int count = random.integer(1, 12);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = random_pixel_point(random, drawing.viewport);
        glm::vec3 c = random_pixel_point(random, drawing.viewport);
        const glm::vec3 b(c.x, a.y, 0.5f * (a.z + c.z)), d(a.x, c.y, 0.5f * (a.z + c.z));
        add_triangle(drawing.mesh, a, b, c);
        add_triangle(drawing.mesh, a, c, d);
    }
}

/// Triangles with corners up to 1e5 units away: through the near plane, and far beyond the guard band.
inline void add_huge(Random& random, Drawing& drawing) {
    drawing.clip_from_world = clip_from_world(random_camera(random), 1.4f);
    const int count = random.integer(1, 12);
    for (int i = 0; i < count; ++i) {
        const float radius = std::pow(10.0f, random.real(0.0f, 5.0f));
        const glm::vec3 a = random.in_box(radius), b = random.in_box(radius), c = random.in_box(radius);
        add_triangle(drawing.mesh, a, b, c);
    }
}

inline constexpr int kSceneKinds = 9;

/// Scene number `seed`; scenes of the same kind are kSceneKinds apart.
inline Drawing random_scene(std::uint32_t seed) {
    Random random(seed);
    Drawing drawing;
    drawing.samples = random.integer(0, 1) == 0 ? 1 : random.integer(1, 8);
    const bool tiny = random.integer(0, 3) == 0;
    const int width = random.integer(1, tiny ? 8 : 200), height = random.integer(1, tiny ? 8 : 150);
    // A supersampled image is a whole number of pixels.
    drawing.viewport.width = std::max(width / drawing.samples, 1) * drawing.samples;
    drawing.viewport.height = std::max(height / drawing.samples, 1) * drawing.samples;
    const CullMode modes[] = {CullMode::back, CullMode::front, CullMode::none, CullMode::none};
    drawing.cull = modes[random.integer(0, 3)];
    drawing.clip_from_world = clip_from_pixels(drawing.viewport);
    switch (seed % kSceneKinds) {
        case 0: add_soup(random, drawing, 4.0f); break;
        case 1: add_fan(random, drawing); break;
        case 2: add_slivers(random, drawing); break;
        case 3: add_shared_grid(random, drawing); break;
        case 4: add_sub_pixel(random, drawing); break;
        case 5: add_huge(random, drawing); break;
        case 6: add_coplanar(random, drawing); break;
        case 7: add_rectangles(random, drawing); break;
        default: add_soup(random, drawing, 30.0f); break;
    }
    finish(drawing.mesh);
    return drawing;
}

}  // namespace kreda::tests
