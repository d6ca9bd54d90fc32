// The workload W10: a hundred layers, each over the whole picture, of which one is seen.
#include <cstdio>
#include <filesystem>
#include <string>

#include "tools/bench/process_bench.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

constexpr int kLayers = 100;

constexpr const char* kLayersScene =
    R"(# W10: a hundred layers over the whole picture, drawn in no order; flat, one light.
[image]
size = [1920, 1080]

[camera]
position = [0, 0, 4]
target = [0, 0, 0]

[shading]
frequency = "flat"

[[light]]
direction = [-0.4, -0.8, -0.5]

[[material]]
name = "paper"
model = "lambert"
)";

std::string layer_text(int place) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "\n[[object]]\nmesh = \"plane\"\nmaterial = \"paper\"\nscale = 30\nrotate = [90, 0, 0]\ntranslate = "
                  "[0, 0, %.2f]\n",
                  -0.05 * place);
    return text;
}

}  // namespace

void write_layers(const std::string& folder) {
    make_folder(folder);
    std::string text = kLayersScene;
    // 37 and 100 have no common divisor: every layer comes once, far from the one before.
    for (int i = 0; i < kLayers; ++i) text += layer_text((37 * i + 11) % kLayers);
    const std::filesystem::path file = std::filesystem::path(folder) / "W10.toml";
    write_file(file.string(), text);
    std::fprintf(stderr, "wrote %s: %d layers\n", file.c_str(), kLayers);
}

}  // namespace kreda::tools
