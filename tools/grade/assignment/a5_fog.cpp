// A5: fog, and the encoding that a display needs.
#include "lighting/fog.hpp"
#include "raster/film.hpp"
#include "scene/render/render.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

using lighting::Fog;
using lighting::FogDistance;
using lighting::FogMode;

Fog fog_of(const StageRow& row) {
    const glm::vec3 range = row.vec3("start_end_density");
    Fog fog;
    fog.mode = static_cast<FogMode>(row.integer("mode"));
    fog.distance = static_cast<FogDistance>(row.integer("distance"));
    fog.color = row.vec3("fog_color");
    fog.start = range.x;
    fog.end = range.y;
    fog.density = range.z;
    return fog;
}

float fog_factor(const Fog& fog, float z) {
    switch (fog.mode) {
        case FogMode::none: return 1.0f;
        case FogMode::linear: return lighting::fog_linear(z, fog.start, fog.end);
        case FogMode::exp: return lighting::fog_exp(z, fog.density);
        case FogMode::exp2: return lighting::fog_exp2(z, fog.density);
    }
    return 1.0f;
}

float distance_to(const Fog& fog, const glm::vec3& p, const glm::vec3& eye, const glm::vec3& forward) {
    return fog.distance == FogDistance::planar ? lighting::planar_distance(p, eye, forward)
                                               : lighting::radial_distance(p, eye);
}

float encode(float light) {
    return raster::srgb_from_linear(raster::saturate(light));
}

glm::vec3 foggy_pixel(const StageRow& row) {
    const Fog fog = fog_of(row);
    const float f = fog_factor(fog, distance_to(fog, row.vec3("p"), row.vec3("eye"), row.vec3("forward")));
    const glm::vec3 mixed = lighting::mix_fog(f, row.vec3("surface"), fog.color);
    return {encode(mixed.x), encode(mixed.y), encode(mixed.z)};
}

void add_fog(TableBuilder& builder, const Fog& fog) {
    builder.add("mode", static_cast<double>(fog.mode));
    builder.add("distance", static_cast<double>(fog.distance));
    builder.add("fog_color", fog.color);
    builder.add("start_end_density", glm::vec3(fog.start, fog.end, fog.density));
}

/// The scene's film before fog: what the surfaces send.
raster::Image film_without_fog(const scene::Scene& scene) {
    scene::Scene clear = scene;
    clear.fog.mode = FogMode::none;
    return scene::render(clear);
}

void record_fog_functions(const SceneRecord& record, const raster::Image& clear, std::vector<StageTable>& tables) {
    const Fog& fog = record.scene().fog;
    const glm::vec3 eye = record.frame.lighting.eye, forward = record.frame.lighting.forward;
    TableBuilder planar("planar_distance", record.name), radial("radial_distance", record.name);
    TableBuilder factor("fog_factor", record.name), mix("mix_fog", record.name), encoded("encode_srgb", record.name);
    for (const SeenPoint& p : some_points(record, 300)) {
        for (TableBuilder* table : {&planar, &radial}) {
            table->add("p", p.position);
            table->add("eye", eye);
            table->add("forward", forward);
            table->end_row(p.pixel);
        }
        const float z = distance_to(fog, p.position, eye, forward);
        add_fog(factor, fog);
        factor.add("z", z);
        factor.end_row(p.pixel);
        mix.add("f", fog_factor(fog, z));
        mix.add("surface", clear.rgb(p.pixel.x, p.pixel.y));
        mix.add("fog_color", fog.color);
        mix.end_row(p.pixel);
        encoded.add("light", clear.rgb(p.pixel.x, p.pixel.y).x);
        encoded.end_row(p.pixel);
    }
    for (int i = 0; i < 32; ++i) {  // also the toe of the curve, and what lies beyond white
        encoded.add("light", i < 24 ? 0.0003f * static_cast<float>(i) : 0.2f * static_cast<float>(i - 22));
        encoded.end_row();
    }
    for (const TableBuilder* table : {&planar, &radial, &factor, &mix, &encoded}) append_rows(tables, table->table);
}

}  // namespace

void record_a5(const SceneRecord& record, std::vector<StageTable>& tables) {
    const raster::Image clear = film_without_fog(record.scene());
    record_fog_functions(record, clear, tables);
    TableBuilder picture("foggy_pixel", record.name);
    for (const SeenPoint& p : record.points) {
        picture.add("p", p.position);
        picture.add("surface", clear.rgb(p.pixel.x, p.pixel.y));
        add_fog(picture, record.scene().fog);
        picture.add("eye", record.frame.lighting.eye);
        picture.add("forward", record.frame.lighting.forward);
        picture.end_row(p.pixel);
    }
    append_rows(tables, picture.table);
}

void reference_a5(StageRow row) {
    if (row.is("planar_distance")) {
        row.put("z", lighting::planar_distance(row.vec3("p"), row.vec3("eye"), row.vec3("forward")));
    } else if (row.is("radial_distance")) {
        row.put("z", lighting::radial_distance(row.vec3("p"), row.vec3("eye")));
    } else if (row.is("fog_factor")) {
        row.put("f", fog_factor(fog_of(row), row.number("z")));
    } else if (row.is("mix_fog")) {
        row.put("mixed", lighting::mix_fog(row.number("f"), row.vec3("surface"), row.vec3("fog_color")));
    } else if (row.is("encode_srgb")) {
        row.put("encoded", encode(row.number("light")));
    } else if (row.is("foggy_pixel")) {
        row.put("color", foggy_pixel(row));
    }
}

}  // namespace kreda::tools
