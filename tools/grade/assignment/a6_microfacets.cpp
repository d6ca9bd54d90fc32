// A6: Fresnel's F and Cook and Torrance's model.
#include <glm/geometric.hpp>

#include "lighting/cook_torrance.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

using lighting::CookTorranceSetup;

CookTorranceSetup setup_of(const StageRow& row) {
    lighting::CookTorranceMaterial material;
    material.albedo = row.vec3("albedo");
    material.metallic = row.number("metallic");
    material.roughness = row.number("roughness");
    return prepare(material);
}

glm::vec3 reflected(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const CookTorranceSetup& setup) {
    const lighting::ReflectedTerms terms = cook_torrance(n, l, v, setup);
    return terms.diffuse + terms.specular;
}

glm::vec3 shade_microfacets(const StageRow& row) {
    const CookTorranceSetup setup = setup_of(row);
    const glm::vec3 n = lighting::unit(row.vec3("n"));
    const glm::vec3 v = lighting::unit(row.vec3("eye") - row.vec3("p"));
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < row.count("light_radiance", 3); ++i) {
        const lighting::LightSetup light = light_at(row, i);
        sum += light.radiance * reflected(n, -light.axis, v, setup);
    }
    return sum;
}

void add_surface(TableBuilder& builder, const lighting::CookTorranceMaterial& m) {
    builder.add("albedo", m.albedo);
    builder.add("metallic", m.metallic);
    builder.add("roughness", m.roughness);
}

const lighting::CookTorranceMaterial& material_of(const SceneRecord& record, const SeenPoint& p) {
    return record.frame.plan.materials[p.cover.triangle.material].material.cook_torrance;
}

/// One row of each function for a point and a light that shines on it.
struct FunctionRows {
    TableBuilder f0, schlick, ggx, geometry, whole;
};

void add_point(FunctionRows& rows, const SceneRecord& record, const SeenPoint& p, const lighting::LightSetup& light) {
    const lighting::CookTorranceMaterial& m = material_of(record, p);
    const glm::vec3 n = lighting::unit(p.normal), v = lighting::unit(record.frame.lighting.eye - p.position);
    const lighting::MicrofacetAngles angles = lighting::microfacet_angles(n, -light.axis, v);
    rows.whole.add("n", n);
    rows.whole.add("l", -light.axis);
    rows.whole.add("v", v);
    add_surface(rows.whole, m);
    rows.whole.end_row(p.pixel);
    rows.f0.add("albedo", m.albedo);
    rows.f0.add("metallic", m.metallic);
    rows.f0.end_row(p.pixel);
    rows.schlick.add("F0", lighting::base_reflectivity(m.albedo, m.metallic));
    rows.schlick.add("v_dot_h", angles.v_dot_h);
    rows.schlick.end_row(p.pixel);
    rows.ggx.add("n_dot_h", angles.n_dot_h);
    rows.ggx.add("roughness", m.roughness);
    rows.ggx.end_row(p.pixel);
    if (angles.n_dot_l < 0.001f || angles.n_dot_v < 0.001f) return;
    rows.geometry.add("n_dot_l", angles.n_dot_l);
    rows.geometry.add("n_dot_v", angles.n_dot_v);
    rows.geometry.add("roughness", m.roughness);
    rows.geometry.end_row(p.pixel);
}

}  // namespace

void record_a6(const SceneRecord& record, std::vector<StageTable>& tables) {
    FunctionRows rows{{"base_reflectivity", record.name},
                      {"schlick", record.name},
                      {"ggx", record.name},
                      {"geometry", record.name},
                      {"cook_torrance", record.name}};
    for (const lighting::LightSetup& light : record.frame.lighting.lights) {
        for (const SeenPoint& p : some_points(record, 200)) add_point(rows, record, p, light);
    }
    for (const TableBuilder* t : {&rows.f0, &rows.schlick, &rows.ggx, &rows.geometry, &rows.whole}) {
        append_rows(tables, t->table);
    }
    TableBuilder picture("shade", record.name);
    list_lights(picture, record.frame.lighting.lights);
    for (const SeenPoint& p : record.points) {
        picture.add("p", p.position);
        picture.add("n", p.normal);
        picture.add("eye", record.frame.lighting.eye);
        add_surface(picture, material_of(record, p));
        picture.end_row(p.pixel);
    }
    append_rows(tables, picture.table);
}

void reference_a6(StageRow row) {
    if (row.is("base_reflectivity")) {
        row.put("F0", lighting::base_reflectivity(row.vec3("albedo"), row.number("metallic")));
    } else if (row.is("schlick")) {
        const glm::vec3 f0 = row.vec3("F0");
        const float c = row.number("v_dot_h");
        row.put("F", glm::vec3(lighting::fresnel_schlick(c, f0.x), lighting::fresnel_schlick(c, f0.y),
                               lighting::fresnel_schlick(c, f0.z)));
    } else if (row.is("ggx")) {
        const float c = row.number("n_dot_h");
        const float alpha = lighting::alpha_from_roughness(row.number("roughness"));
        row.put("D", lighting::ggx_distribution(c, (1.0f - c) * (1.0f + c), alpha));
    } else if (row.is("geometry")) {
        const float k = lighting::schlick_k_direct(row.number("roughness"));
        row.put("G", lighting::schlick_ggx_g1(row.number("n_dot_l"), k) *
                         lighting::schlick_ggx_g1(row.number("n_dot_v"), k));
    } else if (row.is("cook_torrance")) {
        row.put("reflected", reflected(row.vec3("n"), row.vec3("l"), row.vec3("v"), setup_of(row)));
    } else if (row.is("shade")) {
        row.put("color", shade_microfacets(row));
    }
}

}  // namespace kreda::tools
