#include "raster/fragments.hpp"

#include <algorithm>
#include <bit>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"
#include "raster/screen_lanes.hpp"

namespace kreda::raster {

namespace {

/// Centre of a sample, 1/256 sample.
inline std::int32_t centre_of(int sample) {
    return sample * kSubpixels + kPixelCentre;
}

/// One corner's share in the weights along a row: the exact edge function opposite to it, and 1/w.
struct CornerRow {
    double start = 0.0;      ///< E at the first sample, an exact integer
    double step = 0.0;       ///< change of E to the next sample, an exact integer
    double step_down = 0.0;  ///< the same to the sample below
    float scale = 0.0f;      ///< 1 / (area2 w): turns E into q
};

/// Everything that the samples of a run share. Edge i lies opposite to corner i, so E_i is the weight of corner i.
struct RunWeights {
    CornerRow a, b, c;
};

/// The edge from `from` to `to`, opposite to a corner, without the scale.
inline CornerRow corner_row(const ScreenVertex& from, const ScreenVertex& to, std::int32_t p_x, std::int32_t p_y) {
    return {edge_function<double>(from.x, from.y, to.x, to.y, p_x, p_y),
            static_cast<double>(from.y - to.y) * kSubpixels, static_cast<double>(to.x - from.x) * kSubpixels, 0.0f};
}

/// (p_x, p_y): the centre of the run's first sample, 1/256 sample.
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

/// q_i of the three corners at sample i of a run.
inline glm::vec3 corner_q(const RunWeights& w, int i) {
    const double k = i;
    return {static_cast<float>(w.a.start + w.a.step * k) * w.a.scale,
            static_cast<float>(w.b.start + w.b.step * k) * w.b.scale,
            static_cast<float>(w.c.start + w.c.step * k) * w.c.scale};
}

/// Weights of the three corners at sample i of a run; they sum to 1.
inline glm::vec3 corner_weights(const RunWeights& w, int i) {
    const glm::vec3 q = corner_q(w, i);
    const float inv_sum = 1.0f / (q.x + q.y + q.z);
    return {q.x * inv_sum, q.y * inv_sum, q.z * inv_sum};
}

/// Runs that are not longer than this are short: of small triangles most are. (In a debugger every sample is itself.)
constexpr int kShortRun = kBatchLanes > 1 ? 4 : 1;

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

/// How much q_i changes to the next sample, and to the one below.
inline glm::vec3 q_step_right(const RunWeights& w) {
    return {static_cast<float>(w.a.step) * w.a.scale, static_cast<float>(w.b.step) * w.b.scale,
            static_cast<float>(w.c.step) * w.c.scale};
}
inline glm::vec3 q_step_down(const RunWeights& w) {
    return {static_cast<float>(w.a.step_down) * w.a.scale, static_cast<float>(w.b.step_down) * w.b.scale,
            static_cast<float>(w.c.step_down) * w.c.scale};
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

/// The weights from sample to sample of the run, which may leave some out.
inline RunWeights along(RunWeights weights, const Run& run) {
    for (CornerRow* const row : {&weights.a, &weights.b, &weights.c}) row->step *= run.step;
    return weights;
}

/// Samples of a run, and how far it is from each to what counts as its neighbour.
struct Neighbours {
    RunWeights along_run;
    glm::vec3 dq_right, dq_down;
};

inline Neighbours neighbours_of(const RunWeights& w, const Run& run, int spacing) {
    const auto apart = static_cast<float>(spacing);
    return {along(w, run), apart * q_step_right(w), apart * q_step_down(w)};
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

/// A corner as the weights want it: 1/w, or 1 where they shall leave out the perspective.
inline ScreenVertex corner_of(const BatchTask& task, std::uint32_t vertex) {
    ScreenVertex corner = task.in.screen[vertex];
    if (!task.perspective) corner.inv_w = 1.0f;
    return corner;
}

/// One corner's share in the weights of runs that are prepared side by side, a lane a run.
struct CornerRowLanes {
    alignas(64) double start[kScreenLanes];
    double step[kScreenLanes];
    float scale[kScreenLanes];

    void set(int r, const CornerRow& row) {
        start[r] = row.start;
        step[r] = row.step;
        scale[r] = row.scale;
    }
    [[nodiscard]] CornerRow at(int r) const {
        return {start[r], step[r], 0.0, scale[r]};
    }
};

/// Runs that are prepared side by side: the corners of their triangles, the centre of the first sample, and the result.
struct RunLanes {
    ScreenLanes a, b, c;
    std::int32_t x[kScreenLanes] = {}, y[kScreenLanes] = {};
    std::array<std::uint32_t, 3> vertex[kScreenLanes];
    bool behind[kScreenLanes];
    CornerRowLanes row_a, row_b, row_c;
    float b0[kScreenLanes], b1[kScreenLanes], b2[kScreenLanes];  ///< weights at the first sample

    void set(int r, const RunWeights& w, const glm::vec3& first) {
        row_a.set(r, w.a);
        row_b.set(r, w.b);
        row_c.set(r, w.c);
        b0[r] = first.x;
        b1[r] = first.y;
        b2[r] = first.z;
    }
    [[nodiscard]] RunWeights at(int r) const {
        return {row_a.at(r), row_b.at(r), row_c.at(r)};
    }
};

inline RunWeights weights_of(const RunLanes& runs, int r) {
    return run_weights(runs.a.at(r), runs.b.at(r), runs.c.at(r), runs.x[r], runs.y[r]);
}

inline void fetch_runs(const BatchTask& task, const Run* runs, int count, RunLanes& out) {
    for (int r = 0; r < count; ++r) {
        const ScreenTriangle& triangle = task.set.triangle(runs[r].triangle);
        const std::array<std::uint32_t, 3> v = triangle.vertex;
        out.vertex[r] = v;
        out.behind[r] = task.two_sided && triangle.behind;
        out.a.set(r, corner_of(task, v[0]));
        out.b.set(r, corner_of(task, v[1]));
        out.c.set(r, corner_of(task, v[2]));
        out.x[r] = centre_of(task.area.x + runs[r].x);
        out.y[r] = centre_of(task.area.y + runs[r].y);
    }
}

inline void prepare_runs(int lanes, RunLanes& runs) {
    for (int i = 0; i < lanes; ++i) {
        const RunWeights weights = weights_of(runs, i);
        runs.set(i, weights, corner_weights(weights, 0));
    }
}

/// All attributes of prepared run r into the samples from `first` on. Where the number of lanes is a constant the loops
/// unroll: most runs of small triangles hold one sample or a few.
inline void interpolate_run(const BatchTask& task, const RunLanes& runs, int r, const Run& run, Fragments& out,
                            int first) {
    WeightRow row;
    const int count = run.count;
    if (count == 1) {
        row.set(0, {runs.b0[r], runs.b1[r], runs.b2[r]});
        blend_run(task.in, runs.vertex[r], runs.behind[r], row, 1, out, first);
    } else if (count <= kShortRun) {
        fill_weights(along(runs.at(r), run), kShortRun, row);
        blend_run(task.in, runs.vertex[r], runs.behind[r], row, kShortRun, out, first);
    } else {
        fill_weights(along(runs.at(r), run), lanes_for(count), row);
        blend_run(task.in, runs.vertex[r], runs.behind[r], row, lanes_for(count), out, first);
    }
    if (task.with_uv_steps)
        fill_uv_steps(task.in.uv, runs.vertex[r], neighbours_of(weights_of(runs, r), run, task.spacing),
                      lanes_for(count), out, first);
}

KREDA_BATCH_LOOP void interpolate_all(BatchTask task, const Run* runs, int run_count, Fragments& out) {
    RunLanes prepared;
    int first = 0;
    for (int done = 0; done < run_count; done += kScreenLanes) {
        const int count = std::min(run_count - done, kScreenLanes);
        fetch_runs(task, runs + done, count, prepared);
        prepare_runs(lanes_for(count), prepared);
        for (int r = 0; r < count; ++r) {
            interpolate_run(task, prepared, r, runs[done + r], out, first);
            first += runs[done + r].count;
        }
    }
    out.count = first;
}

/// Bit x of begins[y] is set where the triangle of sample (x, y) differs from its left neighbour's, and for x = 0.
KREDA_BATCH_LOOP void mark_beginnings(const TileVisibility& tile, int rows, std::uint64_t* __restrict begins) {
    alignas(64) std::uint64_t bit[kTileSide];
    for (int x = 0; x < kTileSide; ++x) bit[x] = std::uint64_t{1} << x;
    for (int y = 0; y < rows; ++y) {
        const std::uint32_t* row = &tile.triangle[y * kTileSide];
        std::uint64_t mask = 1;
        for (int x = 1; x < kTileSide; ++x) mask |= row[x] != row[x - 1] ? bit[x] : 0;
        begins[y] = mask;
    }
}

}  // namespace

int collect_runs(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, Run* runs) {
    int found = 0;
    std::uint64_t begins[kTileSide];
    mark_beginnings(tile, area.height, begins);
    for (int y = 0; y < area.height; ++y) {
        const std::uint32_t* row = &tile.triangle[y * kTileSide];
        std::uint64_t rest = begins[y];
        for (int x = 0; x < area.width;) {
            rest &= rest - 1;  // forget where this run begins; what is left begins later
            const int end = std::min(rest ? std::countr_zero(rest) : kTileSide, area.width);
            if (row[x] != kNoTriangle) {
                runs[found++] = {static_cast<std::uint16_t>(x),       static_cast<std::uint16_t>(y),
                                 static_cast<std::uint16_t>(end - x), 1,
                                 set.triangle(row[x]).material,       row[x]};
            }
            x = end;
        }
    }
    return found;
}

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
