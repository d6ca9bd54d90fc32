#include "lighting/environment/prefilter.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>

#include "lighting/importance.hpp"
#include "lighting/microfacet.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel3;

/// A direction in the frame of n, the mip level to read, and the weight n.l.
struct LobeSample {
    glm::vec3 l;
    float lod;
    float n_dot_l;
};

/// The same for all texels of a level: computed once.
std::vector<LobeSample> lobe_samples(float alpha, int count, int radiance_size) {
    const float texel_angle =
        4.0f * raster::kPi / (6.0f * static_cast<float>(radiance_size) * static_cast<float>(radiance_size));
    std::vector<LobeSample> samples;
    for (int k = 0; k < count; ++k) {
        const glm::vec3 h = ggx_half_vector(hammersley(k, count), alpha);
        const glm::vec3 l = mirror_vector(h, {0.0f, 0.0f, 1.0f});
        if (l.z <= 0.0f) continue;
        const float p = 0.25f * ggx_distribution(h.z, h.x * h.x + h.y * h.y, alpha);
        const float share = 1.0f / (static_cast<float>(count) * p);
        samples.push_back({l, 0.5f * raster::log2(share / texel_angle), l.z});
    }
    return samples;
}

struct PrefilterScratch {
    Channel3 n, l, color, sum;
    TapScratch taps;
};

KREDA_BATCH_LOOP void place_sample(int lanes, glm::vec3 d, PrefilterScratch& s) {
    for (int i = 0; i < lanes; ++i) s.l.set(i, to_world(frame_around(s.n.at(i)), d));
}

KREDA_BATCH_LOOP void add_sample(int lanes, float w, const Channel3& color, Channel3& sum) {
    for (int i = 0; i < lanes; ++i) sum.set(i, sum.at(i) + color.at(i) * w);
}

/// s.sum = the prefiltered radiance along s.n.
void filter_batch(const CubeMap& radiance, const std::vector<LobeSample>& samples, int lanes, PrefilterScratch& s) {
    float total = 0.0f;
    for (const LobeSample& sample : samples) total += sample.n_dot_l;
    for (int i = 0; i < lanes; ++i) s.sum.set(i, glm::vec3(0.0f));  // not vectorized: GCC makes it calls of memset
    for (const LobeSample& sample : samples) {
        place_sample(lanes, sample.l, s);
        sample_trilinear(radiance, lanes, s.l, sample.lod, s.taps, s.color);
        add_sample(lanes, sample.n_dot_l / total, s.color, s.sum);
    }
}

struct Chunk {
    int level, first, count;  ///< texels of the level, face by face, row by row
};

constexpr int kChunk = 256;  ///< texels that are filtered together

/// Pieces of work of the blurred levels, the largest lobes first.
std::vector<Chunk> chunks_of(const CubeMap& map) {
    std::vector<Chunk> chunks;
    for (int level = map.last_level(); level >= 1; --level) {
        const int size = map.levels[static_cast<std::size_t>(level)].size;
        const int total = kCubeFaces * size * size;
        for (int first = 0; first < total; first += kChunk)
            chunks.push_back({level, first, std::min(kChunk, total - first)});
    }
    return chunks;
}

void filter_chunk(const CubeMap& radiance, const std::vector<LobeSample>& samples, const Chunk& chunk, CubeMap& map,
                  PrefilterScratch& s) {
    const int size = map.levels[static_cast<std::size_t>(chunk.level)].size;
    const int lanes = raster::lanes_for(chunk.count);
    const auto place = [&](int i) {
        const int texel = chunk.first + i;
        return glm::ivec3{texel / (size * size), texel % size, texel / size % size};
    };
    for (int i = 0; i < chunk.count; ++i) {
        const glm::ivec3 p = place(i);
        s.n.set(i, glm::normalize(texel_direction(size, p.x, p.y, p.z)));
    }
    filter_batch(radiance, samples, lanes, s);
    for (int i = 0; i < chunk.count; ++i) {
        const glm::ivec3 p = place(i);
        map.set_texel(chunk.level, p.x, p.y, p.z, s.sum.at(i));
    }
}

CubeMap mirror_and_room(const CubeMap& radiance, const PrefilterSettings& settings) {
    const int size = radiance.levels[0].size;
    CubeMap map = make_cube_map(prefilter_sizes(size, settings));
    if (map.levels[0].size != size) return map;  // nobody asks for the mirror
    const std::size_t mirror = std::size_t(4) * kCubeFaces * std::size_t(size + 2) * std::size_t(size + 2);
    std::copy_n(radiance.texels.begin(), mirror, map.texels.begin());
    return map;
}

}  // namespace

std::vector<int> prefilter_sizes(int size, const PrefilterSettings& settings) {
    if (!settings.blurred) return {size};
    std::vector<int> sizes{settings.mirror || settings.first_level == 0 ? size : 1};
    for (int level = 1; level <= settings.last_level; ++level) {
        const int blurred = std::min({size, settings.largest_blurred, 8 << (kPrefilterLevels - 1 - level)});
        sizes.push_back(level < settings.first_level ? 1 : blurred);
    }
    return sizes;
}

int samples_of_level(const PrefilterSettings& settings, int level) {
    return std::max(32, static_cast<int>(static_cast<float>(settings.samples) * alpha_of_level(level)));
}

CubeMap prefilter(const CubeMap& radiance, const PrefilterSettings& settings, const Progress& progress) {
    CubeMap map = mirror_and_room(radiance, settings);
    std::vector<std::vector<LobeSample>> samples(1);
    for (int level = 1; level <= map.last_level(); ++level) {
        samples.push_back(
            lobe_samples(alpha_of_level(level), samples_of_level(settings, level), radiance.levels[0].size));
    }
    const std::vector<Chunk> chunks = chunks_of(map);
    double all_work = 0.0;
    const auto work_of = [&](const Chunk& chunk) {
        return static_cast<double>(chunk.count) *
               static_cast<double>(samples[static_cast<std::size_t>(chunk.level)].size());
    };
    for (const Chunk& chunk : chunks) all_work += work_of(chunk);
    WorkCounter counter(all_work, progress);
#pragma omp parallel
    {
        const auto scratch = std::make_unique<PrefilterScratch>();
#pragma omp for schedule(dynamic)
        for (int i = 0; i < static_cast<int>(chunks.size()); ++i) {
            const Chunk& chunk = chunks[static_cast<std::size_t>(i)];
            filter_chunk(radiance, samples[static_cast<std::size_t>(chunk.level)], chunk, map, *scratch);
            counter.add(work_of(chunk));
        }
    }
    for (int level = 1; level <= map.last_level(); ++level) fill_border(map, level);
    return map;
}

glm::vec3 prefiltered_radiance(const CubeMap& radiance, const glm::vec3& n, float alpha, int samples) {
    return prefiltered_radiance(radiance, std::vector<glm::vec3>{n}, alpha, samples).front();
}

std::vector<glm::vec3> prefiltered_radiance(const CubeMap& radiance, const std::vector<glm::vec3>& n, float alpha,
                                            int samples) {
    const auto scratch = std::make_unique<PrefilterScratch>();
    const std::vector<LobeSample> lobe = lobe_samples(alpha, samples, radiance.levels[0].size);
    const int total = static_cast<int>(n.size());
    std::vector<glm::vec3> colors;
    colors.reserve(n.size());
    for (int first = 0; first < total; first += kChunk) {
        const int count = std::min(kChunk, total - first), lanes = raster::lanes_for(count);
        for (int i = 0; i < lanes; ++i) {  // not vectorized: once a lobe; the directions lie one behind the other
            scratch->n.set(i, glm::normalize(n[static_cast<std::size_t>(first + std::min(i, count - 1))]));
        }
        filter_batch(radiance, lobe, lanes, *scratch);
        for (int i = 0; i < count; ++i) colors.push_back(scratch->sum.at(i));
    }
    return colors;
}

}  // namespace kreda::lighting
