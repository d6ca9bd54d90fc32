// Environments as sums of rays in double: what the lessons on light from images are held against.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "lighting/environment/sky.hpp"

namespace kreda::tests {

/// A direction, its solid angle and the radiance from there.
struct Ray {
    glm::dvec3 l;
    double w;
    glm::dvec3 L;
};

/// polar from +y, azimuth from +x to +z.
inline glm::dvec3 direction_of_angles(double azimuth, double polar) {
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

/// width x width / 2 rays; radiance is a function of the texel of an equirectangular image and of its direction.
inline std::vector<Ray> rays_of(int width,
                                const std::function<glm::dvec3(int x, int y, const glm::dvec3& d)>& radiance) {
    constexpr double kPi = std::numbers::pi;
    const int height = width / 2;
    std::vector<Ray> rays;
    for (int y = 0; y < height; ++y) {
        const double w = 2.0 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
        for (int x = 0; x < width; ++x) {
            const double azimuth = 2.0 * kPi * ((x + 0.5) / width - 0.5), polar = kPi * (y + 0.5) / height;
            const glm::dvec3 d = direction_of_angles(azimuth, polar);
            rays.push_back({d, w, radiance(x, y, d)});
        }
    }
    return rays;
}

inline std::vector<Ray> rays_of_sky(lighting::Sky sky, int width) {
    return rays_of(
        width, [&](int, int, const glm::dvec3& d) { return glm::dvec3(lighting::sky_radiance(sky, glm::vec3(d))); });
}

/// A spiral of equal areas.
inline std::vector<glm::dvec3> even_directions(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count;
        directions.push_back(direction_of_angles(std::numbers::pi * (3.0 - std::sqrt(5.0)) * i, std::acos(y)));
    }
    return directions;
}

/// sum of L w D (n.l) / sum of w D (n.l),  GGX's D from n.h = sqrt((1 + n.l) / 2).          Walter et al. 2007 eq. (33)
inline glm::dvec3 lobe_average(const std::vector<Ray>& rays, const glm::dvec3& n, double alpha) {
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (const Ray& ray : rays) {
        const double n_dot_l = glm::dot(n, ray.l);
        if (n_dot_l <= 0.0) continue;
        const double q = 0.5 * (1.0 + n_dot_l) * (alpha * alpha - 1.0) + 1.0;
        const double weight = ray.w * n_dot_l / (q * q);
        sum += weight * ray.L;
        total += weight;
    }
    return sum / total;
}

}  // namespace kreda::tests
