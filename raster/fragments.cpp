#include "raster/fragments.hpp"

#include <algorithm>
#include <bit>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// Everything that the samples of a run share: the exact edge functions along the row and 1/w of the corners.
/// Edge i lies opposite to corner i, so E_i is the weight of corner i.
struct RunWeights {
    double start[3];   ///< E_i at the run's first sample, an exact integer
    double step[3];    ///< change of E_i to the next sample, an exact integer
    double step_down[3];  ///< the same to the sample below
    float scale[3];    ///< 1 / (area2 w_i): turns E_i into q_i
};

RunWeights run_weights(const ScreenVertex* const corner[3], std::int64_t p_x, std::int64_t p_y,
                       AttributeInterpolation interpolation) {
    RunWeights weights;
    double area2 = 0.0;
    for (int i = 0; i < 3; ++i) {
        const ScreenVertex& a = *corner[(i + 1) % 3];
        const ScreenVertex& b = *corner[(i + 2) % 3];
        weights.start[i] = static_cast<double>(edge_function(a.x, a.y, b.x, b.y, p_x, p_y));
        weights.step[i] = static_cast<double>(std::int64_t{a.y - b.y} * kSubpixels);
        weights.step_down[i] = static_cast<double>(std::int64_t{b.x - a.x} * kSubpixels);
        area2 += weights.start[i];
    }
    const float inv_area2 = static_cast<float>(1.0 / area2);
    for (int i = 0; i < 3; ++i) {
        weights.scale[i] = interpolation == AttributeInterpolation::perspective ? inv_area2 * corner[i]->inv_w : inv_area2;
    }
    return weights;
}

/// q_i of the three corners at sample i of a run.
inline glm::vec3 corner_q(const RunWeights& w, int i) {
    const double k = i;
    return {static_cast<float>(w.start[0] + w.step[0] * k) * w.scale[0],
            static_cast<float>(w.start[1] + w.step[1] * k) * w.scale[1],
            static_cast<float>(w.start[2] + w.step[2] * k) * w.scale[2]};
}

/// Weights of the three corners at sample i of a run; they sum to 1.
inline glm::vec3 corner_weights(const RunWeights& w, int i) {
    const glm::vec3 q = corner_q(w, i);
    const float inv_sum = 1.0f / (q.x + q.y + q.z);
    return {q.x * inv_sum, q.y * inv_sum, q.z * inv_sum};
}

/// Corner weights of the samples of a run.
struct WeightRow {
    alignas(64) float b0[kTileSide];
    alignas(64) float b1[kTileSide];
    alignas(64) float b2[kTileSide];
};

inline void fill_weights(const RunWeights& w, int lanes, WeightRow& row) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 b = corner_weights(w, i);
        row.b0[i] = b.x;
        row.b1[i] = b.y;
        row.b2[i] = b.z;
    }
}

/// One component of an attribute along a run: a = b_0 a_0 + b_1 a_1 + b_2 a_2.
inline void blend(const WeightRow& b, int lanes, float a0, float a1, float a2, float* __restrict out) {
    for (int i = 0; i < lanes; ++i) out[i] = b.b0[i] * a0 + b.b1[i] * a1 + b.b2[i] * a2;
}

inline void blend3(const WeightRow& b, int lanes, const glm::vec3* stream, const std::array<std::uint32_t, 3>& vertex,
                   Channel3& out, int first) {
    const glm::vec3 a0 = stream[vertex[0]];
    const glm::vec3 a1 = stream[vertex[1]];
    const glm::vec3 a2 = stream[vertex[2]];
    blend(b, lanes, a0.x, a1.x, a2.x, out.x + first);
    blend(b, lanes, a0.y, a1.y, a2.y, out.y + first);
    blend(b, lanes, a0.z, a1.z, a2.z, out.z + first);
}

/// How much q_i changes to a neighbouring sample.
inline glm::vec3 q_step(const double (&step)[3], const RunWeights& w) {
    return {static_cast<float>(step[0]) * w.scale[0], static_cast<float>(step[1]) * w.scale[1],
            static_cast<float>(step[2]) * w.scale[2]};
}

/// a of the neighbour minus a here. A neighbour that the triangle's plane reaches only behind the eye (the plane's
/// horizon lies between) is as far away as can be.
inline float step_of(const glm::vec3& dq, float inv_sum_here, const glm::vec3& corner_value, float here) {
    constexpr float kAlmostHorizon = 1e-6f;
    const float sum_ratio = 1.0f + (dq.x + dq.y + dq.z) * inv_sum_here;
    const float change = dq.x * (corner_value.x - here) + dq.y * (corner_value.y - here) + dq.z * (corner_value.z - here);
    return change * inv_sum_here / (sum_ratio > kAlmostHorizon ? sum_ratio : kAlmostHorizon);
}

/// The steps of one texture coordinate along a run, to the right and down.
inline void fill_steps(const RunWeights& w, int lanes, const glm::vec3& corner_value, const float* __restrict here,
                       float* __restrict step_right, float* __restrict step_down) {
    const glm::vec3 right = q_step(w.step, w);
    const glm::vec3 down = q_step(w.step_down, w);
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 q = corner_q(w, i);
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
    const glm::vec2* uv;
    const glm::vec4* tangent;
    const float* fog;
};

inline void interpolate_uv(const Attributes& in, const std::array<std::uint32_t, 3>& v, const RunWeights& weights,
                           const WeightRow& b, int lanes, bool with_steps, Fragments& out, int first) {
    const glm::vec3 u(in.uv[v[0]].x, in.uv[v[1]].x, in.uv[v[2]].x);
    const glm::vec3 t(in.uv[v[0]].y, in.uv[v[1]].y, in.uv[v[2]].y);
    blend(b, lanes, u.x, u.y, u.z, out.u.value + first);
    blend(b, lanes, t.x, t.y, t.z, out.v.value + first);
    if (!with_steps) return;
    fill_steps(weights, lanes, u, out.u.value + first, out.du_dx.value + first, out.du_dy.value + first);
    fill_steps(weights, lanes, t, out.v.value + first, out.dv_dx.value + first, out.dv_dy.value + first);
}

/// Every sample of a run lies on the same triangle.
inline void fill_face_normal(const glm::vec3* position, const std::array<std::uint32_t, 3>& v, int lanes, Channel3& out,
                             int first) {
    const glm::vec3 normal = glm::cross(position[v[1]] - position[v[0]], position[v[2]] - position[v[0]]);
    for (int i = first; i < first + lanes; ++i) out.set(i, normal);
}

inline void interpolate_tangent(const glm::vec4* tangent, const std::array<std::uint32_t, 3>& v, const WeightRow& b,
                                int lanes, Fragments& out, int first) {
    const glm::vec4 t0 = tangent[v[0]];
    const glm::vec4 t1 = tangent[v[1]];
    const glm::vec4 t2 = tangent[v[2]];
    blend(b, lanes, t0.x, t1.x, t2.x, out.tangent.x + first);
    blend(b, lanes, t0.y, t1.y, t2.y, out.tangent.y + first);
    blend(b, lanes, t0.z, t1.z, t2.z, out.tangent.z + first);
    blend(b, lanes, t0.w, t1.w, t2.w, out.tangent_side.value + first);
}

inline void interpolate_run(const Attributes& in, const ScreenTriangle& triangle, const Run& run, const TileArea& area,
                            AttributeInterpolation interpolation, bool with_uv_steps, int lanes, Fragments& out,
                            int first) {
    const std::array<std::uint32_t, 3> v = triangle.vertex;
    const ScreenVertex* const corner[3] = {&in.screen[v[0]], &in.screen[v[1]], &in.screen[v[2]]};
    const std::int64_t p_x = (area.x + run.x) * kSubpixels + kPixelCentre;
    const std::int64_t p_y = (area.y + run.y) * kSubpixels + kPixelCentre;
    WeightRow b;
    const RunWeights weights = run_weights(corner, p_x, p_y, interpolation);
    fill_weights(weights, lanes, b);
    if (in.position) blend3(b, lanes, in.position, v, out.position, first);
    if (in.normal) blend3(b, lanes, in.normal, v, out.normal, first);
    if (in.face_corners) fill_face_normal(in.face_corners, v, lanes, out.face_normal, first);
    if (in.color) blend3(b, lanes, in.color, v, out.color, first);
    if (in.uv) interpolate_uv(in, v, weights, b, lanes, with_uv_steps, out, first);
    if (in.tangent) interpolate_tangent(in.tangent, v, b, lanes, out, first);
    if (in.fog) blend(b, lanes, in.fog[v[0]], in.fog[v[1]], in.fog[v[2]], out.fog.value + first);
}

/// Of small triangles most runs are not longer than this: a few lanes are then enough. The compiler makes two
/// versions of interpolate_run, one for a constant number of lanes.
constexpr int kShortRun = 4;

KREDA_BATCH_LOOP void interpolate_all(const Attributes& in, const TriangleSet& set, const TileArea& area,
                                      const Run* runs, int run_count, AttributeInterpolation interpolation,
                                      bool with_uv_steps, Fragments& out) {
    int first = 0;
    for (int r = 0; r < run_count; ++r) {
        const Run& run = runs[r];
        const ScreenTriangle& triangle = set.triangle(run.triangle);
        if (kBatchLanes > 1 && run.count <= kShortRun) {
            interpolate_run(in, triangle, run, area, interpolation, with_uv_steps, kShortRun, out, first);
        } else {
            interpolate_run(in, triangle, run, area, interpolation, with_uv_steps, lanes_for(run.count), out, first);
        }
        first += run.count;
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

int find_runs(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, Run* runs) {
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
                runs[found++] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                 static_cast<std::uint16_t>(end - x), set.triangle(row[x]).material, row[x]};
            }
            x = end;
        }
    }
    return found;
}

void interpolate_runs(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, const Run* runs,
                      int run_count, const FragmentNeeds& needs, AttributeInterpolation interpolation,
                      Fragments& fragments) {
    const Attributes attributes{streams.screen.data(),
                                needs.position ? streams.position_world.data() : nullptr,
                                needs.normal ? streams.normal_world.data() : nullptr,
                                needs.face_normal ? streams.position_world.data() : nullptr,
                                needs.color ? streams.color.data() : nullptr,
                                needs.uv ? streams.uv.data() : nullptr,
                                needs.tangent ? streams.tangent_world.data() : nullptr,
                                needs.fog ? streams.fog.data() : nullptr};
    interpolate_all(attributes, set, area, runs, run_count, interpolation, needs.uv_steps, fragments);
}

}  // namespace kreda::raster
