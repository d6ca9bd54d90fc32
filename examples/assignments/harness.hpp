// What turns a student's functions into a program that can be checked. It reads rows of numbers, gives each row to the
// function that the row is for, and writes what came back. There is nothing to change here.
//
//     program INPUTS OUTPUTS [STAGE]
//
// INPUTS holds tables, one for a function and a scene. A column has some numbers a row, or is one list for all rows.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace harness {

struct Column {
    std::string name;
    std::size_t components = 1;
    bool per_row = true;  ///< false: one list, the same for every row
    std::vector<double> values;
};

struct Table {
    std::string stage, scene;
    std::size_t rows = 0;
    std::vector<Column> inputs, outputs;
    std::size_t asked = 0;  ///< the input that was asked for last
};

/// One call of a function: its arguments by name, and where its results go.
struct Row {
    Table& table;
    std::size_t index = 0;

    [[nodiscard]] bool is(const char* stage) const {
        return table.stage == stage;
    }
    [[nodiscard]] const Column& column(const char* name) const {
        // Every row asks for the same arguments in the same order: look behind the last one first.
        do { table.asked = (table.asked + 1) % table.inputs.size(); } while (table.inputs[table.asked].name != name);
        return table.inputs[table.asked];
    }
    [[nodiscard]] const double* numbers(const char* name) const {
        const Column& c = column(name);
        return c.values.data() + (c.per_row ? index * c.components : 0);
    }
    [[nodiscard]] float number(const char* name) const {
        return static_cast<float>(*numbers(name));
    }
    [[nodiscard]] std::int64_t integer(const char* name) const {
        return static_cast<std::int64_t>(*numbers(name));
    }
    [[nodiscard]] glm::vec2 vec2(const char* name) const {
        const double* v = numbers(name);
        return {v[0], v[1]};
    }
    [[nodiscard]] glm::vec3 vec3(const char* name) const {
        return vec3_at(name, 0);
    }
    /// Number i of a list of vectors.
    [[nodiscard]] glm::vec3 vec3_at(const char* name, std::size_t i) const {
        const double* v = numbers(name) + 3 * i;
        return {v[0], v[1], v[2]};
    }
    [[nodiscard]] float number_at(const char* name, std::size_t i) const {
        return static_cast<float>(numbers(name)[i]);
    }
    /// 16 numbers, column by column.
    [[nodiscard]] glm::mat4 mat4(const char* name) const {
        const double* v = numbers(name);
        glm::mat4 m;
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = static_cast<float>(v[i]);
        return m;
    }
    /// How many entries of `size` numbers a list has.
    [[nodiscard]] std::size_t count(const char* name, std::size_t size) const {
        return column(name).values.size() / size;
    }

    void put(const char* name, std::initializer_list<double> values) {
        std::size_t c = 0;
        while (c < table.outputs.size() && table.outputs[c].name != name) ++c;
        if (c == table.outputs.size()) {
            table.outputs.push_back({name, values.size(), true, std::vector<double>(table.rows * values.size())});
        }
        std::size_t at = index * values.size();
        for (const double value : values) table.outputs[c].values[at++] = value;
    }
    void put(const char* name, double value) {
        put(name, {value});
    }
    void put(const char* name, const glm::vec2& v) {
        put(name, {v.x, v.y});
    }
    void put(const char* name, const glm::vec3& v) {
        put(name, {v.x, v.y, v.z});
    }
};

/// Calls the function that a row is for; every assignment's stages.cpp has one.
using RunRow = void (*)(Row row);

inline bool read_table(std::istream& file, Table& table) {
    std::string word;
    std::size_t columns = 0;
    if (!(file >> word >> table.stage >> table.scene >> table.rows >> columns)) return false;
    for (std::size_t c = 0; c < columns; ++c) {
        Column column;
        std::size_t numbers = 0;
        file >> word >> column.name >> column.components >> column.per_row >> numbers;
        file.get();  // the end of the line
        column.values.resize(numbers);
        file.read(reinterpret_cast<char*>(column.values.data()),
                  static_cast<std::streamsize>(numbers * sizeof(double)));
        table.inputs.push_back(column);
    }
    return bool(file);
}

inline void write_table(std::ostream& file, const Table& table) {
    file << "table " << table.stage << ' ' << table.scene << ' ' << table.rows << ' ' << table.outputs.size() << '\n';
    for (const Column& c : table.outputs) {
        file << "column " << c.name << ' ' << c.components << " 1 " << c.values.size() << '\n';
        file.write(reinterpret_cast<const char*>(c.values.data()),
                   static_cast<std::streamsize>(c.values.size() * sizeof(double)));
        file << '\n';
    }
}

inline std::vector<Table> read_tables(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<Table> tables(1);
    while (read_table(file, tables.back())) tables.emplace_back();
    tables.pop_back();
    return tables;
}

/// Run every table (or those of one stage); a table is in the file as soon as it is done.
inline void run_tables(std::vector<Table> tables, RunRow run_row, const std::string& path, const std::string& only) {
    std::ofstream file(path, std::ios::binary);
    for (Table& table : tables) {
        if (!only.empty() && table.stage != only) continue;
        for (std::size_t i = 0; i < table.rows; ++i) run_row(Row{table, i});
        write_table(file, table);
        file.flush();
    }
}

}  // namespace harness
