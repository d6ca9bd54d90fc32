// The equations of lighting/energy.hpp as the paper prints them, in long double.
#include <algorithm>
#include <cmath>

#include "lighting/energy.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

}  // namespace

std::vector<Formula> formulas_of_energy() {
    static const EnergyTable table = compute_energy_table(Distribution::ggx, Geometry::smith_correlated);
    const Axis share{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f, 0.999999f}};
    const auto itself = [](float (*albedo)(const Inputs&)) {
        return [albedo](const Inputs& x) { return Real{albedo(x)}; };
    };
    const auto directional = [](const Inputs& x) { return directional_albedo(table, x[0], x[1]); };
    const auto average = [](const Inputs& x) { return average_albedo(table, x[0]); };
    return {
        {"directional_albedo",
         "mu in [-1e-7, 1 + 1e-7], roughness in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {{0.0f, 1.0f, Spread::even, {1e-8f, 1e-4f}, {-1e-7f, 1.0000001f}}, kRoughness},
         directional,
         itself(directional)},
        {"average_albedo", "roughness in [0, 1]", "[0, 1]", 0, 1, false, 0, {kRoughness}, average, itself(average)},
        {"multiple_scattering",
         "E(l), E(v) in [0, 1], E_avg in [0, 1]",
         "[0, 3.2e5]",
         0,
         3.2e5,
         true,
         1e-6,
         {share, share, share},
         [](const Inputs& x) { return multiple_scattering(x[0], x[1], x[2]); },
         [](const Inputs& x) {
             const Real lost = std::max(1 - Real{x[2]}, Real(1e-6f));
             return (1 - Real{x[0]}) * (1 - Real{x[1]}) / (kPi * lost);
         }},
        {"multiple_scattering_color",
         "F_avg, E_avg in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         1e-1,
         {share, share},
         [](const Inputs& x) { return multiple_scattering_color(x[0], x[1]); },
         [](const Inputs& x) {
             const Real below = 1 - x[0] * (1 - Real{x[1]});
             return Real{x[0]} * x[0] * x[1] / std::max(below, Real(1e-6f));
         }},
        formula_of({"multiple_scattering_color",
                    "R_0 in [0, 1], what F_avg exceeds Schlick's by in [-0.04, 0], E_avg in [0.1, 1]: three channels",
                    "[0, 1.7321]",
                    1.7321,
                    false,
                    5e-6,
                    {share, {-0.04f, 0.0f, Spread::even, {}}, {0.1f, 1.0f, Spread::even, {}}},
                    [](const Inputs& x) {
                        return multiple_scattering_color({x[0], 0.25f, 1.0f}, {x[1], x[1] / 2, x[1] / 4}, x[2]);
                    },
                    [](const Inputs& x) {
                        const auto channel = [&](Real f0, Real shift) {
                            const Real F = f0 + (1 - f0) / 21 + shift;
                            return F * F * x[2] / (1 - F * (1 - Real{x[2]}));
                        };
                        return Wide(channel(x[0], x[1]), channel(0.25L, x[1] / 2), channel(1, x[1] / 4));
                    }}),
        {"average_schlick",
         "R_0 in [0, 1]",
         "[0.047, 1]",
         0.047,
         1,
         false,
         2e-7,
         {share},
         [](const Inputs& x) { return average_schlick(x[0]); },
         [](const Inputs& x) { return x[0] + (1 - Real{x[0]}) / 21; }},
        {"average_f82",
         "R_0 in [0, 1], b in [-20, 20]",
         "[-0.12, 1.16]",
         -0.12,
         1.16,
         false,
         2e-7,
         {share, {-20.0f, 20.0f, Spread::even, {0.0f}}},
         [](const Inputs& x) { return average_f82(x[0], x[1]); },
         [](const Inputs& x) { return x[0] + (1 - Real{x[0]}) / 21 - Real{x[1]} / 126; }},
    };
}

}  // namespace kreda::tests
