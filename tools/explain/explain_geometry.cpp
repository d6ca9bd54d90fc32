// Explain, first half: which triangle, its corners in every space, edge functions and the fill rule, depth.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "raster/camera.hpp"
#include "raster/depth.hpp"
#include "scene/plan/origin_words.hpp"
#include "scene/render/render.hpp"
#include "tools/explain/explain.hpp"

namespace kreda::tools {

namespace {

using raster::ScreenVertex;

/// Edge i lies opposite to corner i.
constexpr const char* kEdgeNames[3] = {"E_bc", "E_ca", "E_ab"};

std::string pair_text(std::int64_t x, std::int64_t y) {
    return "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

void put_matrix(const std::string& name, const glm::mat4& matrix, Section& section) {
    Table table{name, {name, "", "", ""}, {}};
    for (int row = 0; row < 4; ++row) {
        std::vector<std::string> cells;
        for (int column = 0; column < 4; ++column) cells.push_back(number_text(matrix[column][row]));
        table.rows.push_back(cells);
    }
    section.put(table);
}

/// Rows are spaces, columns the corners of the mesh's triangle.
Table spaces_table(const std::array<VertexSpaces, 3>& corner, int samples) {
    Table table{"spaces", {"space", "corner 0", "corner 1", "corner 2"}, {}};
    const auto row = [&](const char* space, auto&& value, bool after_divide) {
        std::vector<std::string> cells{space};
        for (const VertexSpaces& v : corner) cells.push_back(after_divide && !v.inside ? "(clipped first)" : value(v));
        table.rows.push_back(cells);
    };
    row(
        "object", [](const VertexSpaces& v) { return vector_text(v.object); }, false);
    row(
        "world", [](const VertexSpaces& v) { return vector_text(v.world); }, false);
    row(
        "view", [](const VertexSpaces& v) { return vector_text(glm::vec3(v.view)); }, false);
    row(
        "clip", [](const VertexSpaces& v) { return vector_text(v.clip); }, false);
    row(
        "ndc", [](const VertexSpaces& v) { return vector_text(v.ndc); }, true);
    if (samples > 1) {
        const float n = static_cast<float>(samples);
        row(
            "window, in pixels", [n](const VertexSpaces& v) { return vector_text(v.window / glm::vec3(n, n, 1.0f)); },
            true);
    }
    row(
        samples > 1 ? "window, in samples" : "window", [](const VertexSpaces& v) { return vector_text(v.window); },
        true);
    row(
        "snapped, 1/256", [](const VertexSpaces& v) { return pair_text(v.screen.x, v.screen.y); }, true);
    row(
        "1/w", [](const VertexSpaces& v) { return number_text(v.screen.inv_w); }, true);
    return table;
}

/// Where the clipper's corners lie in the triangle of the mesh.
void say_clipping(const DrawnTriangle& drawn, Section& section) {
    section.say(
        "The triangle crosses a plane of the view (or leaves the guard band): it was cut, and this is one of the "
        "pieces. Its corners, by their weights in the triangle of the mesh:");
    Table table{"clipped_corners", {"corner", "weights", "clip", "snapped, 1/256"}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner& corner = drawn.corner[i];
        table.rows.push_back({kCornerNames[i], vector_text(corner.weights), vector_text(corner.clip),
                              pair_text(corner.screen.x, corner.screen.y)});
    }
    section.put(table);
}

void say_order(const DrawnTriangle& drawn, Section& section) {
    std::string order;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3& w = drawn.corner[i].weights;
        const int original = w.x == 1.0f ? 0 : w.y == 1.0f ? 1 : 2;
        order += std::string(i ? ", " : "") + kCornerNames[i] + " = corner " + std::to_string(original);
    }
    section.say("On the screen, clockwise with y down, they are called " + order + ".");
}

void explain_spaces(const SampleFacts& sample, const SourceTriangle& source, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    const raster::MeshInstance& instance = frame.buffers.instances[source.object];
    Section section{"spaces", "its corners through the spaces", {}};
    if (scene::is_far_from_zero(frame.scene)) section.say(scene::origin_sentence(frame.scene));
    const std::string about = scene::mesh_origin_sentence(*instance.mesh);
    if (!about.empty()) section.say(about);
    put_matrix("world_from_object", instance.world_from_object, section);
    put_matrix("view_from_world", view_from_world(frame.scene.camera), section);
    const float aspect = raster::aspect_of(frame.scene.image.width, frame.scene.image.height);
    put_matrix("clip_from_view", clip_from_view(frame.scene.camera, aspect), section);
    std::array<VertexSpaces, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = vertex_spaces(frame.scene, frame.plan, instance, source.vertex[i]);
    }
    section.put(spaces_table(corner, frame.plan.samples));
    const std::string width = std::to_string(frame.plan.viewport.width);
    const std::string height = std::to_string(frame.plan.viewport.height);
    section.say("clip = clip_from_view view_from_world world_from_object object; ndc = clip / w; window = ((x + 1) " +
                width + "/2, (1 - y) " + height + "/2, (z + 1)/2)" + (frame.plan.samples > 1 ? ", in samples" : "") +
                "; snapped = the nearest 1/256.");
    const DrawnTriangle drawn = drawn_triangle(frame.scene, frame.plan, frame.buffers, sample.seen().triangle);
    if (drawn.clipped)
        say_clipping(drawn, section);
    else
        say_order(drawn, section);
    derivation.sections.push_back(section);
}

/// E = 0 is decided by the kind of edge, everything else by the sign.
std::string verdict(std::int64_t e, bool top_left) {
    if (e != 0) return e > 0 ? "inside" : "outside";
    return top_left ? "on the edge: inside" : "on the edge: outside";
}

std::string kind_of_edge(std::int64_t d_x, std::int64_t d_y) {
    if (d_y == 0) return d_x > 0 ? "top" : "bottom";
    return d_y < 0 ? "left" : "right";
}

Table edge_table(const scene::Frame& frame, const raster::ScreenTriangle& triangle, int x, int y) {
    Table table{"edges", {"edge", "from", "to", "E", "kind", "top-left", "the centre is"}, {}};
    const std::array<std::int64_t, 3> edge = edges_at(frame.buffers.streams, triangle, x, y);
    for (const std::size_t i : {2u, 0u, 1u}) {  // ab, bc, ca
        const ScreenVertex& from = frame.buffers.streams.screen[triangle.vertex[(i + 1) % 3]];
        const ScreenVertex& to = frame.buffers.streams.screen[triangle.vertex[(i + 2) % 3]];
        const bool top_left = raster::is_top_left(to.x - from.x, to.y - from.y);
        table.rows.push_back({kEdgeNames[i], pair_text(from.x, from.y), pair_text(to.x, to.y), std::to_string(edge[i]),
                              kind_of_edge(to.x - from.x, to.y - from.y), top_left ? "yes" : "no",
                              verdict(edge[i], top_left)});
    }
    return table;
}

void say_centre(int x, int y, Section& section) {
    section.equation("P", "(256 x + 128, 256 y + 128)",
                     "(256·" + std::to_string(x) + " + 128, 256·" + std::to_string(y) + " + 128)",
                     std::vector<double>{256.0 * x + 128.0, 256.0 * y + 128.0}, "the sample's centre, in 1/256");
    section.say(
        "E = (b_x - a_x)(P_y - a_y) - (b_y - a_y)(P_x - a_x), twice the area of a, b, P: whole numbers, exact. "
        "Inside is E > 0, and E = 0 on top and left edges.");
}

std::string name_of(Absence why) {
    switch (why) {
        case Absence::hidden_part: return "its part is hidden (object.hide)";
        case Absence::culled: return "culled: it shows its other side (shading.cull)";
        case Absence::before_near_plane: return "clipped: nearer than camera.near";
        case Absence::beyond_far_plane: return "clipped: farther than camera.far";
    }
    return "";
}

/// What would lie over the sample and was not drawn.
void say_absent(const SampleFacts& sample, Section& section) {
    const std::vector<AbsentTriangle> absent =
        absent_over(sample.frame.scene, sample.frame.plan, sample.frame.buffers, sample.x, sample.y);
    if (absent.empty()) {
        section.say("No triangle that was left out lies over it.");
        return;
    }
    section.say("Triangles over it that were not drawn, nearest first:");
    Table table{"not_drawn", {"triangle", "why", "z/w", "w"}, {}};
    for (const AbsentTriangle& t : absent) {
        table.rows.push_back(
            {triangle_text(sample.frame, t.source), name_of(t.why), number_text(t.z), number_text(t.w)});
    }
    section.put(table);
}

}  // namespace

void explain_triangle(const SampleFacts& sample, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    const SourceTriangle source = find_source(frame.buffers.instances, sample.seen().triangle.source);
    Section section{"triangle", "the triangle that is seen", {}};
    const std::uint32_t material = sample.seen().triangle.material;
    section.say(triangle_text(frame, source) + ": vertices " + std::to_string(source.vertex[0]) + ", " +
                std::to_string(source.vertex[1]) + ", " + std::to_string(source.vertex[2]) +
                " of its mesh, material \"" + frame.scene.materials[material].name + "\".");
    derivation.sections.push_back(section);
    explain_spaces(sample, source, derivation);
}

void explain_coverage(const SampleFacts& sample, Derivation& derivation) {
    Section section{"coverage", "is the sample's centre inside?", {}};
    say_centre(sample.x, sample.y, section);
    section.put(edge_table(sample.frame, sample.seen().triangle, sample.x, sample.y));
    derivation.sections.push_back(section);
}

void explain_depth(const SampleFacts& sample, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    const std::array<std::uint32_t, 3> v = sample.seen().triangle.vertex;
    const ScreenVertex& a = frame.buffers.streams.screen[v[0]];
    const ScreenVertex& b = frame.buffers.streams.screen[v[1]];
    const ScreenVertex& c = frame.buffers.streams.screen[v[2]];
    const raster::DepthPlane plane = depth_plane(a, b, c, raster::edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    const double d_x = (sample.x * 256.0 + 128.0 - a.x) / 256.0;
    const double d_y = (sample.y * 256.0 + 128.0 - a.y) / 256.0;
    Section section{"depth", "depth, and what it beat", {}};
    section.equation("z", "z_a + ∂z/∂y Δy + ∂z/∂x Δx",
                     number_text(plane.z0) + " + " + factor_text(plane.dz_dy) + "·" + factor_text(d_y) + " + " +
                         factor_text(plane.dz_dx) + "·" + factor_text(d_x),
                     sample.seen().depth, "window depth, 0 near, 1 far");
    Table table{"covers", {"drawn", "triangle", "depth", ""}, {}};
    for (std::size_t i = 0; i < sample.covers.size(); ++i) {
        const Cover& cover = sample.covers[i];
        const bool seen = static_cast<int>(i) == sample.nearest;
        const float behind = cover.depth - sample.seen().depth;
        table.rows.push_back({std::to_string(i + 1),
                              triangle_text(frame, find_source(frame.buffers.instances, cover.triangle.source)),
                              number_text(cover.depth),
                              seen            ? "seen"
                              : behind > 0.0f ? "hidden, " + number_text(behind) + " behind"
                                              : "hidden, as near but drawn later"});
    }
    section.say("Every triangle over this sample, in drawing order; the smaller depth wins, at equal depth the first:");
    section.put(table);
    say_absent(sample, section);
    derivation.sections.push_back(section);
}

void explain_absence(const SampleFacts& sample, Derivation& derivation) {
    const scene::Frame& frame = sample.frame;
    Section section{"background", "why the background is seen", {}};
    section.say("No drawn triangle covers the centre of this sample.");
    for (const Cover& cover : sample.covers) {
        section.say(triangle_text(frame, find_source(frame.buffers.instances, cover.triangle.source)) +
                    " covers it at depth " + number_text(cover.depth) + ", on the far plane: not nearer than nothing.");
    }
    const std::optional<NearestEdge> nearest = nearest_edge(frame.buffers, sample.x, sample.y);
    if (nearest) {
        const SourceTriangle source = find_source(frame.buffers.instances, nearest->triangle.source);
        section.say("Nearest is " + triangle_text(frame, source) + ": its edge " + (kEdgeNames[nearest->edge] + 2) +
                    " is " + number_text(nearest->distance) + " samples away.");
        say_centre(sample.x, sample.y, section);
        section.put(edge_table(frame, nearest->triangle, sample.x, sample.y));
    } else {
        section.say("Not a single triangle was drawn.");
    }
    say_absent(sample, section);
    explain_background_color(sample, section);
    derivation.sections.push_back(section);
}

}  // namespace kreda::tools
