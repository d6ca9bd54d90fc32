// A2 Depth and perspective. Read README.md; write the five functions; check them with `./course assignment 2`.
#include "assignment.hpp"

// The corners' shares on the screen: lambda_i = e_i / (e_0 + e_1 + e_2).
glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2) {
    (void)e_0, (void)e_1, (void)e_2;
    return glm::vec3(0.0f);  // A2: write here
}

// The window depth at the pixel.
float window_depth(const glm::vec3& lambda, const glm::vec3& z) {
    (void)lambda, (void)z;
    return 0.5f;  // A2: write here
}

// Is it drawn? Where both are as near, the first stays.
bool is_nearer(float z, float stored) {
    (void)z, (void)stored;
    return false;  // A2: write here
}

// The corners' shares on the triangle itself; they sum to 1.
glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w) {
    (void)lambda, (void)inv_w;
    return glm::vec3(0.0f);  // A2: write here
}

// Draw the fragment into the pixel if it is nearer: its depth and its attribute.
void draw_fragment(const Fragment& f, Pixel& pixel) {
    (void)f, (void)pixel;  // A2: write here
}
