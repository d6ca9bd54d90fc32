// The workload W9: what a student downloads, at its largest.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "raster/image.hpp"
#include "raster/shapes.hpp"
#include "scene/files/image_file.hpp"
#include "tools/bench/process_bench.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

constexpr const char* kMillionScene = R"(# W9: a million triangles with three textures under an image of an environment.
[image]
size = [1280, 720]
background = "environment"
tone_map = "reinhard"

[camera]
position = [0, 1.6, 3.4]
target = [0, 0, 0]

[environment]
file = "sky.exr"

[[light]]
direction = [-0.5, -1, -0.4]
intensity = 3
shadow = true

[[material]]
name = "glazed"
model = "cook_torrance"
albedo_map = "albedo.png"
roughness_map = "roughness.png"
ao_map = "ao.png"
texture_scale = [8, 2]

[[object]]
mesh = "torus.obj"
material = "glazed"
)";

template <class... Numbers>
void append(std::string& text, const char* format, Numbers... numbers) {
    char line[128];
    const int length = std::snprintf(line, sizeof line, format, numbers...);
    text.append(line, static_cast<std::size_t>(length));
}

std::string obj_text(const raster::Mesh& mesh) {
    std::string text = "# written by kreda bench\no torus\n";
    for (const glm::vec3& p : mesh.positions) append(text, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    for (const glm::vec2& uv : mesh.uvs) append(text, "vt %.6f %.6f\n", uv.x, uv.y);
    for (const glm::vec3& n : mesh.normals) append(text, "vn %.5f %.5f %.5f\n", n.x, n.y, n.z);
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const unsigned a = mesh.indices[t] + 1, b = mesh.indices[t + 1] + 1, c = mesh.indices[t + 2] + 1;
        append(text, "f %u/%u/%u %u/%u/%u %u/%u/%u\n", a, a, a, b, b, b, c, c, c);
    }
    return text;
}

/// Waves and a grain, so that the file is as large as that of a photograph.
raster::Image texture(float from, float to, float waves) {
    constexpr int kSide = 1024;
    raster::Image image = raster::make_image(kSide, kSide, 3);
    std::uint32_t grain = 1;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            grain = grain * 1664525u + 1013904223u;
            const float wave = 0.5f + 0.4f * std::sin(waves * 6.2831853f * static_cast<float>(x + y) / kSide);
            const float share = wave + 0.1f * static_cast<float>(grain >> 8) / static_cast<float>(1u << 24);
            image.set_rgb(x, y, from + (to - from) * share * glm::vec3(1.0f, 0.8f, 0.6f));
        }
    }
    return image;
}

/// A bright sky over a dark ground, and a sun.
raster::Image sky() {
    constexpr int kWidth = 1024, kHeight = 512;
    raster::Image image = raster::make_image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y) {
        const float up = 1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / kHeight;
        for (int x = 0; x < kWidth; ++x) {
            const bool sun = std::hypot(static_cast<float>(x) - 300.0f, static_cast<float>(y) - 120.0f) < 8.0f;
            const float light = sun ? 300.0f : up > 0.0f ? 0.4f + up : 0.15f;
            image.set_rgb(x, y, light * glm::vec3(1.0f, 0.95f, sun ? 0.8f : 1.15f));
        }
    }
    return image;
}

}  // namespace

void write_million_triangles(const std::string& folder) {
    make_folder(folder);
    const std::filesystem::path place = folder;
    const raster::Mesh mesh = raster::make_shape("torus", 1000).value();
    write_file((place / "torus.obj").string(), obj_text(mesh));
    scene::write_png((place / "albedo.png").string(), texture(0.2f, 0.9f, 9.0f));
    scene::write_png((place / "roughness.png").string(), texture(0.15f, 0.7f, 4.0f));
    scene::write_png((place / "ao.png").string(), texture(0.6f, 1.0f, 15.0f));
    scene::write_exr((place / "sky.exr").string(), sky());
    write_file((place / "W9.toml").string(), kMillionScene);
    std::fprintf(stderr, "wrote %s: %u triangles\n", (place / "W9.toml").c_str(), mesh.triangle_count());
}

}  // namespace kreda::tools
