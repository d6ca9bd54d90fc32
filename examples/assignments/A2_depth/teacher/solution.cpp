// A2, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    const double sum = double(e_0 + e_1 + e_2);
    return {e_0 / sum, e_1 / sum, e_2 / sum};
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    return glm::dot(lambda, z);
}

bool is_nearer(float z, float stored) {
    return z < stored;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    const glm::vec3 q = lambda * inv_w;
    return q / (q.x + q.y + q.z);
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 lambda = barycentric(f.e_0, f.e_1, f.e_2);
    const float z = window_depth(lambda, f.z);
    if (!is_nearer(z, pixel.depth)) return;
    const glm::vec3 b = perspective_weights(lambda, f.inv_w);
    pixel.depth = z;
    pixel.attribute = b.x * f.a_0 + b.y * f.a_1 + b.z * f.a_2;
}
