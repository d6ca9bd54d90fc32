#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

void extend(std::vector<double>& list, const glm::vec3& v) {
    list.insert(list.end(), {v.x, v.y, v.z});
}

glm::vec3 kind_inner_outer(const lighting::LightSetup& light) {
    return {static_cast<float>(light.type), light.cos_inner, light.cos_outer};
}

glm::vec3 attenuation(const lighting::LightSetup& light) {
    return {light.attenuation.constant, light.attenuation.linear, light.attenuation.quadratic};
}

}  // namespace

void add_light(TableBuilder& builder, const lighting::LightSetup& light) {
    builder.add("light_kind_inner_outer", kind_inner_outer(light));
    builder.add("light_position", light.position);
    builder.add("light_axis", light.axis);
    builder.add("light_radiance", light.radiance);
    builder.add("light_attenuation", attenuation(light));
}

void list_lights(TableBuilder& builder, std::span<const lighting::LightSetup> lights) {
    std::vector<double> kinds, positions, axes, radiances, attenuations;
    for (const lighting::LightSetup& light : lights) {
        extend(kinds, kind_inner_outer(light));
        extend(positions, light.position);
        extend(axes, light.axis);
        extend(radiances, light.radiance);
        extend(attenuations, attenuation(light));
    }
    builder.list("light_kind_inner_outer", kinds);
    builder.list("light_position", positions);
    builder.list("light_axis", axes);
    builder.list("light_radiance", radiances);
    builder.list("light_attenuation", attenuations);
}

lighting::LightSetup light_at(const StageRow& row, std::size_t i) {
    const glm::vec3 kind = row.vec3_at("light_kind_inner_outer", i);
    const glm::vec3 a = row.vec3_at("light_attenuation", i);
    return {.type = static_cast<lighting::LightType>(static_cast<int>(kind.x)),
            .position = row.vec3_at("light_position", i),
            .axis = row.vec3_at("light_axis", i),
            .radiance = row.vec3_at("light_radiance", i),
            .attenuation = {a.x, a.y, a.z},
            .cos_inner = kind.y,
            .cos_outer = kind.z};
}

void add_material(TableBuilder& builder, const lighting::PhongMaterial& m) {
    builder.add("m_A", m.ambient);
    builder.add("m_D", m.diffuse);
    builder.add("m_S", m.specular);
    builder.add("m_E", m.emission);
    builder.add("h", m.shininess);
}

void append_rows(std::vector<StageTable>& tables, const StageTable& table) {
    if (table.rows == 0) return;
    for (StageTable& t : tables) {
        if (t.stage != table.stage || t.scene != table.scene) continue;
        t.rows += table.rows;
        t.pixel.insert(t.pixel.end(), table.pixel.begin(), table.pixel.end());
        for (std::size_t c = 0; c < t.columns.size(); ++c) {
            const StageColumn& more = table.columns[c];
            if (more.per_row) {
                t.columns[c].values.insert(t.columns[c].values.end(), more.values.begin(), more.values.end());
            }
        }
        return;
    }
    tables.push_back(table);
}

}  // namespace kreda::tools
