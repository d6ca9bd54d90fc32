// The price of exactness: what the renderer computes more carefully than it would have to, each alone, in loops of its
// own; the renderer itself has no other way.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "raster/film.hpp"
#include "raster/platform.hpp"
#include "raster/scalar_math.hpp"
#include "scene/files/image_file.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/frequency_error.hpp"
#include "tools/measure/paired_times.hpp"

namespace kreda::tools {

namespace {

constexpr int kCount = 4096;  // numbers of a loop: they stay in the nearest cache
using Numbers = std::array<float, kCount>;

/// log2 and 2^x as bits and a quotient each.       Mineiro 2011, fastapprox
float rough_pow(float x, float y) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const float mantissa = std::bit_cast<float>((bits & 0x007fffffu) | 0x3f000000u);
    const float log2_x = static_cast<float>(static_cast<std::int32_t>(bits)) * 1.1920928955078125e-7f - 124.22551499f -
                         1.498030302f * mantissa - 1.72587999f / (0.3520887068f + mantissa);
    const float p = y * log2_x, clipped = p < -126.0f ? -126.0f : p;
    const float z = clipped - static_cast<float>(static_cast<std::int32_t>(clipped)) + 1.0f;  // clipped <= 0
    const float scaled = 8388608.0f * (clipped + 121.2740575f + 27.7280233f / (4.84252568f - z) - 1.49012907f * z);
    return std::bit_cast<float>(static_cast<std::int32_t>(scaled));
}

/// 1 / sqrt(x) from the bits of x, and one step of Newton's method.       Lomont 2003
float rough_reciprocal_root(float x) {
    const float y = std::bit_cast<float>(0x5f375a86u - (std::bit_cast<std::uint32_t>(x) >> 1));
    return y * (1.5f - 0.5f * x * y * y);
}

}  // namespace

KREDA_BATCH_LOOP void pow_of_all(const Numbers& x, float y, Numbers& result) {
    for (int i = 0; i < kCount; ++i)
        result[static_cast<std::size_t>(i)] = raster::pow(x[static_cast<std::size_t>(i)], y);
}

KREDA_BATCH_LOOP void rough_pow_of_all(const Numbers& x, float y, Numbers& result) {
    for (int i = 0; i < kCount; ++i) result[static_cast<std::size_t>(i)] = rough_pow(x[static_cast<std::size_t>(i)], y);
}

KREDA_BATCH_LOOP void roots_of_all(const Numbers& x, Numbers& result) {
    for (int i = 0; i < kCount; ++i)
        result[static_cast<std::size_t>(i)] = 1.0f / std::sqrt(x[static_cast<std::size_t>(i)]);
}

KREDA_BATCH_LOOP void rough_roots_of_all(const Numbers& x, Numbers& result) {
    for (int i = 0; i < kCount; ++i)
        result[static_cast<std::size_t>(i)] = rough_reciprocal_root(x[static_cast<std::size_t>(i)]);
}

namespace {

/// One care: what it costs and what its lack misses.
struct Care {
    std::string name;
    double nanoseconds = 0.0;           ///< of one more careful result, beside a rough one
    double error = 0.0;                 ///< of a rough one, in codes of 8 bits, at worst
    double for_w1 = 0.0, for_w3 = 0.0;  ///< how many a pixel of those pictures has
    std::string note;
};

/// Highlights of exponent 32: their errors are codes where they are as bright as white.
Care care_of_pow(const Effort& effort) {
    const auto x = std::make_unique<Numbers>(), exact = std::make_unique<Numbers>(),
               rough = std::make_unique<Numbers>();
    for (std::size_t i = 0; i < kCount; ++i) (*x)[i] = (static_cast<float>(i) + 0.5f) / kCount;
    const std::vector<PairedTime> times = paired_times({[&] {
                                                            for (int i = 0; i < 50; ++i) pow_of_all(*x, 32.0f, *exact);
                                                        },
                                                        [&] {
                                                            for (int i = 0; i < 50; ++i)
                                                                rough_pow_of_all(*x, 32.0f, *rough);
                                                        }},
                                                       effort.count(21, 81));
    double worst = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
        const double truth = std::pow(double{(*x)[i]}, 32.0);
        const double codes = 255.0 * std::abs(double{raster::srgb_from_linear((*rough)[i])} -
                                              double{raster::srgb_from_linear(static_cast<float>(truth))});
        worst = std::max(worst, codes);
    }
    return {"pow to 1e-6", 1e6 * (times[0].median - times[1].median) / (50.0 * kCount),
            worst,         1.0,
            0.0,           "against bits and two quotients (Mineiro 2011)"};
}

/// Unit vectors: a length that is off by e makes Lambert's cosine off by e, at most of a white surface.
Care care_of_roots(const Effort& effort) {
    const auto x = std::make_unique<Numbers>(), exact = std::make_unique<Numbers>(),
               rough = std::make_unique<Numbers>();
    for (std::size_t i = 0; i < kCount; ++i) (*x)[i] = 0.25f + 4.0f * (static_cast<float>(i) + 0.5f) / kCount;
    const std::vector<PairedTime> times = paired_times({[&] {
                                                            for (int i = 0; i < 50; ++i) roots_of_all(*x, *exact);
                                                        },
                                                        [&] {
                                                            for (int i = 0; i < 50; ++i) rough_roots_of_all(*x, *rough);
                                                        }},
                                                       effort.count(21, 81));
    double worst = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
        const double share = double{(*rough)[i]} * std::sqrt(double{(*x)[i]});
        const double white = double{raster::srgb_from_linear(static_cast<float>(std::min(share, 1.0)))};
        worst = std::max(worst, 255.0 * std::abs(white - 1.0));
    }
    return {"exact roots",
            1e6 * (times[0].median - times[1].median) / (50.0 * kCount),
            worst,
            2.0,
            6.0,
            "n and v, and one half vector a light; against bits and one step of Newton's method (Lomont 2003)"};
}

/// A film of bytes: every sample is rounded before the mean is taken.
Care care_of_film() {
    const scene::Scene scene = shiny_ball(2, 64, {640, 640});
    scene::Scene single = scene;
    single.image.samples = 1;
    scene::RenderBuffers buffers;
    render(single, make_plan(single), buffers);
    const raster::Image& samples = buffers.film;
    double worst = 0.0;
    for (int y = 0; y + 1 < samples.height; y += 2) {
        for (int x = 0; x + 1 < samples.width; x += 2) {
            glm::vec3 exact(0.0f), bytes(0.0f);
            for (int s = 0; s < 4; ++s) {
                const glm::vec3 sample =
                    glm::clamp(samples.rgb(x + s % 2, y + s / 2), glm::vec3(0.0f), glm::vec3(1.0f));
                exact += 0.25f * sample;
                for (int c = 0; c < 3; ++c) bytes[c] += 0.25f * std::round(255.0f * sample[c]) / 255.0f;
            }
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, 255.0 * std::abs(double{raster::srgb_from_linear(exact[c])} -
                                                         double{raster::srgb_from_linear(bytes[c])}));
            }
        }
    }
    return {"film of floats",
            0.0,
            worst,
            0.0,
            0.0,
            "against linear bytes a sample, a third of the memory; time is not told apart"};
}

/// Of 1000 pixels beside the edges of triangles of some ten pixels: how many change sides when vertices are rounded.
double flipped(int bits, int triangles) {
    std::uint32_t state = 1;
    const auto next = [&] {
        state = state * 1664525u + 1013904223u;
        return static_cast<double>(state >> 8) / 16777216.0;
    };
    const double step = std::ldexp(1.0, -bits);
    std::int64_t flips = 0, edges = 0;
    for (int t = 0; t < triangles; ++t) {
        std::array<glm::dvec2, 3> exact, rounded;
        for (std::size_t i = 0; i < 3; ++i) {
            exact[i] = {16.0 * next(), 16.0 * next()};
            rounded[i] = {step * std::round(exact[i].x / step), step * std::round(exact[i].y / step)};
        }
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto side = [&](const std::array<glm::dvec2, 3>& v) {
                        const glm::dvec2 a = v[i], b = v[(i + 1) % 3];
                        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
                    };
                    const glm::dvec2 along = exact[(i + 1) % 3] - exact[i];
                    const double length = std::sqrt(along.x * along.x + along.y * along.y);
                    if (std::abs(side(exact)) > 0.5 * length)
                        continue;  // farther than half a pixel from the edge's line
                    ++edges;
                    flips += (side(exact) > 0.0) != (side(rounded) > 0.0);
                }
            }
        }
    }
    return 1000.0 * static_cast<double>(flips) / static_cast<double>(edges);
}

}  // namespace

Finding measure_exactness(const Effort& effort) {
    Finding finding{{{"care", "ns each", "worst error without it [codes]", "ms of W1", "ms of W3", "note"}, {}},
                    {"bits of sub-pixel positions", "of 1000 pixels at edges on the other side", false, true, {}, true},
                    ""};
    finding.plot.series = {{"triangles of ten pixels", {}}};
    std::vector<Care> cares = {care_of_pow(effort), care_of_roots(effort), care_of_film()};
    effort.show(0.5);
    constexpr double kPixels = 1920.0 * 1080.0;
    for (const Care& care : cares) {
        const auto ms = [&](double each) { return digits(1e-6 * care.nanoseconds * each * kPixels); };
        finding.table.add(
            {care.name, digits(care.nanoseconds), digits(care.error), ms(care.for_w1), ms(care.for_w3), care.note});
    }
    double at_4 = 0.0, at_8 = 0.0;
    for (int bits = 0; bits <= 12; ++bits) {
        const double flips = flipped(bits, effort.count(2000, 20000));
        finding.plot.series[0].points.emplace_back(bits, flips);
        if (bits == 4) at_4 = flips;
        if (bits == 8) at_8 = flips;
        finding.table.add({std::to_string(bits) + " bits of sub-pixel", "0", "", "0", "0",
                           digits(flips) + " of 1000 pixels at edges change sides; integers take the same time"});
        effort.show(0.5 + bits / 24.0);
    }
    finding.text =
        "Each care alone, in a loop of its own, one thread. pow to 1e-6 takes " + fixed(cares[0].nanoseconds, 2) +
        " ns more than a rough one, which misses up to " + fixed(cares[0].error, 2) +
        " codes of a highlight: " + fixed(1e-6 * cares[0].nanoseconds * kPixels, 2) +
        " ms of a picture of 1920 x 1080 with one highlight a pixel (W1). An exact root and quotient take " +
        fixed(cares[1].nanoseconds, 2) + " ns more than bits and a step of Newton's, which miss " +
        fixed(cares[1].error, 2) + " codes at worst: " + fixed(6e-6 * cares[1].nanoseconds * kPixels, 2) +
        " ms of four lights at every pixel (W3). Four samples of bytes in place of floats miss " +
        fixed(cares[2].error, 2) + " codes in the dark. With 8 bits below a pixel " + fixed(at_8, 2) +
        " of 1000 pixels at edges lie on the other side, with 4 bits " + fixed(at_4, 1) +
        ". Equal bits on every machine cost what fused multiply-adds would save, which needs another build and is not "
        "measured here.";
    return finding;
}

}  // namespace kreda::tools
