#include "tools/explain/probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/clip.hpp"
#include "raster/depth.hpp"

namespace kreda::tools {

namespace {

using raster::ScreenTriangle;
using raster::ScreenVertex;
using raster::VertexStreams;

std::array<const ScreenVertex*, 3> corners_of(const VertexStreams& streams, const ScreenTriangle& triangle) {
    return {&streams.screen[triangle.vertex[0]], &streams.screen[triangle.vertex[1]],
            &streams.screen[triangle.vertex[2]]};
}

glm::mat4 clip_from_object(const scene::Scene& scene, const raster::MeshInstance& instance) {
    return clip_from_world(scene.camera, raster::aspect_of(scene.image.width, scene.image.height)) *
           instance.world_from_object;
}

float depth_over(const std::array<const ScreenVertex*, 3>& v, int x, int y) {
    const std::int64_t area2 = raster::edge_function(v[0]->x, v[0]->y, v[1]->x, v[1]->y, v[2]->x, v[2]->y);
    const raster::DepthPlane plane = raster::depth_plane(*v[0], *v[1], *v[2], area2);
    return depth_at(plane, depth_of_row(plane, y), x);
}

/// Distance of p from the segment a b, all in 1/256 sample.
double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

glm::dvec2 place(const ScreenVertex& v) {
    return {v.x, v.y};
}

glm::dvec2 centre_of_sample(int x, int y) {
    return {raster::centre_of(x), raster::centre_of(y)};
}

/// Where the line of sight through `ndc` meets a triangle given in clip space; found: inside it and before the eye.
struct Hit {
    bool found = false;
    bool front = false;  ///< the triangle is counter-clockwise seen from the eye
    double w = 0.0, z = 0.0;
};
Hit line_of_sight(const std::array<glm::dvec4, 3>& clip, glm::dvec2 ndc) {
    const auto xyw = [&](int i) { return glm::dvec3(clip[i % 3].x, clip[i % 3].y, clip[i % 3].w); };
    const glm::dvec3 ray(ndc, 1.0);
    const double volume = glm::dot(xyw(0), glm::cross(xyw(1), xyw(2)));
    glm::dvec3 edge;
    for (int i = 0; i < 3; ++i) edge[i] = glm::dot(glm::cross(xyw(i + 1), xyw(i + 2)), ray);
    const double sum = edge.x + edge.y + edge.z;
    const double sign = volume < 0.0 ? -1.0 : 1.0;
    Hit hit;
    hit.w = volume / sum;
    hit.found = volume != 0.0 && std::min({edge.x * sign, edge.y * sign, edge.z * sign}) >= 0.0 && hit.w > 0.0;
    hit.front = volume > 0.0;
    hit.z = (edge.x * clip[0].z + edge.y * clip[1].z + edge.z * clip[2].z) / volume;
    return hit;
}

bool is_culled(raster::CullMode cull, bool front) {
    return front ? cull == raster::CullMode::front : cull == raster::CullMode::back;
}

/// The absent triangles of one part of one object.
void find_absent(const scene::RenderPlan& plan, const scene::RenderBuffers& buffers, const glm::mat4& matrix,
                 SourceTriangle source, glm::dvec2 ndc, std::vector<AbsentTriangle>& found) {
    const raster::MeshInstance& instance = buffers.instances[source.object];
    const raster::MeshPart& part = instance.mesh->parts[source.part];
    const bool hidden = !instance.part_hidden.empty() && instance.part_hidden[source.part];
    const bool mirrored = raster::is_mirrored(glm::mat3(instance.world_from_object));
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        std::array<glm::dvec4, 3> clip;
        for (std::size_t i = 0; i < 3; ++i) {
            source.vertex[i] = instance.mesh->indices[3 * std::size_t{t} + i];
            clip[i] = glm::dvec4(matrix * glm::vec4(instance.mesh->positions[source.vertex[i]], 1.0f));
        }
        const Hit hit = line_of_sight(clip, ndc);
        if (!hit.found) continue;
        source.triangle = t;
        const auto add = [&](Absence why) { found.push_back({source, why, hit.w, hit.z}); };
        if (hidden)
            add(Absence::hidden_part);
        else if (hit.z < -1.0)
            add(Absence::before_near_plane);
        else if (hit.z > 1.0)
            add(Absence::beyond_far_plane);
        else if (is_culled(plan.cull, hit.front != mirrored))
            add(Absence::culled);
    }
}

/// Triangle `t` of chunk `c`, where it covers the sample.
void add_cover(const VertexStreams& streams, const raster::TriangleSet& set, std::size_t c, std::uint32_t t, int x,
               int y, std::vector<Cover>& covers) {
    const ScreenTriangle& triangle = set.chunks[c].triangles[t];
    const auto v = corners_of(streams, triangle);
    if (!covers_sample(*v[0], *v[1], *v[2], x, y)) return;
    covers.push_back({raster::triangle_id(c, t), triangle, edges_at(streams, triangle, x, y), depth_over(v, x, y)});
}

}  // namespace

SourceTriangle find_source(const std::vector<raster::MeshInstance>& instances, std::uint32_t source) {
    SourceTriangle found;
    found.triangle = source;
    while (found.triangle >= instances[found.object].mesh->triangle_count()) {
        found.triangle -= instances[found.object++].mesh->triangle_count();
    }
    const raster::Mesh& mesh = *instances[found.object].mesh;
    while (found.triangle >= mesh.parts[found.part].first_triangle + mesh.parts[found.part].triangle_count)
        ++found.part;
    for (std::size_t i = 0; i < 3; ++i) found.vertex[i] = mesh.indices[3 * std::size_t{found.triangle} + i];
    return found;
}

std::array<std::int64_t, 3> edges_at(const VertexStreams& streams, const ScreenTriangle& triangle, int x, int y) {
    const auto v = corners_of(streams, triangle);
    const std::int64_t p_x = raster::centre_of(x);
    const std::int64_t p_y = raster::centre_of(y);
    std::array<std::int64_t, 3> edge;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenVertex& a = *v[(i + 1) % 3];
        const ScreenVertex& b = *v[(i + 2) % 3];
        edge[i] = raster::edge_function(a.x, a.y, b.x, b.y, p_x, p_y);
    }
    return edge;
}

std::vector<Cover> triangles_over(const VertexStreams& streams, const raster::TriangleSet& set, int x, int y) {
    std::vector<Cover> covers;
    const auto tile = static_cast<std::size_t>(set.grid.tile_of(y) * set.grid.columns + set.grid.tile_of(x));
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const raster::TriangleChunk& chunk = set.chunks[c];
        for (std::uint32_t e = chunk.tile_begin[tile]; e < chunk.tile_begin[tile + 1]; ++e) {
            add_cover(streams, set, c, chunk.tile_entries[e], x, y, covers);
        }
    }
    return covers;
}

std::vector<std::vector<Cover>> triangles_over_all(const VertexStreams& streams, const raster::TriangleSet& set,
                                                   int width, int height) {
    std::vector<std::vector<Cover>> covers(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const auto& triangles = set.chunks[c].triangles;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            const auto v = corners_of(streams, triangles[t]);
            const raster::SampleBox box = raster::sample_box(*v[0], *v[1], *v[2], width, height);
            for (int y = box.y_first; y <= box.y_last; ++y) {
                for (int x = box.x_first; x <= box.x_last; ++x) {
                    add_cover(streams, set, c, t, x, y, covers[static_cast<std::size_t>(y * width + x)]);
                }
            }
        }
    }
    return covers;
}

int nearest_of(const std::vector<Cover>& covers) {
    int nearest = -1;
    float depth = raster::kClearDepth;
    for (std::size_t i = 0; i < covers.size(); ++i) {
        if (!(covers[i].depth < depth)) continue;
        depth = covers[i].depth;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

glm::vec3 corner_weights_at(const VertexStreams& streams, const ScreenTriangle& triangle, int x, int y,
                            raster::AttributeInterpolation interpolation) {
    // The attribute that is (1,0,0), (0,1,0), (0,0,1) at the corners comes out as their weights.
    VertexStreams corners;
    for (const ScreenVertex* vertex : corners_of(streams, triangle)) corners.screen.push_back(*vertex);
    corners.color = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    raster::TriangleSet set;
    set.chunks.resize(1);
    set.chunks[0].triangles.push_back({{0, 1, 2}, 0, 0});
    const raster::TileArea area{x, y, 1, 1, 0};
    const raster::Run run{0, 0, 1, 1, 0, 0};
    const auto fragments = std::make_unique<raster::Fragments>();
    interpolate_runs(corners, set, area, &run, 1, {.color = true}, interpolation, *fragments);
    return fragments->color.at(0);
}

VertexSpaces vertex_spaces(const scene::Scene& scene, const scene::RenderPlan& plan,
                           const raster::MeshInstance& instance, std::uint32_t vertex) {
    VertexSpaces v;
    v.object = instance.mesh->positions[vertex];
    v.world = glm::vec3(instance.world_from_object * glm::vec4(v.object, 1.0f));
    v.view = view_from_world(scene.camera) * glm::vec4(v.world, 1.0f);
    v.clip = clip_from_object(scene, instance) * glm::vec4(v.object, 1.0f);
    v.inside = raster::inside_guard_band(v.clip, raster::guard_band_ndc(plan.viewport.width),
                                         raster::guard_band_ndc(plan.viewport.height));
    v.ndc = glm::vec3(v.clip) * (1.0f / v.clip.w);
    v.window = raster::window_from_ndc(v.ndc, plan.viewport);
    v.screen = to_screen(v.clip, plan.viewport);
    return v;
}

DrawnTriangle drawn_triangle(const scene::Scene& scene, const scene::RenderPlan& plan,
                             const scene::RenderBuffers& buffers, const ScreenTriangle& triangle) {
    const SourceTriangle source = find_source(buffers.instances, triangle.source);
    const raster::MeshInstance& instance = buffers.instances[source.object];
    const glm::mat4 matrix = clip_from_object(scene, instance);
    std::array<glm::vec4, 3> clip;
    for (std::size_t i = 0; i < 3; ++i) clip[i] = matrix * glm::vec4(instance.mesh->positions[source.vertex[i]], 1.0f);
    DrawnTriangle drawn;
    const raster::ClipPolygon polygon =
        raster::clip_triangle(clip[0], clip[1], clip[2], raster::guard_band_ndc(plan.viewport.width),
                              raster::guard_band_ndc(plan.viewport.height));
    for (std::size_t i = 0; i < 3; ++i) {
        DrawnCorner& corner = drawn.corner[i];
        corner.screen = buffers.streams.screen[triangle.vertex[i]];
        const auto original =
            std::find(source.vertex.begin(), source.vertex.end(), triangle.vertex[i] - instance.first_vertex) -
            source.vertex.begin();
        if (original < 3) {
            corner.weights[static_cast<int>(original)] = 1.0f;
            corner.clip = clip[static_cast<std::size_t>(original)];
            continue;
        }
        drawn.clipped = true;
        for (int k = 0; k < polygon.count; ++k) {
            const ScreenVertex screen = to_screen(polygon.vertex[k].position, plan.viewport);
            if (screen.x != corner.screen.x || screen.y != corner.screen.y || screen.z != corner.screen.z) continue;
            corner.weights = polygon.vertex[k].weights;
            corner.clip = polygon.vertex[k].position;
        }
    }
    return drawn;
}

std::vector<AbsentTriangle> absent_over(const scene::Scene& scene, const scene::RenderPlan& plan,
                                        const scene::RenderBuffers& buffers, int x, int y) {
    const glm::dvec2 centre = glm::dvec2(x, y) + 0.5;
    const glm::dvec2 ndc(2.0 * centre.x / plan.viewport.width - 1.0, 1.0 - 2.0 * centre.y / plan.viewport.height);
    std::vector<AbsentTriangle> found;
    for (std::uint32_t object = 0; object < buffers.instances.size(); ++object) {
        const raster::MeshInstance& instance = buffers.instances[object];
        const glm::mat4 matrix = clip_from_object(scene, instance);
        for (std::uint32_t part = 0; part < instance.mesh->parts.size(); ++part) {
            find_absent(plan, buffers, matrix, {object, part, 0, {}}, ndc, found);
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    return found;
}

std::optional<NearestEdge> nearest_edge(const scene::RenderBuffers& buffers, int x, int y) {
    std::optional<NearestEdge> nearest;
    double least = std::numeric_limits<double>::infinity();
    const glm::dvec2 p = centre_of_sample(x, y);
    for (const raster::TriangleChunk& chunk : buffers.triangles.chunks) {
        for (const ScreenTriangle& triangle : chunk.triangles) {
            const auto v = corners_of(buffers.streams, triangle);
            for (std::size_t i = 0; i < 3; ++i) {
                const double d = distance_to_segment(p, place(*v[(i + 1) % 3]), place(*v[(i + 2) % 3]));
                if (!(d < least)) continue;
                least = d;
                nearest = NearestEdge{triangle, static_cast<int>(i), d / raster::kSubpixels};
            }
        }
    }
    return nearest;
}

}  // namespace kreda::tools
