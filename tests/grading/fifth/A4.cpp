// A4, solved by another hand: the inverse on the row vector's side, corners as a struct.
#include "assignment.hpp"

namespace {

struct Corner {
    glm::vec3 p, n;
    float w;
};

glm::vec3 of_length_one(glm::vec3 v) {
    v *= 1.0f / glm::length(v);
    return v;
}

void corners_of(const Triangle& t, const Weights& w, Corner (&corners)[3]) {
    corners[0] = {t.a, t.n_a, w.x};
    corners[1] = {t.b, t.n_b, w.y};
    corners[2] = {t.c, t.n_c, w.z};
}

}  // namespace

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object) {
    const glm::mat3 object_from_world = glm::inverse(glm::mat3(world_from_object));
    return of_length_one(n_object * object_from_world);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 u = b - a, v = c - a;
    return of_length_one({u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x});
}

glm::vec3 flat_color(const Triangle& t, const Lit& lit) {
    const float third = 1.0f / 3.0f;
    const glm::vec3 n = face_normal(t.a, t.b, t.c);
    return light_at(lit, third * t.a + third * t.b + third * t.c, n);
}

glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit) {
    Corner corners[3];
    corners_of(t, w, corners);
    glm::vec3 sum(0.0f);
    for (const Corner& corner : corners) sum += corner.w * light_at(lit, corner.p, of_length_one(corner.n));
    return sum;
}

glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit) {
    Corner corners[3];
    corners_of(t, w, corners);
    glm::vec3 p(0.0f), n(0.0f);
    for (const Corner& corner : corners) {
        p += corner.w * corner.p;
        n += corner.w * corner.n;
    }
    return light_at(lit, p, of_length_one(n));
}

glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit) {
    if (frequency == Frequency::phong) {
        return phong_color(t, w, lit);
    } else if (frequency == Frequency::gouraud) {
        return gouraud_color(t, w, lit);
    } else {
        return flat_color(t, lit);
    }
}
