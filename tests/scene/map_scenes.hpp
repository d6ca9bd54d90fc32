// What the tests of maps share: small pictures as text, and a wall that fills the picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/temp_folder.hpp"

namespace kreda::tests {

/// A picture as text (PPM), all pixels alike.
inline std::string even_ppm(int r, int g, int b) {
    std::string text = "P3\n2 2\n255\n";
    for (int i = 0; i < 4; ++i) {
        text += std::to_string(r) + " " + std::to_string(g) + " " + std::to_string(b) + "\n";
    }
    return text;
}

inline std::string even_pgm(int grey) {
    return "P2\n1 1\n255\n" + std::to_string(grey) + "\n";
}

inline scene::Scene read_in(const TempFolder& folder, const std::string& text) {
    return scene::read_scene_text(text, "s.toml", folder.path.string());
}

inline std::string complaint_in(const TempFolder& folder, const std::string& text) {
    try {
        (void)read_in(folder, text);
    } catch (const scene::UserError& error) { return error.what(); }
    return "no complaint";
}

inline bool warns(const scene::Scene& scene, const std::string& part) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& warning) { return has(warning, part); });
}

/// The wall [-1, 1]^2 that fills the picture, straight ahead; material and the rest as given.
inline std::string wall(const std::string& material, const std::string& more = "") {
    return "[image]\nsize = [32, 32]\n[camera]\nposition = [0, 5, 0]\nup = [0, 0, -1]\nprojection = 'orthographic'\n"
           "height = 2\n[[light]]\ndirection = [0, -1, 0]\n[ambient]\ncolor = [0, 0, 0]\n" +
           more + "[[object]]\nmesh = 'plane'\nmaterial = 'm'\n[[material]]\nname = 'm'\n" + material;
}

inline float worst_difference(const raster::Image& a, const raster::Image& b) {
    REQUIRE(a.values.size() == b.values.size());
    float worst = 0.0f;
    for (std::size_t i = 0; i < a.values.size(); ++i) worst = std::max(worst, std::abs(a.values[i] - b.values[i]));
    return worst;
}

}  // namespace kreda::tests
