// A2 by a third hand: loops over the corners, the first share is what the others leave, one nested if.
#include "assignment.hpp"

namespace {

glm::vec3 blend(const glm::vec3& share, const glm::vec3 (&value)[3]) {
    glm::vec3 sum(0.0f);
    for (int corner = 0; corner < 3; ++corner) sum += share[corner] * value[corner];
    return sum;
}

}  // namespace

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    const std::int64_t whole = e_0 + e_1 + e_2;
    const double second = double(e_1) / double(whole);
    const double third = double(e_2) / double(whole);
    const double first = 1.0 - second - third;
    return glm::vec3(float(first), float(second), float(third));
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    float depth = 0.0f;
    for (int corner = 0; corner < 3; ++corner) { depth += lambda[corner] * z[corner]; }
    return depth;
}

bool is_nearer(float z, float stored) {
    if (z >= stored) return false;
    return true;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    glm::vec3 share;
    float total = 0.0f;
    for (int corner = 0; corner < 3; ++corner) {
        share[corner] = lambda[corner] * inv_w[corner];
        total += share[corner];
    }
    for (int corner = 0; corner < 3; ++corner) share[corner] /= total;
    return share;
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 on_screen = barycentric(f.e_0, f.e_1, f.e_2);
    const float depth_here = window_depth(on_screen, f.z);
    if (is_nearer(depth_here, pixel.depth)) {
        const glm::vec3 on_triangle = perspective_weights(on_screen, f.inv_w);
        const glm::vec3 corners[3] = {f.a_0, f.a_1, f.a_2};
        pixel.attribute = blend(on_triangle, corners);
        pixel.depth = depth_here;
    }
}
