// live: A3 phong
// A matt surface: m_D (l . n). Behind the light the cosine is negative, and
// the surface takes light away: the lamps of the other side go dark. Clip it,
// equation (1). The highlight is right as it stands: lesson 22 is about it. The
// other functions are given.
#include "assignment.hpp"

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float n_dot_l = glm::dot(n, l);
    const float cosine = n_dot_l;
    const float v_dot_r = glm::dot(v, mirror_vector(n, l));
    const bool shines = n_dot_l > 0.0f && v_dot_r > 0.0f;
    return {m.diffuse * cosine, shines ? m.specular * std::pow(v_dot_r, m.shininess) : glm::vec3(0.0f)};
}
