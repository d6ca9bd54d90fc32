// Built-in environments: radiance as a formula of the direction, for scenes that come without a file.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// The skies that need no file.
enum class Sky { studio, sunset, gradient };

/// Earth below, sky above, a soft sun of 20 (half width 4.2 degrees) at (0.4, 0.8, 0.3).   d unit.
///   L = mix(earth, sky, (d.y + 1) / 2) + 20 (d.sun)^256
inline glm::vec3 gradient_sky(const glm::vec3& d) {
    const float t = 0.5f * d.y + 0.5f;
    const float cosine = raster::saturate((0.4f * d.x + 0.8f * d.y + 0.3f * d.z) * 1.05999788f);  // 1 / |(.4, .8, .3)|
    float lobe = cosine;
    for (int i = 0; i < 8; ++i) lobe *= lobe;
    return glm::vec3(0.3f, 0.25f, 0.2f) * (1.0f - t) + glm::vec3(0.4f, 0.6f, 1.0f) * t + glm::vec3(20.0f * lobe);
}

/// 0 below `from`, 1 above `to`, smooth between.
inline float smooth_step(float from, float to, float x) {
    return raster::smooth_ramp(raster::saturate((x - from) / (to - from)));
}

/// 1 inside a rectangle of half widths `half` around the axis `center`, as seen from the middle; soft edges.
inline float soft_box(const glm::vec3& d, const glm::vec3& center, const glm::vec3& right, const glm::vec3& up,
                      float half_width, float half_height) {
    constexpr float kEdge = 0.04f;
    const float along = glm::dot(d, center);
    const float x = glm::dot(d, right) / (along > 0.05f ? along : 0.05f);
    const float y = glm::dot(d, up) / (along > 0.05f ? along : 0.05f);
    const float inside_x = 1.0f - smooth_step(half_width - kEdge, half_width + kEdge, x < 0.0f ? -x : x);
    const float inside_y = 1.0f - smooth_step(half_height - kEdge, half_height + kEdge, y < 0.0f ? -y : y);
    return smooth_step(0.05f, 0.15f, along) * inside_x * inside_y;
}

/// A dark room: a key light at the upper left, a fill at the right, a strip behind, a light floor. The viewer looks
/// down -z, so the key stands at +z: behind the camera.   d unit.
inline glm::vec3 studio_sky(const glm::vec3& d) {
    const float floor = smooth_step(0.1f, -0.6f, d.y);
    glm::vec3 radiance = glm::vec3(0.06f, 0.065f, 0.075f) + glm::vec3(0.16f, 0.15f, 0.14f) * floor;
    const float key = soft_box(d, {-0.57207754f, 0.57207754f, 0.58777855f}, {0.71658188f, 0.0f, 0.69750300f},
                               {0.39902518f, 0.82021287f, -0.40993973f}, 0.5f, 0.35f);
    const float fill = soft_box(d, {0.93632918f, 0.28089875f, 0.21067407f}, {0.21951221f, 0.0f, -0.97560976f},
                                {-0.27404749f, 0.95973597f, -0.06166068f}, 0.3f, 0.6f);
    const float strip = soft_box(d, {0.0f, 0.31622777f, -0.94868330f}, {1.0f, 0.0f, 0.0f},
                                 {0.0f, 0.94868330f, 0.31622777f}, 0.9f, 0.12f);
    radiance +=
        glm::vec3(9.0f, 8.6f, 8.0f) * key + glm::vec3(1.6f, 1.9f, 2.4f) * fill + glm::vec3(5.0f, 5.0f, 5.2f) * strip;
    return radiance;
}

/// A low red sun at -z, its glow along the horizon, blue above, dark ground.   d unit.
inline glm::vec3 sunset_sky(const glm::vec3& d) {
    const float height = d.y > 0.0f ? d.y : 0.0f;
    const float near_horizon = raster::exp(-5.0f * height);
    const float cosine = raster::saturate(0.2f * d.x + 0.09950372f * d.y - 0.97472f * d.z);
    const float cosine2 = cosine * cosine, cosine4 = cosine2 * cosine2, cosine8 = cosine4 * cosine4;
    const float sun = smooth_step(0.99862953f, 0.99939083f, cosine);  // 3 to 2 degrees
    const glm::vec3 above =
        glm::vec3(0.10f, 0.16f, 0.36f) * (1.0f - near_horizon) + glm::vec3(0.75f, 0.36f, 0.20f) * near_horizon;
    const glm::vec3 glow = glm::vec3(1.6f, 0.62f, 0.16f) * (cosine8 * near_horizon);
    const glm::vec3 ground = glm::vec3(0.055f, 0.045f, 0.04f) + glm::vec3(0.12f, 0.05f, 0.02f) * cosine4;
    const float is_sky = smooth_step(-0.01f, 0.01f, d.y);
    return ground * (1.0f - is_sky) + (above + glow + glm::vec3(260.0f, 110.0f, 32.0f) * sun) * is_sky;
}

/// Radiance of a built-in sky in the unit direction d, linear RGB.
inline glm::vec3 sky_radiance(Sky sky, const glm::vec3& d) {
    switch (sky) {
        case Sky::studio: return studio_sky(d);
        case Sky::sunset: return sunset_sky(d);
        case Sky::gradient: return gradient_sky(d);
    }
    return glm::vec3(0.0f);
}

}  // namespace kreda::lighting
