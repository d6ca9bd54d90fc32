#include "lighting/environment/irradiance.hpp"

#include <algorithm>
#include <memory>

#include "lighting/importance.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel3;

constexpr double kPiInDouble = 3.14159265358979323846;

/// The level with `size` texels a side; of a map without such a level the last that is larger, or the first.
int level_of_size(const CubeMap& map, int size) {
    int level = 0;
    while (level < map.last_level() && map.levels[static_cast<std::size_t>(level)].size > size) ++level;
    return level;
}

/// A texel as a light: where it is and what it sends.
struct TexelLight {
    glm::vec3 l;
    glm::vec3 power;  ///< L w
};

/// The texels of one face of a level.
std::vector<TexelLight> lights_of_face(const CubeMap& map, int level, int face) {
    const int size = map.levels[static_cast<std::size_t>(level)].size;
    std::vector<TexelLight> lights;
    lights.reserve(static_cast<std::size_t>(size) * size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float w = static_cast<float>(texel_solid_angle(size, x, y));
            lights.push_back({glm::normalize(texel_direction(size, face, x, y)), map.texel(level, face, x, y) * w});
        }
    }
    return lights;
}

/// The normals of a batch and what they have received.
struct GatherScratch {
    Channel3 n, l, color, row_sum, face_sum, sum;
    TapScratch taps;
};

KREDA_BATCH_LOOP void clear(int lanes, Channel3& sum) {
    for (int i = 0; i < lanes; ++i) sum.set(i, glm::vec3(0.0f));  // not vectorized: GCC makes it calls of memset
}

KREDA_BATCH_LOOP void add(int lanes, float f, const Channel3& from, Channel3& to) {
    for (int i = 0; i < lanes; ++i) to.set(i, to.at(i) + from.at(i) * f);
}

/// sum += L w max(n.l, 0) for a run of texels, one after another for all normals of the batch.
KREDA_BATCH_LOOP void add_texels(int lanes, const TexelLight* lights, int light_count, const Channel3& n,
                                 Channel3& sum) {
    for (int k = 0; k < light_count; ++k) {
        const glm::vec3 l = lights[k].l;
        const glm::vec3 power = lights[k].power;
        for (int i = 0; i < lanes; ++i) {
            const float cosine = glm::dot(n.at(i), l);
            sum.set(i, sum.at(i) + power * (cosine > 0.0f ? cosine : 0.0f));
        }
    }
}

/// Rows are added to faces, faces to the whole, so that no float is added to one that is thousands of times larger.
void sum_texels(const std::vector<std::vector<TexelLight>>& faces, int lanes, GatherScratch& s) {
    clear(lanes, s.sum);
    for (const std::vector<TexelLight>& lights : faces) {
        const int row = static_cast<int>(std::sqrt(static_cast<double>(lights.size())) + 0.5);
        clear(lanes, s.face_sum);
        for (int first = 0; first < static_cast<int>(lights.size()); first += row) {
            clear(lanes, s.row_sum);
            add_texels(lanes, lights.data() + first, row, s.n, s.row_sum);
            add(lanes, 1.0f, s.row_sum, s.face_sum);
        }
        add(lanes, 1.0f, s.face_sum, s.sum);
    }
}

/// One direction in the frame of each normal.
KREDA_BATCH_LOOP void turn_to_normals(int lanes, glm::vec3 d, const Channel3& n, Channel3& l) {
    for (int i = 0; i < lanes; ++i) l.set(i, to_world(frame_around(n.at(i)), d));
}

/// sum += L(l) weight
void add_direction(const CubeMap& radiance, int lanes, const glm::vec3& direction, float weight, Channel3& sum,
                   GatherScratch& s) {
    turn_to_normals(lanes, direction, s.n, s.l);
    sample_level(radiance, 0, lanes, s.l, s.taps, s.color);
    add(lanes, weight, s.color, sum);
}

/// The lecture's double loop; i over the azimuths, j over the angles to the normal.
void sum_hemisphere(const CubeMap& radiance, int lanes, int N1, int N2, float offset, GatherScratch& s) {
    clear(lanes, s.sum);
    for (int j = 0; j < N2; ++j) {
        const float theta_turns = (static_cast<float>(j) + offset) * 0.25f / static_cast<float>(N2);
        const raster::SinCos theta = raster::sin_cos_of_turns(theta_turns);
        clear(lanes, s.row_sum);
        for (int i = 0; i < N1; ++i) {
            const raster::SinCos phi =
                raster::sin_cos_of_turns((static_cast<float>(i) + 0.5f) / static_cast<float>(N1));
            add_direction(radiance, lanes, {theta.sin * phi.cos, theta.sin * phi.sin, theta.cos}, 1.0f, s.row_sum, s);
        }
        const double step = 2.0 * kPiInDouble / N1 * kPiInDouble / (2.0 * N2);
        add(lanes, static_cast<float>(step * double(theta.cos) * double(theta.sin)), s.row_sum, s.sum);
    }
}

void sum_cosine(const CubeMap& radiance, int lanes, int N, GatherScratch& s) {
    constexpr int kBlock = 256;
    clear(lanes, s.sum);
    for (int first = 0; first < N; first += kBlock) {
        clear(lanes, s.row_sum);
        for (int k = first; k < std::min(first + kBlock, N); ++k) {
            add_direction(radiance, lanes, cosine_direction(hammersley(k, N)), 1.0f, s.row_sum, s);
        }
        add(lanes, static_cast<float>(kPiInDouble / N), s.row_sum, s.sum);
    }
}

/// A batch of one normal.
template <class Sum>
glm::vec3 for_one_normal(const glm::vec3& n, Sum sum) {
    const auto scratch = std::make_unique<GatherScratch>();
    const int lanes = raster::lanes_for(1);
    for (int i = 0; i < lanes; ++i) scratch->n.set(i, glm::normalize(n));
    sum(lanes, *scratch);
    return scratch->sum.at(0);
}

std::vector<std::vector<TexelLight>> lights_of(const CubeMap& radiance, int source_size) {
    const int level = level_of_size(radiance, source_size);
    std::vector<std::vector<TexelLight>> faces;
    faces.reserve(kCubeFaces);
    for (int face = 0; face < kCubeFaces; ++face) faces.push_back(lights_of_face(radiance, level, face));
    return faces;
}

/// A_l K_lm^2 of each coefficient.
std::array<double, 9> sh_factors() {
    const double a0 = kPiInDouble, a1 = 2.0 * kPiInDouble / 3.0, a2 = 0.25 * kPiInDouble;
    const double k0 = 1.0 / (4.0 * kPiInDouble), k1 = 3.0 * k0, k2 = 15.0 * k0;
    return {a0 * k0, a1 * k1, a1 * k1, a1 * k1, a2 * k2, a2 * k2, a2 * 5.0 / 4.0 * k0, a2 * k2, a2 * k2 / 4.0};
}

}  // namespace

glm::vec3 irradiance_of_texels(const CubeMap& radiance, const glm::vec3& n, int source_size) {
    const auto faces = lights_of(radiance, source_size);
    return for_one_normal(n, [&](int lanes, GatherScratch& s) { sum_texels(faces, lanes, s); });
}

glm::vec3 irradiance_of_hemisphere(const CubeMap& radiance, const glm::vec3& n, int N1, int N2, float offset) {
    return for_one_normal(n, [&](int lanes, GatherScratch& s) { sum_hemisphere(radiance, lanes, N1, N2, offset, s); });
}

glm::vec3 irradiance_of_cosine(const CubeMap& radiance, const glm::vec3& n, int N) {
    return for_one_normal(n, [&](int lanes, GatherScratch& s) { sum_cosine(radiance, lanes, N, s); });
}

CubeMap irradiance_map(const CubeMap& radiance, const IrradianceSettings& settings, const Progress& progress) {
    const int size = settings.size;
    CubeMap map = make_cube_map({size});
    const auto faces = lights_of(radiance, settings.sum == IrradianceSum::texels ? kIrradianceSourceSize : 1);
    const int texel_count = kCubeFaces * size * size;
    constexpr int kBatch = 128;  // small, so that there is work for every thread
    WorkCounter counter(texel_count, progress);
#pragma omp parallel
    {
        const auto scratch = std::make_unique<GatherScratch>();
#pragma omp for schedule(dynamic)
        for (int first = 0; first < texel_count; first += kBatch) {
            const int count = std::min(kBatch, texel_count - first);
            const int lanes = raster::lanes_for(count);
            const auto place = [&](int i) { return glm::ivec3{i / (size * size), i % size, i / size % size}; };
            for (int i = 0; i < count; ++i) {
                const glm::ivec3 p = place(first + i);
                scratch->n.set(i, glm::normalize(texel_direction(size, p.x, p.y, p.z)));
            }
            switch (settings.sum) {
                case IrradianceSum::texels: sum_texels(faces, lanes, *scratch); break;
                case IrradianceSum::cosine:
                    sum_cosine(radiance, lanes, settings.azimuths * settings.angles, *scratch);
                    break;
                case IrradianceSum::hemisphere:
                    sum_hemisphere(radiance, lanes, settings.azimuths, settings.angles, 0.5f, *scratch);
                    break;
            }
            for (int i = 0; i < count; ++i) {
                const glm::ivec3 p = place(first + i);
                map.set_texel(0, p.x, p.y, p.z, scratch->sum.at(i));
            }
            counter.add(count);
        }
    }
    fill_border(map, 0);
    return map;
}

Sh9 project_to_sh9(const CubeMap& radiance) {
    std::array<glm::dvec3, 9> sums{};
    const int level = level_of_size(radiance, kShSourceSize);
    for (int face = 0; face < kCubeFaces; ++face) {
        for (const TexelLight& light : lights_of_face(radiance, level, face)) {
            const std::array<float, 9> p = sh_polynomials(light.l);
            for (std::size_t k = 0; k < 9; ++k) sums[k] += glm::dvec3(light.power) * double(p[k]);
        }
    }
    const std::array<double, 9> factors = sh_factors();
    Sh9 sh;
    for (std::size_t k = 0; k < 9; ++k) sh.c[k] = glm::vec3(sums[k] * factors[k]);
    return sh;
}

Sh9 sh9_of_light(const glm::vec3& l) {
    const std::array<float, 9> p = sh_polynomials(glm::normalize(l));
    const std::array<double, 9> factors = sh_factors();
    Sh9 sh;
    for (std::size_t k = 0; k < 9; ++k) sh.c[k] = glm::vec3(static_cast<float>(factors[k] * double(p[k])));
    return sh;
}

KREDA_BATCH_LOOP void irradiance_of_sh9(Sh9 sh, int lanes, const Channel3& n, Channel3& E) {
    for (int i = 0; i < lanes; ++i) E.set(i, irradiance_of_sh9(sh, n.at(i)));
}

}  // namespace kreda::lighting
