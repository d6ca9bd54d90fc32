// A4, solved by another hand: a row times a matrix, one blend for all, a switch.
#include "assignment.hpp"

namespace {

glm::vec3 blend(const Weights& w, const glm::vec3& at_a, const glm::vec3& at_b, const glm::vec3& at_c) {
    return at_a * w[0] + at_b * w[1] + at_c * w[2];
}

glm::vec3 corner_color(const Lit& lit, const glm::vec3& corner, const glm::vec3& normal) {
    return light_at(lit, corner, glm::normalize(normal));
}

}  // namespace

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::mat3 linear(world_from_object);
    const glm::vec3 n = n_object * glm::inverse(linear);
    return n / glm::length(n);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 first = b - a, second = c - b;
    const glm::vec3 area = glm::cross(first, second);
    return area / glm::length(area);
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    const Weights thirds(1.0f / 3.0f);
    const glm::vec3 middle = blend(thirds, t.a, t.b, t.c);
    return light_at(lit, middle, face_normal(t.a, t.b, t.c));
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 first = corner_color(lit, t.a, t.n_a);
    const glm::vec3 second = corner_color(lit, t.b, t.n_b);
    const glm::vec3 third = corner_color(lit, t.c, t.n_c);
    return blend(w, first, second, third);
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 place = blend(w, t.a, t.b, t.c);
    const glm::vec3 normal = blend(w, t.n_a, t.n_b, t.n_c);
    return light_at(lit, place, normal / glm::length(normal));
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    switch (frequency) {
        case Frequency::flat: return flat_color(t, lit);
        case Frequency::gouraud: return gouraud_color(t, w, lit);
        case Frequency::phong: break;
    }
    return phong_color(t, w, lit);
}
