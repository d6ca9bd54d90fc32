// Five small scenes that `kreda tune` is tried on.
#pragma once

#include <array>
#include <string>

namespace kreda::tests {

struct TunedScene {
    const char* name;
    const char* text;
};

/// The environment is sky.png, the texture squares.png, beside the scene.
inline constexpr std::array<TunedScene, 5> kTunedScenes = {{
    {"Phong and fog", R"(
[image]
size = [48, 27]
samples = 2
[camera]
position = [0, 1.5, 5]
target = [0, 0.3, 0]
[[light]]
direction = [-1, -2, -1]
[fog]
mode = "exp"
density = 0.12
[[material]]
name = "red"
model = "phong"
diffuse = [0.7, 0.2, 0.1]
[[object]]
mesh = "plane"
scale = [20, 1, 20]
translate = [0, -0.6, 0]
detail = 16
material = "red"
[[object]]
mesh = "sphere"
detail = 32
material = "red"
)"},
    {"textured Cook-Torrance", R"(
[image]
size = [48, 27]
[camera]
position = [0, 1, 4]
target = [0, 0, 0]
[[light]]
direction = [-1, -2, -1]
intensity = 3
[[material]]
name = "tiles"
model = "cook_torrance"
albedo_map = "squares.png"
roughness = 0.4
[[object]]
mesh = "sphere"
detail = 48
material = "tiles"
)"},
    {"metals under an environment", R"(
[image]
size = [32, 18]
[camera]
position = [0, 0.5, 4]
target = [0, 0, 0]
[environment]
file = "sky.png"
samples = 128
[[material]]
name = "gold"
model = "cook_torrance"
metallic = 1
roughness = 0.5
measured = "gold"
fresnel = "exact"
[[object]]
mesh = "sphere"
detail = 32
material = "gold"
)"},
    {"soft shadows", R"(
[image]
size = [48, 27]
[camera]
position = [0, 2.2, 4.2]
target = [0, 0.4, 0]
[[light]]
direction = [-1, -1.1, -0.6]
shadow = true
[shadow]
method = "map"
filter = "pcss"
size = 512
light_size = 0.1
[[material]]
name = "wood"
model = "lambert"
[[object]]
mesh = "plane"
scale = [2, 1, 1.5]
material = "wood"
casts_shadow = false
[[object]]
mesh = "cube"
scale = [0.3, 0.3, 0.3]
translate = [-0.3, 0.6, 0.2]
material = "wood"
)"},
    {"everything at once", R"(
[image]
size = [32, 18]
[camera]
position = [0, 1.2, 4.5]
target = [0, 0, 0]
[environment]
file = "sky.png"
samples = 128
[[light]]
direction = [-1, -2, -1]
intensity = 2
shadow = true
[shadow]
method = "map"
size = 512
[fog]
mode = "exp"
density = 0.05
[[material]]
name = "tiles"
model = "cook_torrance"
albedo_map = "squares.png"
roughness = 0.4
[[material]]
name = "floor"
model = "lambert"
[[object]]
mesh = "plane"
scale = [4, 1, 4]
translate = [0, -1, 0]
detail = 8
material = "floor"
[[object]]
mesh = "sphere"
detail = 32
material = "tiles"
)"},
}};

}  // namespace kreda::tests
