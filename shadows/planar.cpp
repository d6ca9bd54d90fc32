#include "shadows/planar.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shadows/light_ray.hpp"
#include "shadows/projected_triangles.hpp"
#include "shadows/row_bands.hpp"

namespace kreda::shadows {

namespace {

/// An occluder's image may reach this many times as far as the occluder is high; farther away nothing is seen of it.
constexpr double kFarthestImage = 0x1p20;

/// The part of a convex polygon where dot(form, corner) >= 0.
OccluderPart clip(const OccluderPart& in, const glm::dvec4& form) {
    return cut_polygon(
        in, [&](const glm::dvec4& corner) { return glm::dot(form, corner); },
        [](const glm::dvec4& inside, const glm::dvec4& outside, double t) { return inside + t * (outside - inside); });
}

void append_image(const OccluderPart& polygon, const glm::dmat4& clip_from_occluder, const raster::Viewport& viewport,
                  std::vector<ProjectedTriangle>& triangles) {
    const auto image = [&](int i) { return glm::vec4(clip_from_occluder * polygon.corner[i]); };
    raster::for_each_of_fan(0, polygon.count, [&](int i, int j, int k) {
        append_on_screen(image(i), image(j), image(k), viewport, triangles);
    });
}

/// Mark every sample that some triangle covers.
void mark(const std::vector<ProjectedTriangle>& triangles, const raster::Viewport& viewport, std::span<float> shadow) {
    const int bands = count_bands(viewport.height);
#pragma omp parallel for schedule(dynamic)
    for (int band = 0; band < bands; ++band) {
        const auto [band_first, band_last] = row_band(band, viewport.height);
        for (const ProjectedTriangle& t : triangles) {
            const raster::SampleBox box = sample_box(t.a, t.b, t.c, viewport.width, viewport.height);
            const int last = std::min(box.y_last, band_last);
            for (int y = std::max(box.y_first, band_first); y <= last; ++y) {
                const SampleSpan span = covered_in_row(t, y, viewport.width);
                float* row = shadow.data() + static_cast<std::size_t>(y) * viewport.width;
                if (span.first <= span.last) std::fill(row + span.first, row + span.last + 1, 0.0f);
            }
        }
    }
}

/// Height below which a corner counts as lying in the plane: the rounding error of positions, as in light_ray.hpp.
double in_plane_height(double largest_coordinate) {
    return kInterpolationRoundings * 0x1p-24 * largest_coordinate;
}

}  // namespace

std::optional<glm::dvec4> plane_of(const Occluder& occluder) {
    glm::dvec3 normal(0.0);  // of the largest triangle
    double size = 0.0;
    for (std::size_t i = 0; i + 2 < occluder.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return glm::dvec3(occluder.positions[occluder.indices[i + k]]); };
        const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n;
        for (std::size_t k = 0; k < 3; ++k) {
            size = std::max(size, largest_coordinate(occluder.positions[occluder.indices[i + k]]));
        }
    }
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    normal *= (occluder.clockwise ? -1.0 : 1.0) / length;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const std::uint32_t v : occluder.indices) {
        const double height = glm::dot(normal, glm::dvec3(occluder.positions[v]));
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (!(high - low <= in_plane_height(size))) return std::nullopt;
    return glm::dvec4(normal, -0.5 * (low + high));
}

OccluderPart between_plane_and_light(const glm::dvec4& plane, const glm::dvec4& light, const glm::vec3& a,
                                     const glm::vec3& b, const glm::vec3& c) {
    const double size =
        std::max({largest_coordinate(a), largest_coordinate(b), largest_coordinate(c), std::abs(plane.w)});
    const glm::dvec4 above = plane - glm::dvec4(0.0, 0.0, 0.0, in_plane_height(size));
    OccluderPart polygon{{{{glm::dvec3(a), 1.0}, {glm::dvec3(b), 1.0}, {glm::dvec3(c), 1.0}}}, 3};
    polygon = clip(polygon, above);
    if (light.w == 0.0) return polygon;
    const double light_height = glm::dot(plane, light) * (1.0 - 1.0 / kFarthestImage);
    return clip(polygon, glm::dvec4(0.0, 0.0, 0.0, light_height) - plane);
}

PlanarSetup planar_setup(const glm::dvec4& plane, const ShadowLight& light, const VisibleSamples& samples) {
    PlanarSetup setup;
    setup.light = homogeneous(light);
    const double light_height = glm::dot(plane, setup.light);
    if (light_height == 0.0) return setup;  // the light shines along the plane: nothing arrives, nothing is cast
    setup.casts = true;
    setup.toward = light_height > 0.0 ? plane : -plane;
    setup.clip_from_occluder = glm::dmat4(samples.clip_from_world) * planar_projection(setup.toward, setup.light);
    return setup;
}

namespace {

/// Append the image of triangle i of an occluder on the picture's grid.
void append_image(const PlanarSetup& setup, const Occluder& occluder, std::size_t i, const raster::Viewport& viewport,
                  std::vector<ProjectedTriangle>& triangles) {
    const auto corner = [&](std::size_t k) { return occluder.positions[occluder.indices[3 * i + k]]; };
    append_image(between_plane_and_light(setup.toward, setup.light, corner(0), corner(1), corner(2)),
                 setup.clip_from_occluder, viewport, triangles);
}

bool covers(const ProjectedTriangle& t, int x, int y, const raster::Viewport& viewport) {
    const raster::SampleBox box = sample_box(t.a, t.b, t.c, viewport.width, viewport.height);
    if (y < box.y_first || y > box.y_last) return false;
    const SampleSpan span = covered_in_row(t, y, viewport.width);
    return x >= span.first && x <= span.last;
}

}  // namespace

std::optional<PlanarCause> planar_cause(std::span<const Occluder> occluders, const glm::dvec4& plane,
                                        const ShadowLight& light, const VisibleSamples& samples, int x, int y) {
    const PlanarSetup setup = planar_setup(plane, light, samples);
    if (!setup.casts) return std::nullopt;
    std::vector<ProjectedTriangle> triangles;
    for (std::size_t o = 0; o < occluders.size(); ++o) {
        for (std::size_t i = 0; i < occluders[o].indices.size() / 3; ++i) {
            triangles.clear();
            append_image(setup, occluders[o], i, samples.viewport, triangles);
            for (const ProjectedTriangle& t : triangles) {
                if (covers(t, x, y, samples.viewport)) return PlanarCause{o, i};
            }
        }
    }
    return std::nullopt;
}

void planar_shadow(std::span<const Occluder> occluders, const glm::dvec4& plane, const ShadowLight& light,
                   const VisibleSamples& samples, std::span<float> shadow) {
    std::fill(shadow.begin(), shadow.end(), 1.0f);
    const PlanarSetup setup = planar_setup(plane, light, samples);
    if (!setup.casts) return;
    std::vector<ProjectedTriangle> triangles;
    for (const Occluder& occluder : occluders) {
        for (std::size_t i = 0; i < occluder.indices.size() / 3; ++i) {
            append_image(setup, occluder, i, samples.viewport, triangles);
        }
    }
    mark(triangles, samples.viewport, shadow);
}

}  // namespace kreda::shadows
