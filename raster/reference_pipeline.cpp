#include "raster/reference_pipeline.hpp"

#include <array>
#include <utility>

#include <glm/matrix.hpp>

#include "raster/clip.hpp"
#include "raster/depth.hpp"
#include "raster/triangle_setup.hpp"
#include "raster/visibility.hpp"

namespace kreda::raster {

namespace {

/// A vertex after the vertex stage: where it is, and what it carries.
struct Corner {
    glm::vec4 clip{0.0f};
    ScreenVertex screen;
    VertexAttributes attributes;
};
using Triangle = std::array<Corner, 3>;

/// The picture while it is drawn: at every sample the depth, and which of the drawn triangles is nearest.
struct Canvas {
    VisibilityBuffer nearest;
    std::vector<Triangle> drawn;
    std::vector<std::uint32_t> source;  ///< of each drawn triangle
};

/// a = sum b_i a_i
VertexAttributes blend(const Triangle& t, const glm::vec3& b) {
    const VertexAttributes &p = t[0].attributes, &q = t[1].attributes, &r = t[2].attributes;
    return {b.x * p.position + b.y * q.position + b.z * r.position, b.x * p.normal + b.y * q.normal + b.z * r.normal,
            b.x * p.uv + b.y * q.uv + b.z * r.uv};
}

/// 1. Vertex: object -> clip -> screen, and its attributes in the world.
Corner place_vertex(const MeshInstance& instance, std::uint32_t index, const glm::mat4& clip_from_world,
                    const Viewport& viewport) {
    const Mesh& mesh = *instance.mesh;
    const glm::vec4 p(mesh.positions[index], 1.0f);
    Corner corner;
    corner.clip = (clip_from_world * instance.world_from_object) * p;
    corner.screen = to_screen(corner.clip, viewport);
    corner.attributes.position = glm::vec3(instance.world_from_object * p);
    if (!mesh.normals.empty()) {
        corner.attributes.normal = normal_from_object(instance.world_from_object) * mesh.normals[index];
    }
    if (!mesh.uvs.empty()) corner.attributes.uv = mesh.uvs[index];
    return corner;
}

/// 2. Clip: the triangle itself where it can be drawn as it is, else what is left of it, as a fan.
std::vector<Triangle> clip(const Triangle& t, const Viewport& viewport) {
    const float guard_x = guard_band_ndc(viewport.width), guard_y = guard_band_ndc(viewport.height);
    const auto inside = [&](const Corner& corner) { return inside_guard_band(corner.clip, guard_x, guard_y); };
    if (inside(t[0]) && inside(t[1]) && inside(t[2])) return {t};

    const ClipPolygon polygon = clip_triangle(t[0].clip, t[1].clip, t[2].clip, guard_x, guard_y);
    std::array<Corner, ClipPolygon::kMaxCorners> corner;
    std::array<ScreenVertex, ClipPolygon::kMaxCorners> screen;
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& vertex = polygon.vertex[i];
        corner[i] = {vertex.position, to_screen(vertex.position, viewport), blend(t, vertex.weights)};
        screen[i] = corner[i].screen;
    }
    std::vector<Triangle> fan;
    const int apex = fan_apex(screen.data(), polygon.count);
    const auto at = [&](int k) { return corner[(apex + k) % polygon.count]; };
    for (int i = 1; i + 1 < polygon.count; ++i) fan.push_back({at(0), at(i), at(i + 1)});
    return fan;
}

std::int64_t area_of(const Triangle& t) {
    const ScreenVertex &a = t[0].screen, &b = t[1].screen, &c = t[2].screen;
    return edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
}

/// 3. Cover: every sample centre inside the triangle, where nothing nearer was drawn before.
void cover(Triangle t, std::uint32_t source, CullMode cull, Canvas& canvas) {
    const bool front = area_of(t) < 0;  // counter-clockwise; y points down
    if (area_of(t) == 0 || cull == (front ? CullMode::front : CullMode::back)) return;
    if (front) std::swap(t[1], t[2]);
    const ScreenVertex &a = t[0].screen, &b = t[1].screen, &c = t[2].screen;
    const DepthPlane plane = depth_plane(a, b, c, static_cast<double>(area_of(t)));
    const SampleBox box = sample_box(a, b, c, canvas.nearest.width, canvas.nearest.height);
    for (int y = box.y_first; y <= box.y_last; ++y) {
        for (int x = box.x_first; x <= box.x_last; ++x) {
            const std::size_t sample = static_cast<std::size_t>(y) * canvas.nearest.width + x;
            const float z = depth_at(plane, depth_of_row(plane, y), x);
            if (!covers_sample(a, b, c, x, y) || z >= canvas.nearest.depth[sample]) continue;
            canvas.nearest.depth[sample] = z;
            canvas.nearest.triangle[sample] = static_cast<std::uint32_t>(canvas.drawn.size());
        }
    }
    canvas.drawn.push_back(t);
    canvas.source.push_back(source);
}

/// 4. Interpolate:  q_i = E_i / (E_0 + E_1 + E_2) / w_i,   b_i = q_i / sum q_i           Heckbert & Moreton 1991
glm::vec3 weights_at(const Triangle& t, int x, int y) {
    const std::int64_t p_x = centre_of(x), p_y = centre_of(y);
    const float inv_area2 = static_cast<float>(1.0 / static_cast<double>(area_of(t)));
    glm::vec3 q;
    for (int i = 0; i < 3; ++i) {  // the edge opposite to corner i
        const ScreenVertex &from = t[(i + 1) % 3].screen, &to = t[(i + 2) % 3].screen;
        const float E = static_cast<float>(edge_function(from.x, from.y, to.x, to.y, p_x, p_y));
        q[i] = E * (inv_area2 * t[i].screen.inv_w);
    }
    return q * (1.0f / (q.x + q.y + q.z));
}

}  // namespace

void draw_reference(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                    const Viewport& viewport, CullMode cull, const std::function<void(const ReferenceSample&)>& visit) {
    Canvas canvas{VisibilityBuffer(viewport.width, viewport.height), {}, {}};
    std::uint32_t first = 0;  // number of the instance's first triangle
    for (const MeshInstance& instance : instances) {
        const std::vector<std::uint32_t>& index = instance.mesh->indices;
        const auto vertex = [&](std::size_t i) { return place_vertex(instance, index[i], clip_from_world, viewport); };
        for (std::size_t p = 0; p < instance.mesh->parts.size(); ++p) {
            if (!instance.part_hidden.empty() && instance.part_hidden[p]) continue;
            const MeshPart& part = instance.mesh->parts[p];
            for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
                const Triangle whole = {vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)};
                for (const Triangle& piece : clip(whole, viewport)) {
                    cover(piece, first + static_cast<std::uint32_t>(t),
                          cull_mode_for(cull, is_mirrored(glm::mat3(instance.world_from_object))), canvas);
                }
            }
        }
        first += instance.mesh->triangle_count();
    }
    for (int y = 0; y < viewport.height; ++y) {
        for (int x = 0; x < viewport.width; ++x) {  // 5. Visit
            const std::size_t sample = static_cast<std::size_t>(y) * viewport.width + x;
            const std::uint32_t seen = canvas.nearest.triangle[sample];
            if (seen == kNoTriangle) continue;
            const Triangle& t = canvas.drawn[seen];
            visit({x, y, canvas.nearest.depth[sample], canvas.source[seen], blend(t, weights_at(t, x, y))});
        }
    }
}

}  // namespace kreda::raster
