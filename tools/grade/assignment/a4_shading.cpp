// A4: flat, Gouraud and Phong shading, and the normal's matrix.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "lighting/reflection.hpp"
#include "scene/render/render.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

struct LitCorners {
    glm::vec3 place[3], normal[3];
};

LitCorners lit_corners_of(const StageRow& row) {
    return {{row.vec3("a"), row.vec3("b"), row.vec3("c")}, {row.vec3("n_a"), row.vec3("n_b"), row.vec3("n_c")}};
}

glm::vec3 light_at(const StageRow& row, const glm::vec3& p, const glm::vec3& n) {
    const lighting::PhongMaterial m{row.vec3("m_A"), row.vec3("m_D"), row.vec3("m_S"), glm::vec3(0.0f),
                                    row.number("h")};
    const glm::vec3 v = lighting::unit(row.vec3("eye") - p);
    const lighting::ReflectedTerms terms = lighting::blinn_phong(n, row.vec3("l"), v, m);
    return lighting::ambient_term(row.vec3("s_A"), m.ambient) + row.vec3("radiance") * (terms.diffuse + terms.specular);
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return lighting::unit(glm::cross(b - a, c - a));
}

glm::vec3 flat_color(const StageRow& row) {
    const LitCorners t = lit_corners_of(row);
    const glm::vec3 centre = (t.place[0] + t.place[1] + t.place[2]) * (1.0f / 3.0f);
    return light_at(row, centre, face_normal(t.place[0], t.place[1], t.place[2]));
}

glm::vec3 gouraud_color(const StageRow& row) {
    const LitCorners t = lit_corners_of(row);
    const glm::vec3 w = row.vec3("w");
    glm::vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) color += w[i] * light_at(row, t.place[i], lighting::unit(t.normal[i]));
    return color;
}

glm::vec3 phong_color(const StageRow& row) {
    const LitCorners t = lit_corners_of(row);
    const glm::vec3 w = row.vec3("w");
    glm::vec3 p(0.0f), n(0.0f);
    for (int i = 0; i < 3; ++i) {
        p += w[i] * t.place[i];
        n += w[i] * t.normal[i];
    }
    return light_at(row, p, lighting::unit(n));
}

glm::vec3 shade_pixel(const StageRow& row) {
    switch (static_cast<scene::ShadingFrequency>(row.integer("frequency"))) {
        case scene::ShadingFrequency::flat: return flat_color(row);
        case scene::ShadingFrequency::gouraud: return gouraud_color(row);
        case scene::ShadingFrequency::phong: return phong_color(row);
    }
    return glm::vec3(0.0f);
}

/// Corners on the screen are clockwise as they are seen; the course's are counter-clockwise.
constexpr std::size_t kOrder[3] = {0, 2, 1};

void add_corners(TableBuilder& builder, const SceneRecord& record, const SeenPoint& p, bool with_normals) {
    const raster::VertexStreams& streams = record.frame.buffers.streams;
    const auto& vertex = p.cover.triangle.vertex;
    const char* const places[] = {"a", "b", "c"};
    const char* const normals[] = {"n_a", "n_b", "n_c"};
    for (std::size_t i = 0; i < 3; ++i) builder.add(places[i], streams.position_world[vertex[kOrder[i]]]);
    for (std::size_t i = 0; i < 3 && with_normals; ++i)
        builder.add(normals[i], streams.normal_world[vertex[kOrder[i]]]);
}

void add_lit(TableBuilder& builder, const SceneRecord& record, const SeenPoint& p) {
    const lighting::LightSetup& light = record.frame.lighting.lights[0];
    const lighting::PhongMaterial& m = record.frame.plan.materials[p.cover.triangle.material].material.phong;
    builder.add("l", -light.axis);
    builder.add("radiance", light.radiance);
    builder.add("s_A", record.frame.lighting.ambient);
    builder.add("eye", record.frame.lighting.eye);
    builder.add("m_A", m.ambient);
    builder.add("m_D", m.diffuse);
    builder.add("m_S", m.specular);
    builder.add("h", m.shininess);
}

void record_normals(const SceneRecord& record, std::vector<StageTable>& tables) {
    TableBuilder world("world_normal", record.name), face("face_normal", record.name);
    for (const SeenPoint& p : some_points(record, 200)) {
        const raster::MeshInstance& instance = record.frame.buffers.instances[p.source.object];
        const glm::mat4& m = instance.world_from_object;
        std::initializer_list<double> matrix = {m[0][0], m[0][1], m[0][2], m[0][3], m[1][0], m[1][1], m[1][2], m[1][3],
                                                m[2][0], m[2][1], m[2][2], m[2][3], m[3][0], m[3][1], m[3][2], m[3][3]};
        world.add("world_from_object", matrix);
        world.add("n_object", instance.mesh->normals[p.source.vertex[0]]);
        world.end_row(p.pixel);
        add_corners(face, record, p, false);
        face.end_row(p.pixel);
    }
    append_rows(tables, world.table);
    append_rows(tables, face.table);
}

}  // namespace

void record_a4(const SceneRecord& record, std::vector<StageTable>& tables) {
    record_normals(record, tables);
    for (const char* stage : {"flat_color", "gouraud_color", "phong_color", "shade_pixel"}) {
        TableBuilder rows(stage, record.name);
        const bool picture = std::string(stage) == "shade_pixel";
        for (const SeenPoint& p : picture ? record.points : some_points(record, 200)) {
            if (picture) rows.add("frequency", static_cast<double>(record.scene().shading.frequency));
            add_corners(rows, record, p, true);
            rows.add("w", glm::vec3(p.weights[0], p.weights[2], p.weights[1]));
            add_lit(rows, record, p);
            rows.end_row(p.pixel);
        }
        append_rows(tables, rows.table);
    }
}

void reference_a4(StageRow row) {
    if (row.is("world_normal")) {
        const glm::mat3 matrix = raster::normal_from_object(row.mat4("world_from_object"));
        row.put("n", lighting::unit(matrix * row.vec3("n_object")));
    } else if (row.is("face_normal")) {
        row.put("n", face_normal(row.vec3("a"), row.vec3("b"), row.vec3("c")));
    } else if (row.is("flat_color")) {
        row.put("color", flat_color(row));
    } else if (row.is("gouraud_color")) {
        row.put("color", gouraud_color(row));
    } else if (row.is("phong_color")) {
        row.put("color", phong_color(row));
    } else if (row.is("shade_pixel")) {
        row.put("color", shade_pixel(row));
    }
}

}  // namespace kreda::tools
