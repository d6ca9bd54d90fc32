// A2, solved by another hand: indices and loops.
#include "assignment.hpp"

static float share(std::int64_t part, std::int64_t whole) {
    return float(double(part) / double(whole));
}

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    std::int64_t area = e_0;
    area += e_1;
    area += e_2;
    glm::vec3 out;
    out[0] = share(e_0, area);
    out[1] = share(e_1, area);
    out[2] = share(e_2, area);
    return out;
}

float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    float depth = 0.0f;
    for (int i = 0; i < 3; ++i) depth += lambda[i] * z[i];
    return depth;
}

bool is_nearer(float z, float stored) {
    if (z >= stored) return false;
    return true;
}

glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    float top[3], total = 0.0f;
    for (int i = 0; i < 3; ++i) {
        top[i] = lambda[i] * inv_w[i];
        total += top[i];
    }
    return {top[0] / total, top[1] / total, top[2] / total};
}

void draw_fragment(const Fragment& f, Pixel& pixel) {
    const glm::vec3 bary = barycentric(f.e_0, f.e_1, f.e_2);
    const float depth = window_depth(bary, f.z);
    if (is_nearer(depth, pixel.depth)) {
        const glm::vec3 weights = perspective_weights(bary, f.inv_w);
        glm::vec3 value(0.0f);
        value += weights[0] * f.a_0;
        value += weights[1] * f.a_1;
        value += weights[2] * f.a_2;
        pixel = Pixel{depth, value};
    }
}
