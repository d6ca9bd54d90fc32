// A4, solved by another hand: cofactors for the normal's matrix, arrays of corners, a switch.
#include "assignment.hpp"

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::vec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
    const float volume = glm::dot(x, glm::cross(y, z));
    glm::vec3 n = glm::cross(y, z) * n_object.x + glm::cross(z, x) * n_object.y + glm::cross(x, y) * n_object.z;
    n /= volume;
    return n / std::sqrt(glm::dot(n, n));
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 u = c - b, w = a - b;
    const glm::vec3 outward = glm::cross(u, w);
    return outward / glm::length(outward);
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    glm::vec3 middle = t.a;
    middle += t.b;
    middle += t.c;
    middle *= 1.0f / 3.0f;
    const glm::vec3 facing = face_normal(t.a, t.b, t.c);
    return light_at(lit, middle, facing);
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 corner[3] = {t.a, t.b, t.c};
    const glm::vec3 normal[3] = {t.n_a, t.n_b, t.n_c};
    glm::vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) color += light_at(lit, corner[i], glm::normalize(normal[i])) * w[i];
    return color;
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const auto blend = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        return a * w.x + b * w.y + c * w.z;
    };
    glm::vec3 normal = blend(t.n_a, t.n_b, t.n_c);
    normal /= glm::length(normal);
    return light_at(lit, blend(t.a, t.b, t.c), normal);
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    switch (frequency) {
        case Frequency::flat: return flat_color(t, lit);
        case Frequency::gouraud: return gouraud_color(t, w, lit);
        case Frequency::phong: break;
    }
    return phong_color(t, w, lit);
}
