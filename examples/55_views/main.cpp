// 55_views: every term of an environment's light as its own picture: they multiply, and the last column adds up.
// Page docs/55_views.md | After 54_split_sum | New: view_panels(), EnvironmentChannels, the views of [environment]
// Break at: diffuse_share | Look at: F, then environment.brdf, environment.diffuse | Try: sky "studio", ao = 0.5
#include <utility>

#include "examples/example.hpp"
#include "examples/view_panels.hpp"
#include "raster/scalar_math.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

void draw(const Options& options) {
    const scene::Scene whole = read_scene(options, KREDA_EXAMPLE_FOLDER "/views.toml");
    scene::RenderBuffers buffers;
    render(whole, make_plan(whole), buffers);
    save(options, "picture", buffers.film, film_settings(whole.image));

    // E / pi (1 - F)(1 - metallic) c = diffuse,   P (F0 A + B) = specular,   diffuse + specular = ambient
    scene::Scene small = whole;
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 3);
    small.image.width = size.x;
    small.image.height = size.y;
    const std::vector<Panel> panels = view_panels(small,
                                                  {{"irradiance", "irradiance / π", raster::kInvPi},
                                                   {"fresnel", "fresnel"},
                                                   {"environment_diffuse", "diffuse"},
                                                   {"prefilter", "prefilter"},
                                                   {"brdf", "brdf"},
                                                   {"environment_specular", "specular"},
                                                   {"albedo", "albedo"},
                                                   {"f0", "$F_0$"},
                                                   {"ambient", "ambient"}},
                                                  std::move(buffers));
    save_panels(options, "sheet", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "55_views", draw);
}
