// A4 by a third hand: the matrix of cofactors, arrays of corners, a switch.
#include "assignment.hpp"

#include <initializer_list>

namespace {

glm::vec3 unit(const glm::vec3& v) {
    return v / std::sqrt(glm::dot(v, v));
}

}  // namespace

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::vec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
    const float volume = glm::dot(x, glm::cross(y, z));
    const glm::vec3 turned =
        glm::cross(y, z) * n_object.x + glm::cross(z, x) * n_object.y + glm::cross(x, y) * n_object.z;
    return unit(turned / volume);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 first_side = b - a;
    const glm::vec3 second_side = c - b;
    return unit(glm::cross(first_side, second_side));
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    glm::vec3 middle(0.0f);
    for (const glm::vec3& corner : {t.a, t.b, t.c}) middle += corner / 3.0f;
    const glm::vec3 n = face_normal(t.a, t.b, t.c);
    return light_at(lit, middle, n);
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 corners[3] = {t.a, t.b, t.c}, normals[3] = {t.n_a, t.n_b, t.n_c};
    glm::vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 n = unit(normals[i]);
        color += w[i] * light_at(lit, corners[i], n);
    }
    return color;
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    const glm::vec3 corners[3] = {t.a, t.b, t.c}, normals[3] = {t.n_a, t.n_b, t.n_c};
    glm::vec3 place(0.0f), direction(0.0f);
    for (int i = 0; i < 3; ++i) {
        place += corners[i] * w[i];
        direction += normals[i] * w[i];
    }
    return light_at(lit, place, unit(direction));
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    switch (frequency) {
        case Frequency::flat: return flat_color(t, lit);
        case Frequency::gouraud: return gouraud_color(t, w, lit);
        case Frequency::phong: return phong_color(t, w, lit);
    }
    return glm::vec3(0.0f);
}
