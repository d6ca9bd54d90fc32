#include "raster/triangle_setup.hpp"

#include <algorithm>

#include "raster/clip.hpp"
#include "raster/convex_polygon.hpp"
#include "raster/judge_lanes.hpp"
#include "raster/outside_view.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::raster {

namespace {

/// A triangle that waits for the clipper: its place among the chunk's triangles and its corners in clip space.
struct PendingClip {
    std::uint32_t place = 0;  ///< index in the chunk before which its pieces are drawn
    ScreenTriangle triangle;
    ClipPolygon polygon;
};

/// What setting up one chunk needs to know.
struct ChunkTask {
    std::uint32_t instance = 0;
    std::uint32_t first_triangle = 0;  ///< in the mesh, whatever their parts
    std::uint32_t triangle_count = 0;
    std::uint32_t first_source = 0;  ///< number of the instance's first triangle over all instances
    bool outside = false;            ///< the whole instance lies beyond the view
};

struct SetupInput {
    glm::mat4 clip_from_world;
    Viewport viewport;
    CullMode cull;
    bool mirrored;  ///< the instance's transform turns counter-clockwise into clockwise
};

/// Triangles that will be drawn, with the tiles that they touch; there is room for more behind the last.
struct DrawList {
    std::vector<ScreenTriangle> triangles;
    std::vector<TileRange> tiles;
    std::uint32_t count = 0;

    void make_room(std::uint32_t more) {
        if (triangles.size() >= count + more) return;
        triangles.resize(count + more);
        tiles.resize(count + more);
    }
};

/// Write a triangle, clockwise, behind the last; it stays only if it is to be drawn.
void append(const ScreenTriangle& triangle, bool front, bool mirrored, const TileRange& tiles, bool drawn,
            DrawList& list) {
    ScreenTriangle& to = list.triangles[list.count];  // field by field: a copy would wait for its parts to reach memory
    to.vertex[0] = triangle.vertex[0];
    to.vertex[1] = triangle.vertex[front ? 2 : 1];
    to.vertex[2] = triangle.vertex[front ? 1 : 2];
    to.source = triangle.source;
    to.material = triangle.material;
    to.behind = front == mirrored;
    list.tiles[list.count] = tiles;
    list.count += drawn;
}

/// The three corners of a triangle in clip space, computed again: only triangles for the clipper need them.
ClipPolygon clip_again(const MeshInstance& instance, const SetupInput& input, const std::uint32_t* corner,
                       bool& finite) {
    const glm::mat4 clip_from_object = input.clip_from_world * instance.world_from_object;
    std::array<glm::vec4, 3> clip;
    finite = true;
    for (int i = 0; i < 3; ++i) {
        clip[i] = clip_from_object * glm::vec4(instance.mesh->positions[corner[i]], 1.0f);
        finite = finite && is_finite(clip[i].x) && is_finite(clip[i].y) && is_finite(clip[i].z) && is_finite(clip[i].w);
    }
    return clip_triangle(clip[0], clip[1], clip[2], guard_band_ndc(input.viewport.width),
                         guard_band_ndc(input.viewport.height));
}

void count_fates(const std::int32_t* fate, int count, TriangleCounts& counts) {
    counts.drawn += how_many(fate, count, Fate::drawn);
    counts.degenerate += how_many(fate, count, Fate::degenerate);
    counts.culled += how_many(fate, count, Fate::culled);
    counts.outside += how_many(fate, count, Fate::outside);
}

/// Put a triangle aside that the clipper leaves something of.
void clip_later(const MeshInstance& instance, const SetupInput& input, const std::uint32_t* index,
                const ScreenTriangle& triangle, std::uint32_t place, TriangleCounts& counts,
                std::vector<PendingClip>& pending) {
    bool finite = true;
    const ClipPolygon polygon = clip_again(instance, input, index, finite);
    counts.non_finite += !finite;
    counts.outside += finite && polygon.count == 0;
    if (polygon.count > 0) pending.push_back({place, triangle, polygon});
}

/// List the triangles of one part of a mesh, from `begin` to `end`, that will be drawn; those that need clipping are
/// put aside in `pending`.
void list_triangles(std::uint32_t begin, std::uint32_t end, std::uint32_t material, std::uint32_t first_source,
                    const MeshInstance& instance, const SetupInput& input, const TileGrid& grid,
                    const VertexStreams& streams, DrawList& list, TriangleCounts& counts,
                    std::vector<PendingClip>& pending) {
    const std::uint32_t* index = &instance.mesh->indices[3 * std::size_t{begin}];
    JudgeLanes lanes{};  // lanes behind the last triangle are judged, too
    ScreenTriangle triangle;
    triangle.material = material;
    counts.input += end - begin;
    for (std::uint32_t first = begin; first < end; first += kScreenLanes, index += 3 * kScreenLanes) {
        const int count = static_cast<int>(std::min<std::uint32_t>(end - first, kScreenLanes));
        fetch_corners(&streams.screen[instance.first_vertex], index, count, lanes);
        const bool any = judge_triangles(count, input.cull, input.viewport, grid, lanes);
        count_fates(lanes.fate, count, counts);
        for (int i = 0; any && i < count; ++i) {
            const Fate fate{lanes.fate[i]};
            triangle.source = first_source + first + static_cast<std::uint32_t>(i);
            for (int k = 0; k < 3; ++k) triangle.vertex[k] = instance.first_vertex + index[3 * i + k];
            append(triangle, lanes.front[i] != 0, input.mirrored, lanes.tiles_at(i), fate == Fate::drawn, list);
            if (fate == Fate::needs_clip) {
                clip_later(instance, input, index + 3 * i, triangle, list.count, counts, pending);
            }
        }
    }
}

/// List the triangles of one chunk, part by part.
void list_chunk(const ChunkTask& task, const MeshInstance& instance, const SetupInput& input, const TileGrid& grid,
                const VertexStreams& streams, DrawList& list, TriangleCounts& counts,
                std::vector<PendingClip>& pending) {
    list.count = 0;
    list.make_room(task.triangle_count + 1);
    const std::vector<MeshPart>& parts = instance.mesh->parts;
    const std::uint32_t first = task.first_triangle, last = first + task.triangle_count;
    const auto is_before = [&](const MeshPart& part) { return part.first_triangle + part.triangle_count <= first; };
    const auto first_part = std::partition_point(parts.begin(), parts.end(), is_before);
    for (auto part = first_part; part != parts.end() && part->first_triangle < last; ++part) {
        const auto p = static_cast<std::size_t>(part - parts.begin());
        if (!instance.part_hidden.empty() && instance.part_hidden[p]) continue;
        const std::uint32_t begin = std::max(part->first_triangle, first);
        const std::uint32_t end = std::min(part->first_triangle + part->triangle_count, last);
        if (task.outside) {
            counts.input += end - begin;
            counts.outside += end - begin;
            continue;
        }
        list_triangles(begin, end, instance.part_material[p], task.first_source, instance, input, grid, streams, list,
                       counts, pending);
    }
}

/// Weighted sum of an attribute at a triangle's corners, appended to its stream if that is in use.
template <class Attribute>
void append_weighted(AlignedVector<Attribute>& stream, const std::array<std::uint32_t, 3>& corner,
                     const glm::vec3& weights) {
    if (stream.empty()) return;
    const Attribute value =
        weights.x * stream[corner[0]] + weights.y * stream[corner[1]] + weights.z * stream[corner[2]];
    stream.push_back(value);
}

/// A new vertex of the clipper: its place on the screen and its attributes.
void append_vertex(const ClipVertex& vertex, const std::array<std::uint32_t, 3>& corner, const Viewport& viewport,
                   VertexStreams& streams) {
    streams.screen.push_back(to_screen(vertex.position, viewport));
    append_weighted(streams.position_world, corner, vertex.weights);
    append_weighted(streams.normal_world, corner, vertex.weights);
    append_weighted(streams.uv, corner, vertex.weights);
    append_weighted(streams.tangent_world, corner, vertex.weights);
    append_weighted(streams.color, corner, vertex.weights);
    append_weighted(streams.color_behind, corner, vertex.weights);
    append_weighted(streams.fog, corner, vertex.weights);
}

/// Draw one clipped triangle as a fan of triangles.
void draw_fan(const PendingClip& clip, const SetupInput& input, const TileGrid& grid, VertexStreams& streams,
              DrawList& list, TriangleCounts& counts) {
    const auto first = static_cast<std::uint32_t>(streams.screen.size());
    const int count = clip.polygon.count;
    for (int i = 0; i < count; ++i)
        append_vertex(clip.polygon.vertex[i], clip.triangle.vertex, input.viewport, streams);
    const int apex = fan_apex(&streams.screen[first], count);
    list.make_room(static_cast<std::uint32_t>(count) + 1);
    for_each_of_fan(apex, count, [&](int i, int j, int k) {
        const auto corner = [&](int n) { return first + static_cast<std::uint32_t>(n); };
        ScreenTriangle piece = clip.triangle;
        piece.vertex = {corner(i), corner(j), corner(k)};
        const ScreenPoint a = point_of(streams.screen[piece.vertex[0]]);
        const ScreenPoint b = point_of(streams.screen[piece.vertex[1]]);
        const ScreenPoint c = point_of(streams.screen[piece.vertex[2]]);
        const Judgement judgement = judge(a, b, c, input.cull, input.viewport);
        const Fate fate = look_closer(a, b, c, judgement);
        const auto number = static_cast<std::int32_t>(fate);
        count_fates(&number, 1, counts);
        append(piece, judgement.front, input.mirrored, tiles_of(grid, judgement.x, judgement.y), fate == Fate::drawn,
               list);
    });
    ++counts.clipped;
}

/// List the clipped triangles of a chunk, too, each at its place in the drawing order.
DrawList with_clipped(const DrawList& list, const std::vector<PendingClip>& pending, const SetupInput& input,
                      const TileGrid& grid, VertexStreams& streams, TriangleCounts& counts) {
    DrawList merged;
    std::uint32_t copied = 0;
    const auto copy_until = [&](std::uint32_t place) {
        merged.make_room(place - copied);
        for (; copied < place; ++copied, ++merged.count) {
            merged.triangles[merged.count] = list.triangles[copied];
            merged.tiles[merged.count] = list.tiles[copied];
        }
    };
    for (const PendingClip& clip : pending) {
        copy_until(clip.place);
        draw_fan(clip, input, grid, streams, merged, counts);
    }
    copy_until(list.count);
    return merged;
}

/// Keep the triangles and sort them into tiles: count, then fill. The order within a tile stays the drawing order.
void fill_chunk(const DrawList& list, const TileGrid& grid, TriangleChunk& chunk) {
    chunk.triangles.assign(list.triangles.begin(), list.triangles.begin() + list.count);
    const auto for_each_tile = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < list.count; ++t) {
            const TileRange range = list.tiles[t];
            for (int y = range.y0; y <= range.y1; ++y) {
                for (int x = range.x0; x <= range.x1; ++x) visit(y * grid.columns + x, t);
            }
        }
    };
    std::vector<std::uint32_t>& begin = chunk.tile_begin;
    begin.assign(static_cast<std::size_t>(grid.columns) * grid.rows + 1, 0);
    for_each_tile([&](int tile, std::uint32_t) { ++begin[tile + 1]; });
    for (std::size_t tile = 1; tile < begin.size(); ++tile) begin[tile] += begin[tile - 1];
    chunk.tile_entries.resize(begin.back());
    // While filling, begin[t] runs to the end of tile t; shifting by one tile afterwards restores the beginnings.
    for_each_tile(
        [&](int tile, std::uint32_t t) { chunk.tile_entries[begin[tile]++] = static_cast<std::uint16_t>(t); });
    for (std::size_t tile = begin.size() - 1; tile > 0; --tile) begin[tile] = begin[tile - 1];
    begin[0] = 0;
}

/// A chunk that waits for the clipper.
struct WaitingChunk {
    std::vector<PendingClip> clips;  ///< empty: it does not wait
    DrawList list;
};

void start_chunk(const ChunkTask& task, TriangleChunk& chunk) {
    chunk.counts = {};
    chunk.instance = task.instance;
    chunk.first_source = task.first_source;
}

/// Cut all instances into chunks.
std::vector<ChunkTask> make_tasks(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                                  const Viewport& viewport) {
    std::vector<ChunkTask> tasks;
    std::uint32_t source = 0;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const std::uint32_t triangles = instances[i].mesh->triangle_count();
        const bool outside = lies_outside(instances[i], clip_from_world, viewport);
        for (std::uint32_t begin = 0; begin < triangles; begin += kTrianglesPerChunk) {
            tasks.push_back({i, begin, std::min(kTrianglesPerChunk, triangles - begin), source, outside});
        }
        source += triangles;
    }
    return tasks;
}

void add(TriangleCounts& sum, const TriangleCounts& counts) {
    sum.input += counts.input;
    sum.drawn += counts.drawn;
    sum.culled += counts.culled;
    sum.outside += counts.outside;
    sum.degenerate += counts.degenerate;
    sum.non_finite += counts.non_finite;
    sum.clipped += counts.clipped;
}

}  // namespace

std::size_t bytes_to_set_up(std::size_t triangles) {
    return (std::min<std::size_t>(triangles, kTrianglesPerChunk) + 1) * (sizeof(ScreenTriangle) + sizeof(TileRange));
}

int fan_apex(const ScreenVertex* corner, int count) {
    for (int apex = 0; apex < count; ++apex) {
        bool any_left = false, any_right = false;
        for_each_of_fan(apex, count, [&](int i, int j, int k) {
            const ScreenVertex &a = corner[i], &b = corner[j], &c = corner[k];
            const std::int64_t area = edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
            any_left |= area < 0;
            any_right |= area > 0;
        });
        if (!any_left || !any_right) return apex;
    }
    return 0;
}

TriangleCounts setup_triangles(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                               const Viewport& viewport, CullMode cull, int samples, VertexStreams& streams,
                               TriangleSet& set) {
    const auto frame_of = [&](const ChunkTask& task) {
        const bool mirrored = is_mirrored(glm::mat3(instances[task.instance].world_from_object));
        return SetupInput{clip_from_world, viewport, cull_mode_for(cull, mirrored), mirrored};
    };
    const std::vector<ChunkTask> tasks = make_tasks(instances, clip_from_world, viewport);
    const int chunk_count = static_cast<int>(tasks.size());
    set.grid = make_tile_grid(viewport, samples);
    set.chunks.resize(tasks.size());
    std::vector<WaitingChunk> waiting(tasks.size());
#pragma omp parallel if (chunk_count > 1)
    {
        DrawList list;
#pragma omp for schedule(dynamic)
        for (int i = 0; i < chunk_count; ++i) {
            TriangleChunk& chunk = set.chunks[i];
            start_chunk(tasks[i], chunk);
            list_chunk(tasks[i], instances[tasks[i].instance], frame_of(tasks[i]), set.grid, streams, list,
                       chunk.counts, waiting[i].clips);
            if (waiting[i].clips.empty())
                fill_chunk(list, set.grid, chunk);
            else
                waiting[i].list = list;
        }
    }
    // Clipped triangles append vertices to the streams: one thread, in order, so that their numbers never change.
    for (int i = 0; i < chunk_count; ++i) {
        if (waiting[i].clips.empty()) continue;
        waiting[i].list = with_clipped(waiting[i].list, waiting[i].clips, frame_of(tasks[i]), set.grid, streams,
                                       set.chunks[i].counts);
    }
#pragma omp parallel for schedule(dynamic) if (chunk_count > 1)
    for (int i = 0; i < chunk_count; ++i) {
        if (!waiting[i].clips.empty()) fill_chunk(waiting[i].list, set.grid, set.chunks[i]);
    }
    TriangleCounts sum;
    for (const TriangleChunk& chunk : set.chunks) add(sum, chunk.counts);
    return sum;
}

}  // namespace kreda::raster
