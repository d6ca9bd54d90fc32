#include "raster/triangle_setup.hpp"

#include <algorithm>

#include <glm/matrix.hpp>

#include "raster/clip.hpp"
#include "raster/platform.hpp"
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
    std::uint32_t part = 0;
    std::uint32_t first_triangle = 0;  ///< in the mesh
    std::uint32_t triangle_count = 0;
    std::uint32_t first_source = 0;  ///< number of the instance's first triangle over all instances
};

struct Frame {
    glm::mat4 clip_from_world;
    Viewport viewport;
    CullMode cull;
};

/// A mirroring transform (a negative scale) turns counter-clockwise into clockwise: what was the back is then the
/// front.
CullMode cull_mode_for(CullMode cull, const glm::mat4& world_from_object) {
    if (glm::determinant(glm::dmat3(world_from_object)) >= 0.0) return cull;
    if (cull == CullMode::back) return CullMode::front;
    return cull == CullMode::front ? CullMode::back : cull;
}

/// First and last sample whose centre lies in [min, max] (1/256 sample), inside an image of `side` samples.
struct SampleRange {
    std::int32_t first, last;
};
SampleRange samples_between(std::int32_t min, std::int32_t max, int side) {
    const std::int32_t first = (min + kPixelCentre - 1) >> kSubpixelBits;
    const std::int32_t last = (max - kPixelCentre) >> kSubpixelBits;
    return {std::max(first, 0), std::min(last, side - 1)};
}

/// What becomes of a triangle.
enum class Fate { drawn, degenerate, culled, outside };

/// Orient a triangle clockwise (y down) and decide what becomes of it; if it is drawn, say which tiles its samples may
/// lie in. The sign of the snapped area decides where it faces.
Fate judge(const VertexStreams& streams, const Frame& frame, const TileGrid& grid, ScreenTriangle& triangle,
           TriangleChunk::TileRange& tiles) {
    const ScreenVertex* const a = &streams.screen[triangle.vertex[0]];
    const ScreenVertex* b = &streams.screen[triangle.vertex[1]];
    const ScreenVertex* c = &streams.screen[triangle.vertex[2]];
    const std::int64_t area = edge_function(a->x, a->y, b->x, b->y, c->x, c->y);
    if (area == 0) return Fate::degenerate;
    const bool front = area < 0;  // counter-clockwise with y up is negative with y down
    if (front ? frame.cull == CullMode::front : frame.cull == CullMode::back) return Fate::culled;
    if (front) {
        std::swap(triangle.vertex[1], triangle.vertex[2]);
        std::swap(b, c);
    }
    const SampleRange x =
        samples_between(std::min({a->x, b->x, c->x}), std::max({a->x, b->x, c->x}), frame.viewport.width);
    const SampleRange y =
        samples_between(std::min({a->y, b->y, c->y}), std::max({a->y, b->y, c->y}), frame.viewport.height);
    const bool no_centre = (x.first > x.last) | (y.first > y.last);
    if (no_centre) return Fate::outside;
    const bool one_centre = (x.first == x.last) & (y.first == y.last);
    if (one_centre && !covers_sample(*a, *b, *c, x.first, y.first)) return Fate::outside;
    tiles = {grid.tile_of(x.first), grid.tile_of(y.first), grid.tile_of(x.last), grid.tile_of(y.last)};
    return Fate::drawn;
}

/// Triangles that will be drawn, with the tiles that they touch; there is room for more behind the last.
struct DrawList {
    std::vector<ScreenTriangle> triangles;
    std::vector<TriangleChunk::TileRange> tiles;
    std::uint32_t count = 0;

    void make_room(std::uint32_t more) {
        if (triangles.size() >= count + more) return;
        triangles.resize(count + more);
        tiles.resize(count + more);
    }
};

/// The place behind the last triangle. What is written there stays only if draw_or_count() finds that it is to be
/// drawn. (Written in place, field by field: a copy would wait for its parts to reach memory.)
ScreenTriangle& candidate(DrawList& list) {
    return list.triangles[list.count];
}

/// Keep the candidate, or count why not.
void draw_or_count(const VertexStreams& streams, const Frame& frame, const TileGrid& grid, DrawList& list,
                   TriangleCounts& counts) {
    switch (judge(streams, frame, grid, candidate(list), list.tiles[list.count])) {
        case Fate::drawn:
            ++counts.drawn;
            ++list.count;
            return;
        case Fate::degenerate:
            ++counts.degenerate;
            return;
        case Fate::culled:
            ++counts.culled;
            return;
        case Fate::outside:
            ++counts.outside;
            return;
    }
}

void assign(const DrawList& list, TriangleChunk& chunk) {
    chunk.triangles.assign(list.triangles.begin(), list.triangles.begin() + list.count);
    chunk.tile_range.assign(list.tiles.begin(), list.tiles.begin() + list.count);
}

/// The three corners of a triangle in clip space, computed again: only triangles for the clipper need them.
ClipPolygon clip_again(const MeshInstance& instance, const Frame& frame, const std::uint32_t* corner, bool& finite) {
    const glm::mat4 clip_from_object = frame.clip_from_world * instance.world_from_object;
    std::array<glm::vec4, 3> clip;
    finite = true;
    for (int i = 0; i < 3; ++i) {
        clip[i] = clip_from_object * glm::vec4(instance.mesh->positions[corner[i]], 1.0f);
        finite = finite && is_finite(clip[i].x) && is_finite(clip[i].y) && is_finite(clip[i].z) && is_finite(clip[i].w);
    }
    return clip_triangle(clip[0], clip[1], clip[2], guard_band_ndc(frame.viewport.width),
                         guard_band_ndc(frame.viewport.height));
}

/// Set up the triangles of one chunk that need no clipping; the others are put aside in `pending`.
void setup_chunk(const ChunkTask& task, const MeshInstance& instance, const Frame& frame, const TileGrid& grid,
                 const VertexStreams& streams, DrawList& list, TriangleChunk& chunk,
                 std::vector<PendingClip>& pending) {
    chunk.counts = {};
    chunk.counts.input = task.triangle_count;
    chunk.instance = task.instance;
    chunk.first_source = task.first_source;
    list.count = 0;
    list.make_room(kTrianglesPerChunk + 1);
    const std::uint32_t* index = &instance.mesh->indices[3 * std::size_t{task.first_triangle}];
    for (std::uint32_t i = 0; i < task.triangle_count; ++i, index += 3) {
        ScreenTriangle& triangle = candidate(list);
        triangle.source = task.first_source + task.first_triangle + i;
        triangle.material = instance.part_material[task.part];
        bool needs_clip = false;
        for (int corner = 0; corner < 3; ++corner) {
            triangle.vertex[corner] = instance.first_vertex + index[corner];
            needs_clip |= streams.screen[triangle.vertex[corner]].x == kNeedsClip;
        }
        if (!needs_clip) {
            draw_or_count(streams, frame, grid, list, chunk.counts);
            continue;
        }
        bool finite = true;
        const ClipPolygon polygon = clip_again(instance, frame, index, finite);
        chunk.counts.non_finite += !finite;
        chunk.counts.outside += finite && polygon.count == 0;
        if (polygon.count > 0) pending.push_back({list.count, triangle, polygon});
    }
    assign(list, chunk);
}

/// Weighted sum of an attribute at a triangle's corners, appended to its stream if that is in use.
template <class Attribute>
void append_weighted(std::vector<Attribute>& stream, const std::array<std::uint32_t, 3>& corner,
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
    append_weighted(streams.fog, corner, vertex.weights);
}

/// Draw one clipped triangle as a fan of triangles.
void draw_fan(const PendingClip& clip, const Frame& frame, const TileGrid& grid, VertexStreams& streams, DrawList& list,
              TriangleCounts& counts) {
    const auto first = static_cast<std::uint32_t>(streams.screen.size());
    const int count = clip.polygon.count;
    for (int i = 0; i < count; ++i)
        append_vertex(clip.polygon.vertex[i], clip.triangle.vertex, frame.viewport, streams);
    const int apex = fan_apex(&streams.screen[first], count);
    list.make_room(static_cast<std::uint32_t>(count) + 1);
    for (int i = 1; i + 1 < count; ++i) {
        const auto corner = [&](int k) { return first + static_cast<std::uint32_t>((apex + k) % count); };
        ScreenTriangle& piece = candidate(list);
        piece = clip.triangle;
        piece.vertex = {corner(0), corner(i), corner(i + 1)};
        draw_or_count(streams, frame, grid, list, counts);
    }
    ++counts.clipped;
}

/// Draw the clipped triangles of a chunk, each at its place in the drawing order.
void draw_clipped(const std::vector<PendingClip>& pending, const Frame& frame, const TileGrid& grid,
                  VertexStreams& streams, TriangleChunk& chunk) {
    DrawList merged;
    std::uint32_t copied = 0;
    const auto copy_until = [&](std::uint32_t place) {
        merged.make_room(place - copied);
        for (; copied < place; ++copied, ++merged.count) {
            merged.triangles[merged.count] = chunk.triangles[copied];
            merged.tiles[merged.count] = chunk.tile_range[copied];
        }
    };
    for (const PendingClip& clip : pending) {
        copy_until(clip.place);
        draw_fan(clip, frame, grid, streams, merged, chunk.counts);
    }
    copy_until(static_cast<std::uint32_t>(chunk.triangles.size()));
    assign(merged, chunk);
}

/// Sort the chunk's triangles into tiles: count, then fill. The order within a tile stays the drawing order.
void bin_chunk(const TileGrid& grid, TriangleChunk& chunk) {
    const auto for_each_tile = [&](auto&& visit) {
        for (std::size_t t = 0; t < chunk.tile_range.size(); ++t) {
            const TriangleChunk::TileRange range = chunk.tile_range[t];
            for (int y = range.y0; y <= range.y1; ++y) {
                for (int x = range.x0; x <= range.x1; ++x) visit(y * grid.columns + x, t);
            }
        }
    };
    std::vector<std::uint32_t>& begin = chunk.tile_begin;
    begin.assign(static_cast<std::size_t>(grid.columns) * grid.rows + 1, 0);
    for_each_tile([&](int tile, std::size_t) { ++begin[tile + 1]; });
    for (std::size_t tile = 1; tile < begin.size(); ++tile) begin[tile] += begin[tile - 1];
    chunk.tile_entries.resize(begin.back());
    // While filling, begin[t] runs to the end of tile t; shifting by one tile afterwards restores the beginnings.
    for_each_tile([&](int tile, std::size_t t) { chunk.tile_entries[begin[tile]++] = static_cast<std::uint16_t>(t); });
    for (std::size_t tile = begin.size() - 1; tile > 0; --tile) begin[tile] = begin[tile - 1];
    begin[0] = 0;
}

/// Cut all visible parts of all instances into chunks.
std::vector<ChunkTask> make_tasks(const std::vector<MeshInstance>& instances) {
    std::vector<ChunkTask> tasks;
    std::uint32_t source = 0;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const MeshInstance& instance = instances[i];
        for (std::uint32_t p = 0; p < instance.mesh->parts.size(); ++p) {
            const MeshPart& part = instance.mesh->parts[p];
            const bool hidden = !instance.part_hidden.empty() && instance.part_hidden[p];
            for (std::uint32_t begin = 0; begin < part.triangle_count && !hidden; begin += kTrianglesPerChunk) {
                const std::uint32_t count = std::min(kTrianglesPerChunk, part.triangle_count - begin);
                tasks.push_back({i, p, part.first_triangle + begin, count, source});
            }
        }
        source += instance.mesh->triangle_count();
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

int fan_apex(const ScreenVertex* corner, int count) {
    for (int apex = 0; apex < count; ++apex) {
        bool any_left = false, any_right = false;
        for (int i = 1; i + 1 < count; ++i) {
            const ScreenVertex& a = corner[apex];
            const ScreenVertex& b = corner[(apex + i) % count];
            const ScreenVertex& c = corner[(apex + i + 1) % count];
            const std::int64_t area = edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
            any_left |= area < 0;
            any_right |= area > 0;
        }
        if (!any_left || !any_right) return apex;
    }
    return 0;
}

TileGrid make_tile_grid(const Viewport& viewport, int samples) {
    TileGrid grid;
    grid.tile_side = kTileSide / samples * samples;
    const std::uint32_t side = static_cast<std::uint32_t>(grid.tile_side);
    grid.reciprocal = ((1u << 20) + side - 1) / side;
    grid.columns = (viewport.width + grid.tile_side - 1) / grid.tile_side;
    grid.rows = (viewport.height + grid.tile_side - 1) / grid.tile_side;
    return grid;
}

TriangleCounts setup_triangles(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                               const Viewport& viewport, CullMode cull, int samples, VertexStreams& streams,
                               TriangleSet& set) {
    const auto frame_of = [&](const ChunkTask& task) {
        return Frame{clip_from_world, viewport, cull_mode_for(cull, instances[task.instance].world_from_object)};
    };
    const std::vector<ChunkTask> tasks = make_tasks(instances);
    const int chunk_count = static_cast<int>(tasks.size());
    set.grid = make_tile_grid(viewport, samples);
    set.chunks.resize(tasks.size());
    std::vector<std::vector<PendingClip>> pending(tasks.size());
#pragma omp parallel if (chunk_count > 1)
    {
        DrawList list;
#pragma omp for schedule(dynamic)
        for (int i = 0; i < chunk_count; ++i) {
            setup_chunk(tasks[i], instances[tasks[i].instance], frame_of(tasks[i]), set.grid, streams, list,
                        set.chunks[i], pending[i]);
        }
    }
    // Clipped triangles append vertices to the streams: one thread, in order, so that their numbers never change.
    for (int i = 0; i < chunk_count; ++i) {
        if (!pending[i].empty()) draw_clipped(pending[i], frame_of(tasks[i]), set.grid, streams, set.chunks[i]);
    }
    TriangleCounts sum;
#pragma omp parallel for schedule(dynamic) if (chunk_count > 1)
    for (int i = 0; i < chunk_count; ++i) bin_chunk(set.grid, set.chunks[i]);
    for (const TriangleChunk& chunk : set.chunks) add(sum, chunk.counts);
    return sum;
}

}  // namespace kreda::raster
