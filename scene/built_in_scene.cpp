#include "scene/files/read_scene.hpp"

namespace kreda::scene {

std::string built_in_scene_text() {
    return R"(# A teapot on a table in the evening: Kreda's built-in scene, and a good one to start your own from.
# Angles are degrees, colours are linear RGB. Every key has a default: delete a line and see.

[image]
size = [640, 360]
samples = 3                      # 3 x 3 samples a pixel
background = "environment"       # show the sky; or one colour: [0.55, 0.68, 0.85]
tone_map = "reinhard_extended"   # fits the bright sun into 0..1
white = 6

[camera]
position = [0.8, 1.0, 4.1]
target = [0.22, 0.52, 0]
vertical_fov = 26
far = 2000                       # to the horizon

[shading]
frequency = "phong"              # try "gouraud" and "flat"
cull = "none"                    # the pot is open at its rim: "back" lets you see through

[environment]                    # light from everywhere: the sky and what it shows on the glaze
sky = "sunset"                   # or "studio", "gradient", or file = "your.hdr"
rotation = 50

[[light]]                        # the sun, low, from the left
type = "directional"
direction = [1.5, -1, -0.4]      # the way the light travels
color = [1, 0.7, 0.42]
intensity = 6
shadow = true

[shadow]
filter = "pcss"                  # softer with distance; try "none" and "pcf"
light_size = 0.1                 # how wide the sun is, seen from distance 1

[[material]]
name = "glaze"
model = "cook_torrance"          # try "lambert", "phong", "blinn_phong" (three times as bright: docs/21_lambert.md)
albedo = [0.04, 0.28, 0.36]      # c, which cook_torrance reads
# diffuse = [0.04, 0.28, 0.36]   # m_D: instead of albedo where the model is one of the others
roughness = 0.2

[[material]]
name = "gold"
model = "cook_torrance"
measured = "gold"
metallic = 1
roughness = 0.25                 # 0.05 is a mirror

[[material]]
name = "table"
model = "cook_torrance"
albedo = [0.35, 0.28, 0.22]
roughness = 0.6

[[object]]
mesh = "teapot"
detail = 24                      # each of the 32 patches becomes 24 x 24 quads
material = "glaze"
rotate = [0, 20, 0]

[[object]]
mesh = "sphere"
material = "gold"
translate = [1.05, 0.2, 0.75]
scale = 0.2

[[object]]
mesh = "plane"
material = "table"
scale = [800, 1, 800]
casts_shadow = false             # so the shadow map need not cover it
)";
}

}  // namespace kreda::scene
