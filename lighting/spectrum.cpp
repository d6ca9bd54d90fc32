#include "lighting/spectrum.hpp"

#include <algorithm>

#include <glm/mat3x3.hpp>

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using glm::dvec3;

/// Linear sRGB from XYZ, white D65.                                                       IEC 61966-2-1; B. Lindbloom
dvec3 srgb_from_xyz(const dvec3& xyz) {
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// What the observer sees of one wavelength of D65.
dvec3 weight(const ObserverSample& s) {
    return dvec3(s.x_bar, s.y_bar, s.z_bar) * s.d65;
}

/// Sums of reflected and of all light over some wavelengths, channel by channel.
struct ColorSum {
    dvec3 reflected{0.0};
    dvec3 white{0.0};

    void add(const ObserverSample& s, double reflectance) {
        reflected += weight(s) * reflectance;
        white += weight(s);
    }
    [[nodiscard]] glm::vec3 color() const {
        return glm::vec3(srgb_from_xyz(reflected) / srgb_from_xyz(white));
    }
};

double between(double a, double b, double t) {
    return (1.0 - t) * a + t * b;
}

/// The observer at any wavelength: linear between the samples.
ObserverSample observer_at(double wavelength) {
    const auto samples = observer_samples();
    const double position = std::clamp((wavelength - 400.0) / 10.0, 0.0, 30.0);
    const auto i = std::min(static_cast<std::size_t>(position), samples.size() - 2);
    const double t = position - static_cast<double>(i);
    const ObserverSample& a = samples[i];
    const ObserverSample& b = samples[i + 1];
    return {wavelength, between(a.x_bar, b.x_bar, t), between(a.y_bar, b.y_bar, t), between(a.z_bar, b.z_bar, t),
            between(a.d65, b.d65, t)};
}

float fresnel_at(const MeasuredMaterial& material, float c, double wavelength) {
    const IndexSample index = index_at(material, wavelength);
    return fresnel_conductor(c, static_cast<float>(index.n), static_cast<float>(index.k));
}

SpectralColors colors_of(const FresnelFunction& fresnel) {
    const glm::vec3 f0 = fresnel(1.0f);
    const glm::vec3 f82 = fresnel(1.0f / 7.0f);
    const glm::vec3 b{f82_coefficient(f0.x, f82.x), f82_coefficient(f0.y, f82.y), f82_coefficient(f0.z, f82.z)};
    return {f0, f82, b};
}

}  // namespace

const MeasuredMaterial* find_measured(std::string_view name) {
    const auto materials = measured_materials();
    const auto found =
        std::find_if(materials.begin(), materials.end(), [name](const MeasuredMaterial& m) { return m.name == name; });
    return found == materials.end() ? nullptr : &*found;
}

IndexSample index_at(const MeasuredMaterial& material, double wavelength) {
    const auto samples = material.samples;
    const auto right = std::find_if(samples.begin(), samples.end(),
                                    [wavelength](const IndexSample& s) { return s.wavelength >= wavelength; });
    if (right == samples.begin()) return {wavelength, right->n, right->k};
    const auto left = right - 1;
    if (right == samples.end()) return {wavelength, left->n, left->k};
    const double t = (wavelength - left->wavelength) / (right->wavelength - left->wavelength);
    return {wavelength, between(left->n, right->n, t), between(left->k, right->k, t)};
}

ThreeChannelIndex three_channel_index(const MeasuredMaterial& material) {
    ThreeChannelIndex index;
    for (int channel = 0; channel < 3; ++channel) {
        const IndexSample sample = index_at(material, kChannelWavelengths[static_cast<std::size_t>(channel)]);
        index.n[channel] = static_cast<float>(sample.n);
        index.k[channel] = static_cast<float>(sample.k);
    }
    return index;
}

ThreeChannelIndex published_index(std::string_view name) {
    if (name == "gold") return {{0.23f, 0.57f, 1.39f}, {3.94f, 2.18f, 1.72f}};
    if (name == "platinum") return {{2.49f, 2.04f, 1.9f}, {4.44f, 3.63f, 3.28f}};
    if (name == "water") return {{1.331f, 1.3336f, 1.336f}, glm::vec3(0.0f)};
    if (name == "diamond") return {{2.41f, 2.42f, 2.43f}, glm::vec3(0.0f)};
    KREDA_EXPECT(name == "a material of table 1");
    return {};
}

glm::vec3 linear_srgb_from_spectrum(const Spectrum& reflectance) {
    ColorSum sum;
    const auto samples = observer_samples();
    for (std::size_t i = 0; i < samples.size(); ++i) sum.add(samples[i], reflectance[i]);
    return sum.color();
}

Spectrum fresnel_spectrum(const MeasuredMaterial& material, float c) {
    Spectrum F{};
    const auto samples = observer_samples();
    for (std::size_t i = 0; i < samples.size(); ++i) F[i] = fresnel_at(material, c, samples[i].wavelength);
    return F;
}

glm::vec3 spectral_fresnel(const MeasuredMaterial& material, float c) {
    return linear_srgb_from_spectrum(fresnel_spectrum(material, c));
}

glm::vec3 spectral_fresnel_of_few(const MeasuredMaterial& material, float c, int count) {
    KREDA_EXPECT(count >= 1);
    ColorSum sum;
    for (int i = 0; i < count; ++i) {
        const double wavelength = 400.0 + 300.0 * (i + 0.5) / count;
        sum.add(observer_at(wavelength), fresnel_at(material, c, wavelength));
    }
    return sum.color();
}

SpectralIndex spectral_index(const MeasuredMaterial& material, float outside_ior) {
    SpectralIndex index;
    dvec3 white(0.0);
    const auto samples = observer_samples();
    for (const ObserverSample& s : samples) white += weight(s);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const IndexSample inside = index_at(material, samples[i].wavelength);
        index.n[i] = static_cast<float>(inside.n / outside_ior);
        index.k[i] = static_cast<float>(inside.k / outside_ior);
        index.color[i] = glm::vec3(srgb_from_xyz(weight(samples[i])) / srgb_from_xyz(white));
    }
    return index;
}

glm::vec3 spectral_fresnel(float c, const SpectralIndex& index) {
    glm::vec3 F(0.0f);
    for (std::size_t i = 0; i < index.n.size(); ++i) { F += reflected_at(c, index.color[i], index.n[i], index.k[i]); }
    return F;
}

SpectralColors spectral_colors(const MeasuredMaterial& material) {
    return colors_of([&](float c) { return spectral_fresnel(material, c); });
}

SpectralColors spectral_colors(const SpectralIndex& index) {
    return colors_of([&](float c) { return spectral_fresnel(c, index); });
}

FresnelTable spectral_fresnel_table(const MeasuredMaterial& material, int size) {
    return tabulate([&](float c) { return spectral_fresnel(material, c); }, size);
}

FresnelTable spectral_fresnel_table(const SpectralIndex& index, int size) {
    return tabulate([&](float c) { return spectral_fresnel(c, index); }, size);
}

}  // namespace kreda::lighting
