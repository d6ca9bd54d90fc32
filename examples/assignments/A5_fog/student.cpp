// A5 Fog, and what a display needs. Read README.md; write the six functions; check them with `./course assignment 5`.
#include "assignment.hpp"

// Distance of p from the plane through the eye that is parallel to the picture; never negative.
float planar_distance(const glm::vec3& p, const Eye& eye) {
    (void)p, (void)eye;
    return 0.0f;  // A5: write here
}

// Distance of p from the eye.
float radial_distance(const glm::vec3& p, const Eye& eye) {
    (void)p, (void)eye;
    return 0.0f;  // A5: write here
}

// f at distance z, in 0..1: linear, e^(-d z), e^(-(d z)^2); without fog 1.
float fog_factor(const Fog& fog, float z) {
    (void)fog, (void)z;
    return 0.0f;  // A5: write here
}

// f = 1: the surface, f = 0: fog.
glm::vec3 mix_fog(float f, const glm::vec3& surface, const glm::vec3& fog_color) {
    (void)f, (void)surface, (void)fog_color;
    return glm::vec3(0.0f);  // A5: write here
}

// Linear light (clamp it to 0..1) to the number that an sRGB picture holds.
float encode_srgb(float light) {
    (void)light;
    return 0.0f;  // A5: write here
}

// The whole of it: the surface's light through the fog, encoded.
glm::vec3 foggy_pixel(const glm::vec3& p, const glm::vec3& surface, const Fog& fog, const Eye& eye) {
    (void)p, (void)surface, (void)fog, (void)eye;
    return glm::vec3(0.0f);  // A5: write here
}
