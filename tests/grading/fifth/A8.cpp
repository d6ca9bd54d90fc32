// A8, solved by another hand: angles, lerps, samples in helper functions.
#include "assignment.hpp"

namespace {

glm::vec3 texel(const Environment& image, int column, int row) {
    while (column < 0) column += image.width;
    while (column >= image.width) column -= image.width;
    if (row < 0) row = 0;
    if (row > image.height - 1) row = image.height - 1;
    return image.texels[column + image.width * row];
}

glm::vec3 between(const glm::vec3& a, const glm::vec3& b, float t) {
    return a + t * (b - a);
}

glm::vec3 on_sphere(float cosine, float turn) {
    const float sine = std::sqrt(std::fmax(1.0f - cosine * cosine, 0.0f));
    const float angle = turn * 2.0f * kPi;
    return glm::vec3(sine * std::cos(angle), sine * std::sin(angle), cosine);
}

glm::vec3 light_from(const Environment& image, const glm::vec3& direction) {
    return radiance(image, equirect_point(direction));
}

}  // namespace

glm::vec2 equirect_point(const glm::vec3& d) {
    const float polar = std::acos(std::fmin(std::fmax(d.y, -1.0f), 1.0f));
    const float around_y = std::atan2(d.z, d.x) + kPi;
    return glm::vec2(around_y / (2.0f * kPi), polar / kPi);
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float across = float(image.width) * uv.x - 0.5f, down = float(image.height) * uv.y - 0.5f;
    const float column = std::floor(across), row = std::floor(down);
    const float right = across - column, below = down - row;
    const int c = int(column), r = int(row);
    const glm::vec3 upper = between(texel(image, c, r), texel(image, c + 1, r), right);
    const glm::vec3 lower = between(texel(image, c, r + 1), texel(image, c + 1, r + 1), right);
    return between(upper, lower, below);
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    const float sine = std::sqrt(u.y);
    const float angle = 2.0f * kPi * u.x;
    return glm::vec3(std::cos(angle) * sine, std::sin(angle) * sine, std::sqrt(1.0f - u.y));
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 mean(0.0f);
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 local = cosine_direction(hammersley(i, samples));
        mean += light_from(image, around(n, local)) / float(samples);
    }
    return kPi * mean;
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float a2 = alpha * alpha;
    const float cosine = std::sqrt((1.0f - u.y) / (1.0f + a2 * u.y - u.y));
    return on_sphere(cosine, u.x);
}

float mip_level(float density, int samples, int width) {
    const float of_sample = 1.0f / (density * float(samples));
    const float of_texel = 4.0f * kPi / (6.0f * float(width) * float(width));
    const float level = std::log2(of_sample / of_texel) / 2.0f;
    return std::fmax(level, 0.0f);
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 sum(0.0f);
    float total = 0.0f;
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 h = around(n, ggx_half_vector(hammersley(i, samples), alpha));
        const glm::vec3 l = glm::dot(n, h) * 2.0f * h - n;
        const float weight = std::fmax(glm::dot(l, n), 0.0f);
        if (weight > 0.0f) sum += light_from(image, l) * weight;
        total += weight;
    }
    return sum / total;
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const float n_v = glm::dot(v, n);
    const glm::vec3 r = n * (2.0f * n_v) - v;
    const glm::vec3 diffuse = irradiance(image, n, samples) / kPi;
    const glm::vec3 glossy = prefiltered(image, r, alpha, samples);
    return (diffuse + glossy) / 2.0f;
}
