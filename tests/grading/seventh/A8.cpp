// A8, by one who works in the lobe's own axes and uses the arccosine and the tangent.
#include "assignment.hpp"

namespace {

glm::vec3 mixed(const glm::vec3& a, const glm::vec3& b, float t) {
    return a + (b - a) * t;
}

glm::vec3 texel(const Environment& image, int column, int row) {
    column = (column % image.width + image.width) % image.width;
    if (row < 0) row = 0;
    if (row > image.height - 1) row = image.height - 1;
    return image.texels[std::size_t(column + image.width * row)];
}

glm::vec3 polar(float turns, float sine, float cosine) {
    const float phi = turns * 2.0f * kPi;
    return glm::vec3(std::cos(phi) * sine, std::sin(phi) * sine, cosine);
}

}  // namespace

glm::vec2 equirect_point(const glm::vec3& d) {
    const float height = std::fmin(std::fmax(d.y, -1.0f), 1.0f);
    glm::vec2 uv;
    uv.x = (std::atan2(d.z, d.x) + kPi) / (2.0f * kPi);
    uv.y = std::acos(height) / kPi;
    return uv;
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float x = uv.x * float(image.width) - 0.5f;
    const float y = uv.y * float(image.height) - 0.5f;
    const int column = int(std::floor(x));
    const int row = int(std::floor(y));
    const float right = x - std::floor(x);
    const float down = y - std::floor(y);
    const glm::vec3 upper = mixed(texel(image, column, row), texel(image, column + 1, row), right);
    const glm::vec3 lower = mixed(texel(image, column, row + 1), texel(image, column + 1, row + 1), right);
    return mixed(upper, lower, down);
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    const float radius = std::sqrt(u.y);
    return polar(u.x, radius, std::sqrt(1.0f - u.y));
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 sum(0.0f);
    for (int k = 0; k < samples; k++) {
        const glm::vec3 local = cosine_direction(hammersley(k, samples));
        const glm::vec3 l = around(n, local);
        sum += radiance(image, equirect_point(l));
    }
    return sum * (kPi / float(samples));
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float tangent2 = alpha * alpha * u.y / (1.0f - u.y);
    const float cosine = 1.0f / std::sqrt(1.0f + tangent2);
    return polar(u.x, cosine * std::sqrt(tangent2), cosine);
}

float mip_level(float density, int samples, int width) {
    const float of_sample = 1.0f / (density * float(samples));
    const float of_texel = 2.0f * kPi / (3.0f * float(width) * float(width));
    const float level = std::log2(of_sample / of_texel) / 2.0f;
    return std::fmax(level, 0.0f);
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (int k = 0; k < samples; k++) {
        const glm::vec3 h = ggx_half_vector(hammersley(k, samples), alpha);
        const glm::vec3 local = 2.0f * h.z * h - glm::vec3(0.0f, 0.0f, 1.0f);
        const float weight = local.z;
        if (weight > 0.0f) {
            const glm::vec3 l = around(n, local);
            sum += weight * radiance(image, equirect_point(l));
            weights += weight;
        }
    }
    return sum / weights;
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const glm::vec3 mirrored = -glm::reflect(v, n);
    const glm::vec3 matt = irradiance(image, n, samples) * (1.0f / kPi);
    const glm::vec3 glossy = prefiltered(image, mirrored, alpha, samples);
    return 0.5f * matt + 0.5f * glossy;
}
