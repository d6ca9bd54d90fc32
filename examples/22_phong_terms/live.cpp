// live: A3 mirror_vector phong
// The matt term is there, the highlight is not: write r, equation (2), and m_S
// (v . r)^h, equation (1), on the side that faces the light. The other
// functions are given.
#include "assignment.hpp"

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    (void)n;
    return -l;
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float n_dot_l = glm::dot(n, l);
    const float cosine = n_dot_l > 0.0f ? n_dot_l : 0.0f;
    const glm::vec3 r = mirror_vector(n, l);
    const float v_dot_r = glm::dot(v, r);
    (void)v_dot_r;
    return {m.diffuse * cosine, glm::vec3(0.0f)};
}
