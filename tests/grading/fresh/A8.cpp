// A8, solved by another hand: helper functions, while loops, spherical angles.
#include "assignment.hpp"

#include <algorithm>

static glm::vec3 from_angles(float cosine, float phi) {
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    return glm::vec3(std::cos(phi) * sine, std::sin(phi) * sine, cosine);
}

static int wrapped(int x, int n) {
    while (x < 0) x += n;
    while (x >= n) x -= n;
    return x;
}

static glm::vec3 texel(const Environment& e, int x, int y) {
    const int column = wrapped(x, e.width);
    const int row = std::clamp(y, 0, e.height - 1);
    return e.texels[std::size_t(column + row * e.width)];
}

static glm::vec3 mirrored(const glm::vec3& d, const glm::vec3& axis) {
    return axis * (2.0f * glm::dot(d, axis)) - d;
}

glm::vec2 equirect_point(const glm::vec3& d) {
    glm::vec2 uv;
    uv.x = (std::atan2(d.z, d.x) + kPi) / (2.0f * kPi);
    uv.y = std::acos(std::clamp(d.y, -1.0f, 1.0f)) / kPi;
    return uv;
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float px = uv.x * image.width - 0.5f, py = uv.y * image.height - 0.5f;
    const float fx = std::floor(px), fy = std::floor(py);
    const int x = int(fx), y = int(fy);
    const float a = px - fx, b = py - fy;
    const glm::vec3 upper = texel(image, x, y) * (1.0f - a) + texel(image, x + 1, y) * a;
    const glm::vec3 lower = texel(image, x, y + 1) * (1.0f - a) + texel(image, x + 1, y + 1) * a;
    return upper * (1.0f - b) + lower * b;
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    return from_angles(std::sqrt(1.0f - u.y), 2.0f * kPi * u.x);
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 total(0.0f);
    int i = 0;
    while (i < samples) {
        const glm::vec3 local = cosine_direction(hammersley(i, samples));
        const glm::vec3 world = around(n, local);
        total += radiance(image, equirect_point(world));
        ++i;
    }
    return total * (kPi / float(samples));
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float a2 = alpha * alpha;
    const float cosine = std::sqrt((1.0f - u.y) / (1.0f - u.y + a2 * u.y));
    return from_angles(cosine, 2.0f * kPi * u.x);
}

float mip_level(float density, int samples, int width) {
    const float sample_angle = 1.0f / (density * float(samples));
    const float texel_angle = 4.0f * kPi / float(6 * width * width);
    return std::max(0.0f, 0.5f * std::log2(sample_angle / texel_angle));
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 total(0.0f);
    float weight = 0.0f;
    int i = 0;
    while (i < samples) {
        const glm::vec3 h = around(n, ggx_half_vector(hammersley(i, samples), alpha));
        const glm::vec3 l = mirrored(n, h);
        const float w = std::max(glm::dot(l, n), 0.0f);
        if (w > 0.0f) total += radiance(image, equirect_point(l)) * w;
        weight += w;
        ++i;
    }
    return total * (1.0f / weight);
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const glm::vec3 scattered = irradiance(image, n, samples) / kPi;
    const glm::vec3 glossy = prefiltered(image, mirrored(v, n), alpha, samples);
    return (scattered + glossy) / 2.0f;
}
