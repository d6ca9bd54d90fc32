// Experiments on closed forms in place of maps of an environment: nine numbers for irradiance, a fit for A and B.
#include <cmath>

#include "lighting/environment/environment_image.hpp"
#include "tools/measure/brdf_quadrature.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/paired_times.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Nine coefficients of a disc of light of that angular radius around +z, of radiance 1: lights of its every part.
lighting::Sh9 sh9_of_disc(double radius, int rings) {
    lighting::Sh9 sum;
    constexpr int kAround = 64;
    const double z_of_rim = std::cos(radius);
    for (int i = 0; i < rings; ++i) {
        const double z = 1.0 - (1.0 - z_of_rim) * (i + 0.5) / rings,
                     s = std::sqrt(1.0 - z * z);  // rings of equal areas
        for (int j = 0; j < kAround; ++j) {
            const double phi = 2.0 * kPi * (j + 0.5) / kAround;
            const glm::vec3 l(static_cast<float>(s * std::cos(phi)), static_cast<float>(s * std::sin(phi)),
                              static_cast<float>(z));
            const lighting::Sh9 one = lighting::sh9_of_light(l);
            const float weight = static_cast<float>(2.0 * kPi * (1.0 - z_of_rim) / (rings * kAround));
            for (std::size_t k = 0; k < 9; ++k) sum.c[k] += weight * one.c[k];
        }
    }
    return sum;
}

/// E of the disc on a plane whose normal is tilted by `tilt` from its middle, by the same sum of max(n.l, 0).
double irradiance_of_disc(double radius, double tilt, int rings, int around) {
    const double z_of_rim = std::cos(radius);
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double z = 1.0 - (1.0 - z_of_rim) * (i + 0.5) / rings, s = std::sqrt(1.0 - z * z);
        for (int j = 0; j < around; ++j) {
            const double phi = 2.0 * kPi * (j + 0.5) / around;
            sum += std::max(std::sin(tilt) * s * std::cos(phi) + std::cos(tilt) * z, 0.0);
        }
    }
    return sum * 2.0 * kPi * (1.0 - z_of_rim) / (rings * around);
}

constexpr const char* kMatteBall = R"(
[image]
size = [320, 320]
[camera]
position = [0, 0, 4]
target = [0, 0, 0]
vertical_fov = 32
[environment]
sky = "sunset"
[[material]]
name = "white"
model = "lambert"
diffuse = [0.8, 0.8, 0.8]
[[object]]
mesh = "sphere"
detail = 96
material = "white"
)";

}  // namespace

Finding measure_sh9(const Effort& effort) {
    Finding finding{
        {{"radius of the light [degrees]", "greatest error [%]", "mean error [%]", "least E [%]"}, {}},
        {"angular radius of the light [degrees]", "error, share of the greatest E [%]", false, true, {}, true},
        ""};
    finding.plot.series = {{"greatest", {}}, {"mean", {}}};
    const int rings = effort.count(32, 128), tilts = effort.count(90, 360);
    double smallest = 0.0, of_lamp = 0.0, of_sky = 0.0;
    for (const int degrees : {1, 5, 10, 20, 30, 45, 60, 75, 90}) {
        const double radius = degrees * kPi / 180.0;
        const lighting::Sh9 sh = sh9_of_disc(radius, rings);
        const double most = irradiance_of_disc(radius, 0.0, rings, 64);
        double greatest = 0.0, sum = 0.0, weights = 0.0, least = 1e30;
        for (int i = 0; i <= tilts; ++i) {
            const double tilt = kPi * i / tilts;
            const glm::vec3 n(static_cast<float>(std::sin(tilt)), 0.0f, static_cast<float>(std::cos(tilt)));
            const double E = double{irradiance_of_sh9(sh, n).x};
            const double error = std::abs(E - irradiance_of_disc(radius, tilt, rings, 64)) / most;
            greatest = std::max(greatest, error);
            least = std::min(least, E / most);
            sum += std::sin(tilt) * error;
            weights += std::sin(tilt);
        }
        finding.table.add(
            {std::to_string(degrees), digits(100.0 * greatest), digits(100.0 * sum / weights), digits(100.0 * least)});
        finding.plot.series[0].points.emplace_back(degrees, 100.0 * greatest);
        finding.plot.series[1].points.emplace_back(degrees, 100.0 * sum / weights);
        if (degrees == 1) smallest = greatest;
        if (degrees == 30) of_lamp = greatest;
        if (degrees == 90) of_sky = greatest;
        effort.show(degrees / 100.0);
    }
    scene::RenderBuffers a, b;
    const scene::Scene map = scene_of(kMatteBall), nine = scene_of(kMatteBall, {"environment.irradiance=sh9"});
    const Picture by_map = draw_picture(map, a, effort.threads), by_nine = draw_picture(nine, b, effort.threads);
    const std::vector<PairedTime> times = paired_times(
        {[&] { (void)draw_picture(map, a, effort.threads); }, [&] { (void)draw_picture(nine, b, effort.threads); }},
        effort.count(15, 61));
    finding.text =
        "A disc of light, its irradiance by nine numbers against the sum over its parts. Of a sun of 1 degree they "
        "miss "
        "up to " +
        fixed(100.0 * smallest, 1) + " % of the greatest irradiance, of a lamp of 30 degrees " +
        fixed(100.0 * of_lamp, 1) + " %, of half a sky " + fixed(100.0 * of_sky, 2) +
        " %. A white ball under the sunset is off by " + fixed(code_error(by_nine.encoded, by_map.encoded).mean, 2) +
        " codes in the mean; a frame takes " + in_words(times[1], "that with a map") + ".";
    return finding;
}

Finding measure_brdf_fit(const Effort& effort) {
    Finding finding{{{"way", "roughness", "mean error of A + B", "greatest"}, {}},
                    {"roughness", "greatest error of A + B", false, true, {}, true},
                    ""};
    finding.plot.series = {{"map of 64 x 64", {}}, {"closed form", {}}};
    const lighting::BrdfMap map =
        lighting::compute_brdf_map(lighting::Distribution::ggx, lighting::Geometry::smith_correlated);
    const int steps = effort.count(48, 128), points = effort.count(32, 96);
    std::array<double, 2> worst{}, mean{};
    const std::vector<float> roughnesses = {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1.0f};
    for (const float roughness : roughnesses) {
        std::array<double, 2> greatest{}, sum{};
        for (int i = 0; i < points; ++i) {
            const float n_dot_v = static_cast<float>((i + 0.5) / points);
            const auto white = [](const lighting::BrdfTerms& terms) {
                return double{terms.scale} + double{terms.bias};
            };
            const double exact = white(brdf_by_quadrature(double{n_dot_v}, double{roughness}, steps));
            const std::array<double, 2> found = {white(look_up_brdf(map, n_dot_v, roughness)),
                                                 white(lighting::brdf_fit(n_dot_v, roughness))};
            for (std::size_t w = 0; w < 2; ++w) {
                greatest[w] = std::max(greatest[w], std::abs(found[w] - exact));
                sum[w] += std::abs(found[w] - exact) / points;
            }
        }
        for (std::size_t w = 0; w < 2; ++w) {
            finding.table.add(
                {finding.plot.series[w].name, digits(double{roughness}), digits(sum[w]), digits(greatest[w])});
            finding.plot.series[w].points.emplace_back(double{roughness}, greatest[w]);
            worst[w] = std::max(worst[w], greatest[w]);
            mean[w] += sum[w] / static_cast<double>(roughnesses.size());
        }
        effort.show(double{roughness});
    }
    raster::Channel n_dot_v, roughness;
    raster::Channel3 terms;
    lighting::TapScratch scratch;
    const int lanes = raster::lanes_for(raster::kBatchCapacity);
    for (int i = 0; i < lanes; ++i) {
        n_dot_v.set(i, static_cast<float>((i * 37 % lanes + 0.5) / lanes));
        roughness.set(i, static_cast<float>((i * 101 % lanes + 0.5) / lanes));
    }
    const auto often = [&](auto work) {
        return [work] {
            for (int i = 0; i < 500; ++i) work();
        };
    };
    const std::vector<PairedTime> times =
        paired_times({often([&] { look_up_brdf(map, lanes, n_dot_v, roughness, scratch, terms); }),
                      often([&] { lighting::brdf_fit(lanes, n_dot_v, roughness, terms); })},
                     effort.count(21, 81));
    finding.text = "GGX with height-correlated Smith against quadrature: the map misses " + digits(worst[0]) +
                   " at worst and " + digits(mean[0]) + " in the mean, the closed form " + digits(worst[1]) + " and " +
                   digits(mean[1]) + ". In batches the closed form takes " + in_words(times[1], "the map") +
                   ", and has nothing to bake.";
    return finding;
}

}  // namespace kreda::tools
