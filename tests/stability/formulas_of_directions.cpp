// Directions that are made of numbers and of other directions, in long double: importance.hpp, normal_map.hpp,
// orthonormal_frame.hpp, the half vector's angles.
#include <algorithm>
#include <cmath>

#include "lighting/importance.hpp"
#include "lighting/microfacet.hpp"
#include "lighting/normal_map.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

Wide turned(Real cosine, Real turns) {
    const Real sine = std::sqrt(std::max((1 - cosine) * (1 + cosine), Real{0})), phi = 2 * kPi * turns;
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

const Axis kSquare{0.0f, 0.99999994f, Spread::even, {1e-8f, 0.5f}};
const Axis kWidth{kMinAlpha, 1.0f, Spread::logarithmic, {0.01f, 0.25f}};

std::vector<Formula> chosen_directions() {
    const Axis number{0.0f, 16777216.0f, Spread::even, {1.0f, 2.0f, 3.0f, 1024.0f}};
    return {
        {"radical_inverse",
         "whole numbers in [0, 2^24]",
         "[0, 1)",
         0,
         0.99999995,
         false,
         0,
         {number},
         [](const Inputs& x) { return radical_inverse(static_cast<std::uint32_t>(x[0])); },
         [](const Inputs& x) {
             Real sum = 0, half = 0.5L;
             for (std::uint32_t i = static_cast<std::uint32_t>(x[0]); i > 0; i >>= 1, half /= 2) sum += half * (i & 1u);
             return std::floor(sum * 16777216) / 16777216;
         }},
        {"hammersley",
         "i in [0, n), n in [1, 65536]: its second number",
         "(0, 1)",
         1e-8,
         0.99999995,
         false,
         7e-8,
         {{0.0f, 65535.0f, Spread::even, {1.0f}}, {1.0f, 65536.0f, Spread::logarithmic, {1024.0f}}},
         [](const Inputs& x) { return hammersley(static_cast<int>(x[0]), static_cast<int>(x[1])).y; },
         [](const Inputs& x) {
             const Real second = radical_inverse(static_cast<std::uint32_t>(x[0])) + 0.5L / static_cast<int>(x[1]);
             return std::min(second, Real{0.99999994f});
         }},
        formula_of({"around_normal",
                    "cosine in [-1, 1], turns in [-1, 1]",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    3e-7,
                    {kHeight, {-1.0f, 1.0f, Spread::even, {0.0f, 0.25f, 1e-8f}}},
                    [](const Inputs& x) { return around_normal(x[0], x[1]); },
                    [](const Inputs& x) { return turned(x[0], x[1]); }}),
        formula_of({"cosine_direction",
                    "u in [0, 1)²",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    4e-4,
                    {kSquare, kSquare},
                    [](const Inputs& x) {
                        return cosine_direction({x[0], x[1]});
                    },
                    [](const Inputs& x) { return turned(std::sqrt(1 - Real{x[1]}), x[0]); }}),
        formula_of({"ggx_half_vector",
                    "u in [0, 1)², alpha in [0.002, 1]",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    6e-4,
                    {kSquare, kSquare, kWidth},
                    [](const Inputs& x) {
                        return ggx_half_vector({x[0], x[1]}, x[2]);
                    },
                    [](const Inputs& x) {
                        const Real y = x[1], alpha2 = Real{x[2]} * x[2];
                        return turned(std::sqrt((1 - y) / (1 + (alpha2 - 1) * y)), x[0]);
                    }}),
        formula_of({"visible_half_vector",
                    "u in [0, 1) x [0, 0.99], v unit, v.z in [0.001, 1], alpha in [0.002, 1]",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    4e-4,
                    {kSquare, {0.0f, 0.99f, Spread::even, {0.5f}}, {1e-3f, 1.0f, Spread::even, {}}, kAnyTurn, kWidth},
                    [](const Inputs& x) {
                        return visible_half_vector({x[0], x[1]}, direction(x[2], x[3]), x[4]);
                    },
                    [](const Inputs& x) {
                        const Real phi = 2 * kPi * x[0];
                        const Wide v(direction(x[2], x[3]));
                        return visible_facet<Real>(v, x[4], std::cos(phi), std::sin(phi), x[1]);
                    }}),
    };
}

/// The half vector of two directions that are taken as exact.
Wide exact_half(const Inputs& x) {
    const Wide sum = Wide(direction(x[0], x[1])) + Wide(direction(x[2], x[3]));
    const Real length = glm::length(sum);
    return length > 1e-15L ? sum / length : Wide(Real{0});
}

std::vector<Formula> angles() {
    const glm::vec3 up{0.0f, 0.0f, 1.0f};
    const std::vector<Axis> two = {kHeight, kTurn, kHeight, kTurn};
    const auto angles_of = [=](const Inputs& x) {
        return microfacet_angles(up, direction(x[0], x[1]), direction(x[2], x[3]));
    };
    const auto exact_sine = [](const Inputs& x) {
        const Wide h = exact_half(x);
        const Real d = h.x * h.x + h.y * h.y + (1 - h.z) * (1 - h.z);
        return std::clamp(d * (1 - d / 4), Real{0}, Real{1});
    };
    const auto exact_v_dot_h = [](const Inputs& x) {
        return std::min(glm::length(Wide(direction(x[0], x[1])) + Wide(direction(x[2], x[3]))) / 2, Real{1});
    };
    return {
        {"squared_sine", "two unit vectors", "[0, 1]", 0, 1, false, 8e-7, two,
         [](const Inputs& x) { return squared_sine(direction(x[0], x[1]), direction(x[2], x[3])); },
         [](const Inputs& x) {
             const Wide apart = Wide(direction(x[0], x[1])) - Wide(direction(x[2], x[3]));
             const Real d = glm::dot(apart, apart);
             return std::clamp(d * (1 - d / 4), Real{0}, Real{1});
         }},
        {"half_vector_angles", "n, l, v unit to 3e-7: v·h", "[0, 1]", 0, 1, false, 2e-7, two,
         [=](const Inputs& x) { return half_vector_angles(up, direction(x[0], x[1]), direction(x[2], x[3])).v_dot_h; },
         exact_v_dot_h},
        {"microfacet_angles", "n, l, v unit to 3e-7: n·h", "[0, 1]", 0, 1, false, 3e-7, two,
         [=](const Inputs& x) { return angles_of(x).n_dot_h; },
         [](const Inputs& x) { return std::clamp(exact_half(x).z, Real{0}, Real{1}); }},
        {"microfacet_angles",
         "l up to 3e-7 longer or shorter than 1, also 1e-7 below the surface: n·l",
         "[0, 1]",
         0,
         1,
         false,
         1e-7,
         {{-1.0f, 1.0f, Spread::even, {-1e-7f, 0.0f, 1e-8f}}, kTurn, {-3e-7f, 3e-7f, Spread::even, {-1e-7f, 1e-7f}}},
         [=](const Inputs& x) { return microfacet_angles(up, direction(x[0], x[1]) * (1.0f + x[2]), up).n_dot_l; },
         [](const Inputs& x) { return std::clamp(Real{x[0] * (1.0f + x[2])}, Real{0}, Real{1}); }},
        {"microfacet_angles", "n, l, v unit to 3e-7: sin² of n and h", "[0, 1]", 0, 1, false, 8e-7, two,
         [=](const Inputs& x) { return angles_of(x).sin2_h; }, exact_sine},
    };
}

/// Duff et al. 2017 in long double.
struct WideFrame {
    Wide t, b, n;
    explicit WideFrame(const Wide& normal) : n(normal) {
        const Real sign = n.z < 0 ? -1 : 1, a = -1 / (sign + n.z);
        t = {1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
        b = {n.x * n.y * a, sign + n.y * n.y * a, -n.y};
    }
};

std::vector<Formula> frames() {
    const glm::vec3 up{0.0f, 0.0f, 1.0f};
    const Axis tilt{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, 0.5f}};
    const Axis depth{0.01f, 1.0f, Spread::even, {}};
    const std::vector<Axis> tangent = {{-0.9999f, 0.9999f, Spread::even, {0.0f}}, kTurn};
    const auto exact_t = [](const Inputs& x) {
        const Wide T(direction(x[0], x[1]));
        return glm::normalize(Wide(T.x, T.y, Real{0}));
    };
    return {
        formula_of({"tangent_frame", "n unit, T 0.01 from it or more: its t", "[0, 1.0000004]", 1.0000004, false, 4e-7,
                    tangent, [=](const Inputs& x) { return tangent_frame(up, direction(x[0], x[1]), 1.0f).t; },
                    exact_t}),
        formula_of({"bend_normal",
                    "n of length 2, T along x, m in [-1, 1]² x [0.01, 1]",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    4e-7,
                    {tilt, tilt, depth},
                    [](const Inputs& x) {
                        return bend_normal({0.0f, 0.0f, 2.0f}, {3.0f, 0.0f, 0.0f}, 1.0f, {x[0], x[1], x[2]});
                    },
                    [](const Inputs& x) { return glm::normalize(Wide(x[0], x[1], x[2])); }}),
        formula_of({"frame_around",
                    "n unit to 3e-7: its t",
                    "[0, 1.000001]",
                    1.000001,
                    false,
                    1e-6,
                    {kHeight, kTurn},
                    [](const Inputs& x) { return frame_around(direction(x[0], x[1])).t; },
                    [](const Inputs& x) { return WideFrame(Wide(direction(x[0], x[1]))).t; }}),
    };
}

/// d in the frame around n, and back.
std::vector<Formula> changes_of_frame() {
    const auto frame = [](const Inputs& x) { return frame_around(direction(x[0], x[1])); };
    const auto wide_frame = [](const Inputs& x) { return WideFrame(Wide(direction(x[0], x[1]))); };
    const auto row = [](const std::string& name, const auto& value, const auto& exact) {
        return formula_of({name,
                           "n, d unit to 3e-7",
                           "[0, 1.000002]",
                           1.000002,
                           false,
                           2e-6,
                           {kHeight, kTurn, kHeight, kTurn},
                           value,
                           exact});
    };
    return {
        row(
            "to_world", [=](const Inputs& x) { return to_world(frame(x), direction(x[2], x[3])); },
            [=](const Inputs& x) {
                const WideFrame f = wide_frame(x);
                const Wide d(direction(x[2], x[3]));
                return f.t * d.x + f.b * d.y + f.n * d.z;
            }),
        row(
            "to_surface", [=](const Inputs& x) { return to_surface(frame(x), direction(x[2], x[3])); },
            [=](const Inputs& x) {
                const WideFrame f = wide_frame(x);
                const Wide d(direction(x[2], x[3]));
                return Wide(glm::dot(f.t, d), glm::dot(f.b, d), glm::dot(f.n, d));
            }),
    };
}

}  // namespace

std::vector<Formula> formulas_of_directions() {
    return joined(joined(chosen_directions(), angles()), joined(frames(), changes_of_frame()));
}

}  // namespace kreda::tests
