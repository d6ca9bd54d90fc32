// 50_environment: light from every direction, kept as an equirectangular image and as a cube; seams, and bad texels.
// Page docs/50_environment.md | After 17_textures | New: equirect_point(), cube_point(), fill_border()
// Break at: cube_point | Look at: d, s, t, along | Try: kCoarse 8, scene.environment.rotation_deg 90
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "examples/seams.hpp"
#include "examples/sphere_views.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/irradiance.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;
using glm::vec3;

namespace {

constexpr int kCoarse = 4;    // texels a side of a face: few, so that seams can be seen
constexpr int kColumns = 32;  // of the image with bad texels

/// Where some directions lie in an image and on the cube.
void print_directions() {
    const char* const faces[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    std::printf("%-14s %9s %9s    %s %6s %9s\n", "direction", "u", "v", "face", "u", "v");
    for (const vec3& d : {vec3(1, 0, 0), vec3(0, 0, -1), vec3(0, 1, 0), vec3(1, 1, 1), vec3(-3, 1, 2)}) {
        const glm::dvec2 in_image = lighting::equirect_point(d);
        const lighting::CubePoint on_cube = lighting::cube_point(d);
        std::printf("(%2.0f, %2.0f, %2.0f) %9.6f %9.6f    %s %9.6f %9.6f\n", double{d.x}, double{d.y}, double{d.z},
                    in_image.x, in_image.y, faces[on_cube.face], double{on_cube.u}, double{on_cube.v});
    }
}

/// Radiance as a display shows it, in linear RGB.
Image shown(const Image& radiance, float exposure = 1.3f) {
    return develop(radiance, {exposure, raster::ToneMap::reinhard_extended, 6.0f, raster::Transfer::linear});
}

/// A ball that mirrors the sky it stands in.
Image mirror_ball(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.environment.on = true;
    scene.environment.sky = lighting::Sky::sunset;
    scene.environment.samples = 256;
    scene.image.environment_background = true;
    scene.camera.position = {0.0f, 0.2f, 3.4f};
    add_shape(scene, "sphere", 96, {}, microfacet(vec3(0.95f), 1.0f, 0.02f));
    return shown(scene::render(scene));
}

void draw_layouts(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    const int side = std::min(size.x / 4, size.y / 3);
    const float type = caption_size(options.height);
    const auto as_color = [](const vec3& d) { return 0.5f + 0.5f * d; };
    save_panels(options, "layouts", 3,
                {with_equirect_axes(shown(equirect_picture(size.x, lighting::sunset_sky)), type),
                 with_cube_axes(shown(cube_picture(side, lighting::sunset_sky)), type), mirror_ball(size),
                 equirect_picture(size.x, as_color), cube_picture(side, as_color),
                 camera_picture(size, {0.0f, 0.0f, -1.0f}, 90.0f, as_color)});
}

void draw_seams(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const lighting::CubeMap cube = lighting::cube_from_sky(lighting::Sky::studio, kCoarse);
    const lighting::EquirectMap map = lighting::make_equirect_map(equirect_picture(4 * kCoarse, lighting::studio_sky));
    const auto view = [&](const char* caption, const vec3& forward, const DirectionColor& color) -> Panel {
        return {shown(camera_picture(size, forward, 60.0f, color), 0.15f), caption};
    };
    const auto draw_cube = [&](const char* caption, const lighting::CubeMap& from) {  // towards a corner, three faces
        return view(caption, {-1.0f, 1.0f, 1.0f}, [&](const vec3& d) { return sample_level(from, 0, d); });
    };
    const auto draw_image = [&](const char* caption, const lighting::EquirectMap& from) {  // the pole, the meridian
        return view(caption, {-1.0f, 1.5f, 0.3f}, [&](const vec3& d) { return sample_equirect(from, d); });
    };
    save_panels(options, "seams", 2,
                {draw_cube("each face alone", with_faces_alone(cube)), draw_cube("with its neighbours", cube),
                 draw_image("not wrapped", without_wrapping(map)), draw_image("wrapped", map)});
}

/// Radiance as a display shows it, but red what is no number or endless, and blue what is negative.
Image marked(const Image& radiance) {
    Image picture = shown(radiance);
    for (int y = 0; y < radiance.height; ++y) {
        for (int x = 0; x < radiance.width; ++x) {
            const vec3 L = radiance.rgb(x, y);
            if (!std::isfinite(L.x + L.y + L.z)) picture.set_rgb(x, y, kRed);
            if (L.x < 0.0f) picture.set_rgb(x, y, kBlue);
        }
    }
    return picture;
}

/// What a white matt ball would show for each normal in the light of this image, E / pi.
Image matt_white(int width, const Image& environment) {
    const lighting::CubeMap E = irradiance_map(lighting::cube_from_equirect(environment, 16), {.size = 8});
    return marked(equirect_picture(width, [&](const vec3& n) { return sample_level(E, 0, n) / raster::kPi; }));
}

void draw_repairs(const Options& options) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    Image image = equirect_picture(kColumns, lighting::sunset_sky);
    image.set_rgb(20, 9, vec3(kNaN));
    image.set_rgb(27, 5, {kInfinity, 1.0f, 1.0f});
    image.set_rgb(3, 10, {-0.5f, 0.1f, 0.1f});
    const Image damaged = image;
    const lighting::EnvironmentRepairs repairs = lighting::repair_environment(image);
    std::printf("texels repaired: %d not a number, %d infinite, %d negative\n", static_cast<int>(repairs.nan),
                static_cast<int>(repairs.infinite), static_cast<int>(repairs.negative));
    const int factor = size.x / kColumns;
    save_panels(options, "repairs", 2,
                {{enlarge(marked(damaged), factor), "as it came"},
                 {enlarge(marked(image), factor), "repaired"},
                 {matt_white(factor * kColumns, damaged), "its light: none"},
                 {matt_white(factor * kColumns, image), "its light"}});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "50_environment", [](const Options& options) {
        print_directions();
        draw_layouts(options);
        draw_seams(options);
        draw_repairs(options);
    });
}
