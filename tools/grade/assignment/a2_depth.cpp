// A2: the depth test, and interpolation that is right in perspective.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "scene/render/render.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

/// Triangles over a pixel that a row has room for.
constexpr std::size_t kMostCovers = 4;

/// lambda_i = E_i / (E_0 + E_1 + E_2)
glm::dvec3 barycentric(const double* e) {
    const double sum = e[0] + e[1] + e[2];
    return {e[0] / sum, e[1] / sum, e[2] / sum};
}

/// q_i = lambda_i / w_i, divided by their sum                                            Heckbert & Moreton 1991
glm::dvec3 perspective_weights(const glm::dvec3& lambda, const glm::dvec3& inv_w) {
    const glm::dvec3 q = lambda * inv_w;
    return q / (q.x + q.y + q.z);
}

float wave(float a) {
    return std::abs(2.0f * (a - std::floor(a)) - 1.0f);
}

void draw_pixel(StageRow& row) {
    float depth = raster::kClearDepth;
    glm::vec3 attribute(0.0f);
    for (std::int64_t k = 0; k < row.integer("count"); ++k) {
        const std::size_t i = static_cast<std::size_t>(k);
        const glm::dvec3 lambda = barycentric(row.numbers("E") + 3 * i);
        const float z = static_cast<float>(glm::dot(lambda, glm::dvec3(row.vec3_at("z", i))));
        if (!(z < depth)) continue;
        const glm::vec3 b = perspective_weights(lambda, row.vec3_at("inv_w", i));
        depth = z;
        attribute = b.x * row.vec3_at("attributes", 3 * i) + b.y * row.vec3_at("attributes", 3 * i + 1) +
                    b.z * row.vec3_at("attributes", 3 * i + 2);
    }
    row.put("color", glm::vec3(wave(attribute.x), wave(attribute.y), wave(attribute.z)));
    row.put("depth", depth);
}

/// What the corners of a triangle carry: their places, moved by the object's number so that a tie shows.
glm::vec3 attribute_of(const SceneRecord& record, const Cover& cover, std::size_t corner) {
    const SourceTriangle source = find_source(record.frame.buffers.instances, cover.triangle.source);
    const glm::vec3 place = record.frame.buffers.streams.position_world[cover.triangle.vertex[corner]];
    return 2.3f * place + static_cast<float>(source.object) * glm::vec3(0.37f, 0.21f, 0.13f);
}

struct CornerNumbers {
    glm::vec3 z, inv_w;
};
CornerNumbers corner_numbers(const SceneRecord& record, const Cover& cover) {
    CornerNumbers numbers{};
    for (int i = 0; i < 3; ++i) {
        const raster::ScreenVertex& v =
            record.frame.buffers.streams.screen[cover.triangle.vertex[static_cast<std::size_t>(i)]];
        numbers.z[i] = v.z;
        numbers.inv_w[i] = v.inv_w;
    }
    return numbers;
}

void add_list(StageTable& table, const char* name, const std::vector<double>& values, std::size_t components) {
    for (StageColumn& c : table.columns) {
        if (c.name != name) continue;
        c.values.insert(c.values.end(), values.begin(), values.end());
        return;
    }
    table.columns.push_back({name, components, true, values});
}

void add_pixel(TableBuilder& picture, const SceneRecord& record, glm::ivec2 pixel, const std::vector<Cover>& covers) {
    const std::size_t count = std::min(covers.size(), kMostCovers);
    std::vector<double> e(3 * kMostCovers), z(3 * kMostCovers), inv_w(3 * kMostCovers), attributes(9 * kMostCovers);
    for (std::size_t k = 0; k < count; ++k) {
        const CornerNumbers numbers = corner_numbers(record, covers[k]);
        for (std::size_t i = 0; i < 3; ++i) {
            const int axis = static_cast<int>(i);
            e[3 * k + i] = static_cast<double>(covers[k].edge[i]);
            z[3 * k + i] = numbers.z[axis];
            inv_w[3 * k + i] = numbers.inv_w[axis];
            const glm::vec3 a = attribute_of(record, covers[k], i);
            for (int c = 0; c < 3; ++c) attributes[9 * k + 3 * i + static_cast<std::size_t>(c)] = a[c];
        }
    }
    picture.add("count", static_cast<double>(count));
    add_list(picture.table, "E", e, e.size());
    add_list(picture.table, "z", z, z.size());
    add_list(picture.table, "inv_w", inv_w, inv_w.size());
    add_list(picture.table, "attributes", attributes, attributes.size());
    picture.end_row(pixel);
}

void record_depth_functions(const SceneRecord& record, std::vector<StageTable>& tables) {
    TableBuilder lambda("barycentric", record.name), depth("window_depth", record.name);
    TableBuilder nearer("is_nearer", record.name), weights("perspective_weights", record.name);
    for (const SeenPoint& p : some_points(record, 200)) {
        const double e[] = {double(p.cover.edge[0]), double(p.cover.edge[1]), double(p.cover.edge[2])};
        const glm::vec3 shares = barycentric(e);
        const CornerNumbers numbers = corner_numbers(record, p.cover);
        lambda.add("E", {e[0], e[1], e[2]});
        lambda.end_row(p.pixel);
        depth.add("lambda", shares);
        depth.add("z", numbers.z);
        depth.end_row(p.pixel);
        weights.add("lambda", shares);
        weights.add("inv_w", numbers.inv_w);
        weights.end_row(p.pixel);
        for (const double stored : {1.0, double(p.cover.depth), 0.9 * double(p.cover.depth), p.cover.depth - 0.0005}) {
            nearer.add("z", p.cover.depth);
            nearer.add("stored", static_cast<float>(stored));
            nearer.end_row(p.pixel);
        }
    }
    nearer.table.exact = true;
    for (const TableBuilder* t : {&lambda, &depth, &nearer, &weights}) append_rows(tables, t->table);
}

}  // namespace

void record_a2(const SceneRecord& record, std::vector<StageTable>& tables) {
    record_depth_functions(record, tables);
    TableBuilder picture("draw_fragment", record.name);
    for (const SeenPoint& p : record.points) {
        const std::size_t i = static_cast<std::size_t>(p.pixel.y * record.frame.plan.viewport.width + p.pixel.x);
        add_pixel(picture, record, p.pixel, record.covers[i]);
    }
    picture.table.exact = true;
    append_rows(tables, picture.table);
}

void reference_a2(StageRow row) {
    if (row.is("barycentric")) {
        row.put("lambda", glm::vec3(barycentric(row.numbers("E"))));
    } else if (row.is("window_depth")) {
        row.put("depth", glm::dot(row.vec3("lambda"), row.vec3("z")));
    } else if (row.is("is_nearer")) {
        row.put("nearer", row.number("z") < row.number("stored"));
    } else if (row.is("perspective_weights")) {
        row.put("weights", glm::vec3(perspective_weights(row.vec3("lambda"), row.vec3("inv_w"))));
    } else if (row.is("draw_fragment")) {
        draw_pixel(row);
    }
}

}  // namespace kreda::tools
