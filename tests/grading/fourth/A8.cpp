// A8, solved by another hand: one reader of texels, one for directions, two lerps.
#include "assignment.hpp"

namespace {

glm::vec3 texel(const Environment& image, int column, int row) {
    if (column < 0) column += image.width;
    if (column >= image.width) column -= image.width;
    if (row < 0) row = 0;
    if (row > image.height - 1) row = image.height - 1;
    return image.texels[row * image.width + column];
}

glm::vec3 from(const Environment& image, const glm::vec3& direction) {
    return radiance(image, equirect_point(direction));
}

glm::vec3 mirrored(const glm::vec3& a, const glm::vec3& axis) {
    return 2.0f * glm::dot(a, axis) * axis - a;
}

}  // namespace

glm::vec2 equirect_point(const glm::vec3& d) {
    const float height = std::fmin(std::fmax(d.y, -1.0f), 1.0f);
    const float longitude = std::atan2(d.z, d.x), latitude = std::asin(height);
    return glm::vec2(longitude / (2.0f * kPi) + 0.5f, 0.5f - latitude / kPi);
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float x = uv.x * float(image.width) - 0.5f, y = uv.y * float(image.height) - 0.5f;
    const int column = int(std::floor(x)), row = int(std::floor(y));
    const float s = x - std::floor(x), t = y - std::floor(y);
    const glm::vec3 upper = (1.0f - s) * texel(image, column, row) + s * texel(image, column + 1, row);
    const glm::vec3 lower = (1.0f - s) * texel(image, column, row + 1) + s * texel(image, column + 1, row + 1);
    return (1.0f - t) * upper + t * lower;
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    const float turn = 2.0f * kPi * u.x;
    const float height = std::sqrt(1.0f - u.y);
    const float out = std::sqrt(u.y);
    return glm::vec3(out * std::cos(turn), out * std::sin(turn), height);
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 total(0.0f);
    for (int k = 0; k < samples; ++k) {
        const glm::vec3 l = around(n, cosine_direction(hammersley(k, samples)));
        total += from(image, l);
    }
    return total * (kPi / float(samples));
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float squared = (1.0f - u.y) / (1.0f + u.y * (alpha * alpha - 1.0f));
    const float height = std::sqrt(squared);
    const float out = std::sqrt(1.0f - squared);
    const float angle = u.x * 2.0f * kPi;
    return glm::vec3(std::cos(angle) * out, std::sin(angle) * out, height);
}

float mip_level(float density, int samples, int width) {
    const float sample_size = 1.0f / (density * float(samples));
    const float texel_size = 4.0f * kPi / (6.0f * float(width) * float(width));
    return std::fmax(0.5f * std::log2(sample_size / texel_size), 0.0f);
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 total(0.0f);
    float weight = 0.0f;
    for (int k = 0; k < samples; ++k) {
        const glm::vec3 h = around(n, ggx_half_vector(hammersley(k, samples), alpha));
        const glm::vec3 l = mirrored(n, h);
        const float cosine = glm::dot(l, n);
        if (cosine > 0.0f) {
            total += from(image, l) * cosine;
            weight += cosine;
        }
    }
    return total / weight;
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const glm::vec3 matt = irradiance(image, n, samples) / kPi;
    const glm::vec3 mirror = prefiltered(image, mirrored(v, n), alpha, samples);
    return 0.5f * matt + 0.5f * mirror;
}
