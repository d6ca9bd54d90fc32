// Rows of numbers: what a student's function is given, and what it answers. One table a function ("stage") and scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kreda::tools {

/// One argument or result. Numbers are doubles: every float and every integer below 2^53 is one.
struct StageColumn {
    std::string name;
    std::size_t components = 1;  ///< numbers a row, 1 to 16
    bool per_row = true;         ///< false: one list for all rows; `values` is as long as it likes
    std::vector<double> values;
};

struct StageTable {
    std::string stage;  ///< the function's name
    std::string scene;  ///< the scene's name
    std::size_t rows = 0;
    std::vector<StageColumn> columns;
    std::vector<glm::ivec2> pixel;  ///< one a row: where in the picture it was met; empty: nowhere
    std::vector<bool> doubtful;     ///< one a row: rounding may decide; empty: nowhere
    bool exact = false;             ///< ties are part of the question: nothing is doubtful

    [[nodiscard]] const StageColumn* find(const std::string& name) const;
};

/// One call: its arguments by name, and where its results go. An absent name is a mistake of the program's.
struct StageRow {
    const StageTable& in;
    StageTable& out;
    std::size_t index = 0;

    [[nodiscard]] bool is(const char* stage) const {
        return in.stage == stage;
    }
    [[nodiscard]] const double* numbers(const char* name) const;
    [[nodiscard]] float number(const char* name) const {
        return static_cast<float>(*numbers(name));
    }
    [[nodiscard]] std::int64_t integer(const char* name) const {
        return static_cast<std::int64_t>(*numbers(name));
    }
    [[nodiscard]] glm::vec2 vec2(const char* name) const;
    [[nodiscard]] glm::vec3 vec3(const char* name) const {
        return vec3_at(name, 0);
    }
    [[nodiscard]] glm::vec3 vec3_at(const char* name, std::size_t i) const;
    [[nodiscard]] float number_at(const char* name, std::size_t i) const {
        return static_cast<float>(numbers(name)[i]);
    }
    [[nodiscard]] glm::mat4 mat4(const char* name) const;
    [[nodiscard]] std::size_t count(const char* name, std::size_t size) const;

    void put(const char* name, std::initializer_list<double> values);
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

/// Fills a table column by column while rows are met.
struct TableBuilder {
    StageTable table;

    TableBuilder(std::string stage, std::string scene);
    /// A list that all rows share.
    void list(const std::string& name, std::vector<double> values);
    /// The next row's numbers, in the order in which columns first came; end_row() closes it.
    void add(const std::string& name, std::initializer_list<double> values);
    void add(const std::string& name, double value) {
        add(name, {value});
    }
    void add(const std::string& name, const glm::vec2& v) {
        add(name, {v.x, v.y});
    }
    void add(const std::string& name, const glm::vec3& v) {
        add(name, {v.x, v.y, v.z});
    }
    void end_row(glm::ivec2 pixel = glm::ivec2(-1));
};

/// All bytes of the file that a student's program reads: the harness in examples/assignments/ knows the format.
[[nodiscard]] std::string encode_tables(const std::vector<StageTable>& tables);

/// What a program wrote, held to what it should have written: the outputs of `expected`, table by table, column by
/// column, at their sizes. Tables that are there whole are kept; `complaint` says what came instead of the next one.
struct DecodedTables {
    std::vector<StageTable> tables;
    std::string complaint;
};
[[nodiscard]] DecodedTables decode_tables(const std::string& bytes, const std::vector<StageTable>& expected);

}  // namespace kreda::tools
