// A8: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

const float kPi = 3.14159265f;

/// An equirectangular picture of all that is around: radiance, row by row from the top (+y).
struct Environment {
    int width, height;
    std::vector<glm::vec3> texels;
};

/// Point i of n, spread evenly over the unit square. Hammersley 1960, done for you.
inline glm::vec2 hammersley(int i, int n) {
    std::uint32_t bits = static_cast<std::uint32_t>(i), mirrored = 0;
    for (int b = 0; b < 32; ++b, bits >>= 1) mirrored = mirrored << 1 | (bits & 1u);
    return {(float(i) + 0.5f) / float(n), float(mirrored >> 8) / 16777216.0f + 0.5f / float(n)};
}

/// A direction d that is given around +z, turned so that +z becomes n. Duff et al. 2017, done for you.
inline glm::vec3 around(const glm::vec3& n, const glm::vec3& d) {
    const float sign = n.z < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (sign + n.z), b = n.x * n.y * a;
    const glm::vec3 t{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, s{b, sign + n.y * n.y * a, -n.y};
    return t * d.x + s * d.y + n * d.z;
}

glm::vec2 equirect_point(const glm::vec3& d);
glm::vec3 radiance(const Environment& image, const glm::vec2& uv);
glm::vec3 cosine_direction(const glm::vec2& u);
glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples);
glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha);
float mip_level(float density, int samples, int width);
glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples);
glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples);
