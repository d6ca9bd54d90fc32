// live: A6 ggx
// The distribution of GGX takes alpha, the square of the roughness that an
// artist sets. Here it gets the roughness itself: every highlight is too wide.
// The other functions are given.
#include "assignment.hpp"

float ggx(float n_dot_h, float roughness) {
    const float alpha = roughness;
    const float alpha2 = alpha * alpha;
    const float q = n_dot_h * n_dot_h * (alpha2 - 1.0f) + 1.0f;
    return alpha2 / (kPi * q * q);
}
