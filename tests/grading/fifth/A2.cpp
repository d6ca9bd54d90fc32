// A2, solved by another hand: pointers, sums corner by corner, numerators and denominators.
#include "assignment.hpp"

namespace {

float weighted(const glm::vec3& w, float first, float second, float third) {
    return first * w.x + second * w.y + third * w.z;
}

}  // namespace

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    const double area = double(e_0) + double(e_1) + double(e_2);
    const double inverse = 1.0 / area;
    return glm::vec3(double(e_0) * inverse, double(e_1) * inverse, double(e_2) * inverse);
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    return weighted(lambda, z.x, z.y, z.z);
}

bool is_nearer(float z, float stored) {
    const float distance = stored - z;
    return distance > 0.0f;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    const float a = lambda.x * inv_w.x;
    const float b = lambda.y * inv_w.y;
    const float c = lambda.z * inv_w.z;
    const float one_over_w = a + b + c;
    return glm::vec3(a, b, c) / one_over_w;
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 screen = barycentric(f.e_0, f.e_1, f.e_2);
    const float z = window_depth(screen, f.z);
    const bool visible = is_nearer(z, pixel.depth);
    if (visible) {
        const glm::vec3 w = perspective_weights(screen, f.inv_w);
        for (int i = 0; i < 3; ++i) pixel.attribute[i] = weighted(w, f.a_0[i], f.a_1[i], f.a_2[i]);
        pixel.depth = z;
    }
}
