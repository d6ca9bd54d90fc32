// A7 Shadow map. Read README.md; write the six functions; check them with `./course assignment 7`.
#include "assignment.hpp"

// p in the light's axes: to the right, up, backward; from its origin.
glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p) {
    (void)camera, (void)p;
    return glm::vec3(0.0f);  // A7: write here
}

// The place in the picture of a point q of the light's space. The picture is size x size texels around the origin.
Place map_place(const LightCamera& camera, const glm::vec3& q, int size) {
    (void)camera, (void)q, (void)size;
    return {0.0f, 0.0f, 0.0f};  // A7: write here
}

// The least bias without acne: B = (|z_u| + |z_v|) / 2, where z_u = texel_x n_x / n_z and z_v = texel_y n_y / n_z are
// what the distance changes by from texel to texel. n_view: the unit normal in the light's space, n_z > 0.
float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    (void)n_view, (void)texel;
    return 0.0f;  // A7: write here
}

// 1 if nothing in this texel is nearer to the light than `distance`, else 0. Outside of the picture everything is lit.
float is_lit(const ShadowMap& map, int column, int row, float distance) {
    (void)map, (void)column, (void)row, (void)distance;
    return 0.0f;  // A7: write here
}

// The share of the (2 radius + 1)^2 texels around the place that are lit.
float pcf(const ShadowMap& map, const Place& place, int radius) {
    (void)map, (void)place, (void)radius;
    return 0.0f;  // A7: write here
}

// The whole of it, 0 in shadow to 1 lit: the distance less constant_bias and slope_bias x least_bias, in the map.
// n: unit, world space. A surface that turns away from the light (or lies along it) is in shadow.
float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius) {
    (void)camera, (void)map, (void)p, (void)n, (void)radius;
    return 0.5f;  // A7: write here
}
