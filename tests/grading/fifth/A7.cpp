// A7, solved by another hand: counts in integers, coordinates one after the other.
#include "assignment.hpp"

namespace {

bool inside(const ShadowMap& map, int column, int row) {
    if (column < 0 || column > map.size - 1) return false;
    return row >= 0 && row <= map.size - 1;
}

float slope_of(float along, float towards) {
    return std::fabs(along / towards);
}

}  // namespace

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    const glm::vec3 way = p - camera.origin;
    glm::vec3 q;
    q.x = way.x * camera.right.x + way.y * camera.right.y + way.z * camera.right.z;
    q.y = way.x * camera.up.x + way.y * camera.up.y + way.z * camera.up.z;
    q.z = way.x * camera.backward.x + way.y * camera.backward.y + way.z * camera.backward.z;
    return q;
}

Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    Place place;
    const float middle = float(size) / 2.0f;
    place.u = q.x / camera.texel.x + middle;
    place.v = middle - q.y / camera.texel.y;
    place.distance = 0.0f - q.z;
    return place;
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    const float across = texel.x * slope_of(n_view.x, n_view.z);
    const float down = texel.y * slope_of(n_view.y, n_view.z);
    return (across + down) / 2.0f;
}

float is_lit(const ShadowMap& map, int column, int row, float distance) {
    if (!inside(map, column, row)) return 1.0f;
    const float nearest = map.distance[column + row * map.size];
    if (distance > nearest) return 0.0f;
    return 1.0f;
}

float pcf(const ShadowMap& map, const Place& place, int radius) {
    const int first_column = int(std::floor(place.u)) - radius, first_row = int(std::floor(place.v)) - radius;
    const int side = 2 * radius + 1;
    int lit = 0;
    for (int k = 0; k < side * side; ++k) {
        const int column = first_column + k % side, row = first_row + k / side;
        if (is_lit(map, column, row, place.distance) > 0.5f) ++lit;
    }
    return float(lit) / float(side * side);
}

float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    const glm::vec3 seen(glm::dot(camera.right, n), glm::dot(camera.up, n), glm::dot(camera.backward, n));
    if (!(seen.z > 0.0f)) return 0.0f;
    const float bias = camera.constant_bias + least_bias(seen, camera.texel) * camera.slope_bias;
    Place place = map_place(camera, light_space(camera, p), map.size);
    place.distance = place.distance - bias;
    return pcf(map, place, radius);
}
