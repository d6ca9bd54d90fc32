// A2, by one who multiplies by reciprocals and keeps what is drawn inside of the if.
#include "assignment.hpp"

namespace {

glm::vec3 blend(const glm::vec3& share, const Fragment& f) {
    glm::vec3 sum = f.a_0 * share.x;
    sum += f.a_1 * share.y;
    sum += f.a_2 * share.z;
    return sum;
}

}  // namespace

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    const double per_area = 1.0 / double(e_0 + e_1 + e_2);
    return glm::vec3(per_area * double(e_0), per_area * double(e_1), per_area * double(e_2));
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    float depth = 0.0f;
    for (int corner = 0; corner < 3; ++corner) depth += z[corner] * lambda[corner];
    return depth;
}

bool is_nearer(float z, float stored) {
    return stored - z > 0.0f;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    const float w = 1.0f / glm::dot(inv_w, lambda);
    return glm::vec3(lambda.x * inv_w.x * w, lambda.y * inv_w.y * w, lambda.z * inv_w.z * w);
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 on_screen = barycentric(f.e_0, f.e_1, f.e_2);
    const float depth = window_depth(on_screen, f.z);
    if (is_nearer(depth, pixel.depth)) {
        const glm::vec3 on_triangle = perspective_weights(on_screen, f.inv_w);
        pixel.attribute = blend(on_triangle, f);
        pixel.depth = depth;
    }
}
