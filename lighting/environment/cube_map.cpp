#include "lighting/environment/cube_map.hpp"

#include "raster/platform.hpp"
#include "raster/trigonometry.hpp"

namespace kreda::lighting {

namespace {

/// The solid angle of the rectangle from (0, 0) to (x, y) on the face's plane, |x|, |y| <= 1.
double corner_area(double x, double y) {
    return raster::atan_in_double(x * y / std::sqrt(x * x + y * y + 1.0));
}

/// The neighbour's texel that touches texel (x, y) of the border, which lies beside a face but not at its corner.
glm::vec3 across_edge(const CubeMap& map, int level, int face, int x, int y) {
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    constexpr float kBeyond = 1e-5f;  // just over the edge
    const auto along = [&](int i) {
        if (i < 0) return -kBeyond;
        return i >= size ? 1.0f + kBeyond : (static_cast<float>(i) + 0.5f) / static_cast<float>(size);
    };
    const CubePoint there = cube_point(direction_of({face, along(x), along(y)}));
    const auto texel = [&](float u) {
        const int i = static_cast<int>(u * static_cast<float>(size));
        return i < size ? i : size - 1;
    };
    return map.texel(level, there.face, texel(there.u), texel(there.v));
}

struct LevelTable {
    int size[32];
    int offset[32];
};

LevelTable table_of(const CubeMap& map) {
    LevelTable table{};
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        table.size[i] = map.levels[i].size;
        table.offset[i] = map.levels[i].offset;
    }
    return table;
}

/// Between which two levels a lod lies.
struct LodInterval {
    int level, next;
    float share;  ///< of the next level
};

inline LodInterval lod_interval(float lod, int last_level) {
    const float last = static_cast<float>(last_level);
    const float at_least_0 = lod > 0.0f ? lod : 0.0f;
    const float clamped = at_least_0 < last ? at_least_0 : last;
    const int level = static_cast<int>(clamped);
    return {level, level < last_level ? level + 1 : level, clamped - static_cast<float>(level)};
}

KREDA_BATCH_LOOP void set_taps(int lanes, const CubeLevel& level, const raster::Channel3& d, TapChannels& taps) {
    const int size = level.size;
    const int offset = level.offset;
    for (int i = 0; i < lanes; ++i) taps.set(i, cube_tap(cube_point(d.at(i)), size, offset, 1.0f));
}

KREDA_BATCH_LOOP void set_trilinear_taps(int lanes, const LevelTable& levels, int last_level, const raster::Channel3& d,
                                         const raster::Channel& lod, TapChannels* taps) {
    const LevelTable table = levels;  // a copy: through a reference the compiler fears that taps overwrite it
    TapChannels& finer = taps[0];
    TapChannels& coarser = taps[1];
    for (int i = 0; i < lanes; ++i) {
        const CubePoint point = cube_point(d.at(i));
        const LodInterval between = lod_interval(lod.at(i), last_level);
        finer.set(i, cube_tap(point, table.size[between.level], table.offset[between.level], 1.0f - between.share));
        coarser.set(i, cube_tap(point, table.size[between.next], table.offset[between.next], between.share));
    }
}

/// The same where all points have one lod.
KREDA_BATCH_LOOP void set_taps_between(int lanes, const CubeLevel& finer_level, const CubeLevel& coarser_level,
                                       float share, const raster::Channel3& d, TapChannels* taps) {
    const CubeLevel at_finer = finer_level, at_coarser = coarser_level;
    TapChannels& finer = taps[0];
    TapChannels& coarser = taps[1];
    for (int i = 0; i < lanes; ++i) {
        const CubePoint point = cube_point(d.at(i));
        finer.set(i, cube_tap(point, at_finer.size, at_finer.offset, 1.0f - share));
        coarser.set(i, cube_tap(point, at_coarser.size, at_coarser.offset, share));
    }
}

}  // namespace

double texel_solid_angle(int size, int x, int y) {
    const auto at = [&](int i) { return 2.0 * i / size - 1.0; };
    return corner_area(at(x), at(y)) - corner_area(at(x), at(y + 1)) - corner_area(at(x + 1), at(y)) +
           corner_area(at(x + 1), at(y + 1));
}

CubeMap make_cube_map(const std::vector<int>& sizes) {
    CubeMap map;
    int offset = 0;
    for (const int size : sizes) {
        map.levels.push_back({size, offset});
        offset += 4 * kCubeFaces * (size + 2) * (size + 2);
    }
    map.texels.assign(static_cast<std::size_t>(offset), 0.0f);
    return map;
}

std::vector<int> mip_sizes(int size) {
    std::vector<int> sizes;
    for (; size >= 1; size /= 2) sizes.push_back(size);
    return sizes;
}

void fill_border(CubeMap& map, int level) {
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int i = 0; i < size; ++i) {
            for (const int beyond : {-1, size}) {
                map.set_texel(level, face, i, beyond, across_edge(map, level, face, i, beyond));
                map.set_texel(level, face, beyond, i, across_edge(map, level, face, beyond, i));
            }
        }
        for (const int x : {-1, size}) {
            for (const int y : {-1, size}) {
                const int inner_x = x < 0 ? 0 : size - 1;
                const int inner_y = y < 0 ? 0 : size - 1;
                const glm::vec3 sum = map.texel(level, face, inner_x, inner_y) + map.texel(level, face, inner_x, y) +
                                      map.texel(level, face, x, inner_y);
                map.set_texel(level, face, x, y, sum * (1.0f / 3.0f));
            }
        }
    }
}

void fill_mip_levels(CubeMap& map) {
    fill_border(map, 0);
    for (int level = 1; level <= map.last_level(); ++level) {
        const int size = map.levels[static_cast<std::size_t>(level)].size;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                double weight[4], total = 0.0;
                for (int k = 0; k < 4; ++k) {
                    weight[k] = texel_solid_angle(2 * size, 2 * x + k % 2, 2 * y + k / 2);
                    total += weight[k];
                }
                for (int face = 0; face < kCubeFaces; ++face) {
                    glm::dvec3 sum(0.0);
                    for (int k = 0; k < 4; ++k) {
                        sum += weight[k] * glm::dvec3(map.texel(level - 1, face, 2 * x + k % 2, 2 * y + k / 2));
                    }
                    map.set_texel(level, face, x, y, glm::vec3(sum / total));
                }
            }
        }
        fill_border(map, level);
    }
}

glm::vec3 sample_level(const CubeMap& map, int level, const glm::vec3& direction) {
    const CubeLevel& at = map.levels[static_cast<std::size_t>(level)];
    return weighted_sum(map.texels.data(), cube_tap(cube_point(direction), at.size, at.offset, 1.0f));
}

glm::vec3 sample_trilinear(const CubeMap& map, const glm::vec3& direction, float lod) {
    const LodInterval between = lod_interval(lod, map.last_level());
    const glm::vec3 finer = sample_level(map, between.level, direction);
    const glm::vec3 coarser = sample_level(map, between.next, direction);
    return finer * (1.0f - between.share) + coarser * between.share;
}

void sample_level(const CubeMap& map, int level, int lanes, const raster::Channel3& directions, TapScratch& scratch,
                  raster::Channel3& colors) {
    set_taps(lanes, map.levels[static_cast<std::size_t>(level)], directions, scratch.taps[0]);
    read_taps(map.texels.data(), lanes, 1, scratch);
    split_texels(lanes, scratch, colors);
}

void sample_trilinear(const CubeMap& map, int lanes, const raster::Channel3& directions, const raster::Channel& lod,
                      TapScratch& scratch, raster::Channel3& colors) {
    set_trilinear_taps(lanes, table_of(map), map.last_level(), directions, lod, scratch.taps);
    read_taps(map.texels.data(), lanes, 2, scratch);
    split_texels(lanes, scratch, colors);
}

void sample_trilinear(const CubeMap& map, int lanes, const raster::Channel3& directions, float lod, TapScratch& scratch,
                      raster::Channel3& colors) {
    const LodInterval between = lod_interval(lod, map.last_level());
    set_taps_between(lanes, map.levels[static_cast<std::size_t>(between.level)],
                     map.levels[static_cast<std::size_t>(between.next)], between.share, directions, scratch.taps);
    read_taps(map.texels.data(), lanes, 2, scratch);
    split_texels(lanes, scratch, colors);
}

}  // namespace kreda::lighting
