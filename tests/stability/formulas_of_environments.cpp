// Where a direction lies in an environment's maps (lighting/environment/): beside the same in long double.
#include <algorithm>
#include <cmath>

#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/light_table.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using glm::vec3;

const Axis kFace{0.0f, 5.99f, Spread::even, {1.0f, 2.0f, 3.0f, 4.0f, 5.0f}};
const Axis kShare{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
const Axis kSide{1.0f, 4096.0f, Spread::logarithmic, {2.0f}};
const Axis kAnyLength{1e-15f, 1e15f, Spread::logarithmic, {1.0f}};

/// A number of a list of `count`, for a share of it.
int number_of(float share, int count) {
    return std::min(static_cast<int>(share * static_cast<float>(count)), count - 1);
}

/// OpenGL 4.6, table 8.19: the middle of each face, and whither s and t grow.
Wide exact_on_face(int face, Real u, Real v) {
    static const Wide kMiddle[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    static const Wide kRight[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    static const Wide kDown[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    return kMiddle[face] + (2 * u - 1) * kRight[face] + (2 * v - 1) * kDown[face];
}

/// Of the triangle from the origin to a, b, c [sr].   van Oosterom & Strackee 1983, eq. (8)
Real exact_solid_angle(const Wide& a, const Wide& b, const Wide& c) {
    const Real A = glm::length(a), B = glm::length(b), C = glm::length(c);
    const Real below = A * B * C + glm::dot(a, b) * C + glm::dot(b, c) * A + glm::dot(c, a) * B;
    return 2 * std::atan2(std::fabs(glm::dot(a, glm::cross(b, c))), below);
}

Real exact_texel_solid_angle(int size, int x, int y) {
    const auto corner = [&](int i, int j) { return exact_on_face(4, Real(i) / size, Real(j) / size); };
    const Wide first = corner(x, y), last = corner(x + 1, y + 1);
    return exact_solid_angle(first, corner(x + 1, y), last) + exact_solid_angle(first, corner(x, y + 1), last);
}

/// u, v: the middle of the image is +x, its top +y.
Wide exact_equirect_direction(Real u, Real v) {
    const Real phi = 2 * kPi * (u - 0.5L), theta = kPi * v;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// A direction of the environment: y is up.
vec3 direction_around_y(float height, float turn) {
    const vec3 d = direction(height, turn);
    return {d.x, d.z, d.y};
}

Real largest_of(const Wide& d) {
    return std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
}

std::vector<Formula> places_on_cubes() {
    return {
        formula_of({"direction_of",
                    "u, v in [0, 1], six faces",
                    "[1, 1.7321]",
                    1.7320509,
                    false,
                    1e-7,
                    {kFace, kShare, kShare},
                    [](const Inputs& x) {
                        return lighting::direction_of({static_cast<int>(x[0]), x[1], x[2]});
                    },
                    [](const Inputs& x) { return exact_on_face(static_cast<int>(x[0]), x[1], x[2]); }}),
        formula_of({"cube_point",
                    "d of a length in [1e-15, 1e15]: the direction there",
                    "[1, 1.7321]",
                    1.7320509,
                    false,
                    4e-7,
                    {kHeight, kTurn, kAnyLength},
                    [](const Inputs& x) {
                        const lighting::CubePoint at = lighting::cube_point(direction(x[0], x[1]) * x[2]);
                        return vec3(exact_on_face(at.face, at.u, at.v));
                    },
                    [](const Inputs& x) {
                        const Wide d(direction(x[0], x[1]));
                        return d / largest_of(d);
                    }}),
        {"texel_solid_angle",
         "sizes to 4096, every texel",
         "[2e-8, 2.1]",
         2e-8,
         2.0944,
         true,
         4e-8,
         {kSide, kShare, kShare},
         [](const Inputs& x) {
             const int size = static_cast<int>(x[0]);
             return lighting::texel_solid_angle(size, number_of(x[1], size), number_of(x[2], size));
         },
         [](const Inputs& x) {
             const int size = static_cast<int>(x[0]);
             return exact_texel_solid_angle(size, number_of(x[1], size), number_of(x[2], size));
         }},
        formula_of({"texel_direction",
                    "sizes to 4096, every texel, six faces",
                    "[1, 1.7321]",
                    1.7320509,
                    false,
                    4e-7,
                    {kFace, kSide, kShare, kShare},
                    [](const Inputs& x) {
                        const int size = static_cast<int>(x[1]);
                        return lighting::texel_direction(size, static_cast<int>(x[0]), number_of(x[2], size),
                                                         number_of(x[3], size));
                    },
                    [](const Inputs& x) {
                        const int size = static_cast<int>(x[1]);
                        const auto middle = [&](float share) { return (number_of(share, size) + 0.5L) / size; };
                        return exact_on_face(static_cast<int>(x[0]), middle(x[2]), middle(x[3]));
                    }}),
        {"density_tap",
         "d unit: its factor",
         "[1, 5.1962]",
         1,
         5.1961527,
         true,
         1e-6,
         {kHeight, kTurn},
         [](const Inputs& x) { return lighting::density_tap(16, direction(x[0], x[1])).factor; },
         [](const Inputs& x) {
             const Wide d(direction(x[0], x[1]));
             return std::pow(glm::length(d) / largest_of(d), 3);
         }},
    };
}

std::vector<Formula> places_on_images() {
    const Axis width{1.0f, 16384.0f, Spread::logarithmic, {2.0f}};
    return {
        formula_of({"map_direction",
                    "d unit, any turn",
                    "[0.9999997, 1.0000003]",
                    1.0000003,
                    false,
                    2.5e-7,
                    {kHeight, kTurn, kTurn},
                    [](const Inputs& x) {
                        const Real angle = 2 * kPi * x[2];
                        return lighting::map_direction(direction_around_y(x[0], x[1]),
                                                       static_cast<float>(std::cos(angle)),
                                                       static_cast<float>(std::sin(angle)));
                    },
                    [](const Inputs& x) {
                        const Real angle = 2 * kPi * x[2];
                        const Wide d(direction_around_y(x[0], x[1]));
                        const Real c = std::cos(angle), s = std::sin(angle);
                        return Wide(d.x * c - d.z * s, d.y, d.x * s + d.z * c);
                    }}),
        formula_of({"equirect_point",
                    "d of a length in [1e-15, 1e15]: the direction there",
                    "1",
                    1.0000001,
                    false,
                    8e-7,
                    {kHeight, kTurn, kAnyLength},
                    [](const Inputs& x) {
                        const glm::vec2 at = lighting::equirect_point(direction_around_y(x[0], x[1]) * x[2]);
                        return vec3(exact_equirect_direction(at.x, at.y));
                    },
                    [](const Inputs& x) { return glm::normalize(Wide(direction_around_y(x[0], x[1]))); }}),
        formula_of({"equirect_direction",
                    "u, v in [0, 1]",
                    "[0.9999997, 1.0000003]",
                    1.0000003,
                    false,
                    4e-7,
                    {kShare, kShare},
                    [](const Inputs& x) {
                        return lighting::equirect_direction({x[0], x[1]});
                    },
                    [](const Inputs& x) { return exact_equirect_direction(x[0], x[1]); }}),
        {"equirect_solid_angle",
         "sizes to 16384, every row",
         "[7e-12, 12.567]",
         7e-12,
         12.5664,
         true,
         1e-8,
         {width, width, kShare},
         [](const Inputs& x) {
             const int height = static_cast<int>(x[1]);
             return lighting::equirect_solid_angle(static_cast<int>(x[0]), height, number_of(x[2], height));
         },
         [](const Inputs& x) {  // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2): nothing cancels
             const int height = static_cast<int>(x[1]);
             const Real middle = kPi * (number_of(x[2], height) + 0.5L) / height;
             return 4 * kPi / static_cast<int>(x[0]) * std::sin(middle) * std::sin(kPi / (2 * height));
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_environments() {
    return joined(places_on_cubes(), places_on_images());
}

}  // namespace kreda::tests
