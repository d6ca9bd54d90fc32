// One sample of a drawn frame, looked at again: every triangle over it, just as the rasterizer judged it, and every
// triangle that would be over it had it not been left out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/fragments.hpp"
#include "scene/render/render.hpp"

namespace kreda::tools {

/// Where a triangle of the picture comes from: which one of which part of which object.
struct SourceTriangle {
    std::uint32_t object = 0;               ///< index into Scene::objects
    std::uint32_t part = 0;                 ///< of the object's mesh
    std::uint32_t triangle = 0;             ///< of the mesh, all parts counted
    std::array<std::uint32_t, 3> vertex{};  ///< of the mesh
};

/// The triangle that has this number over all objects (ScreenTriangle::source).
[[nodiscard]] SourceTriangle find_source(const std::vector<raster::MeshInstance>& instances, std::uint32_t source);

/// A triangle of the frame over the centre of a sample.
struct Cover {
    std::uint32_t id = 0;  ///< triangle_id()
    raster::ScreenTriangle triangle;
    std::array<std::int64_t, 3> edge{};  ///< E_i, exact; edge i lies opposite to corner i
    float depth = 0.0f;                  ///< window depth at the sample's centre
};

/// Edge functions of a drawn triangle at the centre of sample (x, y), whether that is covered or not.
[[nodiscard]] std::array<std::int64_t, 3> edges_at(const raster::VertexStreams& streams,
                                                   const raster::ScreenTriangle& triangle, int x, int y);

/// Every triangle of the set over the centre of each sample, row by row from the top; each list in drawing order.
[[nodiscard]] std::vector<std::vector<Cover>> triangles_over_all(const raster::VertexStreams& streams,
                                                                 const raster::TriangleSet& set, int width, int height);

/// Every triangle of the set over the centre of sample (x, y), in drawing order.
[[nodiscard]] std::vector<Cover> triangles_over(const raster::VertexStreams& streams, const raster::TriangleSet& set,
                                                int x, int y);

/// Place in the list of the triangle that the depth test leaves; -1: none.
[[nodiscard]] int nearest_of(const std::vector<Cover>& covers);

/// Weights of a drawn triangle's corners at the centre of sample (x, y), by the very loop that interpolates attributes.
[[nodiscard]] glm::vec3 corner_weights_at(const raster::VertexStreams& streams, const raster::ScreenTriangle& triangle,
                                          int x, int y, raster::AttributeInterpolation interpolation);

/// A vertex of a mesh on its way through the spaces.
struct VertexSpaces {
    glm::vec3 object{0.0f};
    glm::vec3 world{0.0f};
    glm::vec4 view{0.0f};
    glm::vec4 clip{0.0f};
    bool inside = false;          ///< inside near and far plane and guard band; the rest means nothing without it
    glm::vec3 ndc{0.0f};          ///< clip / w
    glm::vec3 window{0.0f};       ///< x and y in samples, y down; z in [0, 1]
    raster::ScreenVertex screen;  ///< snapped
};

[[nodiscard]] VertexSpaces vertex_spaces(const scene::Scene& scene, const scene::RenderPlan& plan,
                                         const raster::MeshInstance& instance, std::uint32_t vertex);

/// A corner of a drawn triangle, told by the triangle of the mesh it was cut from.
struct DrawnCorner {
    glm::vec3 weights{0.0f};  ///< of the mesh triangle's corners; (1, 0, 0) and so on where nothing was cut
    glm::vec4 clip{0.0f};
    raster::ScreenVertex screen;
};

/// The corners of a drawn triangle, and whether the clipper made it.
struct DrawnTriangle {
    std::array<DrawnCorner, 3> corner;
    bool clipped = false;
};
[[nodiscard]] DrawnTriangle drawn_triangle(const scene::Scene& scene, const scene::RenderPlan& plan,
                                           const scene::RenderBuffers& buffers, const raster::ScreenTriangle& triangle);

/// Why a triangle that lies over the sample was not drawn.
enum class Absence { hidden_part, culled, before_near_plane, beyond_far_plane };

struct AbsentTriangle {
    SourceTriangle source;
    Absence why = Absence::culled;
    double w =
        0.0;  ///< clip-space w of the point over the sample's centre: its distance in front of the eye (perspective)
    double z = 0.0;  ///< z/w there, -1 at the near plane, 1 at the far plane
};

/// Triangles that lie over the centre of sample (x, y) in front of the eye and were not drawn. Found by another way
/// than the rasterizer's: homogeneous edge functions in double, without snap and without clipping.  Olano & Greer 1997
[[nodiscard]] std::vector<AbsentTriangle> absent_over(const scene::Scene& scene, const scene::RenderPlan& plan,
                                                      const scene::RenderBuffers& buffers, int x, int y);

/// The drawn triangle whose outline comes nearest to the centre of a sample that it does not cover.
struct NearestEdge {
    raster::ScreenTriangle triangle;
    int edge = 0;           ///< from corner (edge + 1) % 3 to corner (edge + 2) % 3
    double distance = 0.0;  ///< from the sample's centre to the edge, in samples
};
[[nodiscard]] std::optional<NearestEdge> nearest_edge(const scene::RenderBuffers& buffers, int x, int y);

}  // namespace kreda::tools
