// 95_depth_precision: how far apart must two surfaces be for the depth buffer to tell them apart?
// Page docs/95_depth_precision.md | After 11_z_buffer | New: DepthFormat, stored_depth(), depth_step()
// Break at: stored_depth | Look at: z, depth, steps | Try: kNear 1, kFar 1e6, kGap 0.5
#include <cmath>

#include "examples/plots.hpp"
#include "raster/depth_formats.hpp"

using namespace kreda;
using namespace kreda::examples;
using raster::DepthFormat;

namespace {

constexpr double kNear = 0.01, kFar = 10000.0;
constexpr double kHeight = 20.0;  ///< of the eye over the ground
constexpr double kGap = 0.02;     ///< between the ground and the carpets on it

struct Shown {
    DepthFormat format;
    const char* name;
    glm::vec3 color;
};
const Shown kShown[4] = {{DepthFormat::unorm16, "16 bits", kRed},
                         {DepthFormat::unorm24, "24 bits", kOrange},
                         {DepthFormat::float32, "float", kBlue},
                         {DepthFormat::reversed_float32, "float, reversed", kGreen}};

/// Carpets are squares of 30 on a grid of 60.
bool has_carpet(double across, double along) {
    const auto in_square = [](double s) { return s - 60.0 * std::floor(s / 60.0) < 30.0; };
    return in_square(across + 15.0) && in_square(along);
}

/// What the eye sees of carpets that lie almost on the ground, when this is how depth is kept. The horizon is on top;
/// the ground is drawn first, then the carpets.
Panel draw_carpets(glm::ivec2 size, const Shown& shown) {
    Image image = make_board(size.x, size.y);
    const double focal_length = 1.9 * size.y;  // in pixels: 30 degrees from bottom to top
    for (int y = 0; y < size.y; ++y) {
        const double down = (y + 0.5) / focal_length;  // the ray's slope
        const double ground = kHeight / down;
        const double carpet = (kHeight - kGap) / down;
        if (ground >= kFar) continue;
        const double in_buffer = stored_depth(shown.format, ground, kNear, kFar);
        const bool wins = is_nearer(shown.format, stored_depth(shown.format, carpet, kNear, kFar), in_buffer);
        for (int x = 0; x < size.x; ++x) {
            const double across = ground * (x + 0.5 - 0.5 * size.x) / focal_length;
            image.set_rgb(x, y, wins && has_carpet(across, ground) ? shown.color : kSlate);
        }
    }
    return {image, shown.name};
}

/// The least gap over the distance, for all formats.
Plot steps_plot() {
    Plot plot = empty_plot("distance", "least gap", true, true);
    plot.x_range = {0.1, 1000.0};
    plot.y_range = {1e-8, 100.0};
    for (const Shown& shown : kShown) {
        const auto step = [&](double z) { return raster::depth_step(shown.format, z, kNear, kFar); };
        plot.series.push_back(curve(shown.name, *plot.x_range, step, true));
    }
    return plot;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    std::vector<Panel> panels;
    for (const Shown& shown : kShown) panels.push_back(draw_carpets(size, shown));
    save_panels(options, "carpets", 2, panels);
    save_plot(options, "steps", "", steps_plot());
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "95_depth_precision", draw);
}
