// What light that is computed once for several pixels misses.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "raster/film.hpp"
#include "tools/bench/time_report.hpp"
#include "tools/measure/experiment_functions.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

namespace {

constexpr const char* kBalls = R"(
[image]
size = [640, 360]
[camera]
position = [0, 1.2, 5]
target = [0, 0.1, 0]
vertical_fov = 36
[[light]]
direction = [-1, -1.5, -1]
intensity = 2
[[light]]
type = "point"
position = [1.5, 1.5, 2]
intensity = 2
[[material]]
name = "smooth"
model = "cook_torrance"
albedo = [0.7, 0.25, 0.12]
roughness = 0.15
[[material]]
name = "rough"
model = "cook_torrance"
albedo = [0.2, 0.4, 0.6]
roughness = 0.6
[[material]]
name = "floor"
model = "cook_torrance"
albedo = [0.5, 0.5, 0.5]
roughness = 0.8
[[object]]
mesh = "sphere"
detail = 96
translate = [-1.1, 0.2, 0]
scale = 0.8
material = "smooth"
[[object]]
mesh = "torus"
detail = 96
translate = [1.1, 0, 0]
rotate = [60, 0, 0]
scale = 0.8
material = "rough"
[[object]]
mesh = "plane"
scale = [6, 1, 6]
translate = [0, -0.6, 0]
material = "floor"
)";

/// Which object a pixel shows: every object in a colour of its own, without light.
raster::Image objects_shown(int threads) {
    std::vector<std::string> settings = {"image.background=[0,0,0]"};
    const std::array<const char*, 3> colors = {"[1,0,0]", "[0,1,0]", "[0,0,1]"};
    for (std::size_t m = 0; m < colors.size(); ++m) {
        const std::string material = "material." + std::to_string(m);
        settings.push_back(material + ".model=unlit");
        settings.push_back(material + ".diffuse=" + colors[m]);
    }
    scene::RenderBuffers buffers;
    return draw_picture(scene_of(kBalls, settings), buffers, threads).encoded;
}

struct HeldPicture {
    raster::Image picture;
    double points = 0.0;  ///< shading points a pixel
};

/// One point for all pixels of a square of n x n that show the same object: that of its pixel nearest to the middle.
HeldPicture hold(const raster::Image& shaded, const raster::Image& objects, int n) {
    HeldPicture held{shaded, 0.0};
    std::int64_t points = 0;
    for (int top = 0; top < shaded.height; top += n) {
        for (int left = 0; left < shaded.width; left += n) {
            std::vector<std::pair<glm::vec3, glm::ivec2>> seen;  // an object, and where it is shaded
            const auto from_middle = [&](glm::ivec2 p) {
                const glm::ivec2 d = 2 * (p - glm::ivec2(left, top)) - glm::ivec2(n - 1);
                return d.x * d.x + d.y * d.y;
            };
            const auto place_of = [&](int x, int y) {
                const glm::vec3 object = objects.rgb(x, y);
                return std::find_if(seen.begin(), seen.end(), [&](const auto& one) { return one.first == object; });
            };
            const int right = std::min(left + n, shaded.width), bottom = std::min(top + n, shaded.height);
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    const auto place = place_of(x, y);
                    if (place == seen.end()) {
                        seen.push_back({objects.rgb(x, y), {x, y}});
                    } else if (from_middle({x, y}) < from_middle(place->second)) {
                        place->second = {x, y};
                    }
                }
            }
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    const glm::ivec2 at = place_of(x, y)->second;
                    held.picture.set_rgb(x, y, shaded.rgb(at.x, at.y));
                }
            }
            for (const auto& [object, at] : seen) points += object != glm::vec3(0.0f);
        }
    }
    held.points = static_cast<double>(points) / (static_cast<double>(shaded.width) * shaded.height);
    return held;
}

/// A picture with every n-th pixel of a row and column, each held for n x n: edges, too.
raster::Image hold_all(int n, glm::ivec2 size, int threads) {
    scene::RenderBuffers buffers;
    const std::string small = "[" + std::to_string(size.x / n) + "," + std::to_string(size.y / n) + "]";
    const raster::Image drawn = draw_picture(scene_of(kBalls, {"image.size=" + small}), buffers, threads).encoded;
    raster::Image held = raster::make_image(size.x, size.y, 3);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            held.set_rgb(x, y, drawn.rgb(std::min(x / n, drawn.width - 1), std::min(y / n, drawn.height - 1)));
        }
    }
    return held;
}

/// The share of a frame that its passes at lit points take, by the clock.
double light_share(int frames, int threads) {
    const scene::Scene scene = scene_of(kBalls);
    scene::RenderBuffers buffers;
    std::vector<double> shares;
    for (int i = 0; i < frames; ++i) {
        double light = 0.0, all = 0.0;
        const scene::RenderPlan plan = make_plan(scene);
        const scene::StageTimes times = render(scene, plan, buffers, threads).times;
        for (const auto& [name, ms] : times.stages) {
            all += ms;
            for (const scene::PlannedPass& pass : plan.passes) {
                const bool is_light = pass.scope == scene::PassScope::points || pass.name == "light pixels";
                if (pass.name == name && is_light) light += ms;
            }
        }
        shares.push_back(light / all);
    }
    return median(shares);
}

}  // namespace

Finding measure_shading_rate(const Effort& effort) {
    Finding finding{
        {{"pixels a point", "edges", "points a pixel", "mean error [codes]", "99th percentile", "worst"}, {}},
        {"side of the square that shares a point [pixels]", "mean error [codes]", false, false, {}, true},
        ""};
    finding.plot.series = {{"edges at every pixel", {}}, {"edges as coarse as light", {}}};
    scene::RenderBuffers buffers;
    const raster::Image exact = draw_picture(scene_of(kBalls), buffers, effort.threads).encoded;
    const raster::Image objects = objects_shown(effort.threads);
    std::vector<CodeError> fine, coarse;
    double points_of_1 = 1.0, points_of_2 = 0.0;
    for (const int n : {1, 2, 4, 8}) {
        const HeldPicture held = hold(exact, objects, n);
        fine.push_back(code_error(held.picture, exact));
        coarse.push_back(code_error(hold_all(n, {exact.width, exact.height}, effort.threads), exact));
        if (n == 1) points_of_1 = held.points;
        if (n == 2) points_of_2 = held.points;
        const auto add = [&](const std::string& edges, double points, const CodeError& error) {
            finding.table.add({std::to_string(n) + " x " + std::to_string(n), edges, digits(points), digits(error.mean),
                               digits(error.p99), digits(error.worst)});
        };
        add("fine", held.points, fine.back());
        add("coarse", 1.0 / (n * n), coarse.back());
        finding.plot.series[0].points.emplace_back(n, fine.back().mean);
        finding.plot.series[1].points.emplace_back(n, coarse.back().mean);
        effort.show(n / 8.0);
    }
    const double share = light_share(effort.count(7, 31), effort.threads);
    finding.text =
        "Pictures of a renderer that has no such pass: light is computed at every pixel, then each square's pixels of "
        "one "
        "object take the value of the one nearest to its middle. One point for 2 x 2 pixels misses " +
        fixed(fine[1].mean, 2) + " codes in the mean, for 4 x 4 " + fixed(fine[2].mean, 2) +
        ", with every edge where it was. A picture of half the width and height, enlarged, has the same number of "
        "points "
        "inside and misses " +
        fixed(coarse[1].mean, 2) + ": edges are what is missed. 2 x 2 needs " + fixed(points_of_2, 3) +
        " points a pixel. Light takes " + fixed(100.0 * share, 0) + " % of this frame, so it could be no more than " +
        fixed(1.0 / (1.0 - share * (1.0 - points_of_2 / points_of_1)), 2) + " times as fast.";
    return finding;
}

}  // namespace kreda::tools
