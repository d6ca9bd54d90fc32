// The experiments, each a function; experiments.cpp lists them with what they ask.
#pragma once

#include "tools/measure/experiment.hpp"

namespace kreda::tools {

// experiments_fresnel.cpp
[[nodiscard]] Finding measure_fresnel(const Effort& effort);
[[nodiscard]] Finding measure_fresnel_table(const Effort& effort);
[[nodiscard]] Finding measure_fresnel_time(const Effort& effort);
[[nodiscard]] Finding measure_fresnel_pictures(const Effort& effort);
[[nodiscard]] Finding measure_spectrum(const Effort& effort);
// experiments_shading.cpp
[[nodiscard]] Finding measure_frequency(const Effort& effort);
[[nodiscard]] Finding measure_phong_blinn(const Effort& effort);
[[nodiscard]] Finding measure_furnace(const Effort& effort);
// experiments_rate.cpp
[[nodiscard]] Finding measure_shading_rate(const Effort& effort);
// experiments_shadow.cpp
[[nodiscard]] Finding measure_shadow_map(const Effort& effort);
[[nodiscard]] Finding measure_soft_shadow(const Effort& effort);
// experiments_environment.cpp
[[nodiscard]] Finding measure_irradiance(const Effort& effort);
[[nodiscard]] Finding measure_prefilter(const Effort& effort);
[[nodiscard]] Finding measure_brdf_map(const Effort& effort);
[[nodiscard]] Finding measure_split_sum(const Effort& effort);
// experiments_closed_forms.cpp
[[nodiscard]] Finding measure_sh9(const Effort& effort);
[[nodiscard]] Finding measure_brdf_fit(const Effort& effort);
// experiments_raster.cpp
[[nodiscard]] Finding measure_depth(const Effort& effort);
[[nodiscard]] Finding measure_affine(const Effort& effort);
[[nodiscard]] Finding measure_supersampling(const Effort& effort);
[[nodiscard]] Finding measure_texture_filter(const Effort& effort);
[[nodiscard]] Finding measure_fog(const Effort& effort);
[[nodiscard]] Finding measure_transfer(const Effort& effort);
// experiments_float.cpp
[[nodiscard]] Finding measure_float(const Effort& effort);
// experiments_exactness.cpp
[[nodiscard]] Finding measure_exactness(const Effort& effort);

}  // namespace kreda::tools
