// Experiments on how light is reflected: where it is computed, by which model, and what microfacets lose.
#include <algorithm>
#include <cmath>

#include "lighting/energy.hpp"
#include "lighting/microfacet_choices.hpp"
#include "lighting/reflection.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/frequency_error.hpp"
#include "tools/measure/paired_times.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

namespace {

/// The ball of frequency_error.hpp, lit at every sample, with other values.
scene::Scene ball_with(lighting::ReflectionModel model, float shininess) {
    scene::Scene scene = shiny_ball(2, 64, {640, 640});
    scene.materials[0].model = model;
    scene.materials[0].phong.shininess = shininess;
    return scene;
}

}  // namespace

Finding measure_frequency(const Effort& effort) {
    Finding finding{{{"frequency", "detail", "triangles", "mean error [codes]", "99th percentile", "time [ms]"}, {}},
                    {"triangles", "mean error [codes]", true, true, {}, true},
                    ""};
    const raster::Image exact = finest_ball({320, 320}, effort.threads);
    std::array<double, 3> at_32{}, ms_at_32{};
    std::array<int, 3> needed{};  // the first detail within half a code
    for (std::size_t f = 0; f < kFrequencyNames.size(); ++f) {
        finding.plot.series.push_back({kFrequencyNames[f], {}});
        for (const FrequencyRow& row :
             measure_frequency_rows(f, {8, 16, 32, 64, 128, 256}, exact, effort.count(5, 21), effort.threads)) {
            finding.table.add({kFrequencyNames[f], std::to_string(row.detail), std::to_string(row.triangles),
                               digits(row.error.mean), digits(row.error.p99), digits(row.ms)});
            finding.plot.series.back().points.emplace_back(static_cast<double>(row.triangles), row.error.mean);
            if (row.detail == 32) at_32[f] = row.error.mean;
            if (row.detail == 32) ms_at_32[f] = row.ms;
            if (needed[f] == 0 && row.error.mean <= 0.5) needed[f] = row.detail;
        }
        effort.show(static_cast<double>(f + 1) / 3.0);
    }
    const auto detail_text = [](int n) { return n == 0 ? std::string("more than 256") : std::to_string(n); };
    finding.text = "A shiny ball against Phong shading of half a million triangles. At detail 32 flat shading misses " +
                   fixed(at_32[0], 2) + " codes in the mean, Gouraud " + fixed(at_32[1], 2) + ", Phong " +
                   fixed(at_32[2], 2) + "; they take " + fixed(ms_at_32[0], 2) + ", " + fixed(ms_at_32[1], 2) +
                   " and " + fixed(ms_at_32[2], 2) + " ms. Half a code needs detail " + detail_text(needed[0]) + ", " +
                   detail_text(needed[1]) + " and " + detail_text(needed[2]) + ".";
    return finding;
}

namespace {

/// Mean |Phong - Blinn| over all v of the hemisphere, relative to the mean of Phong's: l at `incidence` degrees.
double model_difference(float h, float h_blinn, double incidence, int steps) {
    const double angle = incidence * 3.14159265358979 / 180.0;
    const glm::vec3 n(0.0f, 0.0f, 1.0f);
    const glm::vec3 l(static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle)));
    const glm::vec3 r = lighting::mirror_vector(n, l);
    double difference = 0.0, sum = 0.0;
    for (int j = 0; j < steps; ++j) {
        const double z = (j + 0.5) / steps, s = std::sqrt(1.0 - z * z);  // equal areas
        for (int i = 0; i < 2 * steps; ++i) {
            const double phi = 3.14159265358979 * (i + 0.5) / steps;
            const glm::vec3 v(static_cast<float>(s * std::cos(phi)), static_cast<float>(s * std::sin(phi)),
                              static_cast<float>(z));
            const double phong = std::pow(double{lighting::sigma_phong(v, r)}, double{h});
            const double blinn =
                std::pow(double{lighting::sigma_blinn(n, lighting::half_vector(l, v))}, double{h_blinn});
            difference += std::abs(phong - blinn);
            sum += phong;
        }
    }
    return difference / sum;
}

}  // namespace

Finding measure_phong_blinn(const Effort& effort) {
    Finding finding{{{"exponent of Phong", "incidence [degrees]", "difference [%]"}, {}},
                    {"incidence [degrees]", "mean difference, share of Phong's mean [%]", false, false, {}, true},
                    ""};
    const std::vector<int> incidences = {0, 15, 30, 45, 60, 75};
    std::vector<double> at_32;
    for (const float h : {4.0f, 8.0f, 16.0f, 32.0f, 64.0f, 128.0f}) {
        finding.plot.series.push_back({"h = " + digits(double{h}), {}});
        for (const int incidence : incidences) {
            const double percent = 100.0 * model_difference(h, lighting::blinn_exponent_matching_phong(h), incidence,
                                                            effort.count(120, 400));
            finding.table.add({digits(double{h}), std::to_string(incidence), digits(percent)});
            finding.plot.series.back().points.emplace_back(incidence, percent);
            if (h == 32.0f) at_32.push_back(percent);
        }
        effort.show(static_cast<double>(finding.plot.series.size()) / 6.0);
    }
    const scene::Scene phong = ball_with(lighting::ReflectionModel::phong, 32.0f);
    const scene::Scene blinn = ball_with(lighting::ReflectionModel::blinn_phong, 128.0f);
    scene::RenderBuffers a, b;
    const std::vector<PairedTime> times = paired_times(
        {[&] { (void)draw_picture(phong, a, effort.threads); }, [&] { (void)draw_picture(blinn, b, effort.threads); }},
        effort.count(21, 81));
    finding.text =
        "With exponent 4h the highlights agree where the light comes from above and part with its angle: at h = 32 "
        "they differ by " +
        fixed(at_32.front(), 1) + " % at 0 degrees, " + fixed(at_32[3], 1) + " % at 45 and " + fixed(at_32.back(), 1) +
        " % at 75, where Blinn's highlight is longer than wide. A picture by Blinn-Phong takes " +
        in_words(times[1], "Phong's") + ".";
    return finding;
}

Finding measure_furnace(const Effort& effort) {
    using lighting::Distribution;
    using lighting::Geometry;
    Finding finding{{{"D", "G", "roughness", "n.v", "given back"}, {}},
                    {"roughness", "mean share of an even light that is given back", false, false, {}, true},
                    ""};
    double schlick = 0.0, smith = 0.0, most = 0.0;
    std::string where;
    for (std::size_t d = 0; d < lighting::kDistributions.size(); ++d) {
        for (std::size_t g = 0; g < lighting::kGeometries.size(); ++g) {
            const lighting::EnergyTable table =
                lighting::compute_energy_table(static_cast<Distribution>(d), static_cast<Geometry>(g));
            const std::string D(lighting::kDistributions[d].key), G(lighting::kGeometries[g].key);
            if (d == 0) finding.plot.series.push_back({"ggx, " + G, {}});
            for (const float roughness : {0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
                for (const float n_dot_v : {0.1f, 0.3f, 0.6f, 1.0f}) {
                    const double E = double{lighting::directional_albedo(table, n_dot_v, roughness)};
                    finding.table.add({D, G, digits(double{roughness}), digits(double{n_dot_v}), digits(E)});
                    if (E > most)
                        where = D + ", " + G + " at roughness " + fixed(double{roughness}, 1) +
                                " and n.v = " + fixed(double{n_dot_v}, 1);
                    most = std::max(most, E);
                }
                const double mean = double{lighting::average_albedo(table, roughness)};
                if (d == 0) finding.plot.series.back().points.emplace_back(double{roughness}, mean);
                if (d == 0 && static_cast<Geometry>(g) == Geometry::schlick_ggx && roughness == 0.1f) schlick = mean;
                if (d == 0 && static_cast<Geometry>(g) == Geometry::smith_correlated && roughness == 0.1f) smith = mean;
            }
            effort.show(static_cast<double>(d * lighting::kGeometries.size() + g + 1) / 20.0);
        }
    }
    finding.text = "F = 1, light from everywhere. Schlick-GGX with k = (r + 1)^2 / 8 loses " +
                   fixed(100.0 * (1.0 - schlick), 1) + " % at roughness 0.1, where Smith's G loses " +
                   fixed(100.0 * (1.0 - smith), 2) +
                   " %: that k darkens smooth surfaces. The most that any pair gives back is " + fixed(most, 3) + " (" +
                   where + ")" + (most > 1.001 ? ": more than arrives." : ".");
    return finding;
}

}  // namespace kreda::tools
