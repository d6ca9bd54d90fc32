// A8 by a third hand: one texel is read by a helper that wraps, rows are mixed first, spherical angles, while loops.
#include "assignment.hpp"

namespace {

glm::vec3 texel_at(const Environment& image, int column, int row) {
    while (column < 0) column += image.width;
    while (column >= image.width) column -= image.width;
    if (row < 0) row = 0;
    if (row > image.height - 1) row = image.height - 1;
    return image.texels[static_cast<std::size_t>(row * image.width + column)];
}

glm::vec3 from_angles(float phi, float cos_theta) {
    const float sin_theta = std::sqrt(std::fmax(1.0f - cos_theta * cos_theta, 0.0f));
    return glm::vec3(std::cos(phi) * sin_theta, std::sin(phi) * sin_theta, cos_theta);
}

glm::vec3 mirrored(const glm::vec3& d, const glm::vec3& axis) {
    return 2.0f * glm::dot(axis, d) * axis - d;
}

}  // namespace

glm::vec2 equirect_point(const glm::vec3& d) {
    const float longitude = std::atan2(d.z, d.x);
    const float latitude = std::asin(std::fmin(std::fmax(d.y, -1.0f), 1.0f));
    glm::vec2 uv;
    uv.x = longitude / (2.0f * kPi) + 0.5f;
    uv.y = (kPi / 2.0f - latitude) / kPi;
    return uv;
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float column = uv.x * float(image.width) - 0.5f, row = uv.y * float(image.height) - 0.5f;
    const int c = int(std::floor(column)), r = int(std::floor(row));
    const float right = column - std::floor(column), below = row - std::floor(row);
    const glm::vec3 upper = (1.0f - right) * texel_at(image, c, r) + right * texel_at(image, c + 1, r);
    const glm::vec3 lower = (1.0f - right) * texel_at(image, c, r + 1) + right * texel_at(image, c + 1, r + 1);
    return (1.0f - below) * upper + below * lower;
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    return from_angles(2.0f * kPi * u.x, std::sqrt(1.0f - u.y));
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 mean(0.0f);
    int k = 0;
    while (k < samples) {
        const glm::vec3 direction = around(n, cosine_direction(hammersley(k, samples)));
        mean += radiance(image, equirect_point(direction)) / float(samples);
        ++k;
    }
    return kPi * mean;
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float a2 = alpha * alpha;
    const float c2 = (1.0f - u.y) / (1.0f - u.y + a2 * u.y);
    const float sine = std::sqrt(a2 * u.y / (1.0f - u.y + a2 * u.y));
    const float turn = 2.0f * kPi * u.x;
    return glm::vec3(sine * std::cos(turn), sine * std::sin(turn), std::sqrt(c2));
}

float mip_level(float density, int samples, int width) {
    const float per_sample = 1.0f / density / float(samples);
    const float per_texel = 4.0f * kPi / float(6 * width * width);
    const float levels = 0.5f * (std::log2(per_sample) - std::log2(per_texel));
    return std::fmax(levels, 0.0f);
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 light(0.0f);
    float total = 0.0f;
    int k = 0;
    while (k < samples) {
        const glm::vec3 half = around(n, ggx_half_vector(hammersley(k, samples), alpha));
        const glm::vec3 l = mirrored(n, half);
        const float weight = glm::dot(l, n);
        if (weight > 0.0f) {
            total += weight;
            light += radiance(image, equirect_point(l)) * weight;
        }
        ++k;
    }
    return light / total;
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const glm::vec3 scattered = irradiance(image, n, samples) / kPi;
    const glm::vec3 shining = prefiltered(image, mirrored(v, n), alpha, samples);
    return 0.5f * (scattered + shining);
}
