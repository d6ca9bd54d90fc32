// A3: lights and Phong's model.
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/reflection.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

using lighting::LightSetup;
using lighting::LightType;
using lighting::PhongMaterial;

lighting::LightSample sample_light(const LightSetup& light, const glm::vec3& p) {
    switch (light.type) {
        case LightType::directional: return sample_directional(light);
        case LightType::point: return sample_point(light, p);
        case LightType::spot: return sample_spot(light, p);
    }
    return {};
}

PhongMaterial material_of(const StageRow& row) {
    return {row.vec3("m_A"), row.vec3("m_D"), row.vec3("m_S"), row.vec3("m_E"), row.number("h")};
}

glm::vec3 shade_lights(const StageRow& row) {
    const PhongMaterial m = material_of(row);
    const glm::vec3 n = lighting::unit(row.vec3("normal"));
    const glm::vec3 v = lighting::unit(row.vec3("eye") - row.vec3("position"));
    glm::vec3 sum = lighting::ambient_term(row.vec3("s_A"), m.ambient) + m.emission;
    for (std::size_t i = 0; i < row.count("light_radiance", 3); ++i) {
        const lighting::LightSample s = sample_light(light_at(row, i), row.vec3("position"));
        const lighting::ReflectedTerms t = phong(n, s.l, v, m);
        sum += s.irradiance * (t.diffuse + t.specular);
    }
    return sum;
}

void record_lights(const SceneRecord& record, std::vector<StageTable>& tables) {
    for (const lighting::LightSetup& light : record.frame.lighting.lights) {
        if (light.type == LightType::directional) continue;
        TableBuilder falloff("attenuate", record.name), cone("spot_cone", record.name);
        for (const SeenPoint& p : some_points(record, 100)) {
            const glm::vec3 to_light = light.position - p.position;
            const lighting::Attenuation& a = light.attenuation;
            falloff.add("c_l_q", glm::vec3(a.constant, a.linear, a.quadratic));
            falloff.add("d", glm::length(to_light));
            falloff.end_row(p.pixel);
            if (light.type != LightType::spot) continue;
            cone.add("cos_angle", -glm::dot(glm::normalize(to_light), light.axis));
            cone.add("cos_inner", light.cos_inner);
            cone.add("cos_outer", light.cos_outer);
            cone.end_row(p.pixel);
        }
        append_rows(tables, falloff.table);
        append_rows(tables, cone.table);
    }
}

void record_samples(const SceneRecord& record, std::vector<StageTable>& tables) {
    TableBuilder sample("sample_light", record.name);
    for (const lighting::LightSetup& light : record.frame.lighting.lights) {
        for (const SeenPoint& p : some_points(record, 100)) {
            add_light(sample, light);
            sample.add("p", p.position);
            sample.end_row(p.pixel);
        }
    }
    append_rows(tables, sample.table);
}

void record_reflection(const SceneRecord& record, std::vector<StageTable>& tables) {
    TableBuilder mirror("mirror_vector", record.name), terms("phong", record.name);
    for (const lighting::LightSetup& light : record.frame.lighting.lights) {
        for (const SeenPoint& p : some_points(record, 300)) {
            const glm::vec3 n = lighting::unit(p.normal);
            const glm::vec3 l = sample_light(light, p.position).l;
            mirror.add("n", n);
            mirror.add("l", l);
            mirror.end_row(p.pixel);
            terms.add("n", n);
            terms.add("l", l);
            terms.add("v", lighting::unit(record.frame.lighting.eye - p.position));
            add_material(terms, record.frame.plan.materials[p.cover.triangle.material].material.phong);
            terms.end_row(p.pixel);
        }
    }
    append_rows(tables, mirror.table);
    append_rows(tables, terms.table);
}

}  // namespace

void record_a3(const SceneRecord& record, std::vector<StageTable>& tables) {
    record_lights(record, tables);
    record_samples(record, tables);
    record_reflection(record, tables);
    TableBuilder picture("shade", record.name);
    list_lights(picture, record.frame.lighting.lights);
    for (const SeenPoint& p : record.points) {
        picture.add("position", p.position);
        picture.add("normal", p.normal);
        picture.add("eye", record.frame.lighting.eye);
        picture.add("s_A", record.frame.lighting.ambient);
        add_material(picture, record.frame.plan.materials[p.cover.triangle.material].material.phong);
        picture.end_row(p.pixel);
    }
    append_rows(tables, picture.table);
}

void reference_a3(StageRow row) {
    if (row.is("attenuate")) {
        const glm::vec3 a = row.vec3("c_l_q");
        row.put("attenuation", lighting::attenuate({a.x, a.y, a.z}, row.number("d")));
    } else if (row.is("spot_cone")) {
        row.put("cone", lighting::spot_cone(row.number("cos_angle"), row.number("cos_inner"), row.number("cos_outer")));
    } else if (row.is("sample_light")) {
        const lighting::LightSample s = sample_light(light_at(row, 0), row.vec3("p"));
        row.put("l", s.l);
        row.put("irradiance", s.irradiance);
    } else if (row.is("mirror_vector")) {
        row.put("r", lighting::mirror_vector(row.vec3("n"), row.vec3("l")));
    } else if (row.is("phong")) {
        const lighting::ReflectedTerms t =
            lighting::phong(row.vec3("n"), row.vec3("l"), row.vec3("v"), material_of(row));
        row.put("diffuse", t.diffuse);
        row.put("specular", t.specular);
    } else if (row.is("shade")) {
        row.put("color", shade_lights(row));
    }
}

}  // namespace kreda::tools
