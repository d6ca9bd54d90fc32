// A7, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    const glm::vec3 d = p - camera.origin;
    return {glm::dot(d, camera.right), glm::dot(d, camera.up), glm::dot(d, camera.backward)};
}

Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    const float half = 0.5f * float(size);
    return {half + q.x / camera.texel.x, half - q.y / camera.texel.y, -q.z};
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    const float z_u = texel.x * n_view.x / n_view.z;
    const float z_v = texel.y * n_view.y / n_view.z;
    return 0.5f * (std::abs(z_u) + std::abs(z_v));
}

float is_lit(const ShadowMap& map, int column, int row, float distance) {
    if (column < 0 || row < 0 || column >= map.size || row >= map.size) return 1.0f;
    return distance <= map.distance[row * map.size + column] ? 1.0f : 0.0f;
}

float pcf(const ShadowMap& map, const Place& place, int radius) {
    const int column = int(std::floor(place.u));
    const int row = int(std::floor(place.v));
    float lit = 0.0f;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) { lit += is_lit(map, column + i, row + j, place.distance); }
    }
    const float side = float(2 * radius + 1);
    return lit / (side * side);
}

float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    const glm::vec3 n_view{glm::dot(n, camera.right), glm::dot(n, camera.up), glm::dot(n, camera.backward)};
    if (n_view.z <= 0.0f) return 0.0f;
    Place place = map_place(camera, light_space(camera, p), map.size);
    place.distance -= camera.constant_bias + camera.slope_bias * least_bias(n_view, camera.texel);
    return pcf(map, place, radius);
}
