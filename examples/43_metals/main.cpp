// 43_metals: gold, silver, copper, aluminium, platinum as measured: the whole spectrum against three wavelengths.
// Page docs/43_metals.md | After 42_cook_torrance | New: MeasuredMaterial, spectral_fresnel(), three_channel_index()
// Break at: spectral_fresnel | Look at: index.n, index.k, index.color, F | Try: "gold_hagemann", kRoughness 0.6
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <glm/common.hpp>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "lighting/spectrum.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;
using lighting::FresnelMethod;
using lighting::SpectrumUse;

namespace {

constexpr std::array<const char*, 5> kMetals = {"gold", "silver", "copper", "aluminium", "platinum"};
constexpr float kRoughness = 0.38f;  // rough enough to blur 250 lamps into a studio
constexpr float kExposure = 0.62f;

/// The five metals in a row, each exact at every angle, from the whole spectrum or from 685, 535 and 475 nm.
scene::Scene metals(glm::ivec2 size, SpectrumUse spectrum) {
    scene::Scene scene = empty_scene(size);
    scene.image.samples = 2;
    scene.ambient = glm::vec3(0.0f);
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 2.5f;
    for (std::size_t i = 0; i < kMetals.size(); ++i) {
        lighting::Material metal = microfacet(glm::vec3(1.0f), 1.0f, kRoughness);
        metal.cook_torrance.measured = kMetals[i];
        metal.cook_torrance.spectrum = spectrum;
        metal.cook_torrance.fresnel = FresnelMethod::exact;
        metal.cook_torrance.energy_compensation = lighting::EnergyCompensation::kulla_conty;
        add_shape(scene, "sphere", 96, {2.2f * (static_cast<float>(i) - 2.0f) + 1.1f, 0.0f, 0.0f}, metal);
    }
    scene.lights = lights_all_around(250, studio);
    return scene;
}

/// F0 of each metal as a flat colour: the left half from the whole spectrum, the right half from three wavelengths.
Panel swatches(glm::ivec2 size, int picture_height) {
    Panel panel = drawing_panel(size);
    const int scale = text_scale(picture_height), step = size.x / 5, top = 14 * scale;
    for (int i = 0; i < 5; ++i) {
        const lighting::MeasuredMaterial& metal = *lighting::find_measured(kMetals[static_cast<std::size_t>(i)]);
        const int left = i * step + step / 10, half = step * 2 / 5, height = size.y - top - 4 * scale;
        panel.pictures.push_back({left, top, 2 * half, height});
        fill_rectangle(panel.image, left, top, half, height, lighting::spectral_fresnel(metal, 1.0f));
        const lighting::ThreeChannelIndex three = lighting::three_channel_index(metal);
        fill_rectangle(panel.image, left + half, top, half, height, lighting::f0_from_index(three.n, three.k));
        const glm::vec2 start(left, 11 * scale);
        panel.labels.push_back({start, std::string(metal.name), kChalk, caption_size(picture_height)});
    }
    return panel;
}

/// Reflectance over the wavelength; dots where the three wavelengths lie.
Plot spectra_plot() {
    Plot plot = empty_plot("wavelength [nm]", "$F$ at 0 degrees");
    plot.x_range = {400.0, 700.0};
    plot.y_range = {0.2, 1.0};
    plot.key = "inside right bottom";
    for (std::size_t i = 0; i < kMetals.size(); ++i) {
        const lighting::MeasuredMaterial& metal = *lighting::find_measured(kMetals[i]);
        const auto reflectance = [&](double wavelength) {
            const lighting::IndexSample index = lighting::index_at(metal, wavelength);
            return lighting::f0_from_index(static_cast<float>(index.n), static_cast<float>(index.k));
        };
        plot.series.push_back(curve(kMetals[i], *plot.x_range, reflectance));
        Series three{"", {}, static_cast<int>(i) + 1, {}, false};
        for (const double wavelength : lighting::kChannelWavelengths) {
            three.points.push_back({wavelength, reflectance(wavelength)});
        }
        plot.series.push_back(three);
        plot.series[plot.series.size() - 2].style = three.style;
    }
    return plot;
}

double error_percent(const glm::vec3& color, const glm::vec3& exact) {
    const glm::vec3 error = glm::abs(color - exact) / exact;
    return 100.0 * (error.x + error.y + error.z) / 3.0;
}

/// The colours at 0 degrees, and the error of three wavelengths there and over all angles.
void print_colors() {
    std::printf("Colours at 0 degrees, linear sRGB, and the mean relative error of three wavelengths in percent\n");
    std::printf("%-10s %-22s %-22s %10s %12s   %s\n", "", "whole spectrum", "685, 535, 475 nm", "at 0 deg",
                "all angles", "published");
    const char* published[] = {"8.58", "1.31", "-", "0.30", "1.92"};
    for (std::size_t i = 0; i < kMetals.size(); ++i) {
        const lighting::MeasuredMaterial& metal = *lighting::find_measured(kMetals[i]);
        const lighting::ThreeChannelIndex index = lighting::three_channel_index(metal);
        const glm::vec3 exact = lighting::spectral_fresnel(metal, 1.0f),
                        three = lighting::f0_from_index(index.n, index.k);
        double all = 0.0;
        for (int a = 0; a < 90; ++a) {
            const float c = static_cast<float>(std::cos((a + 0.5) * std::numbers::pi / 180.0));
            all +=
                error_percent(lighting::fresnel_conductor(c, index.n, index.k), lighting::spectral_fresnel(metal, c)) /
                90.0;
        }
        std::printf("%-10s %6.4f %6.4f %6.4f   %6.4f %6.4f %6.4f   %10.2f %12.2f   %s\n", kMetals[i], exact.x, exact.y,
                    exact.z, three.x, three.y, three.z, error_percent(three, exact), all, published[i]);
    }
}

void draw(const Options& options) {
    const glm::ivec2 row = panel_size(options.width, options.height, 1, 3);
    Image full = render_outlined(options, metals(row, SpectrumUse::full));
    Image three = render_outlined(options, metals(row, SpectrumUse::three));
    for (Image* image : {&full, &three}) {
        for (float& value : image->values) value *= kExposure;
    }
    save_panels(options, "metals", 1, {swatches(row, options.height), {full, "spectrum"}, {three, "three"}});
    save_plot(options, "spectra", "", spectra_plot());
    print_colors();
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "43_metals", draw);
}
