// A7 by a third hand: the matrix of the axes, one place where a texel is read, the filter counts hits as integers.
#include "assignment.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace {

/// What turns a vector of the world into the light's axes.
glm::mat3 axes_of(const LightCamera& camera) {
    return glm::transpose(glm::mat3(camera.right, camera.up, camera.backward));
}

bool is_inside(const ShadowMap& map, int column, int row) {
    return column >= 0 && column < map.size && row >= 0 && row < map.size;
}

float seen_at(const ShadowMap& map, int column, int row) {
    return map.distance[static_cast<std::size_t>(map.size * row + column)];
}

}  // namespace

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    return axes_of(camera) * (p - camera.origin);
}

Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    Place place;
    place.u = q.x / camera.texel.x + float(size) / 2.0f;
    place.v = -q.y / camera.texel.y + float(size) / 2.0f;
    place.distance = -q.z;
    return place;
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    const float across = std::fabs(n_view.x / n_view.z) * texel.x;
    const float down = std::fabs(n_view.y / n_view.z) * texel.y;
    return (across + down) / 2.0f;
}

float is_lit(const ShadowMap& map, int column, int row, float distance) {
    if (!is_inside(map, column, row)) return 1.0f;
    if (distance > seen_at(map, column, row)) return 0.0f;
    return 1.0f;
}

float pcf(const ShadowMap& map, const Place& place, int radius) {
    const int column = int(std::floor(place.u)), row = int(std::floor(place.v));
    const int side = 2 * radius + 1;
    int hits = 0;
    for (int k = 0; k < side * side; ++k) {
        const int right = k % side - radius, below = k / side - radius;
        if (is_lit(map, column + right, row + below, place.distance) > 0.5f) ++hits;
    }
    return float(hits) / float(side * side);
}

float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    const glm::vec3 n_light = axes_of(camera) * n;
    if (!(n_light.z > 0.0f)) return 0.0f;
    const Place place = map_place(camera, light_space(camera, p), map.size);
    const float bias = camera.constant_bias + camera.slope_bias * least_bias(n_light, camera.texel);
    return pcf(map, {place.u, place.v, place.distance - bias}, radius);
}
