#include "tools/measure/irradiance_error.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"
#include "tools/measure/cube_texels.hpp"

namespace kreda::tools {

double mean_of(const lighting::CubeMap& map) {
    const int size = map.levels[0].size;
    double sum = 0.0, solid_angle = 0.0;
    for_each_texel(size, [&](int face, int x, int y) {
        const glm::dvec3 value = map.texel(0, face, x, y);
        const double w = lighting::texel_solid_angle(size, x, y);
        sum += w * (value.x + value.y + value.z) / 3.0;
        solid_angle += w;
    });
    return sum / solid_angle;
}

MapError map_error(const lighting::CubeMap& map, const lighting::CubeMap& exact) {
    const int size = exact.levels[0].size;
    KREDA_EXPECT(map.levels[0].size == size);
    lighting::CubeMap difference = lighting::make_cube_map({size});
    double largest = 0.0;
    for_each_texel(size, [&](int face, int x, int y) {
        const glm::vec3 error = glm::abs(map.texel(0, face, x, y) - exact.texel(0, face, x, y));
        difference.set_texel(0, face, x, y, error);
        largest = std::max({largest, double{error.x}, double{error.y}, double{error.z}});
    });
    const double mean = mean_of(exact);
    return {mean_of(difference) / mean, largest / mean};
}

lighting::CubeMap map_of_sh9(const lighting::Sh9& sh, int size) {
    lighting::CubeMap map = lighting::make_cube_map({size});
    for_each_texel(size, [&](int face, int x, int y) {
        const glm::vec3 n = glm::normalize(lighting::texel_direction(size, face, x, y));
        map.set_texel(0, face, x, y, lighting::irradiance_of_sh9(sh, n));
    });
    fill_border(map, 0);
    return map;
}

std::vector<IrradianceWay> sampling_ways(lighting::IrradianceSum sum, int size) {
    std::vector<IrradianceWay> ways;
    for (const int N2 : {2, 4, 8, 16, 32}) {
        ways.push_back({std::to_string(4 * N2 * N2), 4 * N2 * N2, [=](const lighting::CubeMap& radiance) {
                            return irradiance_map(radiance, {sum, 4 * N2, N2, size});
                        }});
    }
    return ways;
}

IrradianceWay every_texel(int size) {
    return {"every texel", 0, [=](const lighting::CubeMap& radiance) {
                return irradiance_map(radiance, {.sum = lighting::IrradianceSum::texels, .size = size});
            }};
}

IrradianceWay nine_coefficients(int size) {
    return {"SH9", 0, [=](const lighting::CubeMap& radiance) { return map_of_sh9(project_to_sh9(radiance), size); }};
}

}  // namespace kreda::tools
