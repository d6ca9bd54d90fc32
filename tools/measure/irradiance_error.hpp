// Irradiance maps made in many ways, and how far one is from another over all normals and the three colours.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lighting/environment/irradiance.hpp"

namespace kreda::tools {

/// The mean of level 0 over all directions and colours. Of E it is a quarter of all the light that comes from
/// everywhere.
[[nodiscard]] double mean_of(const lighting::CubeMap& map);

/// Relative to the mean of the exact map.
struct MapError {
    double mean = 0.0;     ///< mean |E' - E| / mean E
    double largest = 0.0;  ///< max |E' - E| / mean E
};

/// Level 0 of two maps of equal size; texels count with their solid angles.
[[nodiscard]] MapError map_error(const lighting::CubeMap& map, const lighting::CubeMap& exact);

/// The polynomial as a map of one level.
[[nodiscard]] lighting::CubeMap map_of_sh9(const lighting::Sh9& sh, int size);

/// A way to make an irradiance map from an environment.
struct IrradianceWay {
    std::string name;
    int samples = 0;  ///< of each normal; 0: it takes none
    std::function<lighting::CubeMap(const lighting::CubeMap& radiance)> make;
};

/// The double sum (4 N2 azimuths, N2 angles) or the cosine-weighted sum, of 16, 64, 256, 1024 and 4096 samples.
[[nodiscard]] std::vector<IrradianceWay> sampling_ways(lighting::IrradianceSum sum, int size);

/// Every texel (the exact one), and the nine coefficients.
[[nodiscard]] IrradianceWay every_texel(int size);
[[nodiscard]] IrradianceWay nine_coefficients(int size);

}  // namespace kreda::tools
