#include "raster/fragments.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"
#include "raster/run_lanes.hpp"
#include "raster/run_weights.hpp"

namespace kreda::raster {

namespace {

/// Corner weights of the samples of one run.
struct WeightRow {
    alignas(64) float b0[kTileSide];
    alignas(64) float b1[kTileSide];
    alignas(64) float b2[kTileSide];

    void set(int i, const glm::vec3& b) {
        b0[i] = b.x;
        b1[i] = b.y;
        b2[i] = b.z;
    }
};

inline void fill_weights(const RunWeights& w, int lanes, WeightRow& row) {
    for (int i = 0; i < lanes; ++i) row.set(i, corner_weights(w, i));
}

/// One component of an attribute along a run: a = b_0 a_0 + b_1 a_1 + b_2 a_2.
inline void blend(const WeightRow& row, int lanes, float a0, float a1, float a2, float* __restrict out) {
    for (int i = 0; i < lanes; ++i) out[i] = row.b0[i] * a0 + row.b1[i] * a1 + row.b2[i] * a2;
}

inline void blend3(const WeightRow& b, int lanes, const glm::vec3* stream, const std::array<std::uint32_t, 3>& vertex,
                   Channel3& out, int first) {
    const glm::vec3& a0 = stream[vertex[0]];
    const glm::vec3& a1 = stream[vertex[1]];
    const glm::vec3& a2 = stream[vertex[2]];
    blend(b, lanes, a0.x, a1.x, a2.x, out.x + first);
    blend(b, lanes, a0.y, a1.y, a2.y, out.y + first);
    blend(b, lanes, a0.z, a1.z, a2.z, out.z + first);
}

/// a of the neighbour minus a here. A neighbour that the triangle's plane reaches only behind the eye (the plane's
/// horizon lies between) is as far away as can be.
inline float step_of(const glm::vec3& dq, float inv_sum_here, const glm::vec3& corner_value, float here) {
    constexpr float kAlmostHorizon = 1e-6f;
    const float sum_ratio = 1.0f + (dq.x + dq.y + dq.z) * inv_sum_here;
    const float change =
        dq.x * (corner_value.x - here) + dq.y * (corner_value.y - here) + dq.z * (corner_value.z - here);
    return change * inv_sum_here / (sum_ratio > kAlmostHorizon ? sum_ratio : kAlmostHorizon);
}

/// Samples of a run, and how far it is from each to what counts as its neighbour.
struct Neighbours {
    RunWeights along_run;
    glm::vec3 dq_right, dq_down;
};

inline Neighbours neighbours_of(const RunWeights& w, const Run& run, int spacing) {
    const auto apart = static_cast<float>(spacing);
    return {along(w, run.step), apart * q_step_right(w), apart * q_step_down(w)};
}

/// The steps of one texture coordinate along a run, to the right and down.
inline void fill_steps(const Neighbours& n, int lanes, const glm::vec3& corner_value, const float* __restrict here,
                       float* __restrict step_right, float* __restrict step_down) {
    const glm::vec3 right = n.dq_right;
    const glm::vec3 down = n.dq_down;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 q = corner_q(n.along_run, i);
        const float inv_sum = 1.0f / (q.x + q.y + q.z);
        step_right[i] = step_of(right, inv_sum, corner_value, here[i]);
        step_down[i] = step_of(down, inv_sum, corner_value, here[i]);
    }
}

/// The streams as bare arrays; null: the plan does not ask for this attribute.
struct Attributes {
    const ScreenVertex* screen;
    const glm::vec3* position;
    const glm::vec3* normal;
    const glm::vec3* face_corners;  ///< positions again, for the normal of the triangle itself
    const glm::vec3* color;
    const glm::vec3* color_behind;
    const glm::vec2* uv;
    const glm::vec4* tangent;
    const float* fog;
};

inline void interpolate_uv(const glm::vec2* uv, const std::array<std::uint32_t, 3>& v, const WeightRow& b, int lanes,
                           Fragments& out, int first) {
    blend(b, lanes, uv[v[0]].x, uv[v[1]].x, uv[v[2]].x, out.u.value + first);
    blend(b, lanes, uv[v[0]].y, uv[v[1]].y, uv[v[2]].y, out.v.value + first);
}

/// Requires u and v of the run.
inline void fill_uv_steps(const glm::vec2* uv, const std::array<std::uint32_t, 3>& v, const Neighbours& n, int lanes,
                          Fragments& out, int first) {
    const glm::vec3 u(uv[v[0]].x, uv[v[1]].x, uv[v[2]].x);
    const glm::vec3 t(uv[v[0]].y, uv[v[1]].y, uv[v[2]].y);
    fill_steps(n, lanes, u, out.u.value + first, out.du_dx.value + first, out.du_dy.value + first);
    fill_steps(n, lanes, t, out.v.value + first, out.dv_dx.value + first, out.dv_dy.value + first);
}

/// Every sample of a run lies on the same triangle. Its corners are in the order that the screen asks for, so the
/// normals of the vertices say which side is meant.
inline void fill_face_normal(const glm::vec3* position, const glm::vec3* normal, const std::array<std::uint32_t, 3>& v,
                             int lanes, Channel3& out, int first) {
    const glm::vec3 across = glm::cross(position[v[1]] - position[v[0]], position[v[2]] - position[v[0]]);
    const glm::vec3 outside = normal[v[0]] + normal[v[1]] + normal[v[2]];
    const glm::vec3 face_normal = glm::dot(across, outside) < 0.0f ? -across : across;
    for (int i = first; i < first + lanes; ++i) out.set(i, face_normal);
}

inline void interpolate_tangent(const glm::vec4* tangent, const std::array<std::uint32_t, 3>& v, const WeightRow& b,
                                int lanes, Fragments& out, int first) {
    const glm::vec4& t0 = tangent[v[0]];
    const glm::vec4& t1 = tangent[v[1]];
    const glm::vec4& t2 = tangent[v[2]];
    blend(b, lanes, t0.x, t1.x, t2.x, out.tangent.x + first);
    blend(b, lanes, t0.y, t1.y, t2.y, out.tangent.y + first);
    blend(b, lanes, t0.z, t1.z, t2.z, out.tangent.z + first);
    blend(b, lanes, t0.w, t1.w, t2.w, out.tangent_side.value + first);
}

/// The other side of a surface: its vectors point the other way, to the last bit.
inline void turn(float* __restrict values, int lanes) {
    for (int i = 0; i < lanes; ++i) values[i] = -values[i];
}

inline void turn(Channel3& vectors, int lanes, int first) {
    turn(vectors.x + first, lanes);
    turn(vectors.y + first, lanes);
    turn(vectors.z + first, lanes);
}

/// A run that is seen from behind, once its attributes are there.
inline void turn_run(const Attributes& in, int lanes, Fragments& out, int first) {
    if (in.normal) turn(out.normal, lanes, first);
    if (in.face_corners) turn(out.face_normal, lanes, first);
    if (!in.tangent) return;
    turn(out.tangent, lanes, first);
    turn(out.tangent_side.value + first, lanes);
}

/// All attributes of one run from its weights.
inline void blend_run(const Attributes& in, const std::array<std::uint32_t, 3>& v, bool behind, const WeightRow& b,
                      int lanes, Fragments& out, int first) {
    if (in.position) blend3(b, lanes, in.position, v, out.position, first);
    if (in.normal) blend3(b, lanes, in.normal, v, out.normal, first);
    if (in.face_corners) fill_face_normal(in.face_corners, in.normal, v, lanes, out.face_normal, first);
    if (in.color) blend3(b, lanes, behind ? in.color_behind : in.color, v, out.color, first);
    if (in.uv) interpolate_uv(in.uv, v, b, lanes, out, first);
    if (in.tangent) interpolate_tangent(in.tangent, v, b, lanes, out, first);
    if (in.fog) blend(b, lanes, in.fog[v[0]], in.fog[v[1]], in.fog[v[2]], out.fog.value + first);
    if (behind) turn_run(in, lanes, out, first);
}

/// What all runs of a batch share.
struct BatchTask {
    Attributes in;
    const TriangleSet& set;
    TileArea area;
    bool perspective = true;
    bool with_uv_steps = false;
    bool two_sided = false;
    int spacing = 1;
};

inline void fetch_runs(const BatchTask& task, const Run* runs, int count, RunLanes& out) {
    for (int r = 0; r < count; ++r) {
        const ScreenTriangle& triangle = task.set.triangle(runs[r].triangle);
        out.triangle[r] = &triangle;
        out.a.set(r, task.in.screen[triangle.vertex[0]]);
        out.b.set(r, task.in.screen[triangle.vertex[1]]);
        out.c.set(r, task.in.screen[triangle.vertex[2]]);
        out.x[r] = runs[r].x;
        out.y[r] = runs[r].y;
        out.step[r] = runs[r].step;
    }
}

/// Weights without the perspective: as if all corners were equally far away.
inline void leave_out_perspective(RunLanes& runs) {
    for (CornerLanes* const corner : {&runs.a, &runs.b, &runs.c}) std::fill_n(corner->inv_w, kScreenLanes, 1.0f);
}

/// Of the run's row and of the one below; not yet along the run.
inline RunWeights weights_of(const RunLanes& runs, int r, TileArea area) {
    return run_weights(runs.a.at(r), runs.b.at(r), runs.c.at(r), centre_of(area.x + runs.x[r]),
                       centre_of(area.y + runs.y[r]));
}

inline void prepare_runs(TileArea area, int lanes, RunLanes& runs) {
    for (int r = 0; r < lanes; ++r) {
        const RunWeights weights = along(weights_of(runs, r, area), runs.step[r]);
        runs.set(r, weights);
        for (int i = 0; i < kShortRun; ++i) runs.first.set(r, i, corner_weights(weights, i));
    }
}

/// All attributes of prepared run r into the samples from `first` on. Where the number of lanes is a constant the loops
/// unroll: most runs of small triangles hold a few samples.
inline void interpolate_run(const BatchTask& task, const RunLanes& runs, int r, const Run& run, Fragments& out,
                            int first) {
    const ScreenTriangle& triangle = *runs.triangle[r];
    const bool behind = task.two_sided && triangle.behind;
    const int lanes = lanes_for(run.count);
    WeightRow row;
    if (run.count <= kShortRun) {
        for (int i = 0; i < kShortRun; ++i) row.set(i, runs.first.at(r, i));
        blend_run(task.in, triangle.vertex, behind, row, kShortRun, out, first);
    } else {
        fill_weights(runs.at(r), lanes, row);
        blend_run(task.in, triangle.vertex, behind, row, lanes, out, first);
    }
    if (task.with_uv_steps)
        fill_uv_steps(task.in.uv, triangle.vertex, neighbours_of(weights_of(runs, r, task.area), run, task.spacing),
                      lanes, out, first);
}

KREDA_BATCH_LOOP void interpolate_all(BatchTask task, const Run* runs, int run_count, Fragments& out) {
    RunLanes prepared;
    int first = 0;
    for (int done = 0; done < run_count; done += kScreenLanes) {
        const int count = std::min(run_count - done, kScreenLanes);
        fetch_runs(task, runs + done, count, prepared);
        if (!task.perspective) leave_out_perspective(prepared);
        prepare_runs(task.area, lanes_for(count), prepared);
        for (int r = 0; r < count; ++r) {
            interpolate_run(task, prepared, r, runs[done + r], out, first);
            first += runs[done + r].count;
        }
    }
    out.count = first;
}

}  // namespace

void interpolate_runs(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, const Run* runs,
                      int run_count, const FragmentNeeds& needs, AttributeInterpolation interpolation,
                      Fragments& fragments, int spacing) {
    const Attributes attributes{streams.screen.data(),
                                needs.position ? streams.position_world.data() : nullptr,
                                needs.normal ? streams.normal_world.data() : nullptr,
                                needs.face_normal ? streams.position_world.data() : nullptr,
                                needs.color ? streams.color.data() : nullptr,
                                needs.color ? streams.color_behind.data() : nullptr,
                                needs.uv ? streams.uv.data() : nullptr,
                                needs.tangent ? streams.tangent_world.data() : nullptr,
                                needs.fog ? streams.fog.data() : nullptr};
    const bool perspective = interpolation == AttributeInterpolation::perspective;
    interpolate_all({attributes, set, area, perspective, needs.uv_steps, needs.two_sided, spacing}, runs, run_count,
                    fragments);
}

}  // namespace kreda::raster
