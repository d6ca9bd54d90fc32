// How wrong is a shadow? Against the exact one, sample by sample, as numbers and as a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/image.hpp"
#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// Errors of one factor a sample (1 lit .. 0 in shadow) against the exact one, over all visible samples. A sample is
/// misclassified if only one of the two is below 1/2. Edges are where the exact factor differs between neighbours, seen
/// or hidden by each other. Errors near an edge are of where the shadow ends; errors away from every edge are of
/// another kind.
struct ShadowError {
    std::uint64_t visible = 0;       ///< samples that show a surface
    std::uint64_t false_shadow = 0;  ///< lit, and dark in the tested factor
    std::uint64_t false_light = 0;   ///< in shadow, and lit in the tested factor
    std::uint64_t acne = 0;          ///< false shadow farther than `band` samples from every edge
    std::uint64_t leaks = 0;         ///< false light farther than that from every edge
    double edge_length = 0.0;        ///< in samples: pairs of neighbours x pi / 4, right on average over all directions
    double edge_displacement =
        0.0;            ///< misclassified samples near edges / edge length: how many samples an edge is off
    double rmse = 0.0;  ///< root of the mean square difference of the factors

    /// Samples in shadow that are lit, and the other way round.
    [[nodiscard]] std::uint64_t misclassified() const {
        return false_shadow + false_light;
    }
    /// In [0, 1].
    [[nodiscard]] double misclassified_share() const {
        return visible > 0 ? static_cast<double>(misclassified()) / static_cast<double>(visible) : 0.0;
    }
};

/// What a method gets wrong against the exact shadow; `band`: samples around an edge that count as near it.
[[nodiscard]] ShadowError compare_shadows(const VisibleSamples& samples, std::span<const float> exact,
                                          std::span<const float> tested, int band);

/// For every sample whether an edge of the exact shadow runs within `distance` samples of it (by row and column).
[[nodiscard]] std::vector<bool> near_edges(const VisibleSamples& samples, std::span<const float> exact, int distance);

/// Share of the visible samples whose factor changes class from one frame to the next: flicker. [0, 1]
[[nodiscard]] double flipped_share(const VisibleSamples& samples, std::span<const float> before,
                                   std::span<const float> after);

/// Linear RGB: lit samples bright, shadowed ones dark, false shadow red, false light blue, black where nothing is seen.
[[nodiscard]] raster::Image error_picture(const VisibleSamples& samples, std::span<const float> exact,
                                          std::span<const float> tested);

}  // namespace kreda::shadows
