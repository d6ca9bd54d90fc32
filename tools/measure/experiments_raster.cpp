// Experiments on what comes before light: depth, interpolation, samples, textures; and on what comes after it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "raster/depth_formats.hpp"
#include "raster/film.hpp"
#include "raster/texture.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

Finding measure_depth(const Effort& effort) {
    using raster::DepthFormat;
    Finding finding{{{"format", "far / near", "least gap at 1/10 of far, share of the distance", "at far"}, {}},
                    {"far / near", "least gap at far, share of the distance", true, true, {}, true},
                    ""};
    const std::array<std::pair<const char*, DepthFormat>, 4> formats = {
        {{"16 bits", DepthFormat::unorm16},
         {"24 bits", DepthFormat::unorm24},
         {"float", DepthFormat::float32},
         {"float, reversed", DepthFormat::reversed_float32}}};
    std::array<double, 4> at_1e9{};
    std::array<double, 4> most{};  // the greatest far / near with a gap of at most a percent
    for (std::size_t k = 0; k < formats.size(); ++k) {
        finding.plot.series.push_back({formats[k].first, {}});
        for (int power = 1; power <= 9; ++power) {
            const double far = std::pow(10.0, power);
            const double middle = raster::depth_step(formats[k].second, 0.1 * far + 1.0, 1.0, far) / (0.1 * far);
            // just before the far plane, where a step of reversed float is the smallest float
            const double end = raster::depth_step(formats[k].second, 0.999 * far, 1.0, far) / far;
            finding.table.add({formats[k].first, digits(far), digits(middle), digits(end)});
            finding.plot.series.back().points.emplace_back(far, end);
            if (power == 9) at_1e9[k] = end;
            if (end <= 0.01) most[k] = far;
        }
        effort.show(static_cast<double>(k + 1) / 4.0);
    }
    finding.text =
        "Surfaces near the far plane that are a hundredth of their distance apart are told apart up to far / near = " +
        digits(most[0]) + " with 16 bits, " + digits(most[1]) + " with 24 bits, " + digits(most[2]) +
        " with a float and " + digits(most[3]) +
        " with a float whose 1 lies at the near plane. At 1e9 the least gaps are " + digits(at_1e9[1]) + " and " +
        digits(at_1e9[3]) +
        " of the distance with 24 bits and the reversed float. A float alone is no better than 24 bits: its "
        "digits lie where the near plane is.";
    return finding;
}

namespace {

constexpr const char* kFloor = R"(
[image]
size = [320, 180]
samples = 2
[camera]
position = [0, 1.2, 6]
target = [0, 0, 0]
vertical_fov = 50
[[light]]
type = "point"
position = [0, 2, 2]
intensity = 3
[[material]]
name = "floor"
model = "blinn_phong"
[[object]]
mesh = "plane"
scale = [6, 1, 6]
material = "floor"
)";

/// White and blue squares.
std::shared_ptr<const raster::Texture> checkers() {
    raster::Image image = raster::make_image(256, 256, 3);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x)
            image.set_rgb(x, y, (x / 16 + y / 16) % 2 == 0 ? glm::vec3(0.9f) : glm::vec3(0.1f, 0.2f, 0.6f));
    }
    return std::make_shared<raster::Texture>(raster::make_texture(image));
}

scene::Scene checkered_floor(const std::vector<std::string>& overrides) {
    scene::Scene scene = scene_of(kFloor, overrides);
    lighting::Material& floor = scene.materials[0];
    floor.model = lighting::ReflectionModel::lambert;
    floor.maps.diffuse.texture = checkers();
    floor.maps.scale = glm::vec2(3.0f);
    return scene;
}

std::string samples(int n) {
    return "image.samples=" + std::to_string(n);
}

}  // namespace

Finding measure_affine(const Effort& effort) {
    Finding finding{{{"detail", "mean error [codes]", "99th percentile", "worst"}, {}},
                    {"squares a side", "error [codes]", true, true, {{"mean", {}}, {"99th percentile", {}}}, true},
                    ""};
    std::vector<CodeError> errors;
    for (int n = 1; n <= 128; n *= 2) {
        const std::string detail = "object.0.detail=" + std::to_string(n);
        scene::RenderBuffers a, b;
        const raster::Image exact = draw_picture(checkered_floor({detail}), a, effort.threads).encoded;
        errors.push_back(code_error(
            draw_picture(checkered_floor({detail, "shading.interpolation=affine"}), b, effort.threads).encoded, exact));
        finding.table.add(
            {std::to_string(n), digits(errors.back().mean), digits(errors.back().p99), digits(errors.back().worst)});
        finding.plot.series[0].points.emplace_back(n, errors.back().mean);
        finding.plot.series[1].points.emplace_back(n, errors.back().p99);
        effort.show(std::log2(n) / 7.0);
    }
    finding.text = "A checkered floor. Without perspective two triangles miss " + fixed(errors.front().mean, 1) +
                   " codes in the mean, " + "32 squares a side " + fixed(errors[5].mean, 2) + " and 128 " +
                   fixed(errors.back().mean, 2) + ": the error of a triangle falls with its extent in depth.";
    return finding;
}

Finding measure_supersampling(const Effort& effort) {
    Finding finding{{{"samples", "mean error [codes]", "99th percentile", "time [ms]"}, {}},
                    {"time [ms]", "mean error [codes]", true, true, {{"n x n samples", {}}}, true},
                    ""};
    scene::RenderBuffers buffers;
    const raster::Image exact = draw_picture(checkered_floor({samples(8)}), buffers, effort.threads).encoded;
    std::vector<double> means;
    for (const int n : {1, 2, 3, 4, 6}) {
        scene::RenderBuffers own;
        const scene::Scene scene = checkered_floor({samples(n)});
        const CodeError error = code_error(draw_picture(scene, own, effort.threads).encoded, exact);
        std::vector<double> ms;
        for (int i = 0; i < effort.count(5, 21); ++i) ms.push_back(draw_picture(scene, own, effort.threads).frame_ms);
        std::nth_element(ms.begin(), ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2), ms.end());
        means.push_back(error.mean);
        finding.table.add({std::to_string(n), digits(error.mean), digits(error.p99), digits(ms[ms.size() / 2])});
        finding.plot.series[0].points.emplace_back(ms[ms.size() / 2], error.mean);
        effort.show(n / 6.0);
    }
    finding.text = "A checkered floor against 8 x 8 samples a pixel: one sample misses " + fixed(means[0], 3) +
                   " codes in the mean, 2 x 2 " + fixed(means[1], 3) + ", 4 x 4 " + fixed(means[3], 3) +
                   ". The texture is filtered already; what is left are edges.";
    return finding;
}

Finding measure_texture_filter(const Effort& effort) {
    using lighting::TextureFilter;
    Finding finding{{{"filter", "samples", "mean error [codes]", "99th percentile"}, {}},
                    {"samples a side of a pixel", "mean error [codes]", true, true, {}, true},
                    ""};
    scene::Scene truth = checkered_floor({samples(8)});
    truth.materials[0].maps.filter = TextureFilter::bilinear;
    scene::RenderBuffers buffers;
    const raster::Image exact = draw_picture(truth, buffers, effort.threads).encoded;
    std::array<double, 3> at_1{};
    for (std::size_t f = 0; f < 3; ++f) {
        const std::array<const char*, 3> names = {"nearest", "bilinear", "trilinear"};
        finding.plot.series.push_back({names[f], {}});
        for (const int n : {1, 2, 4}) {
            scene::Scene scene = checkered_floor({samples(n)});
            scene.materials[0].maps.filter = static_cast<TextureFilter>(f);
            scene::RenderBuffers own;
            const CodeError error = code_error(draw_picture(scene, own, effort.threads).encoded, exact);
            finding.table.add({names[f], std::to_string(n), digits(error.mean), digits(error.p99)});
            finding.plot.series.back().points.emplace_back(n, error.mean);
            if (n == 1) at_1[f] = error.mean;
        }
        effort.show(static_cast<double>(f + 1) / 3.0);
    }
    finding.text =
        "A checkered floor that runs far away, against 64 bilinear samples a pixel. With one sample a pixel the "
        "nearest texel misses " +
        fixed(at_1[0], 2) + " codes in the mean, bilinear " + fixed(at_1[1], 2) + ", trilinear " + fixed(at_1[2], 2) +
        ": trilinear does not flicker, but blurs where the floor is seen at a slant.";
    return finding;
}

Finding measure_fog(const Effort& effort) {
    Finding finding{{{"vertical angle [degrees]", "way", "detail", "mean error [codes]", "worst"}, {}},
                    {"vertical angle of the camera [degrees]", "mean error [codes]", false, true, {}, true},
                    ""};
    struct Way {
        const char* name;
        const char* set;
        int detail;
    };
    const std::array<Way, 4> ways = {{{"planar", "fog.distance=planar", 64},
                                      {"per vertex, detail 4", "fog.frequency=vertex", 4},
                                      {"per vertex, detail 16", "fog.frequency=vertex", 16},
                                      {"per vertex, detail 64", "fog.frequency=vertex", 64}}};
    std::array<std::array<double, 2>, 4> ends{};
    for (std::size_t w = 0; w < ways.size(); ++w) {
        finding.plot.series.push_back({ways[w].name, {}});
        for (const int angle : {20, 40, 60, 80, 100}) {
            const std::vector<std::string> base = {"camera.vertical_fov=" + std::to_string(angle),
                                                   "object.0.detail=" + std::to_string(ways[w].detail), "fog.mode=exp",
                                                   "fog.density=0.25"};
            std::vector<std::string> set = base;
            set.emplace_back(ways[w].set);
            scene::RenderBuffers a, b;
            const CodeError error = code_error(draw_picture(scene_of(kFloor, set), a, effort.threads).encoded,
                                               draw_picture(scene_of(kFloor, base), b, effort.threads).encoded);
            finding.table.add({std::to_string(angle), ways[w].name, std::to_string(ways[w].detail), digits(error.mean),
                               digits(error.worst)});
            finding.plot.series.back().points.emplace_back(angle, error.mean);
            ends[w][angle == 20 ? 0 : 1] = error.mean;
        }
        effort.show(static_cast<double>(w + 1) / 4.0);
    }
    finding.text = "Against fog by true distance at every pixel. Planar fog misses " + fixed(ends[0][0], 2) +
                   " codes in the mean with a camera of 20 degrees and " + fixed(ends[0][1], 2) +
                   " with one of 100: the corners of the picture are farther than its middle. Fog per vertex misses " +
                   fixed(ends[1][1], 2) + " codes with 4 squares a side and " + fixed(ends[3][1], 3) + " with 64.";
    return finding;
}

Finding measure_transfer(const Effort& effort) {
    Finding finding{{{"linear", "sRGB [codes]", "power 2.2 [codes]", "difference [codes]"}, {}},
                    {"linear value", "power 2.2 - sRGB [codes]", true, false, {{"difference", {}}}, true},
                    ""};
    double worst = 0.0, at = 0.0;
    const int count = effort.count(400, 4000);
    for (int i = 0; i < count; ++i) {
        const double x = std::pow(10.0, -4.0 + 4.0 * i / (count - 1));
        const double srgb = 255.0 * double{raster::srgb_from_linear(static_cast<float>(x))},
                     power = 255.0 * std::pow(x, 1.0 / 2.2);
        if (std::abs(power - srgb) > std::abs(worst)) at = x;
        if (std::abs(power - srgb) > std::abs(worst)) worst = power - srgb;
        if (i % 10 == 0) finding.table.add({digits(x), digits(srgb), digits(power), digits(power - srgb)});
        finding.plot.series[0].points.emplace_back(x, power - srgb);
    }
    finding.text = "The power of 2.2 differs from sRGB's curve by at most " + fixed(std::abs(worst), 2) +
                   " codes, at a linear value of " + digits(at) + ": in the dark, where sRGB is a line.";
    return finding;
}

}  // namespace kreda::tools
