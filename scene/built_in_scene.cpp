#include "scene/files/read_scene.hpp"

namespace kreda::scene {

std::string built_in_scene_text() {
    return R"(# A teapot on a table: Kreda's built-in scene, and a good one to start your own from.
# Angles are degrees, colours are linear RGB. Every key has a default: delete a line and see.

[image]
size = [640, 360]
samples = 3                      # 3 x 3 samples a pixel
background = [0.55, 0.68, 0.85]

[camera]
position = [1.3, 1.5, 3.2]
target = [0, 0.4, 0]
vertical_fov = 30

[shading]
frequency = "phong"              # try "gouraud" and "flat"
cull = "none"                    # the pot is open at its rim: "back" lets you see through

[ambient]
color = [0.15, 0.15, 0.2]        # s_A

[[light]]                        # the sun, over your left shoulder
type = "directional"
direction = [1, -1.6, -0.9]      # the way the light travels
color = [1, 0.95, 0.85]
intensity = 0.85

[[light]]                        # a blue lamp behind the spout, for the rim of the belly
type = "point"
position = [1.8, 0.7, -1.4]
color = [0.5, 0.65, 1]
intensity = 1.2
attenuation = [1, 0, 0.2]        # 1 / (1 + 0.2 d^2)

[[material]]
name = "glaze"
model = "blinn_phong"            # try "phong" and "lambert"
ambient = [0.75, 0.3, 0.1]       # m_A
diffuse = [0.75, 0.3, 0.1]       # m_D
specular = [0.5, 0.5, 0.5]       # m_S
shininess = 80                   # h

[[material]]
name = "table"
model = "lambert"
ambient = [0.6, 0.55, 0.45]
diffuse = [0.6, 0.55, 0.45]

[[object]]
mesh = "teapot"
detail = 24                      # each of the 32 patches becomes 24 x 24 quads
material = "glaze"
rotate = [0, 20, 0]

[[object]]
mesh = "plane"
material = "table"
scale = [3, 1, 3]
)";
}

}  // namespace kreda::scene
