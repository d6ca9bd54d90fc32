// A1: which pixels a triangle covers.
#include <algorithm>

#include "raster/screen.hpp"
#include "scene/render/render.hpp"
#include "tools/grade/assignment/assignment.hpp"
#include "tools/grade/assignment/light_columns.hpp"

namespace kreda::tools {

namespace {

using raster::ScreenVertex;

ScreenVertex vertex_of(const double* v) {
    return {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), 0.0f, 1.0f};
}

/// Six numbers, x and y of each corner.
struct Corners {
    ScreenVertex a, b, c;
};
Corners corners_of(const double* v) {
    return {vertex_of(v), vertex_of(v + 2), vertex_of(v + 4)};
}

raster::SampleBox box_of(const Corners& t, int width, int height) {
    return raster::sample_box(t.a, t.b, t.c, width, height);
}

std::vector<double> numbers_of(const SceneRecord& record, const raster::ScreenTriangle& triangle) {
    std::vector<double> numbers;
    for (const std::uint32_t v : triangle.vertex) {
        numbers.push_back(record.frame.buffers.streams.screen[v].x);
        numbers.push_back(record.frame.buffers.streams.screen[v].y);
    }
    return numbers;
}

std::vector<std::vector<double>> triangles_of(const SceneRecord& record) {
    std::vector<std::vector<double>> triangles;
    for (const raster::TriangleChunk& chunk : record.frame.buffers.triangles.chunks) {
        for (const raster::ScreenTriangle& t : chunk.triangles) triangles.push_back(numbers_of(record, t));
    }
    return triangles;
}

void add_edge(TableBuilder& edge, TableBuilder& top_left, const double* a, const double* b, double x, double y) {
    edge.add("a", {a[0], a[1]});
    edge.add("b", {b[0], b[1]});
    edge.add("p", {x, y});
    edge.end_row();
    top_left.add("a", {a[0], a[1]});
    top_left.add("b", {b[0], b[1]});
    top_left.end_row();
}

/// Every triangle at the pixels on a coarse grid, and where its corners and the middles of its edges lie.
void add_covers(TableBuilder& covers, const std::vector<double>& t, int width, int height) {
    std::vector<glm::ivec2> pixels;
    for (int y = 3; y < height; y += 9) {
        for (int x = 3; x < width; x += 9) pixels.emplace_back(x, y);
    }
    for (std::size_t i = 0; i < 6; i += 2) {
        const std::size_t j = (i + 2) % 6;
        pixels.emplace_back(static_cast<int>(t[i]) >> 8, static_cast<int>(t[i + 1]) >> 8);
        pixels.emplace_back(static_cast<int>(t[i] + t[j]) >> 9, static_cast<int>(t[i + 1] + t[j + 1]) >> 9);
    }
    for (const glm::ivec2& p : pixels) {
        covers.add("a_b_c", {t[0], t[1], t[2], t[3], t[4], t[5]});
        covers.add("x", p.x);
        covers.add("y", p.y);
        const bool inside = p.x >= 0 && p.y >= 0 && p.x < width && p.y < height;
        covers.end_row(inside ? p : glm::ivec2(-1));
    }
}

void record_coverage_functions(const SceneRecord& record, const std::vector<std::vector<double>>& triangles,
                               std::vector<StageTable>& tables) {
    const raster::Viewport& viewport = record.frame.plan.viewport;
    TableBuilder edge("edge_function", record.name), top_left("is_top_left", record.name);
    TableBuilder covers("covers", record.name), box("pixel_box", record.name);
    for (const std::vector<double>& t : triangles) {
        for (std::size_t i = 0; i < 6; i += 2) {
            const std::size_t j = (i + 2) % 6;
            add_edge(edge, top_left, &t[i], &t[j], 128.0 + 256.0 * static_cast<double>(5 * i), 4992.0);
            const double far[] = {t[i] * 50.0 + 7.0, t[i + 1] * 50.0 - 3.0};  // as on a picture of 16384 pixels a side
            add_edge(edge, top_left, far, &t[j], 4194304.0 - 128.0, 2097152.0 + 128.0);
        }
        add_covers(covers, t, viewport.width, viewport.height);
        box.add("a_b_c", {t[0], t[1], t[2], t[3], t[4], t[5]});
        box.add("width", viewport.width);
        box.add("height", viewport.height);
        box.end_row();
    }
    for (TableBuilder* table : {&edge, &top_left, &covers, &box}) {
        table->table.exact = true;
        append_rows(tables, table->table);
    }
}

void count_covers(StageRow& row) {
    const int x = static_cast<int>(row.integer("x")), y = static_cast<int>(row.integer("y"));
    const int width = static_cast<int>(row.integer("width")), height = static_cast<int>(row.integer("height"));
    int covered = 0, tested = 0;
    for (std::size_t i = 0; i < row.count("triangles", 6); ++i) {
        const Corners t = corners_of(row.numbers("triangles") + 6 * i);
        const raster::SampleBox box = box_of(t, width, height);
        if (x < box.x_first || x > box.x_last || y < box.y_first || y > box.y_last) continue;
        ++tested;
        covered += raster::covers_sample(t.a, t.b, t.c, x, y) ? 1 : 0;
    }
    row.put("color", std::min(0.25 * covered, 1.0));
    row.put("tested", tested);
}

}  // namespace

void record_a1(const SceneRecord& record, std::vector<StageTable>& tables) {
    const std::vector<std::vector<double>> triangles = triangles_of(record);
    record_coverage_functions(record, triangles, tables);
    const raster::Viewport& viewport = record.frame.plan.viewport;
    TableBuilder picture("count_covers", record.name);
    std::vector<double> all;
    for (const std::vector<double>& t : triangles) all.insert(all.end(), t.begin(), t.end());
    picture.list("triangles", all);
    for (int y = 0; y < viewport.height; ++y) {
        for (int x = 0; x < viewport.width; ++x) {
            picture.add("x", x);
            picture.add("y", y);
            picture.add("width", viewport.width);
            picture.add("height", viewport.height);
            picture.end_row({x, y});
        }
    }
    picture.table.exact = true;
    append_rows(tables, picture.table);
}

void reference_a1(StageRow row) {
    if (row.is("edge_function")) {
        const ScreenVertex a = vertex_of(row.numbers("a")), b = vertex_of(row.numbers("b"));
        const ScreenVertex p = vertex_of(row.numbers("p"));
        row.put("E", static_cast<double>(raster::edge_function(a.x, a.y, b.x, b.y, p.x, p.y)));
    } else if (row.is("is_top_left")) {
        const ScreenVertex a = vertex_of(row.numbers("a")), b = vertex_of(row.numbers("b"));
        row.put("top_left", raster::is_top_left(b.x - a.x, b.y - a.y));
    } else if (row.is("covers")) {
        const Corners t = corners_of(row.numbers("a_b_c"));
        const int x = static_cast<int>(row.integer("x")), y = static_cast<int>(row.integer("y"));
        row.put("covered", raster::covers_sample(t.a, t.b, t.c, x, y));
    } else if (row.is("pixel_box")) {
        const raster::SampleBox box = box_of(corners_of(row.numbers("a_b_c")), static_cast<int>(row.integer("width")),
                                             static_cast<int>(row.integer("height")));
        row.put("first_last", {double(box.x_first), double(box.y_first), double(box.x_last), double(box.y_last)});
    } else if (row.is("count_covers")) {
        count_covers(row);
    }
}

}  // namespace kreda::tools
