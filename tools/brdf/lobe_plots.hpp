// A figure for each reflection model: polar and cartesian plots, lobes in space, a ball.
#pragma once

#include <string>
#include <vector>

#include "raster/image.hpp"
#include "tools/brdf/lobes.hpp"

namespace kreda::tools {

/// Roughnesses, one a row of a figure, and incidences in degrees, one a curve.
[[nodiscard]] const std::vector<float>& plotted_roughnesses();
[[nodiscard]] const std::vector<double>& plotted_incidences();

/// model, roughness, incidence, theta, f: in the plane of incidence, a line each half degree; theta < 0 is the lamp's
/// side.
[[nodiscard]] std::string lobe_csv(const LobeModel& model);

/// model, roughness, incidence, reflectance: a line for each row and curve of each figure.
[[nodiscard]] std::string reflectance_csv(const std::vector<LobeModel>& models);

/// A ball of the model in the light of one lamp, encoded for a PNG.
[[nodiscard]] raster::Image lit_ball(const LobeModel& model, float roughness, int side);

/// Write NAME.csv, and NAME.png (a row for each roughness) where gnuplot is installed; false: it is not, or failed, and
/// the figure is missing. Throws UserError.
[[nodiscard]] bool write_figure(const LobeModel& model, const std::string& folder);

}  // namespace kreda::tools
