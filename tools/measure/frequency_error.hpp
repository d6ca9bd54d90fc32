// Where light is computed against how fine the triangles are: what each misses, and what it takes.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/scene.hpp"
#include "tools/measure/picture.hpp"

namespace kreda::tools {

/// In the order of scene::ShadingFrequency.
inline constexpr std::array<const char*, 3> kFrequencyNames = {"flat", "gouraud", "phong"};

/// A shiny ball, `detail` segments around, under one lamp, 2 x 2 samples a pixel. `frequency` as in kFrequencyNames.
[[nodiscard]] scene::Scene shiny_ball(std::size_t frequency, int detail, glm::ivec2 size = {320, 320});

/// One frequency at one detail, against Phong shading of detail 512.
struct FrequencyRow {
    std::size_t frequency = 0;
    int detail = 0;
    std::size_t triangles = 0;
    CodeError error;  ///< of all pixels, the background among them
    double ms = 0.0;  ///< of a frame, the median
};

/// All of one frequency. frames: how often each is timed, at least 1.
[[nodiscard]] std::vector<FrequencyRow> measure_frequency_rows(std::size_t frequency, const std::vector<int>& details,
                                                               const raster::Image& exact, int frames, int threads);

/// The picture that the others are held against.
[[nodiscard]] raster::Image finest_ball(glm::ivec2 size = {320, 320}, int threads = 0);

}  // namespace kreda::tools
