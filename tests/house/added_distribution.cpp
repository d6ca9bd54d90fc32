// Run by check_extend.cmake on sources to which the change of docs/extend.md was applied: the new distribution is in
// the table, comes out of the switch, and its facets have the projected area one.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "lighting/microfacet_choices.hpp"

using namespace kreda::lighting;

namespace {

/// int D (n.h) dh over the hemisphere = 2 pi int D cos sin dtheta, by midpoints in x = sin^2: pi int D dx.
/// Substituting x = t^4 puts the points where a smooth surface has its peak.
double projected_area(float alpha) {
    constexpr int kSteps = 200000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) / kSteps;
        const double sin2 = t * t * t * t;
        const float n_dot_h = static_cast<float>(std::sqrt(1.0 - sin2));
        const float D = with_distribution(
            Distribution::berry, [&](auto formula) { return formula(n_dot_h, static_cast<float>(sin2), alpha); });
        sum += D * 4.0 * t * t * t;
    }
    return 3.14159265358979 * sum / kSteps;
}

}  // namespace

int main() {
    if (facts_of(Distribution::berry).key != "berry") return EXIT_FAILURE;
    for (const float alpha : {0.05f, 0.3f, 0.9f}) {
        const double area = projected_area(alpha);
        std::printf("alpha %g: projected area %.6f\n", alpha, area);
        if (std::abs(area - 1.0) > 1e-4) return EXIT_FAILURE;  // float's log2 and quotient: below 1e-5 seen
    }
    return EXIT_SUCCESS;
}
