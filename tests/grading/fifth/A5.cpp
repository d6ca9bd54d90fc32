// A5, solved by another hand: the exponent first, one return, fog in double.
#include "assignment.hpp"

namespace {

double clamped(double x, double low, double high) {
    return x < low ? low : (x > high ? high : x);
}

}  // namespace

float planar_distance(const glm::vec3& p, const Eye& eye) {
    const float along = glm::dot(p, eye.forward) - glm::dot(eye.position, eye.forward);
    if (along < 0.0f) return 0.0f;
    return along;
}

float radial_distance(const glm::vec3& p, const Eye& eye) {
    return std::hypot(p.x - eye.position.x, p.y - eye.position.y, p.z - eye.position.z);
}

float fog_factor(const Fog& fog, float z) {
    double visible = 1.0;
    if (fog.mode == FogMode::linear) {
        const double range = double(fog.end) - double(fog.start);
        visible = 1.0 - (double(z) - fog.start) / range;
    } else if (fog.mode != FogMode::none) {
        double exponent = double(fog.density) * z;
        if (fog.mode == FogMode::exp2) exponent = exponent * exponent;
        visible = 1.0 / std::exp(exponent);
    }
    return float(clamped(visible, 0.0, 1.0));
}

glm::vec3 mix_fog(float f, const glm::vec3& surface, const glm::vec3& fog_color) {
    const float veil = 1.0f - f;
    glm::vec3 c;
    for (int k = 0; k < 3; ++k) c[k] = surface[k] * f + fog_color[k] * veil;
    return c;
}

float encode_srgb(float light) {
    const double x = clamped(light, 0.0, 1.0);
    const bool dark = x <= 0.0031308;
    return float(dark ? x * 12.92 : std::exp(std::log(x) / 2.4) * 1.055 - 0.055);
}

glm::vec3 foggy_pixel(const glm::vec3& p, const glm::vec3& surface, const Fog& fog, const Eye& eye) {
    const float z = fog.distance == FogDistance::radial ? radial_distance(p, eye) : planar_distance(p, eye);
    const glm::vec3 light = mix_fog(fog_factor(fog, z), surface, fog.color);
    return glm::vec3(encode_srgb(light.x), encode_srgb(light.y), encode_srgb(light.z));
}
