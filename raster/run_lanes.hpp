// Runs that are prepared side by side: triangles go in, weights along each run and at its first samples come out.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "raster/platform.hpp"
#include "raster/run_weights.hpp"
#include "raster/screen_lanes.hpp"
#include "raster/triangle_setup.hpp"

namespace kreda::raster {

/// Runs that are not longer than this are short: of small triangles most are. Their weights are made many runs at a
/// time, one side by side with the other, though some are not looked at. (In a debugger every sample is itself.)
inline constexpr int kShortRun = kBatchLanes > 1 ? 4 : 1;

/// One corner's share in the weights of runs that are prepared side by side, a lane a run.
struct CornerRowLanes {
    alignas(64) double start[kScreenLanes];  ///< see CornerRow
    double step[kScreenLanes];               ///< to the next sample of the run
    float scale[kScreenLanes];               ///< turns E into q

    /// The share in run r.
    void set(int r, const CornerRow& row) {
        start[r] = row.start;
        step[r] = row.step;
        scale[r] = row.scale;
    }
    /// As it was set, without the step down.
    [[nodiscard]] CornerRow at(int r) const {
        return {start[r], step[r], 0.0, scale[r]};
    }
};

/// One corner of triangles that are worked on side by side, as the weights want it: without depth.
struct CornerLanes {
    alignas(64) std::int32_t x[kScreenLanes] = {};  ///< 1/256 sample
    std::int32_t y[kScreenLanes] = {};              ///< 1/256 sample
    float inv_w[kScreenLanes] = {};                 ///< 1/w, or 1 where the perspective is left out

    /// The corner of triangle i; its depth is 0.
    [[nodiscard]] ScreenVertex at(int i) const {
        return {x[i], y[i], 0.0f, inv_w[i]};
    }
    /// Replaces it.
    void set(int i, const ScreenVertex& v) {
        x[i] = v.x;
        y[i] = v.y;
        inv_w[i] = v.inv_w;
    }
};

/// Corner weights of the first samples of runs side by side, those of a run one behind the other.
struct FirstWeights {
    alignas(64) float b0[kScreenLanes * kShortRun];  ///< of the first corner
    alignas(64) float b1[kScreenLanes * kShortRun];  ///< of the second
    alignas(64) float b2[kScreenLanes * kShortRun];  ///< of the third

    /// The weights at sample i of run r.
    void set(int r, int i, const glm::vec3& b) {
        b0[r * kShortRun + i] = b.x;
        b1[r * kShortRun + i] = b.y;
        b2[r * kShortRun + i] = b.z;
    }
    /// As they were set.
    [[nodiscard]] glm::vec3 at(int r, int i) const {
        return {b0[r * kShortRun + i], b1[r * kShortRun + i], b2[r * kShortRun + i]};
    }
};

/// The runs themselves, a lane a run.
struct RunLanes {
    const ScreenTriangle* triangle[kScreenLanes];  ///< that each shows
    CornerLanes a, b, c;                           ///< its corners
    std::int32_t x[kScreenLanes] = {};             ///< first sample, within the tile
    std::int32_t y[kScreenLanes] = {};             ///< its row
    std::int32_t step[kScreenLanes] = {};          ///< see Run
    CornerRowLanes row_a, row_b, row_c;            ///< weights along the run
    FirstWeights first;                            ///< weights at its first samples

    /// What was found out of run r.
    void set(int r, const RunWeights& w) {
        row_a.set(r, w.a);
        row_b.set(r, w.b);
        row_c.set(r, w.c);
    }
    /// The weights along run r.
    [[nodiscard]] RunWeights at(int r) const {
        return {row_a.at(r), row_b.at(r), row_c.at(r)};
    }
};

}  // namespace kreda::raster
