#include "tools/measure/prefilter_levels.hpp"

#include <glm/geometric.hpp>

#include "lighting/microfacet.hpp"
#include "tools/measure/cube_texels.hpp"

namespace kreda::tools {

namespace {

/// A texel as a light.
struct TexelLight {
    glm::vec3 l;
    float w;  ///< solid angle
    glm::vec3 L;
};

std::vector<TexelLight> texel_lights(const lighting::CubeMap& radiance) {
    const int size = radiance.levels[0].size;
    std::vector<TexelLight> lights;
    for_each_texel(size, [&](int face, int x, int y) {
        lights.push_back({glm::normalize(lighting::texel_direction(size, face, x, y)),
                          static_cast<float>(lighting::texel_solid_angle(size, x, y)), radiance.texel(0, face, x, y)});
    });
    return lights;
}

/// The lobe around n = v, where h lies halfway:  (n.h)^2 = (1 + n.l) / 2,  sin^2 = (1 - n.l) / 2.
glm::vec3 lobe_average(const std::vector<TexelLight>& lights, const glm::vec3& n, float alpha) {
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (const TexelLight& light : lights) {
        const float n_dot_l = glm::dot(n, light.l);
        if (n_dot_l <= 0.0f) continue;
        const float D = lighting::ggx_distribution(std::sqrt(0.5f + 0.5f * n_dot_l), 0.5f - 0.5f * n_dot_l, alpha);
        const double weight = static_cast<double>(light.w * D * n_dot_l);
        sum += weight * glm::dvec3(light.L);
        total += weight;
    }
    return glm::vec3(sum / total);
}

}  // namespace

lighting::CubeMap sampled_level(const lighting::CubeMap& radiance, float alpha, int samples, int size) {
    std::vector<glm::vec3> normals;
    for_each_texel(size,
                   [&](int face, int x, int y) { normals.push_back(lighting::texel_direction(size, face, x, y)); });
    const std::vector<glm::vec3> colors = prefiltered_radiance(radiance, normals, alpha, samples);
    lighting::CubeMap level = lighting::make_cube_map({size});
    std::size_t i = 0;
    for_each_texel(size, [&](int face, int x, int y) { level.set_texel(0, face, x, y, colors[i++]); });
    fill_border(level, 0);
    return level;
}

lighting::CubeMap exact_level(const lighting::CubeMap& radiance, float alpha, int size) {
    const std::vector<TexelLight> lights = texel_lights(radiance);
    lighting::CubeMap level = lighting::make_cube_map({size});
    for_each_texel(size, [&](int face, int x, int y) {
        const glm::vec3 n = glm::normalize(lighting::texel_direction(size, face, x, y));
        level.set_texel(0, face, x, y, lobe_average(lights, n, alpha));
    });
    fill_border(level, 0);
    return level;
}

lighting::CubeMap without_mips(lighting::CubeMap radiance) {
    radiance.levels.resize(1);
    return radiance;
}

}  // namespace kreda::tools
