#include "lighting/fresnel.hpp"

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

/// lambda such that   weight (1 - c_m)^lambda = delta,   delta = F_14(c_m) - F(c_m).
SchlickCorrection correction_through(float n, float k, float c_m, double weight) {
    const double delta = fresnel_rescaled_schlick(c_m, n, k) - fresnel_conductor(c_m, n, k);
    if (delta <= 0.0) return {};
    const double lambda = std::log(delta / weight) / std::log(1.0 - c_m);
    return {2.0f * n, static_cast<float>(lambda)};
}

}  // namespace

SchlickCorrection fit_correction(float n, float k, float c_m) {
    return correction_through(n, k, c_m, 2.0 * n * c_m);
}

SchlickCorrection fit_correction_as_printed(float n, float k, float c_m) {
    return correction_through(n, k, c_m, 2.0 * n);
}

glm::vec3 f82_coefficient_from_index(const glm::vec3& n, const glm::vec3& k) {
    const glm::vec3 f0 = f0_from_index(n, k);
    const glm::vec3 f82 = fresnel_conductor(1.0f / 7.0f, n, k);
    return {f82_coefficient(f0.x, f82.x), f82_coefficient(f0.y, f82.y), f82_coefficient(f0.z, f82.z)};
}

FresnelTable tabulate(const FresnelFunction& fresnel, int size) {
    KREDA_EXPECT(size >= 2);
    FresnelTable table;
    for (int i = 0; i < size; ++i) {
        const glm::vec3 F = fresnel(static_cast<float>(i) / static_cast<float>(size - 1));
        table.r.push_back(F.x);
        table.g.push_back(F.y);
        table.b.push_back(F.z);
    }
    return table;
}

FresnelTable fresnel_table(const glm::vec3& n, const glm::vec3& k, int size) {
    return tabulate([&](float c) { return fresnel_conductor(c, n, k); }, size);
}

}  // namespace kreda::lighting
