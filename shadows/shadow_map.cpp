#include "shadows/shadow_map.hpp"

#include <algorithm>
#include <limits>

#include "raster/platform.hpp"
#include "raster/rasterize_tile.hpp"

namespace kreda::shadows {

namespace {

using raster::kTileSide;

/// Window depth back to distance. A perspective depth is z = a - b / distance with a = f / (f - n) and b = n a; that of
/// parallel rays goes evenly from near to far.
struct DistanceFromDepth {
    float a = 0.0f, b = 0.0f;         ///< perspective
    float near = 0.0f, range = 1.0f;  ///< parallel

    explicit DistanceFromDepth(const LightView& view)
        : a(view.far / (view.far - view.near)), b(view.near * a), near(view.near), range(view.far - view.near) {}

    [[nodiscard]] float perspective(float z) const {
        return b / (a - z);
    }
    [[nodiscard]] float parallel(float z) const {
        return near + range * z;
    }
};

/// One row of a tile: depth -> distance; where nothing was drawn, nothing casts.
KREDA_BATCH_LOOP void write_row(const float* __restrict depth, int lanes, DistanceFromDepth convert,
                                bool is_perspective, float* __restrict distance) {
    if (is_perspective) {
        for (int i = 0; i < lanes; ++i) {
            const float found = convert.perspective(depth[i]);
            distance[i] = depth[i] < raster::kClearDepth ? found : kNoCaster;
        }
    } else {
        for (int i = 0; i < lanes; ++i) {
            const float found = convert.parallel(depth[i]);
            distance[i] = depth[i] < raster::kClearDepth ? found : kNoCaster;
        }
    }
}

KREDA_BATCH_LOOP float least_of(const float* values, int count) {
    float least[16];
    std::fill(std::begin(least), std::end(least), kNoCaster);
    int i = 0;
    for (; i + 16 <= count; i += 16) {
        for (int k = 0; k < 16; ++k) least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
    }
    for (; i < count; ++i) least[0] = std::min(least[0], values[i]);
    return *std::min_element(std::begin(least), std::end(least));
}

/// Where a face is drawn.
struct FaceTexels {
    float* first;            ///< column 0, row 0
    int stride;              ///< floats from row to row
    std::uint8_t* is_empty;  ///< one a tile, see ShadowMap

    [[nodiscard]] float* row_of(const raster::TileArea& area, int y) const {
        return first + static_cast<std::size_t>(area.y + y) * stride + area.x;
    }
};

/// In a tile that no triangle touches nothing casts. If that was so in the last frame, too, its texels say it already.
void clear_tile(const raster::TileArea& area, const FaceTexels& face) {
    if (face.is_empty[area.index]) return;
    for (int y = 0; y < area.height; ++y) std::fill_n(face.row_of(area, y), area.width, kNoCaster);
    face.is_empty[area.index] = 1;
}

/// Draw one face, tile by tile. Returns the least distance in it if that is asked for.
float draw_face(const ShadowMapBuffers& buffers, const LightView& view, int size, bool find_nearest,
                const FaceTexels& face) {
    const raster::Viewport viewport{size, size};
    const DistanceFromDepth from_depth(view);
    const int tile_count = buffers.triangles.grid.columns * buffers.triangles.grid.rows;
    float nearest = kNoCaster;
#pragma omp parallel for schedule(dynamic) reduction(min : nearest)
    for (int t = 0; t < tile_count; ++t) {
        const raster::TileArea area = tile_area(buffers.triangles.grid, viewport, t);
        if (!any_triangle_touches(buffers.triangles, area)) {
            clear_tile(area, face);
            continue;
        }
        face.is_empty[t] = 0;
        raster::TileDepth tile;
        rasterize_tile(buffers.streams, buffers.triangles, area, tile);
        for (int y = 0; y < area.height; ++y) {
            float* row = face.row_of(area, y);
            write_row(&tile.depth[y * kTileSide], area.width, from_depth, view.perspective, row);
            if (find_nearest) nearest = std::min(nearest, least_of(row, area.width));
        }
    }
    return nearest;
}

/// The ring around a face: no caster, or (cube) the nearest texel of the face itself.
void fill_ring(const ShadowMap& map, bool repeat_edge, float* face) {
    const int size = map.size();
    const auto inside = [&](int i) { return std::clamp(i, 0, size - 1); };
    for (int row = -map.ring(); row < size + map.ring(); ++row) {
        float* texel = face + map.first_texel() + row * map.stride();
        const float* edge = face + map.first_texel() + inside(row) * map.stride();
        const bool is_ring = row != inside(row);
        for (int column = -map.ring(); column < size + map.ring(); ++column) {
            if (!is_ring && column == 0) column = size;  // what lies between has been drawn
            texel[column] = repeat_edge ? edge[inside(column)] : kNoCaster;
        }
    }
}

/// Size a map for a plan. If its texels lie where they lay before, what is known of empty tiles still holds.
void lay_out_map(const ShadowMapPlan& plan, ShadowMap& map) {
    const int last_size = map.size(), last_ring = map.ring();
    map.plan = plan;
    const std::size_t texels = plan.views.size() * static_cast<std::size_t>(map.face_stride());
    if (map.size() != last_size || map.ring() != last_ring || map.distance.size() != texels) map.is_empty.clear();
    map.distance.resize(texels);
    const raster::TileGrid grid = raster::make_tile_grid({map.size(), map.size()}, 1);
    map.is_empty.resize(plan.views.size() * static_cast<std::size_t>(grid.columns * grid.rows), 0);
}

}  // namespace

int filter_margin(const ShadowSettings& settings) {
    switch (settings.filter) {
        case ShadowFilter::none: return 1;
        case ShadowFilter::pcf: return settings.radius + 1;
        case ShadowFilter::pcss: return settings.size / 16 + 1;
    }
    return 1;
}

void draw_shadow_map(std::vector<raster::MeshInstance>& casters, const ShadowMapPlan& plan, ShadowMapBuffers& buffers,
                     ShadowMap& map) {
    lay_out_map(plan, map);
    map.nearest = kNoCaster;
    const raster::Viewport viewport{map.size(), map.size()};
    const bool is_soft = plan.settings.filter == ShadowFilter::pcss;
    float* face = map.distance.data();
    std::uint8_t* is_empty = map.is_empty.data();
    for (const LightView& view : plan.views) {
        const glm::mat4 clip = clip_from_world(view);
        lay_out_vertices(casters, {}, buffers.streams);
        transform_vertices(casters, clip, viewport, buffers.streams);
        setup_triangles(casters, clip, viewport, plan.settings.cull, 1, buffers.streams, buffers.triangles);
        const FaceTexels texels{face + map.first_texel(), map.stride(), is_empty};
        map.nearest = std::min(map.nearest, draw_face(buffers, view, map.size(), is_soft, texels));
        fill_ring(map, plan.views.size() > 1, face);
        face += map.face_stride();
        is_empty += buffers.triangles.grid.columns * buffers.triangles.grid.rows;
    }
}

raster::Image map_distances(const ShadowMap& map) {
    const int faces = static_cast<int>(map.plan.views.size());
    raster::Image distances = raster::make_image(map.size() * faces, map.size(), 1);
    for (int face = 0; face < faces; ++face) {
        for (int y = 0; y < map.size(); ++y) {
            for (int x = 0; x < map.size(); ++x) {
                const float d = map.at(face, x, y);
                distances.at(0, face * map.size() + x, y) = d < kNoCaster ? d : std::numeric_limits<float>::infinity();
            }
        }
    }
    return distances;
}

}  // namespace kreda::shadows
