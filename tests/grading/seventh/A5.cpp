// A5, by one who writes a case for each fog and the optical depth as a number of its own.
#include "assignment.hpp"

namespace {

float cut(float x) {
    if (x < 0.0f) return 0.0f;
    if (x > 1.0f) return 1.0f;
    return x;
}

}  // namespace

float planar_distance(const glm::vec3& p, const Eye& eye) {
    const float ahead = glm::dot(eye.forward, p) - glm::dot(eye.forward, eye.position);
    return std::fmax(ahead, 0.0f);
}

float radial_distance(const glm::vec3& p, const Eye& eye) {
    const glm::vec3 ray = p - eye.position;
    return std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
}

float fog_factor(const Fog& fog, float z) {
    const float depth = fog.density * z;
    switch (fog.mode) {
        case FogMode::none: return 1.0f;
        case FogMode::linear: return cut(1.0f - (z - fog.start) / (fog.end - fog.start));
        case FogMode::exp: return cut(1.0f / std::exp(depth));
        case FogMode::exp2: return cut(std::exp(-1.0f * depth * depth));
    }
    return 1.0f;
}

glm::vec3 mix_fog(float f, const glm::vec3& surface, const glm::vec3& fog_color) {
    return fog_color + (surface - fog_color) * f;
}

float encode_srgb(float light) {
    const float x = cut(light);
    if (x > 0.0031308f) {
        const float root = std::pow(x, 5.0f / 12.0f);
        return 1.055f * root - 0.055f;
    }
    return 12.92f * x;
}

glm::vec3 foggy_pixel(const glm::vec3& p, const glm::vec3& surface, const Fog& fog, const Eye& eye) {
    float z = radial_distance(p, eye);
    if (fog.distance == FogDistance::planar) z = planar_distance(p, eye);
    glm::vec3 pixel = mix_fog(fog_factor(fog, z), surface, fog.color);
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = encode_srgb(pixel[channel]);
    return pixel;
}
