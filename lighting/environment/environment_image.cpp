#include "lighting/environment/environment_image.hpp"

#include <algorithm>
#include <memory>

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel3;
using raster::Image;
using raster::kBatchCapacity;

enum class Fault { none, negative, too_bright, infinite, nan };  // the worst of a texel's values counts

Fault fault_of(float value) {
    if (std::isnan(value)) return Fault::nan;
    if (value > raster::kMaxFinite) return Fault::infinite;
    if (value > kMaxRadiance) return Fault::too_bright;
    return value < 0.0f ? Fault::negative : Fault::none;
}

float largest_finite(const Image& image) {
    float largest = 0.0f;
    for (const float value : image.values) {
        if (std::isfinite(value)) largest = std::max(largest, value);
    }
    return std::min(largest, kMaxRadiance);
}

/// The mean of the finite texels around (x, y), columns wrapped.
float mean_of_neighbours(const Image& image, int c, int x, int y) {
    float sum = 0.0f;
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int row = std::clamp(y + dy, 0, image.height - 1);
            const int column = (x + dx + image.width) % image.width;
            const float value = image.at(c, column, row);
            if (!std::isfinite(value)) continue;
            sum += std::clamp(value, 0.0f, kMaxRadiance);
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<float>(count) : 0.0f;
}

float repaired(const Image& original, int c, int x, int y, float largest) {
    const float value = original.at(c, x, y);
    switch (fault_of(value)) {
        case Fault::nan: return mean_of_neighbours(original, c, x, y);
        case Fault::infinite: return largest;
        case Fault::too_bright: return kMaxRadiance;
        case Fault::negative: return 0.0f;
        case Fault::none: return value;
    }
    return 0.0f;
}

// ------------------------------------------------------------------------------------------- equirect to cube

/// Directions to one of n x n points in each of the texels x .. x + lanes of a row, and their weights.
///   dw = ds dt / (1 + s^2 + t^2)^(3/2)
struct RowOfTexels {
    int size, face, x, y;
};

struct ProjectionScratch {
    Channel3 direction, color, sum;
    raster::Channel weight, total;
    TapScratch taps;
};

KREDA_BATCH_LOOP void set_directions(int lanes, RowOfTexels r, float within_x, float within_y,
                                     const Placement& placement, ProjectionScratch& scratch) {
    const float cos_rotation = placement.cos_rotation;
    const float sin_rotation = placement.sin_rotation;
    const float scale = 1.0f / static_cast<float>(r.size);
    const float v = (static_cast<float>(r.y) + within_y) * scale;
    const float first = static_cast<float>(r.x) + within_x;
    for (int i = 0; i < lanes; ++i) {
        const float u = (first + static_cast<float>(i)) * scale;
        const glm::vec3 d = direction_of({r.face, u, v});
        const float length2 = glm::dot(d, d);
        const float inverse = 1.0f / std::sqrt(length2);
        scratch.direction.set(i, map_direction(d * inverse, cos_rotation, sin_rotation));
        scratch.weight.set(i, inverse / length2);
    }
}

KREDA_BATCH_LOOP void clear_sums(int lanes, ProjectionScratch& scratch) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        scratch.sum.set(i, glm::vec3(0.0f));
        scratch.total.set(i, 0.0f);
    }
}

KREDA_BATCH_LOOP void add_colors(int lanes, ProjectionScratch& scratch) {
    for (int i = 0; i < lanes; ++i) {
        const float w = scratch.weight.at(i);
        scratch.sum.set(i, scratch.sum.at(i) + scratch.color.at(i) * w);
        scratch.total.set(i, scratch.total.at(i) + w);
    }
}

inline TexelTap equirect_tap(const glm::vec3& d, int width, int height) {
    const glm::vec2 point = equirect_point(d);
    const float x = point.x * static_cast<float>(width) + 0.5f;
    const float y = point.y * static_cast<float>(height) + 0.5f;
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int row = 4 * (width + 2);
    return bilinear_tap(top * row + 4 * left, row, x - static_cast<float>(left), y - static_cast<float>(top), 1.0f);
}

KREDA_BATCH_LOOP void set_equirect_taps(int lanes, int image_width, int image_height, const Channel3& d,
                                        TapChannels& taps) {
    const int width = image_width, height = image_height;
    for (int i = 0; i < lanes; ++i) taps.set(i, equirect_tap(d.at(i), width, height));
}

KREDA_BATCH_LOOP void set_studio(int lanes, const Channel3& d, Channel3& color) {
    for (int i = 0; i < lanes; ++i) color.set(i, studio_sky(d.at(i)));
}

KREDA_BATCH_LOOP void set_sunset(int lanes, const Channel3& d, Channel3& color) {
    for (int i = 0; i < lanes; ++i) color.set(i, sunset_sky(d.at(i)));
}

KREDA_BATCH_LOOP void set_gradient(int lanes, const Channel3& d, Channel3& color) {
    for (int i = 0; i < lanes; ++i) color.set(i, gradient_sky(d.at(i)));
}

void set_sky(int lanes, Sky sky, const Channel3& d, Channel3& color) {
    switch (sky) {
        case Sky::studio: return set_studio(lanes, d, color);
        case Sky::sunset: return set_sunset(lanes, d, color);
        case Sky::gradient: return set_gradient(lanes, d, color);
    }
}

/// Fill level 0: every texel the weighted mean of n x n colours that `look_up(lanes, scratch)` finds.
template <class LookUp>
void project(CubeMap& map, int n, const Placement& placement, const Progress& progress, LookUp look_up) {
    const int size = map.levels[0].size;
    WorkCounter counter(kCubeFaces * size, progress);
#pragma omp parallel
    {
        const auto scratch = std::make_unique<ProjectionScratch>();
#pragma omp for schedule(dynamic)
        for (int row = 0; row < kCubeFaces * size; ++row) {
            for (int x = 0; x < size; x += kBatchCapacity) {
                const RowOfTexels texels{size, row / size, x, row % size};
                const int count = std::min(kBatchCapacity, size - x);
                const int lanes = raster::lanes_for(count);
                clear_sums(lanes, *scratch);
                for (int k = 0; k < n * n; ++k) {
                    const int column = k % n, row_within = k / n;
                    const float within_x = (static_cast<float>(column) + 0.5f) / static_cast<float>(n);
                    const float within_y = (static_cast<float>(row_within) + 0.5f) / static_cast<float>(n);
                    set_directions(lanes, texels, within_x, within_y, placement, *scratch);
                    look_up(lanes, *scratch);
                    add_colors(lanes, *scratch);
                }
                for (int i = 0; i < count; ++i) {
                    const glm::vec3 mean = scratch->sum.at(i) / scratch->total.at(i);
                    map.set_texel(0, texels.face, x + i, texels.y, placement.intensity * mean);
                }
            }
            counter.add(1.0);
        }
    }
}

}  // namespace

EnvironmentRepairs repair_environment(Image& image) {
    EnvironmentRepairs repairs;
    const Image original = image;
    const float largest = largest_finite(image);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Fault worst = Fault::none;
            for (int c = 0; c < image.channels; ++c) {
                worst = std::max(worst, fault_of(original.at(c, x, y)));
                image.at(c, x, y) = repaired(original, c, x, y, largest);
            }
            repairs.nan += worst == Fault::nan ? 1 : 0;
            repairs.infinite += worst == Fault::infinite ? 1 : 0;
            repairs.too_bright += worst == Fault::too_bright ? 1 : 0;
            repairs.negative += worst == Fault::negative ? 1 : 0;
        }
    }
    return repairs;
}

std::size_t bytes_of_equirect_map(int width, int height) {
    return 4 * sizeof(float) * std::size_t(width + 2) * std::size_t(height + 2);
}

EquirectMap make_equirect_map(const Image& image) {
    const int w = image.width, h = image.height;
    EquirectMap map{w, h, {}};
    map.texels.assign(4 * std::size_t(w + 2) * std::size_t(h + 2), 0.0f);
    for (int row = -1; row <= h; ++row) {
        const bool over_pole = row < 0 || row >= h;
        const int y = std::clamp(row, 0, h - 1);
        for (int column = -1; column <= w; ++column) {
            const int x = (column + w) % w;
            // Over the pole stands the texel half a turn away; with an odd width that lies between two.
            const glm::vec3 across = 0.5f * (image.rgb((x + w / 2) % w, y) + image.rgb((x + (w + 1) / 2) % w, y));
            const glm::vec3 color = over_pole ? across : image.rgb(x, y);
            float* texel = &map.texels[4 * (std::size_t(row + 1) * std::size_t(w + 2) + std::size_t(column + 1))];
            for (int c = 0; c < 3; ++c) texel[c] = color[c];
        }
    }
    return map;
}

glm::vec3 sample_equirect(const EquirectMap& map, const glm::vec3& direction) {
    return weighted_sum(map.texels.data(), equirect_tap(direction, map.width, map.height));
}

int directions_for(int image_width, int image_height, int size) {
    const int longer = std::max(image_width, 2 * image_height);
    // A texel of the cube holds about longer / (4 size) of the image's a side.
    return std::clamp((longer + size - 1) / size, 2, 64);
}

CubeMap cube_from_equirect(const Image& image, int size, const Placement& placement, const Progress& progress) {
    const EquirectMap source = make_equirect_map(image);
    const int n = directions_for(image.width, image.height, size);
    CubeMap map = make_cube_map(mip_sizes(size));
    project(map, n, placement, progress, [&](int lanes, ProjectionScratch& scratch) {
        set_equirect_taps(lanes, source.width, source.height, scratch.direction, scratch.taps.taps[0]);
        read_taps(source.texels.data(), lanes, 1, scratch.taps);
        split_texels(lanes, scratch.taps, scratch.color);
    });
    fill_mip_levels(map);
    return map;
}

CubeMap cube_from_sky(Sky sky, int size, const Placement& placement, const Progress& progress) {
    CubeMap map = make_cube_map(mip_sizes(size));
    project(map, kSkyDirections, placement, progress,
            [&](int lanes, ProjectionScratch& scratch) { set_sky(lanes, sky, scratch.direction, scratch.color); });
    fill_mip_levels(map);
    return map;
}

int cube_size_for(int image_width, int largest) {
    int size = 128;
    while (size < largest && 4 * size < image_width) size *= 2;
    return std::min(size, largest);
}

}  // namespace kreda::lighting
