// A7, solved by another hand: one turn into the light's axes for points and normals, a count instead of a sum.
#include "assignment.hpp"

namespace {

glm::vec3 turned(const LightCamera& camera, const glm::vec3& d) {
    return glm::vec3(glm::dot(camera.right, d), glm::dot(camera.up, d), glm::dot(camera.backward, d));
}

}  // namespace

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    return turned(camera, p - camera.origin);
}

Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    Place place;
    place.u = q.x / camera.texel.x + float(size) / 2.0f;
    place.v = float(size) / 2.0f - q.y / camera.texel.y;
    place.distance = -q.z;
    return place;
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    const float across = std::abs(n_view.x) * texel.x;
    const float down = std::abs(n_view.y) * texel.y;
    return (across + down) / (2.0f * n_view.z);
}

float is_lit(const ShadowMap& map, int column, int row, float distance) {
    const bool inside = column >= 0 && column < map.size && row >= 0 && row < map.size;
    if (!inside) return 1.0f;
    const float nearest = map.distance[map.size * row + column];
    return nearest >= distance ? 1.0f : 0.0f;
}

float pcf(const ShadowMap& map, const Place& place, int radius) {
    const int middle_x = int(std::floor(place.u)), middle_y = int(std::floor(place.v));
    float lit = 0.0f, all = 0.0f;
    for (int y = middle_y - radius; y <= middle_y + radius; ++y) {
        for (int x = middle_x - radius; x <= middle_x + radius; ++x) {
            lit += is_lit(map, x, y, place.distance);
            all += 1.0f;
        }
    }
    return lit / all;
}

float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    const glm::vec3 seen = turned(camera, n);
    if (seen.z <= 0.0f) return 0.0f;
    const float bias = camera.constant_bias + least_bias(seen, camera.texel) * camera.slope_bias;
    Place place = map_place(camera, light_space(camera, p), map.size);
    place.distance = place.distance - bias;
    return pcf(map, place, radius);
}
