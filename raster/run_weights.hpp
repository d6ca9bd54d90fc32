// The weights of a triangle's corners along a run of samples: exact edge functions and 1/w.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "raster/screen.hpp"

namespace kreda::raster {

/// One corner's share in the weights along a row: the exact edge function opposite to it, and 1/w.
struct CornerRow {
    double start = 0.0;      ///< E at the first sample, an exact integer
    double step = 0.0;       ///< change of E to the next sample, an exact integer
    double step_down = 0.0;  ///< the same to the sample below
    float scale = 0.0f;      ///< 1 / (area2 w): turns E into q
};

/// Everything that the samples of a run share. Edge i lies opposite to corner i, so E_i is the weight of corner i.
struct RunWeights {
    CornerRow a, b, c;  ///< one a corner
};

/// The edge from `from` to `to`, opposite to a corner, without the scale.
inline CornerRow corner_row(const ScreenVertex& from, const ScreenVertex& to, std::int32_t p_x, std::int32_t p_y) {
    return {edge_function<double>(from.x, from.y, to.x, to.y, p_x, p_y),
            static_cast<double>(from.y - to.y) * kSubpixels, static_cast<double>(to.x - from.x) * kSubpixels, 0.0f};
}

/// a, b, c: clockwise on the screen, on the guard band's grid, of an area above 0, their 1/w in 1e-9 .. 1e9 of each
/// other. (p_x, p_y): the centre of the run's first sample, 1/256 sample; the run lies in the triangle.
inline RunWeights run_weights(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int32_t p_x,
                              std::int32_t p_y) {
    RunWeights weights{corner_row(b, c, p_x, p_y), corner_row(c, a, p_x, p_y), corner_row(a, b, p_x, p_y)};
    const double area2 = weights.a.start + weights.b.start + weights.c.start;
    const float inv_area2 = static_cast<float>(1.0 / area2);
    weights.a.scale = inv_area2 * a.inv_w;
    weights.b.scale = inv_area2 * b.inv_w;
    weights.c.scale = inv_area2 * c.inv_w;
    return weights;
}

/// q_i = lambda_i / w_i of the three corners at sample i of a run, lambda_i in [0, 1].
inline glm::vec3 corner_q(const RunWeights& w, int i) {
    const double k = i;
    return {static_cast<float>(w.a.start + w.a.step * k) * w.a.scale,
            static_cast<float>(w.b.start + w.b.step * k) * w.b.scale,
            static_cast<float>(w.c.start + w.c.step * k) * w.c.scale};
}

/// Weights of the three corners at sample i of a run, q_i / sum q_i in [0, 1]; they sum to 1. Heckbert & Moreton 1991
inline glm::vec3 corner_weights(const RunWeights& w, int i) {
    const glm::vec3 q = corner_q(w, i);
    const float inv_sum = 1.0f / (q.x + q.y + q.z);
    return {q.x * inv_sum, q.y * inv_sum, q.z * inv_sum};
}

/// How much q_i changes to the next sample of the row.
inline glm::vec3 q_step_right(const RunWeights& w) {
    return {static_cast<float>(w.a.step) * w.a.scale, static_cast<float>(w.b.step) * w.b.scale,
            static_cast<float>(w.c.step) * w.c.scale};
}
/// How much q_i changes to the sample below.
inline glm::vec3 q_step_down(const RunWeights& w) {
    return {static_cast<float>(w.a.step_down) * w.a.scale, static_cast<float>(w.b.step_down) * w.b.scale,
            static_cast<float>(w.c.step_down) * w.c.scale};
}

/// The weights from sample to sample of a run that takes every step-th.
inline RunWeights along(RunWeights weights, int step) {
    weights.a.step *= step;
    weights.b.step *= step;
    weights.c.step *= step;
    return weights;
}

}  // namespace kreda::raster
