// Experiments on light from an image: how many samples, how large a map, and what the split sum misses.
#include <cmath>

#include "lighting/environment/environment_image.hpp"
#include "tools/measure/brdf_quadrature.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/irradiance_error.hpp"
#include "tools/measure/prefilter_levels.hpp"
#include "tools/measure/split_sum_error.hpp"

namespace kreda::tools {

namespace {

using lighting::CubeMap;

const std::array<std::pair<const char*, lighting::Sky>, 3> kSkies = {
    {{"gradient", lighting::Sky::gradient}, {"studio", lighting::Sky::studio}, {"sunset", lighting::Sky::sunset}}};

}  // namespace

Finding measure_irradiance(const Effort& effort) {
    Finding finding{{{"sky", "way", "samples", "mean error [%]", "greatest [%]"}, {}},
                    {"samples of a normal", "mean error [%]", true, true, {}, true},
                    ""};
    constexpr int kSize = 8;
    double sh9_worst = 0.0;
    std::string sh9_sky;
    for (const auto& [name, sky] : kSkies) {
        const CubeMap radiance = lighting::cube_from_sky(sky, effort.count(64, 128));
        const CubeMap exact = every_texel(kSize).make(radiance);
        std::vector<std::pair<std::string, std::vector<IrradianceWay>>> families;
        families.emplace_back("double sum", sampling_ways(lighting::IrradianceSum::hemisphere, kSize));
        families.emplace_back("cosine-weighted", sampling_ways(lighting::IrradianceSum::cosine, kSize));
        families.emplace_back("nine coefficients", std::vector<IrradianceWay>{nine_coefficients(kSize)});
        for (const auto& [family, ways] : families) {
            Series series{std::string(name) + ", " + family, {}};
            for (const IrradianceWay& way : ways) {
                const MapError error = map_error(way.make(radiance), exact);
                finding.table.add({name, family, std::to_string(way.samples), digits(100.0 * error.mean),
                                   digits(100.0 * error.largest)});
                series.points.emplace_back(std::max(way.samples, 9), 100.0 * error.mean);
                if (way.samples == 0 && error.mean > sh9_worst) {
                    sh9_worst = error.mean;
                    sh9_sky = name;
                }
            }
            finding.plot.series.push_back(series);
        }
        effort.show(static_cast<double>(finding.plot.series.size()) / 9.0);
    }
    finding.text = "Against the sum over every texel. Nine coefficients (drawn at 9) miss " +
                   fixed(100.0 * sh9_worst, 2) + " % of the mean on the " + sh9_sky +
                   " sky, where they are worst, and take no samples at all. Sampling errs by the light that it "
                   "misses: most where a small sun is.";
    return finding;
}

Finding measure_prefilter(const Effort& effort) {
    Finding finding{{{"sky", "reads", "alpha", "samples", "mean error [%]"}, {}},
                    {"samples", "mean error at alpha 1/2 [%]", true, true, {}, true},
                    ""};
    constexpr int kSize = 8, kShownLevel = 6;
    const int most = effort.count(512, 8192);
    double plain = 0.0, mips = 0.0;
    for (const auto& [name, sky] : kSkies) {
        const CubeMap radiance = lighting::cube_from_sky(sky, 64);
        for (const bool from_mips : {false, true}) {
            const CubeMap source = from_mips ? radiance : without_mips(radiance);
            Series series{std::string(name) + (from_mips ? ", from mips" : ", plain"), {}};
            for (int level = effort.count(kShownLevel, 4); level < lighting::kPrefilterLevels; ++level) {
                const float alpha = lighting::alpha_of_level(level);
                const CubeMap exact = exact_level(radiance, alpha, kSize);
                for (int samples = 8; samples <= most; samples *= 2) {
                    const double error = 100.0 * map_error(sampled_level(source, alpha, samples, kSize), exact).mean;
                    finding.table.add({name, from_mips ? "mips" : "texels", digits(double{alpha}),
                                       std::to_string(samples), digits(error)});
                    if (level == kShownLevel) series.points.emplace_back(samples, error);
                    if (level == kShownLevel && samples == 128 && sky == lighting::Sky::sunset)
                        (from_mips ? mips : plain) = error;
                }
            }
            finding.plot.series.push_back(series);
            effort.show(static_cast<double>(finding.plot.series.size()) / 6.0);
        }
    }
    finding.text = "Against the sum over every texel. Of the sunset at alpha 1/2, 128 samples of single texels miss " +
                   fixed(plain, 2) + " %, 128 samples that each read a mip level as large as their share of the lobe " +
                   fixed(mips, 2) + " %: the small sun is no longer hit or missed.";
    return finding;
}

namespace {

/// A and B at nodes: n.v = (i / last) or its square, roughness j / last.
struct NodeTable {
    int size;
    bool squared;
    std::vector<glm::dvec2> nodes;
};

NodeTable make_nodes(int size, bool squared, int steps) {
    NodeTable table{size, squared, {}};
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const double x = static_cast<double>(i) / (size - 1), n_dot_v = std::max(squared ? x * x : x, 1e-4);
            const lighting::BrdfTerms terms = brdf_by_quadrature(n_dot_v, static_cast<double>(j) / (size - 1), steps);
            table.nodes.emplace_back(terms.scale, terms.bias);
        }
    }
    return table;
}

/// Bilinear between the four nodes around.
glm::dvec2 look_up(const NodeTable& table, double n_dot_v, double roughness) {
    const double last = table.size - 1, x = (table.squared ? std::sqrt(n_dot_v) : n_dot_v) * last, y = roughness * last;
    const int left = std::min(static_cast<int>(x), table.size - 2), top = std::min(static_cast<int>(y), table.size - 2);
    const auto node = [&](int i, int j) {
        return table.nodes[static_cast<std::size_t>((top + j) * table.size + left + i)];
    };
    const double u = x - left, v = y - top;
    return (1 - v) * ((1 - u) * node(0, 0) + u * node(1, 0)) + v * ((1 - u) * node(0, 1) + u * node(1, 1));
}

}  // namespace

Finding measure_brdf_map(const Effort& effort) {
    Finding finding{{{"way", "nodes a side", "mean error of A + B", "greatest"}, {}},
                    {"nodes a side", "greatest error of A + B", true, true, {}, true},
                    ""};
    const int steps = effort.count(48, 128), points = effort.count(24, 48);
    std::vector<glm::dvec2> places;
    std::vector<double> exact;
    for (int j = 0; j < points; ++j) {
        for (int i = 0; i < points; ++i) {
            places.emplace_back((i + 0.5) / points, 0.1 + 0.9 * (j + 0.5) / points);
            const lighting::BrdfTerms terms = brdf_by_quadrature(places.back().x, places.back().y, steps);
            exact.push_back(double{terms.scale} + double{terms.bias});
        }
    }
    const auto add = [&](const std::string& way, int size, const std::function<double(const glm::dvec2&)>& value) {
        double sum = 0.0, worst = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double error = std::abs(value(places[i]) - exact[i]);
            sum += error;
            worst = std::max(worst, error);
        }
        finding.table.add({way, std::to_string(size), digits(sum / static_cast<double>(places.size())), digits(worst)});
        return worst;
    };
    std::array<double, 2> at_32{};
    for (const bool squared : {false, true}) {
        Series series{squared ? "square root of n.v" : "n.v", {}};
        for (const int size : {8, 16, 32, 64}) {
            const NodeTable table = make_nodes(size, squared, steps);
            const double worst = add(series.name, size, [&](const glm::dvec2& p) {
                const glm::dvec2 terms = look_up(table, p.x, p.y);
                return terms.x + terms.y;
            });
            series.points.emplace_back(size, worst);
            if (size == 32) at_32[squared ? 1 : 0] = worst;
            effort.show((squared ? 0.5 : 0.0) + 0.5 * size / 64.0);
        }
        finding.plot.series.push_back(series);
    }
    const double fit = add("closed form", 0, [](const glm::dvec2& p) {
        const lighting::BrdfTerms terms = lighting::brdf_fit(static_cast<float>(p.x), static_cast<float>(p.y));
        return double{terms.scale} + double{terms.bias};
    });
    finding.text =
        "GGX with height-correlated Smith, roughness 0.1 to 1, against quadrature. With 32 nodes a side the worst "
        "error is " +
        fixed(at_32[0], 4) + " with nodes even in n.v and " + fixed(at_32[1], 4) +
        " with nodes even in its square root, which stand where A and B bend. The closed form, without any table, errs "
        "by " +
        fixed(fit, 3) + " at worst.";
    return finding;
}

Finding measure_split_sum(const Effort& effort) {
    Finding finding{{{"sky", "roughness", "error [%]"}, {}}, {"roughness", "error [%]", false, false, {}, true}, ""};
    const std::vector<float> roughnesses = {0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f};
    double greatest = 0.0;
    std::string where;
    for (const auto& [name, sky] : kSkies) {
        scene::EnvironmentSettings environment;
        environment.sky = sky;
        scene::RenderBuffers split, exact;
        finding.plot.series.push_back({name, {}});
        for (const float roughness : roughnesses) {
            double error = 0.0;
            for (int side = 0; side < 4; ++side) {
                environment.rotation_deg = 90.0f * static_cast<float>(side);
                const scene::Scene ball = metal_ball(environment, roughness, 24);
                error += 0.25 * error_percent(draw_specular(ball, split),
                                              draw_specular(with_reference(ball, effort.count(2048, 16384)), exact),
                                              roughness, 0.1f, 0.95f);
            }
            finding.table.add({name, digits(double{roughness}), digits(error)});
            finding.plot.series.back().points.emplace_back(double{roughness}, error);
            if (error > greatest) {
                greatest = error;
                where = std::string(name) + " at roughness " + fixed(double{roughness}, 1);
            }
        }
        effort.show(static_cast<double>(finding.plot.series.size()) / 3.0);
    }
    finding.text =
        "A ball of metal seen from four sides, n.v from 0.1 to 0.95, against the integral sampled at every point. The "
        "split sum misses "
        "most, " +
        fixed(greatest, 1) + " %, in the sky " + where +
        ". It assumes that the lobe looks as if seen along the normal; a rough surface at a grazing angle does not.";
    return finding;
}

}  // namespace kreda::tools
