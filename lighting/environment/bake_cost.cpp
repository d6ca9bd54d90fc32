#include "lighting/environment/bake_cost.hpp"

#include <algorithm>

namespace kreda::lighting {

namespace {

constexpr double kDirection = 25.0;    // a point of a face, made a unit vector
constexpr double kToWorld = 15.0;      // three products of vectors, added
constexpr double kCubeTap = 35.0;      // face, column, row, four weights
constexpr double kEquirectTap = 75.0;  // two arcus tangents among it
constexpr double kFourTexels = 28.0;   // four floats each
constexpr double kWeighted = 6.0;      // three channels times a weight, added
constexpr double kFacet = 110.0;       // a facet that v sees, its mirrored direction, D, G and the sum

/// A texel as a light: its direction, and radiance times solid angle.
constexpr std::uint64_t kTexelLight = 2 * sizeof(glm::vec3);

std::uint64_t texels_of(int size) {
    return std::uint64_t(kCubeFaces) * std::uint64_t(size) * std::uint64_t(size);
}

std::uint64_t bytes_of(const std::vector<int>& sizes) {
    std::uint64_t bytes = 0;
    for (const int size : sizes) bytes += 4 * sizeof(float) * texels_of(size + 2);
    return bytes;
}

}  // namespace

BakeCost cube_cost(int size, int n) {
    const auto directions = std::uint64_t(n) * std::uint64_t(n);
    return {texels_of(size) * directions, kDirection + kEquirectTap + kFourTexels + kWeighted,
            bytes_of(mip_sizes(size))};
}

BakeCost prefilter_cost(int size, const PrefilterSettings& settings) {
    const std::vector<int> sizes = prefilter_sizes(size, settings);
    BakeCost cost{0, kToWorld + 2.0 * (kCubeTap + kFourTexels) + kWeighted, bytes_of(sizes)};
    for (int level = 1; level < static_cast<int>(sizes.size()); ++level) {
        cost.count += texels_of(sizes[static_cast<std::size_t>(level)]) *
                      static_cast<std::uint64_t>(samples_of_level(settings, level));
    }
    return cost;
}

BakeCost irradiance_cost(int size, IrradianceForm form) {
    if (form == IrradianceForm::sh9) {
        const std::uint64_t texels = texels_of(std::min(size, kShSourceSize));
        return {texels, 120.0, sizeof(Sh9), texels / kCubeFaces * kTexelLight};  // face by face
    }
    const int target = IrradianceSettings{}.size;
    const double cosine_and_sum = 6.0 + kWeighted;
    const std::uint64_t texels = texels_of(std::min(size, kIrradianceSourceSize));
    return {texels_of(target) * texels, cosine_and_sum, bytes_of({target}), texels * kTexelLight};
}

BakeCost brdf_cost(std::size_t maps) {
    constexpr std::uint64_t kNodes = std::uint64_t(kBrdfMapSize) * kBrdfMapSize;
    return {maps * kNodes * std::uint64_t(kBrdfMapSamples), kFacet, maps * kNodes * 4 * sizeof(float)};
}

std::vector<double> bake_work(int size, const EnvironmentNeeds& needs, int samples) {
    return {needs.blurred ? prefilter_cost(size, prefilter_settings(needs, samples)).operations() : 0.0,
            needs.irradiance ? irradiance_cost(size, needs.form).operations() : 0.0,
            brdf_cost(needs.brdf.size()).operations()};
}

}  // namespace kreda::lighting
