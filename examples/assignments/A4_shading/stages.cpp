// A4: which of your functions a row of numbers is for. There is nothing to change here.
#include "assignment.hpp"
#include "harness.hpp"

namespace {

Triangle triangle_of(const harness::Row& row) {
    return {row.vec3("a"), row.vec3("b"), row.vec3("c"), row.vec3("n_a"), row.vec3("n_b"), row.vec3("n_c")};
}

Lit lit_of(const harness::Row& row) {
    return {row.vec3("l"),   row.vec3("radiance"), row.vec3("s_A"), row.vec3("eye"),
            row.vec3("m_A"), row.vec3("m_D"),      row.vec3("m_S"), row.number("h")};
}

}  // namespace

void run_row(harness::Row row) {
    if (row.is("world_normal")) {
        row.put("n", world_normal(row.mat4("world_from_object"), row.vec3("n_object")));
    } else if (row.is("face_normal")) {
        row.put("n", face_normal(row.vec3("a"), row.vec3("b"), row.vec3("c")));
    } else if (row.is("flat_color")) {
        row.put("color", flat_color(triangle_of(row), lit_of(row)));
    } else if (row.is("gouraud_color")) {
        row.put("color", gouraud_color(triangle_of(row), row.vec3("w"), lit_of(row)));
    } else if (row.is("phong_color")) {
        row.put("color", phong_color(triangle_of(row), row.vec3("w"), lit_of(row)));
    } else if (row.is("shade_pixel")) {
        const Frequency frequency = static_cast<Frequency>(row.integer("frequency"));
        row.put("color", shade_pixel(frequency, triangle_of(row), row.vec3("w"), lit_of(row)));
    }
}
