// live: A3 phong
// A matt surface: m_D (l . n). Behind the light the cosine is negative, and
// the surface takes light away: the lamps of the other side go dark. Clip it,
// equation (1). The highlight is left to lesson 22; the other functions are
// given.
#include "assignment.hpp"

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    (void)v;
    const float cosine = glm::dot(n, l);
    return {m.diffuse * cosine, glm::vec3(0.0f)};
}
