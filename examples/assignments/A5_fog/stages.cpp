// A5: which of your functions a row of numbers is for. There is nothing to change here.
#include "assignment.hpp"
#include "harness.hpp"

namespace {

Fog fog_of(const harness::Row& row) {
    const glm::vec3 range = row.vec3("start_end_density");
    return {static_cast<FogMode>(row.integer("mode")),
            static_cast<FogDistance>(row.integer("distance")),
            row.vec3("fog_color"),
            range.x,
            range.y,
            range.z};
}

Eye eye_of(const harness::Row& row) {
    return {row.vec3("eye"), row.vec3("forward")};
}

}  // namespace

void run_row(harness::Row row) {
    if (row.is("planar_distance")) {
        row.put("z", planar_distance(row.vec3("p"), eye_of(row)));
    } else if (row.is("radial_distance")) {
        row.put("z", radial_distance(row.vec3("p"), eye_of(row)));
    } else if (row.is("fog_factor")) {
        row.put("f", fog_factor(fog_of(row), row.number("z")));
    } else if (row.is("mix_fog")) {
        row.put("mixed", mix_fog(row.number("f"), row.vec3("surface"), row.vec3("fog_color")));
    } else if (row.is("encode_srgb")) {
        row.put("encoded", encode_srgb(row.number("light")));
    } else if (row.is("foggy_pixel")) {
        row.put("color", foggy_pixel(row.vec3("p"), row.vec3("surface"), fog_of(row), eye_of(row)));
    }
}
