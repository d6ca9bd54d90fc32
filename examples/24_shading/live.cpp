// live: A4 phong_color shade_pixel
// Phong shading: normals are interpolated, the light is computed at the pixel.
// What is interpolated is not of unit length, and the light is far too strong.
// Make it a unit vector. The other functions are given.
#include "assignment.hpp"

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 p = w.x * t.a + w.y * t.b + w.z * t.c;
    const glm::vec3 n = w.x * t.n_a + w.y * t.n_b + w.z * t.n_c;
    return light_at(lit, p, n);
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    if (frequency == Frequency::flat) return flat_color(t, lit);
    if (frequency == Frequency::gouraud) return gouraud_color(t, w, lit);
    return phong_color(t, w, lit);
}
