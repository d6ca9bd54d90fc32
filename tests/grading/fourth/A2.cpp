// A2, solved by another hand: loops over the corners.
#include "assignment.hpp"

namespace {

float part(std::int64_t e, double whole) {
    return float(double(e) / whole);
}

}  // namespace

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    const double whole = double(e_0) + double(e_1) + double(e_2);
    return glm::vec3(part(e_0, whole), part(e_1, whole), part(e_2, whole));
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    float depth = 0.0f;
    for (int corner = 0; corner < 3; ++corner) depth += z[corner] * lambda[corner];
    return depth;
}

bool is_nearer(float z, float stored) {
    return stored > z;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    glm::vec3 share(0.0f);
    float total = 0.0f;
    for (int corner = 0; corner < 3; ++corner) {
        share[corner] = lambda[corner] * inv_w[corner];
        total += share[corner];
    }
    for (int corner = 0; corner < 3; ++corner) share[corner] /= total;
    return share;
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 flat = barycentric(f.e_0, f.e_1, f.e_2);
    const float depth = window_depth(flat, f.z);
    if (is_nearer(depth, pixel.depth)) {
        const glm::vec3 true_share = perspective_weights(flat, f.inv_w);
        const glm::vec3 value[3] = {f.a_0, f.a_1, f.a_2};
        glm::vec3 seen(0.0f);
        for (int corner = 0; corner < 3; ++corner) seen += true_share[corner] * value[corner];
        pixel.attribute = seen;
        pixel.depth = depth;
    }
}
