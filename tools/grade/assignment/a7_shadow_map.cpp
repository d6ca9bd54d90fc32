// A7: a shadow map, its bias, and percentage closer filtering.
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/reflection.hpp"
#include "scene/error.hpp"
#include "scene/render/render.hpp"
#include "scene/render/shadow_pass.hpp"
#include "shadows/map_point.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

using shadows::LightView;

/// What a row says of the light's camera: its axes, origin, texel, constant and slope bias.
struct LightCamera {
    glm::mat3 axes{1.0f};
    glm::vec3 origin{0.0f};
    shadows::PictureScale scale;
    float constant_bias = 0.0f, slope_bias = 0.0f;
};

LightCamera camera_of(const StageRow& row, int size) {
    const glm::vec3 right = row.vec3_at("light_camera", 0), up = row.vec3_at("light_camera", 1);
    const glm::vec3 rest = row.vec3_at("light_camera", 4);
    LightCamera camera;
    camera.axes = glm::transpose(glm::mat3(right, up, row.vec3_at("light_camera", 2)));
    camera.origin = row.vec3_at("light_camera", 3);
    const glm::vec2 texel(rest.x, rest.y);
    camera.scale = {texel, 1.0f / texel, 0.5f * static_cast<float>(size)};
    camera.constant_bias = rest.z;
    camera.slope_bias = row.number_at("light_camera", 15);
    return camera;
}

float least_bias(const glm::vec3& n_view, const glm::vec2& texel) {
    return shadows::least_bias(shadows::slope_parallel(n_view, texel));
}

int side_of(const StageRow& row) {
    return static_cast<int>(std::lround(std::sqrt(static_cast<double>(row.count("map", 1)))));
}

float is_lit(const StageRow& row, int column, int line, float distance) {
    const int size = side_of(row);
    if (column < 0 || line < 0 || column >= size || line >= size) return 1.0f;
    return distance <= row.number_at("map", static_cast<std::size_t>(line * size + column)) ? 1.0f : 0.0f;
}

float pcf(const StageRow& row, const glm::vec3& u_v_distance, int radius) {
    const int column = static_cast<int>(std::floor(u_v_distance.x)),
              line = static_cast<int>(std::floor(u_v_distance.y));
    float lit = 0.0f;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) lit += is_lit(row, column + i, line + j, u_v_distance.z);
    }
    const float side = static_cast<float>(2 * radius + 1);
    return lit / (side * side);
}

/// u, v and the distance less the bias, by the steps of the batch loop.
glm::vec3 place_of(const LightCamera& camera, const glm::vec3& q, const glm::vec3& n_view) {
    const shadows::MapPoint point =
        shadows::map_point_parallel(q, n_view, camera.scale, {camera.constant_bias, camera.slope_bias, 0.0f, 0.0f});
    return {point.u, point.v, point.distance};
}

float shadow_factor(const StageRow& row) {
    const LightCamera camera = camera_of(row, side_of(row));
    const shadows::PointInView in_view =
        shadows::point_in_picture(camera.axes, camera.origin, row.vec3("p"), row.vec3("n"));
    if (in_view.n.z <= 0.0f) return 0.0f;
    return pcf(row, place_of(camera, in_view.q, in_view.n), static_cast<int>(row.integer("radius")));
}

/// The one picture of the one light of the scene.
const shadows::ShadowMap& map_of(const SceneRecord& record) {
    const auto& memory = record.frame.buffers.shadows;
    if (memory.size() != 1 || memory[0].map.plan.views.size() != 1 || memory[0].map.plan.views[0].perspective) {
        throw scene::UserError(scene::Place{record.scene().file},
                               "a scene of A7 has one directional light with shadow = true and method = \"map\"");
    }
    return memory[0].map;
}

std::vector<double> camera_numbers(const shadows::ShadowMap& map) {
    const LightView& view = map.plan.views[0];
    const shadows::ShadowSettings& settings = map.plan.settings;
    std::vector<double> numbers;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) numbers.push_back(view.view_from_world[c][r]);
    }
    for (int c = 0; c < 3; ++c) numbers.push_back(view.origin[c]);
    const bool follows = settings.bias == shadows::ShadowBias::slope;
    for (int c = 0; c < 2; ++c) numbers.push_back(2.0f * view.half_size[c] / static_cast<float>(settings.size));
    numbers.push_back(settings.constant_bias * (view.far - view.near));
    numbers.push_back(follows ? settings.slope_bias : 0.0f);
    return numbers;
}

std::vector<double> distances(const shadows::ShadowMap& map) {
    std::vector<double> values;
    for (int y = 0; y < map.size(); ++y) {
        for (int x = 0; x < map.size(); ++x) values.push_back(map.at(0, x, y));
    }
    return values;
}

int radius_of(const shadows::ShadowMap& map) {
    return map.plan.settings.filter == shadows::ShadowFilter::pcf ? map.plan.settings.radius : 0;
}

void add_compares(const SceneRecord& record, TableBuilder& lit, TableBuilder& filter, const glm::vec3& place,
                  glm::ivec2 pixel) {
    const shadows::ShadowMap& map = map_of(record);
    for (const float offset : {0.0f, -0.2f, 0.2f}) {
        lit.add("column", std::floor(place.x));
        lit.add("row", std::floor(place.y));
        lit.add("distance", place.z + offset);
        lit.end_row(pixel);
    }
    filter.add("u_v_distance", place);
    filter.add("radius", radius_of(map) > 0 ? radius_of(map) : 1);
    filter.end_row(pixel);
}

/// Rows for the functions before the last, in the order in which the last one calls them.
void record_shadow_functions(const SceneRecord& record, std::vector<StageTable>& tables) {
    const shadows::ShadowMap& map = map_of(record);
    TableBuilder space("light_space", record.name), place("map_place", record.name), bias("least_bias", record.name);
    TableBuilder lit("is_lit", record.name), filter("pcf", record.name);
    for (TableBuilder* t : {&space, &place}) t->list("light_camera", camera_numbers(map));
    for (TableBuilder* t : {&lit, &filter}) t->list("map", distances(map));
    const LightView& view = map.plan.views[0];
    const shadows::PictureScale scale = picture_scale(view, map.size());
    const double size = map.size();
    for (const SeenPoint& p : some_points(record, 250)) {
        const shadows::PointInView v =
            shadows::point_in_picture(view.view_from_world, view.origin, p.position, p.normal);
        space.add("p", p.position);
        space.end_row(p.pixel);
        place.add("q", v.q);
        place.add("size", size);
        place.end_row(p.pixel);
        if (v.n.z > 0.05f) {
            bias.add("n_view", v.n);
            bias.add("texel", scale.texel);
            bias.end_row(p.pixel);
        }
        const shadows::MapPoint at = shadows::map_point_parallel(v.q, v.n, scale, {});
        add_compares(record, lit, filter, {at.u, at.v, at.distance - 0.02f}, p.pixel);
    }
    for (const float edge : {-1.5f, 0.5f, static_cast<float>(size) - 0.5f, static_cast<float>(size) + 0.5f}) {
        add_compares(record, lit, filter, {edge, 0.5f * static_cast<float>(size), 0.5f}, glm::ivec2(-1));
        add_compares(record, lit, filter, {0.25f * static_cast<float>(size), edge, 0.5f}, glm::ivec2(-1));
    }
    for (const TableBuilder* t : {&space, &place, &bias, &lit, &filter}) append_rows(tables, t->table);
}

}  // namespace

void record_a7(const SceneRecord& record, std::vector<StageTable>& tables) {
    record_shadow_functions(record, tables);
    const shadows::ShadowMap& map = map_of(record);
    TableBuilder picture("shadow_factor", record.name);
    picture.list("light_camera", camera_numbers(map));
    picture.list("map", distances(map));
    for (const SeenPoint& p : record.points) {
        picture.add("p", p.position);
        picture.add("n", lighting::unit(p.normal));
        picture.add("radius", radius_of(map));
        picture.end_row(p.pixel);
    }
    append_rows(tables, picture.table);
}

void reference_a7(StageRow row) {
    if (row.is("light_space")) {
        const LightCamera camera = camera_of(row, 0);
        row.put("q", camera.axes * (row.vec3("p") - camera.origin));
    } else if (row.is("map_place")) {
        LightCamera camera = camera_of(row, static_cast<int>(row.integer("size")));
        camera.constant_bias = camera.slope_bias = 0.0f;
        row.put("u_v_distance", place_of(camera, row.vec3("q"), {0.0f, 0.0f, 1.0f}));
    } else if (row.is("least_bias")) {
        row.put("B", least_bias(row.vec3("n_view"), row.vec2("texel")));
    } else if (row.is("is_lit")) {
        row.put("lit", is_lit(row, static_cast<int>(row.integer("column")), static_cast<int>(row.integer("row")),
                              row.number("distance")));
    } else if (row.is("pcf")) {
        row.put("share", pcf(row, row.vec3("u_v_distance"), static_cast<int>(row.integer("radius"))));
    } else if (row.is("shadow_factor")) {
        row.put("color", shadow_factor(row));
    }
}

}  // namespace kreda::tools
