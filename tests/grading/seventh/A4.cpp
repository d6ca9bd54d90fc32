// A4, by one who puts the corners into arrays and blends everything with one helper.
#include "assignment.hpp"

namespace {

glm::vec3 unit(const glm::vec3& a) {
    return a * (1.0f / glm::length(a));
}

glm::vec3 blend(const Weights& w, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return a * w[0] + b * w[1] + c * w[2];
}

}  // namespace

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::mat3 inverse = glm::inverse(glm::mat3(world_from_object));
    glm::vec3 n;
    for (int i = 0; i < 3; ++i) n[i] = glm::dot(inverse[i], n_object);
    return unit(n);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 first = b - a;
    const glm::vec3 second = c - b;
    return unit(glm::cross(first, second));
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    const glm::vec3 middle = blend(Weights(1.0f / 3.0f), t.a, t.b, t.c);
    const glm::vec3 n = face_normal(t.a, t.b, t.c);
    return light_at(lit, middle, n);
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 place[3] = {t.a, t.b, t.c};
    const glm::vec3 normal[3] = {t.n_a, t.n_b, t.n_c};
    glm::vec3 color(0.0f);
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 at_corner = light_at(lit, place[k], unit(normal[k]));
        color += at_corner * w[k];
    }
    return color;
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 n = blend(w, t.n_a, t.n_b, t.n_c);
    const glm::vec3 p = blend(w, t.a, t.b, t.c);
    return light_at(lit, p, unit(n));
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    switch (frequency) {
        case Frequency::flat: return flat_color(t, lit);
        case Frequency::gouraud: return gouraud_color(t, w, lit);
        case Frequency::phong: return phong_color(t, w, lit);
    }
    return glm::vec3(0.0f);
}
