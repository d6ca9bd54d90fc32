// A2: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

/// A triangle over a pixel.
struct Fragment {
    std::int64_t e_0, e_1, e_2;  ///< its edge functions at the pixel's centre; e_0 belongs to corner 0 (page 10)
    glm::vec3 z;                 ///< window depth of its corners, 0 near .. 1 far
    glm::vec3 inv_w;             ///< 1/w of its corners
    glm::vec3 a_0, a_1, a_2;     ///< an attribute (say, a place or a colour) of its corners
};

/// What a pixel shows so far: at first the depth 1 and no attribute.
struct Pixel {
    float depth;
    glm::vec3 attribute;
};

glm::vec3 barycentric(std::int64_t e_0, std::int64_t e_1, std::int64_t e_2);
float window_depth(const glm::vec3& lambda, const glm::vec3& z);
bool is_nearer(float z, float stored);
glm::vec3 perspective_weights(const glm::vec3& lambda, const glm::vec3& inv_w);
void draw_fragment(const Fragment& f, Pixel& pixel);
