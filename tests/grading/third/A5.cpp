// A5 by a third hand: a switch with early returns, the optical depth as a step of its own, the curve in double.
#include "assignment.hpp"

namespace {

float cut(float x) {
    if (x < 0.0f) return 0.0f;
    if (x > 1.0f) return 1.0f;
    return x;
}

}  // namespace

float planar_distance(const glm::vec3& p, const Eye& eye) {
    const glm::vec3 offset = p - eye.position;
    const float ahead = offset.x * eye.forward.x + offset.y * eye.forward.y + offset.z * eye.forward.z;
    return std::fmax(ahead, 0.0f);
}

float radial_distance(const glm::vec3& p, const Eye& eye) {
    const glm::vec3 offset = p - eye.position;
    return std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
}

float fog_factor(const Fog& fog, float z) {
    const float depth = fog.density * z;
    switch (fog.mode) {
        case FogMode::none: return 1.0f;
        case FogMode::linear: return cut((fog.end - z) / (fog.end - fog.start));
        case FogMode::exp: return cut(std::exp(-depth));
        case FogMode::exp2: return cut(std::exp(-depth * depth));
    }
    return 1.0f;
}

glm::vec3 mix_fog(float f, const glm::vec3& surface, const glm::vec3& fog_color) {
    return fog_color + f * (surface - fog_color);
}

float encode_srgb(float light) {
    const double x = cut(light);
    if (x > 0.0031308) {
        return float(1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
    } else {
        return float(12.92 * x);
    }
}

glm::vec3 foggy_pixel(const glm::vec3& p, const glm::vec3& surface, const Fog& fog, const Eye& eye) {
    float z = 0.0f;
    if (fog.distance == FogDistance::radial) {
        z = radial_distance(p, eye);
    } else {
        z = planar_distance(p, eye);
    }
    glm::vec3 picture = mix_fog(fog_factor(fog, z), surface, fog.color);
    for (int channel = 0; channel < 3; ++channel) picture[channel] = encode_srgb(picture[channel]);
    return picture;
}
