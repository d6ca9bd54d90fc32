// Explain, shadows: which triangle, plane or volume decides; shadow maps have a file of their own.
#include "tools/explain/explain_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "scene/render/frame_shadows.hpp"
#include "scene/render/render.hpp"
#include "scene/render/shadow_pass.hpp"
#include "shadows/irregular.hpp"
#include "shadows/light_ray.hpp"
#include "shadows/planar.hpp"
#include "shadows/volume.hpp"

namespace kreda::tools {

namespace {

using scene::Frame;
using scene::Occluders;
using scene::PlannedShadow;
using shadows::Occluder;
using shadows::Triangle;

std::string caster_name(const Frame& frame, const PlannedShadow& planned, std::size_t caster) {
    const int object = planned.casters[caster];
    return "object " + std::to_string(object) + " (" + frame.scene.objects[static_cast<std::size_t>(object)].mesh_name +
           ")";
}

Triangle triangle_of(const Occluder& occluder, std::size_t i) {
    const auto corner = [&](std::size_t k) { return occluder.positions[occluder.indices[3 * i + k]]; };
    return {corner(0), corner(1), corner(2)};
}

/// Triangle i of those that cast, counted in the whole mesh.
std::size_t number_in_mesh(const Frame& frame, const PlannedShadow& planned, std::size_t caster, std::size_t i) {
    const raster::MeshInstance& instance = frame.buffers.instances[static_cast<std::size_t>(planned.casters[caster])];
    for (std::size_t p = 0; p < instance.mesh->parts.size(); ++p) {
        if (instance.part_hidden[p]) continue;
        const raster::MeshPart& part = instance.mesh->parts[p];
        if (i < part.triangle_count) return part.first_triangle + i;
        i -= part.triangle_count;
    }
    return i;
}

std::string caster_triangle(const Frame& frame, const PlannedShadow& planned, std::size_t caster, std::size_t i) {
    return caster_name(frame, planned, caster) + ", triangle " +
           std::to_string(number_in_mesh(frame, planned, caster, i));
}

/// A triangle between the point and the light, and how far along the ray.
struct Blocker {
    std::size_t caster = 0, triangle = 0;
    Triangle corners;
    double t = 0.0;  ///< in lengths of D
};

/// Every triangle of which `stands_between` says so, nearest to the point first.
template <class Test>
std::vector<Blocker> find_all_blockers(const Occluders& occluders, const shadows::LightRay& ray, Test stands_between) {
    std::vector<Blocker> found;
    for (std::size_t c = 0; c < occluders.list.size(); ++c) {
        for (std::size_t i = 0; i < occluders.list[c].indices.size() / 3; ++i) {
            const Triangle t = triangle_of(occluders.list[c], i);
            if (stands_between(t)) found.push_back({c, i, t, hit_parameter(ray, t)});
        }
    }
    std::sort(found.begin(), found.end(), [](const Blocker& a, const Blocker& b) { return a.t < b.t; });
    return found;
}

void say_ray(const shadows::LightRay& ray, const glm::dvec4& light, Section& section) {
    section.equation("D", light.w == 0.0 ? "-direction" : "p_light - p", "", glm::vec3(ray.direction),
                     "the ray to the light: p + t D" + std::string(light.w == 0.0 ? "" : ", t from 0 to 1"));
}

void say_blockers(const Frame& frame, const PlannedShadow& planned, const shadows::LightRay& ray,
                  const std::vector<Blocker>& blockers, Section& section) {
    if (blockers.empty()) {
        section.say("No triangle cuts the ray between the point and the light.");
        section.equation("shadow", "", "", 1.0f, "the ray is free");
        return;
    }
    const double length = glm::length(ray.direction);
    Table table{"blockers", {"triangle", "t", "hit at", "distance"}, {}};
    for (const Blocker& b : blockers) {
        table.rows.push_back({caster_triangle(frame, planned, b.caster, b.triangle), number_text(b.t),
                              vector_text(glm::vec3(ray.origin + b.t * ray.direction)), number_text(b.t * length)});
    }
    section.say("Triangles that the ray cuts and whose plane separates the point from the light, nearest first:");
    section.put(table);
    const Triangle& t = blockers.front().corners;
    const glm::dvec3 n = glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
    section.equation("n", "(b - a) × (c - a)", "", glm::vec3(n), "of the first one");
    section.equation(
        "t", "n·(a - p) / n·D",
        number_text(glm::dot(n, glm::dvec3(t.a) - ray.origin)) + " / " + factor_text(glm::dot(n, ray.direction)),
        std::vector<double>{blockers.front().t});
    section.equation("distance", "t |D|", number_text(blockers.front().t) + " · " + number_text(length),
                     std::vector<double>{blockers.front().t * length}, "from the point to it");
    section.equation("shadow", "", "", 0.0f, "one triangle is enough");
}

void explain_exact(const LitPoint& point, const PlannedShadow& planned, Section& section) {
    const Occluders occluders = collect_occluders(point.frame, planned.casters);
    const glm::dvec4 light = homogeneous(planned.source);
    const glm::vec3 p = point.points.position.at(0);
    const shadows::LightRay ray = shadows::light_ray(light, p);
    say_ray(ray, light, section);
    const auto between = [&](const Triangle& t) { return shadows_point(ray, t, light, p); };
    say_blockers(point.frame, planned, ray, find_all_blockers(occluders, ray, between), section);
}

/// Which sample of the picture the point is, and what is seen there.
struct SeenSample {
    std::size_t index = 0;
    int x = 0, y = 0;
    int object = 0;
    glm::vec3 position{0.0f};
};

SeenSample seen_sample(const LitPoint& point) {
    const shadows::VisibleSampleMemory& visible = point.frame.buffers.visible;
    const std::size_t i = point.points.sample[0];
    const int width = visible.viewport.width;
    const std::uint32_t triangle = visible.triangle[i];
    const raster::TriangleSet& set = point.frame.buffers.triangles;
    return {i, static_cast<int>(i) % width, static_cast<int>(i) / width,
            static_cast<int>(set.chunks[triangle >> raster::kChunkShift].instance), visible.position[i]};
}

void explain_irregular(const LitPoint& point, const PlannedShadow& planned, Section& section) {
    const Occluders occluders = collect_occluders(point.frame, planned.casters);
    const glm::dvec4 light = homogeneous(planned.source);
    const glm::vec3 p = seen_sample(point).position;
    const int number = view_of(planned.source, p);
    const shadows::LightRay ray = shadows::light_ray(light, p);
    if (number < 0) return section.equation("shadow", "", "", 1.0f, "the point is where the light is");
    const shadows::GridView view = grid_views(planned.source)[static_cast<std::size_t>(number)];
    const glm::dvec3 q = project(view, p);
    section.equation("(x, y, w)", "view (p, 1)", "", std::vector<double>{q.x, q.y, q.z},
                     "the point in the light's view");
    section.equation("place", "(x/w, y/w)", "", std::vector<double>{q.x / q.z, q.y / q.z},
                     "there the grid keeps this very point, not the middle of a texel");
    section.say(
        "Every triangle over its cell was tested: A × B · (x, y, w) has one sign for its three edges, and its "
        "plane separates the point from the light.");
    say_ray(ray, light, section);
    const auto between = [&](const Triangle& t) {
        const glm::dvec3 corners[3] = {project(view, t.a), project(view, t.b), project(view, t.c)};
        return shadows_point(shadows::with_edges(t, corners), q, light, p);
    };
    say_blockers(point.frame, planned, ray, find_all_blockers(occluders, ray, between), section);
}

void explain_volume(const LitPoint& point, const PlannedShadow& planned, Section& section) {
    const Frame& frame = point.frame;
    const SeenSample seen = seen_sample(point);
    const Occluders occluders = collect_occluders(frame, planned.casters);
    const std::vector<shadows::VolumeCaster> casters = collect_volume_casters(frame, planned, occluders);
    const shadows::VisibleSamples samples = frame.buffers.visible.samples();
    section.equation("z", "", "", samples.depth[seen.index], "window depth of what is seen");
    Table table{"faces", {"volume of", "depth of the face", "the ray", "behind z", "counts"}, {}};
    std::int32_t exits = 0, entries = 0;
    for (std::size_t c = 0; c < casters.size(); ++c) {
        const shadows::VolumeFaces faces = make_volume_faces({&casters[c], 1}, planned.source, samples);
        for (const shadows::FaceCrossing& face : faces_over(faces, samples, seen.x, seen.y)) {
            const int counts = face.is_behind ? face.weight : 0;
            (face.is_entry ? entries : exits) += counts;
            table.rows.push_back({caster_name(frame, planned, c), number_text(face.depth),
                                  face.is_entry ? "enters" : "leaves", face.is_behind ? "yes" : "no",
                                  std::to_string(face.is_entry ? -counts : counts)});
        }
    }
    section.say("Faces of shadow volumes over this sample; those behind what is seen count, an exit 1, an entry -1:");
    section.put(table);
    section.equation("count", "exits behind - entries behind", std::to_string(exits) + " - " + std::to_string(entries),
                     std::vector<double>{static_cast<double>(exits - entries)}, "volumes that the point lies in");
    section.equation("shadow", "1 where count is 0, else 0", "", shadows::volume_factor(exits - entries));
}

/// The plane, and the image of the triangle that covers the sample: M q with M = (P·L) I - L Pᵀ.
void explain_image(const LitPoint& point, const PlannedShadow& planned, const Occluders& occluders,
                   const shadows::PlanarSetup& setup, const shadows::PlanarCause& cause, const glm::vec3& p,
                   Section& section) {
    const Triangle t = triangle_of(occluders.list[cause.occluder], cause.triangle);
    section.say("The first triangle whose image on the plane covers this sample: " +
                caster_triangle(point.frame, planned, cause.occluder, cause.triangle) +
                ". Its corners and their images:");
    const glm::dmat4 M = shadows::planar_projection(setup.toward, setup.light);
    Table table{"images", {"corner", "height over the plane", "image"}, {}};
    for (const glm::vec3& corner : {t.a, t.b, t.c}) {
        const glm::dvec4 q(glm::dvec3(corner), 1.0), image = M * q;
        table.rows.push_back({vector_text(corner), number_text(glm::dot(setup.toward, q)),
                              image.w > 0.0 ? vector_text(glm::vec3(glm::dvec3(image) / image.w)) : "(clipped first)"});
    }
    section.put(table);
    const shadows::LightRay ray = shadows::light_ray(setup.light, p);
    const double along = hit_parameter(ray, t);
    const glm::dvec3 q = ray.origin + along * ray.direction;
    const glm::dvec4 image = M * glm::dvec4(q, 1.0);
    section.equation("q", "p + t D", vector_text(p) + " + " + factor_text(along) + "·D", glm::vec3(q),
                     "where the ray from the point to the light meets that triangle's plane");
    section.equation("image", "M (q, 1) / w", "M " + vector_text(glm::vec3(q)), glm::vec3(glm::dvec3(image) / image.w),
                     "M = (P·L) I - L Pᵀ: it falls on the point");
    section.equation("shadow", "", "", 0.0f, "an image covers the sample");
}

void explain_planar(const LitPoint& point, const PlannedShadow& planned, Section& section) {
    const SeenSample seen = seen_sample(point);
    const Occluders occluders = collect_occluders(point.frame, planned.casters);
    const auto& receivers = planned.receivers;
    const auto receiver = std::find_if(receivers.rbegin(), receivers.rend(),
                                       [&](const scene::ShadowReceiver& r) { return r.object == seen.object; });
    if (receiver == receivers.rend()) {
        return section.equation("shadow", "", "", 1.0f, "this object is not flat: planar shadows fall on planes alone");
    }
    const glm::dvec4 light = homogeneous(planned.source);
    section.equation("P", "", "",
                     std::vector<double>{receiver->plane.x, receiver->plane.y, receiver->plane.z, receiver->plane.w},
                     "the plane that receives: normal and offset");
    section.equation("L", light.w == 0.0 ? "(-direction, 0)" : "(p_light, 1)", "",
                     std::vector<double>{light.x, light.y, light.z, light.w}, "the light");
    section.equation("P·L", "", "", std::vector<double>{glm::dot(receiver->plane, light)}, "its height over the plane");
    const shadows::VisibleSamples samples = point.frame.buffers.visible.samples();
    const auto cause = planar_cause(occluders.list, receiver->plane, planned.source, samples, seen.x, seen.y);
    if (!cause) {
        section.equation("shadow", "", "", 1.0f, "no triangle's image covers the sample");
        return;
    }
    const shadows::PlanarSetup setup = planar_setup(receiver->plane, planned.source, samples);
    explain_image(point, planned, occluders, setup, *cause, seen.position, section);
}

}  // namespace

void explain_shadow(const LitPoint& point, const PlannedShadow& planned, Section& section) {
    const std::size_t number = static_cast<std::size_t>(&planned - point.frame.plan.shadows.data());
    switch (planned.map.settings.method) {
        case shadows::ShadowMethod::map:
            explain_shadow_map(point, point.frame.buffers.shadows[number].map, section);
            return;
        case shadows::ShadowMethod::exact: return explain_exact(point, planned, section);
        case shadows::ShadowMethod::irregular: return explain_irregular(point, planned, section);
        case shadows::ShadowMethod::volume: return explain_volume(point, planned, section);
        case shadows::ShadowMethod::planar: return explain_planar(point, planned, section);
    }
}

}  // namespace kreda::tools
