// Shadow maps of every size, bias and filter against the exact shadow of the same scene.
#pragma once

#include <array>
#include <vector>

#include "lighting/environment/progress.hpp"
#include "scene/scene.hpp"
#include "shadows/compare.hpp"

namespace kreda::tools {

inline constexpr std::array kMapSizes = {256, 512, 1024, 2048};
inline constexpr std::array kMapFilters = {shadows::ShadowFilter::none, shadows::ShadowFilter::pcf,
                                           shadows::ShadowFilter::pcss};
inline constexpr std::array kMapBiases = {shadows::ShadowBias::none, shadows::ShadowBias::constant,
                                          shadows::ShadowBias::slope, shadows::ShadowBias::normal_offset};

/// One setting, and what it costs.
struct ShadowRow {
    std::size_t filter = 0, bias = 0, size = 0;  ///< in kMapFilters, kMapBiases, kMapSizes
    shadows::ShadowError error;
    double ms = 0.0;  ///< the map and the whole picture, on one thread
};

/// Wrong samples in percent of the visible ones.
[[nodiscard]] double wrong_percent(const ShadowRow& row);

/// All settings, sizes first, then biases, then filters. `light_size`: for pcss. Errors farther than `band` samples
/// from every edge are acne or leaks. Requires a light that casts shadows.
[[nodiscard]] std::vector<ShadowRow> measure_shadow_maps(scene::Scene scene, float light_size, int band,
                                                         const lighting::Progress& progress = {});

}  // namespace kreda::tools
