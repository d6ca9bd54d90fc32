// The normals of triangles and polygons, raster/mesh_checks.hpp, polygon.hpp and corner_clusters.hpp, and the camera's
// direction, in long double.
#include <array>
#include <cmath>

#include "raster/camera.hpp"
#include "raster/corner_clusters.hpp"
#include "raster/mesh_checks.hpp"
#include "raster/polygon.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

const Axis kCoordinate{-1e6f, 1e6f, Spread::even, {0.0f, 1e-20f, 1.0f}};

/// A triangle with a corner 1000 away from the origin.
std::array<glm::vec3, 3> corners_of(const Inputs& x) {
    return {glm::vec3(1e3f, 0.0f, 0.0f), glm::vec3(x[0], x[1], 0.0f), glm::vec3(x[2], x[3], 0.0f)};
}

Real exact_area(const Inputs& x) {
    return (Real{x[0]} - 1000) * x[3] - (Real{x[2]} - 1000) * x[1];
}

}  // namespace

std::vector<Formula> formulas_of_normals() {
    const std::vector<Axis> plane = {kCoordinate, kCoordinate, kCoordinate, kCoordinate};
    return {
        formula_of({"normal_or_up",
                    "a sum of length 0 or [1e-38, 1e38]: the normal",
                    "[0, 1.0000002]",
                    1.0000002,
                    false,
                    1e-7,
                    {kHeight, kTurn, {1e-38f, 1e38f, Spread::logarithmic, {1e-20f, 1e20f}, {0.0f}}},
                    [](const Inputs& x) {
                        std::uint32_t unknown = 0;
                        return raster::normal_or_up(glm::dvec3(direction(x[0], x[1])) * double{x[2]}, unknown);
                    },
                    [](const Inputs& x) {
                        return x[2] == 0.0f ? Wide(0, 1, 0) : glm::normalize(Wide(direction(x[0], x[1])));
                    }}),
        {"twice_area_vector", "corners in [-1e6, 1e6]: along the normal", "[-9e12, 9e12]", -9e12, 9e12, false, 1e-2,
         plane,
         [](const Inputs& x) {
             raster::Mesh mesh;
             const auto corners = corners_of(x);
             mesh.positions.assign(corners.begin(), corners.end());
             mesh.indices = {0, 1, 2};
             return raster::twice_area_vector(mesh, 0).z;
         },
         exact_area},
        {"newell_normal", "corners in [-1e6, 1e6]: along the normal", "[-9e12, 9e12]", -9e12, 9e12, false, 1e-2, plane,
         [](const Inputs& x) { return scene::newell_normal(corners_of(x)).z; }, exact_area},
        formula_of({"view_direction",
                    "the target [1e-6, 1e6] away",
                    "[0, 1.0000002]",
                    1.0000002,
                    false,
                    1e-7,
                    {kHeight, kTurn, {1e-6f, 1e6f, Spread::logarithmic, {1.0f}}},
                    [](const Inputs& x) {
                        raster::Camera camera;
                        camera.position = glm::vec3(0.0f);
                        camera.target = direction(x[0], x[1]) * x[2];
                        camera.up = {0.0f, 0.6f, 0.8f};
                        return raster::view_direction(camera);
                    },
                    [](const Inputs& x) { return glm::normalize(Wide(direction(x[0], x[1]) * x[2])); }}),
    };
}

}  // namespace kreda::tests
