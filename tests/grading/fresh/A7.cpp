// A7, solved by another hand: sums written out, the window of the filter as a list of offsets.
#include "assignment.hpp"

#include <algorithm>

static glm::vec3 along_axes(const LightCamera& c, const glm::vec3& d) {
    const float x = d.x * c.right.x + d.y * c.right.y + d.z * c.right.z;
    const float y = d.x * c.up.x + d.y * c.up.y + d.z * c.up.z;
    const float z = d.x * c.backward.x + d.y * c.backward.y + d.z * c.backward.z;
    return glm::vec3(x, y, z);
}

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    return along_axes(camera, p - camera.origin);
}

Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    Place place;
    place.u = q.x / camera.texel.x + float(size) / 2.0f;
    place.v = float(size) / 2.0f - q.y / camera.texel.y;
    place.distance = -q.z;
    return place;
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    const float tangent_u = std::fabs(n_view.x / n_view.z) * texel.x;
    const float tangent_v = std::fabs(n_view.y / n_view.z) * texel.y;
    return (tangent_u + tangent_v) * 0.5f;
}

float is_lit(const ShadowMap& map, int column, int row, float distance) {
    const bool inside = column >= 0 && column < map.size && row >= 0 && row < map.size;
    if (!inside) return 1.0f;
    const float seen = map.distance[std::size_t(column + map.size * row)];
    if (seen < distance) return 0.0f;
    return 1.0f;
}

float pcf(const ShadowMap& map, const Place& place, int radius) {
    const int x0 = int(std::floor(place.u)) - radius, y0 = int(std::floor(place.v)) - radius;
    const int side = 1 + 2 * radius;
    int lit = 0;
    for (int k = 0; k < side * side; ++k) {
        if (is_lit(map, x0 + k % side, y0 + k / side, place.distance) > 0.5f) ++lit;
    }
    return float(lit) / float(side * side);
}

float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    const glm::vec3 normal = along_axes(camera, n);
    if (normal.z > 0.0f) {
        Place where = map_place(camera, light_space(camera, p), map.size);
        float bias = least_bias(normal, camera.texel) * camera.slope_bias;
        bias += camera.constant_bias;
        where.distance = where.distance - bias;
        return pcf(map, where, radius);
    }
    return 0.0f;
}
