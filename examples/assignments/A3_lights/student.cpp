// A3 Lights and Phong's model. Read README.md; write the six functions; check them with `./course assignment 3`.
#include "assignment.hpp"

// 1 / (constant + linear d + quadratic d^2)                                                      d >= 0
float attenuate(const Attenuation& a, float d) {
    (void)a, (void)d;
    return 0.0f;  // A3: write here
}

// The spot's edge: 1 inside of the inner cone, 0 outside of the outer one, and 3t^2 - 2t^3 between them, where t runs
// from 0 at cos_outer to 1 at cos_inner. The cosines are of the angle between the spot's axis and the ray.
float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    (void)cos_angle, (void)cos_inner, (void)cos_outer;
    return 0.0f;  // A3: write here
}

// l: from the point p to the light, of unit length; and how much light arrives.
LightSample sample_light(const Light& light, const glm::vec3& p) {
    (void)light, (void)p;
    return {glm::vec3(0.0f), glm::vec3(0.0f)};  // A3: write here
}

// The mirror image of l in n.
glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    (void)n, (void)l;
    return glm::vec3(0.0f);  // A3: write here
}

// Phong's terms of one light; n, l and v are unit and point away from the surface. A surface that faces away from the
// light has neither term.
Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    (void)n, (void)l, (void)v, (void)m;
    return {glm::vec3(0.0f), glm::vec3(0.0f)};  // A3: write here
}

// The whole of it: ambient light, emission, and the sum over all lights.
glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    (void)point, (void)lights;
    return glm::vec3(0.0f);  // A3: write here
}
