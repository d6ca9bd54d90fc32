// A4 Flat, Gouraud, Phong. Read README.md; write the six functions; check them with `./course assignment 4`.
#include "assignment.hpp"

// The normal in world space, of unit length. It stays perpendicular to the surface whatever the matrix scales.
glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    (void)world_from_object, (void)n_object;
    return glm::vec3(0.0f);  // A4: write here
}

// Perpendicular to the triangle, of unit length, on the side from which a, b, c are counter-clockwise.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    (void)a, (void)b, (void)c;
    return glm::vec3(0.0f);  // A4: write here
}

// One colour a triangle: lit at its centre of gravity, with its face normal.
glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    (void)t, (void)lit;
    return glm::vec3(0.0f);  // A4: write here
}

// Lit at the three corners; the colours are interpolated.
glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    (void)t, (void)w, (void)lit;
    return glm::vec3(0.0f);  // A4: write here
}

// The normals (as they are) and places of the corners are interpolated; lit at the pixel.
glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    (void)t, (void)w, (void)lit;
    return glm::vec3(0.0f);  // A4: write here
}

// One of the three.
glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    (void)frequency, (void)t, (void)w, (void)lit;
    return glm::vec3(0.0f);  // A4: write here
}
