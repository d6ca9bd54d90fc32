// A5: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

enum class FogMode { none, linear, exp, exp2 };
enum class FogDistance { radial, planar };

struct Fog {
    FogMode mode = FogMode::exp;
    FogDistance distance = FogDistance::radial;
    glm::vec3 color{0.6f};  ///< c_f, linear RGB
    float start = 5.0f;     ///< linear: z_start
    float end = 30.0f;      ///< linear: z_end
    float density = 0.1f;   ///< exp, exp2: d
};

struct Eye {
    glm::vec3 position;  ///< world space
    glm::vec3 forward;   ///< unit, into the scene
};

float planar_distance(const glm::vec3& p, const Eye& eye);
float radial_distance(const glm::vec3& p, const Eye& eye);
float fog_factor(const Fog& fog, float z);
glm::vec3 mix_fog(float f, const glm::vec3& surface, const glm::vec3& fog_color);
float encode_srgb(float light);
glm::vec3 foggy_pixel(const glm::vec3& p, const glm::vec3& surface, const Fog& fog, const Eye& eye);
