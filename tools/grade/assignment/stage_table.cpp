#include "tools/grade/assignment/stage_table.hpp"

#include <cstring>
#include <stdexcept>

namespace kreda::tools {

namespace {

std::string column_head(const StageColumn& c) {
    return "column " + c.name + ' ' + std::to_string(c.components) + ' ' + (c.per_row ? '1' : '0') + ' ' +
           std::to_string(c.values.size()) + '\n';
}

std::string table_head(const StageTable& t) {
    return "table " + t.stage + ' ' + t.scene + ' ' + std::to_string(t.rows) + ' ' + std::to_string(t.columns.size()) +
           '\n';
}

/// Moves `at` past `text` if that is what stands there.
bool skip(const std::string& bytes, std::size_t& at, const std::string& text) {
    if (bytes.compare(at, text.size(), text) != 0) return false;
    at += text.size();
    return true;
}

/// One table of the shape of `expected`; false: something else stands there.
bool decode_table(const std::string& bytes, std::size_t& at, const StageTable& expected, StageTable& table) {
    table = expected;
    if (!skip(bytes, at, table_head(expected))) return false;
    for (StageColumn& c : table.columns) {
        const std::size_t size = c.values.size() * sizeof(double);
        if (!skip(bytes, at, column_head(c)) || bytes.size() - at < size) return false;
        std::memcpy(c.values.data(), bytes.data() + at, size);
        at += size;
        if (!skip(bytes, at, "\n")) return false;
    }
    return true;
}

}  // namespace

const StageColumn* StageTable::find(const std::string& name) const {
    for (const StageColumn& c : columns) {
        if (c.name == name) return &c;
    }
    return nullptr;
}

const double* StageRow::numbers(const char* name) const {
    const StageColumn* c = in.find(name);
    if (c == nullptr) throw std::logic_error("stage " + in.stage + " has no column " + name);
    return c->values.data() + (c->per_row ? index * c->components : 0);
}

glm::vec2 StageRow::vec2(const char* name) const {
    const double* v = numbers(name);
    return {v[0], v[1]};
}

glm::vec3 StageRow::vec3_at(const char* name, std::size_t i) const {
    const double* v = numbers(name) + 3 * i;
    return {v[0], v[1], v[2]};
}

glm::mat4 StageRow::mat4(const char* name) const {
    const double* v = numbers(name);
    glm::mat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = static_cast<float>(v[i]);
    return m;
}

std::size_t StageRow::count(const char* name, std::size_t size) const {
    const StageColumn* c = in.find(name);
    return c == nullptr ? 0 : c->values.size() / size;
}

void StageRow::put(const char* name, std::initializer_list<double> values) {
    std::size_t c = 0;
    while (c < out.columns.size() && out.columns[c].name != name) ++c;
    if (c == out.columns.size()) {
        out.columns.push_back({name, values.size(), true, std::vector<double>(out.rows * values.size())});
    }
    std::size_t at = index * values.size();
    for (const double value : values) out.columns[c].values[at++] = value;
}

TableBuilder::TableBuilder(std::string stage, std::string scene) {
    table.stage = std::move(stage);
    table.scene = std::move(scene);
}

void TableBuilder::list(const std::string& name, std::vector<double> values) {
    table.columns.push_back({name, 1, false, std::move(values)});
}

void TableBuilder::add(const std::string& name, std::initializer_list<double> values) {
    std::size_t c = 0;
    while (c < table.columns.size() && table.columns[c].name != name) ++c;
    if (c == table.columns.size()) table.columns.push_back({name, values.size(), true, {}});
    StageColumn& column = table.columns[c];
    column.values.insert(column.values.end(), values);
}

void TableBuilder::end_row(glm::ivec2 pixel) {
    ++table.rows;
    table.pixel.push_back(pixel);
    for (const StageColumn& c : table.columns) {
        if (c.per_row && c.values.size() != table.rows * c.components) {
            throw std::logic_error("stage " + table.stage + ": column " + c.name + " misses a row");
        }
    }
}

std::string encode_tables(const std::vector<StageTable>& tables) {
    std::string bytes;
    for (const StageTable& t : tables) {
        bytes += table_head(t);
        for (const StageColumn& c : t.columns) {
            bytes += column_head(c);
            bytes.append(reinterpret_cast<const char*>(c.values.data()), c.values.size() * sizeof(double));
            bytes += '\n';
        }
    }
    return bytes;
}

DecodedTables decode_tables(const std::string& bytes, const std::vector<StageTable>& expected) {
    DecodedTables decoded;
    std::size_t at = 0;
    for (const StageTable& e : expected) {
        StageTable table;
        if (!decode_table(bytes, at, e, table)) {
            decoded.complaint = "no whole result of " + e.stage + " for the scene " + e.scene;
            return decoded;
        }
        decoded.tables.push_back(std::move(table));
    }
    return decoded;
}

}  // namespace kreda::tools
