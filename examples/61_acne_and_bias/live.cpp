// live: A7 least_bias
// How far a plane rises within half a texel of the shadow map, equation (1).
// Without it the surface shadows itself: acne. n_view: the normal in the
// light's view, unit; texel: width and height. The other functions are given.
#include "assignment.hpp"

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    (void)n_view, (void)texel;
    return 0.0f;
}
