#include "shadows/volume.hpp"

#include <algorithm>
#include <cmath>

#include "raster/depth.hpp"
#include "raster/platform.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/row_bands.hpp"
#include "shadows/silhouette.hpp"

namespace kreda::shadows {

namespace {

using raster::ScreenVertex;

/// Projects the faces of one caster and appends what is left of them on the sample grid.
class FaceMaker {
public:
    FaceMaker(const VolumeCaster& caster, const glm::dvec4& light, const VisibleSamples& samples, VolumeFaces& out)
        : clip_(caster.position_clip), viewport_(samples.viewport), out_(out) {
        away_.reserve(clip_.size());
        for (const glm::vec3& p : caster.occluder.positions)
            away_.push_back(samples.clip_from_world * pushed_away(light, p));
    }

    /// Where the shadow begins, and the same triangle pushed away, turned over.
    void add_cap(const Cap& cap) {
        const auto [a, b, c] = cap.vertex;
        append(clip_[a], clip_[b], clip_[c]);
        keep(cap.is_clockwise, 1);
        append(away_[a], away_[b], away_[c]);
        stand_near();
        keep(!cap.is_clockwise, 1);
    }

    /// The quad from, from', to', to: counter-clockwise seen from outside.
    void add_side(const SilhouetteEdge& edge) {
        append(clip_[edge.from], away_[edge.from], away_[edge.to]);
        append(clip_[edge.from], away_[edge.to], clip_[edge.to]);
        stand_near();
        keep(false, edge.weight);
    }

private:
    void append(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c) {
        append_on_screen(a, b, c, viewport_, triangles_);
    }

    /// Put the corner first that is nearest to the picture's depths: there the depth plane stands, and far away a float
    /// is coarse. Not for caps: theirs stands where the surface's own does.
    void stand_near() {
        const auto farness = [](const ScreenVertex& v) { return std::abs(v.z - 0.5f); };
        for (ProjectedTriangle& t : triangles_) {
            if (farness(t.b) < std::min(farness(t.a), farness(t.c))) t = {t.b, t.c, t.a, t.is_front};
            if (farness(t.c) < std::min(farness(t.a), farness(t.b))) t = {t.c, t.a, t.b, t.is_front};
        }
    }

    void keep(bool turned_over, int weight) {
        for (const ProjectedTriangle& t : triangles_) out_.faces.push_back({t, t.is_front != turned_over, weight});
        triangles_.clear();
    }

    const std::vector<glm::vec4>& clip_;
    std::vector<glm::vec4> away_;  ///< clip space
    raster::Viewport viewport_;
    VolumeFaces& out_;
    std::vector<ProjectedTriangle> triangles_;
};

raster::DepthPlane plane_of(const ProjectedTriangle& t) {
    return raster::depth_plane(t.a, t.b, t.c, raster::edge_function(t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y));
}

/// Rows of one face from y_first to y_last: count where it lies behind what is seen.
KREDA_BATCH_LOOP void count_rows(const VolumeFace& face, raster::DepthPlane plane, int y_first, int y_last, int width,
                                 const float* __restrict depth, std::int32_t* __restrict count) {
    const bool is_entry = face.is_entry;
    const std::int32_t change = is_entry ? -face.weight : face.weight;
    for (int y = y_first; y <= y_last; ++y) {
        const SampleSpan span = covered_in_row(face.triangle, y, width);
        const float row_depth = raster::depth_of_row(plane, y);
        const float* seen = depth + static_cast<std::size_t>(y) * width;
        std::int32_t* row = count + static_cast<std::size_t>(y) * width;
        for (int x = span.first; x <= span.last; ++x) {
            const float z = raster::depth_at(plane, row_depth, x);
            row[x] += counts_behind(z, seen[x], is_entry) ? change : 0;
        }
    }
}

}  // namespace

std::vector<glm::vec4> clip_positions(const raster::MeshInstance& instance, const glm::mat4& clip_from_world) {
    const glm::mat4 clip_from_object = clip_from_world * instance.world_from_object;
    std::vector<glm::vec4> clip;
    clip.reserve(instance.mesh->positions.size());
    for (const glm::vec3& p : instance.mesh->positions) clip.push_back(clip_from_object * glm::vec4(p, 1.0f));
    return clip;
}

glm::vec4 pushed_away(const glm::dvec4& light, const glm::vec3& a) {
    constexpr double e = 0x1p-30;
    return glm::vec4((light.w + e) * glm::dvec4(glm::dvec3(a), 1.0) - light);
}

VolumeFaces make_volume_faces(std::span<const VolumeCaster> casters, const ShadowLight& light,
                              const VisibleSamples& samples) {
    const glm::dvec4 from = homogeneous(light);
    VolumeFaces result;
    for (std::uint32_t i = 0; i < casters.size(); ++i) {
        const VolumeShape shape = make_shadow_volume(casters[i].occluder, from);
        FaceMaker maker(casters[i], from, samples, result);
        for (const Cap& cap : shape.caps) maker.add_cap(cap);
        for (const SilhouetteEdge& edge : shape.sides) maker.add_side(edge);
        result.caps += static_cast<std::uint32_t>(shape.caps.size());
        result.sides += static_cast<std::uint32_t>(shape.sides.size());
        if (shape.open_triangles > 0) result.open_casters.push_back(i);
    }
    return result;
}

std::vector<std::int32_t> count_volumes(const VolumeFaces& faces, const VisibleSamples& samples) {
    const int width = samples.viewport.width, height = samples.viewport.height;
    std::vector<std::int32_t> count(static_cast<std::size_t>(width) * height, 0);
    const int bands = count_bands(height);
#pragma omp parallel for schedule(dynamic)
    for (int band = 0; band < bands; ++band) {
        const auto [band_first, band_last] = row_band(band, height);
        for (const VolumeFace& face : faces.faces) {
            const auto [a, b, c, is_front] = face.triangle;
            const raster::SampleBox box = sample_box(a, b, c, width, height);
            const int y_first = std::max(box.y_first, band_first), y_last = std::min(box.y_last, band_last);
            if (y_first > y_last) continue;
            count_rows(face, plane_of(face.triangle), y_first, y_last, width, samples.depth.data(), count.data());
        }
    }
    return count;
}

std::vector<FaceCrossing> faces_over(const VolumeFaces& faces, const VisibleSamples& samples, int x, int y) {
    const int width = samples.viewport.width, height = samples.viewport.height;
    const float seen = samples.depth[static_cast<std::size_t>(y) * width + x];
    std::vector<FaceCrossing> crossings;
    for (const VolumeFace& face : faces.faces) {
        const ProjectedTriangle& t = face.triangle;
        const raster::SampleBox box = sample_box(t.a, t.b, t.c, width, height);
        if (y < box.y_first || y > box.y_last) continue;
        const SampleSpan span = covered_in_row(t, y, width);
        if (x < span.first || x > span.last) continue;
        const raster::DepthPlane plane = plane_of(t);
        const float z = raster::depth_at(plane, raster::depth_of_row(plane, y), x);
        crossings.push_back({z, face.is_entry, face.weight, counts_behind(z, seen, face.is_entry)});
    }
    return crossings;
}

std::size_t bytes_to_count_volumes(std::size_t samples, std::size_t vertices, std::size_t triangles) {
    return samples * sizeof(std::int32_t) + vertices * 2 * sizeof(glm::vec4) + triangles * 4 * sizeof(VolumeFace);
}

std::vector<std::uint32_t> volume_shadow(std::span<const VolumeCaster> casters, const ShadowLight& light,
                                         const VisibleSamples& samples, std::span<float> shadow) {
    const VolumeFaces faces = make_volume_faces(casters, light, samples);
    const std::vector<std::int32_t> count = count_volumes(faces, samples);
    std::transform(count.begin(), count.end(), shadow.begin(), volume_factor);
    return faces.open_casters;
}

}  // namespace kreda::shadows
