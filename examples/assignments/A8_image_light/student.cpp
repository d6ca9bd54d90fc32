// A8 Light from an image. Read README.md; write the eight functions; check them with `./course assignment 8`.
#include "assignment.hpp"

// Where the unit direction d lies in the picture, u and v in 0..1 from its left and top.
glm::vec2 equirect_point(const glm::vec3& d) {
    (void)d;
    return glm::vec2(0.0f);  // A8: write here
}

// Bilinear between the middles of texels; the picture goes on round its left and right edge, and ends at top and
// bottom.
glm::vec3 radiance(const Environment& image, const glm::vec2& uv) {
    (void)image, (void)uv;
    return glm::vec3(0.0f);  // A8: write here
}

// Around +z, density cos / pi: cos = sqrt(1 - u.y), turned by u.x full turns from +x towards +y.
glm::vec3 cosine_direction(const glm::vec2& u) {
    (void)u;
    return glm::vec3(0.0f);  // A8: write here
}

// What falls on a plane: pi / N times the sum of the radiance from `samples` cosine-weighted directions.
glm::vec3 irradiance(const Environment& image, const glm::vec3& n, int samples) {
    (void)image, (void)n, (void)samples;
    return glm::vec3(0.0f);  // A8: write here
}

// Around +z, density D (n.h) of GGX: cos^2 = (1 - u.y) / (1 + (alpha^2 - 1) u.y), turned by u.x.
glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    (void)u, (void)alpha;
    return glm::vec3(0.0f);  // A8: write here
}

// The level of a cube map of `width` texels a side whose texels are as large as a sample: log2(w_s / w_p) / 2 with
// w_s = 1 / (N density), w_p = 4 pi / (6 width^2); at least 0.
float mip_level(float density, int samples, int width) {
    (void)density, (void)samples, (void)width;
    return -1.0f;  // A8: write here
}

// The picture blurred for roughness, seen along n: each half vector mirrors n to l; sum L (n.l) / sum (n.l), l above.
glm::vec3 prefiltered(const Environment& image, const glm::vec3& n, float alpha, int samples) {
    (void)image, (void)n, (void)alpha, (void)samples;
    return glm::vec3(0.0f);  // A8: write here
}

// 0.5 E / pi, and 0.5 of the blurred picture along v mirrored in n. n, v: unit.
glm::vec3 shade(const Environment& image, const glm::vec3& n, const glm::vec3& v, float alpha, int samples) {
    (void)image, (void)n, (void)v, (void)alpha, (void)samples;
    return glm::vec3(0.0f);  // A8: write here
}
