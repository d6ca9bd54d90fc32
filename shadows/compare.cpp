#include "shadows/compare.hpp"

#include <algorithm>
#include <cmath>

#include "raster/platform.hpp"
#include "raster/scalar_math.hpp"
#include "raster/visibility.hpp"

namespace kreda::shadows {

namespace {

bool is_seen(const VisibleSamples& samples, std::size_t i) {
    return samples.depth[i] < raster::kClearDepth;
}

bool is_dark(float factor) {
    return factor < 0.5f;
}

/// Calls visit(i, j) for each two visible neighbours, in a row or in a column, between which the exact shadow ends.
template <class Visit>
void for_each_edge(const VisibleSamples& samples, std::span<const float> exact, Visit visit) {
    const int width = samples.viewport.width, height = samples.viewport.height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            const std::size_t right = i + 1, below = i + width;
            if (!is_seen(samples, i)) continue;
            const auto ends_at = [&](std::size_t j) {
                return is_seen(samples, j) && is_dark(exact[i]) != is_dark(exact[j]);
            };
            if (x + 1 < width && ends_at(right)) visit(i, right);
            if (y + 1 < height && ends_at(below)) visit(i, below);
        }
    }
}

}  // namespace

std::vector<bool> near_edges(const VisibleSamples& samples, std::span<const float> exact, int distance) {
    const int width = samples.viewport.width, height = samples.viewport.height;
    std::vector<bool> near(samples.depth.size(), false);
    const auto mark_around = [&](std::size_t i) {
        const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
        for (int j = std::max(y - distance, 0); j <= std::min(y + distance, height - 1); ++j) {
            for (int k = std::max(x - distance, 0); k <= std::min(x + distance, width - 1); ++k) {
                near[static_cast<std::size_t>(j) * width + k] = true;
            }
        }
    };
    for_each_edge(samples, exact, [&](std::size_t i, std::size_t j) {
        mark_around(i);
        mark_around(j);
    });
    return near;
}

ShadowError compare_shadows(const VisibleSamples& samples, std::span<const float> exact, std::span<const float> tested,
                            int band) {
    KREDA_EXPECT(exact.size() == samples.depth.size() && tested.size() == samples.depth.size());
    const std::vector<bool> near = near_edges(samples, exact, band);
    ShadowError error;
    std::uint64_t near_and_wrong = 0;
    double squares = 0.0;
    for (std::size_t i = 0; i < samples.depth.size(); ++i) {
        if (!is_seen(samples, i)) continue;
        ++error.visible;
        squares += (double{tested[i]} - exact[i]) * (double{tested[i]} - exact[i]);
        if (is_dark(tested[i]) == is_dark(exact[i])) continue;
        ++(is_dark(tested[i]) ? error.false_shadow : error.false_light);
        if (near[i]) ++near_and_wrong;
        if (!near[i]) ++(is_dark(tested[i]) ? error.acne : error.leaks);
    }
    std::uint64_t pairs = 0;
    for_each_edge(samples, exact, [&](std::size_t, std::size_t) { ++pairs; });
    error.edge_length = 0.25 * double{raster::kPi} * static_cast<double>(pairs);
    if (pairs > 0) error.edge_displacement = static_cast<double>(near_and_wrong) / error.edge_length;
    if (error.visible > 0) error.rmse = std::sqrt(squares / static_cast<double>(error.visible));
    return error;
}

double flipped_share(const VisibleSamples& samples, std::span<const float> before, std::span<const float> after) {
    std::uint64_t visible = 0, flipped = 0;
    for (std::size_t i = 0; i < samples.depth.size(); ++i) {
        if (!is_seen(samples, i)) continue;
        ++visible;
        flipped += is_dark(before[i]) != is_dark(after[i]);
    }
    return visible > 0 ? static_cast<double>(flipped) / static_cast<double>(visible) : 0.0;
}

raster::Image error_picture(const VisibleSamples& samples, std::span<const float> exact,
                            std::span<const float> tested) {
    const glm::vec3 lit(0.55f), dark(0.08f), false_shadow(1.0f, 0.03f, 0.02f), false_light(0.03f, 0.25f, 1.0f);
    raster::Image picture = raster::make_image(samples.viewport.width, samples.viewport.height, 3);
    for (std::size_t i = 0; i < samples.depth.size(); ++i) {
        if (!is_seen(samples, i)) continue;
        const bool wrong = is_dark(exact[i]) != is_dark(tested[i]);
        const glm::vec3 color = is_dark(tested[i]) ? (wrong ? false_shadow : dark) : (wrong ? false_light : lit);
        picture.set_rgb(static_cast<int>(i % samples.viewport.width), static_cast<int>(i / samples.viewport.width),
                        color);
    }
    return picture;
}

}  // namespace kreda::shadows
