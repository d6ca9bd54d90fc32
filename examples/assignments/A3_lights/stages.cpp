// A3: which of your functions a row of numbers is for. There is nothing to change here.
#include "assignment.hpp"
#include "harness.hpp"

namespace {

Light light_at(const harness::Row& row, std::size_t i) {
    const glm::vec3 a = row.vec3_at("light_attenuation", i);
    const glm::vec3 kind_inner_outer = row.vec3_at("light_kind_inner_outer", i);
    return {static_cast<LightType>(static_cast<int>(kind_inner_outer.x)),
            row.vec3_at("light_position", i),
            row.vec3_at("light_axis", i),
            row.vec3_at("light_radiance", i),
            {a.x, a.y, a.z},
            kind_inner_outer.y,
            kind_inner_outer.z};
}

Material material_of(const harness::Row& row) {
    return {row.vec3("m_A"), row.vec3("m_D"), row.vec3("m_S"), row.vec3("m_E"), row.number("h")};
}

}  // namespace

void run_row(harness::Row row) {
    if (row.is("attenuate")) {
        const glm::vec3 a = row.vec3("c_l_q");
        row.put("attenuation", attenuate({a.x, a.y, a.z}, row.number("d")));
    } else if (row.is("spot_cone")) {
        row.put("cone", spot_cone(row.number("cos_angle"), row.number("cos_inner"), row.number("cos_outer")));
    } else if (row.is("sample_light")) {
        const LightSample s = sample_light(light_at(row, 0), row.vec3("p"));
        row.put("l", s.l);
        row.put("irradiance", s.irradiance);
    } else if (row.is("mirror_vector")) {
        row.put("r", mirror_vector(row.vec3("n"), row.vec3("l")));
    } else if (row.is("phong")) {
        const Terms t = phong(row.vec3("n"), row.vec3("l"), row.vec3("v"), material_of(row));
        row.put("diffuse", t.diffuse);
        row.put("specular", t.specular);
    } else if (row.is("shade")) {
        std::vector<Light> lights;
        for (std::size_t i = 0; i < row.count("light_radiance", 3); ++i) lights.push_back(light_at(row, i));
        row.put("color",
                shade({row.vec3("position"), row.vec3("normal"), row.vec3("eye"), material_of(row), row.vec3("s_A")},
                      lights));
    }
}
