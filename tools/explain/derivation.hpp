// A derivation as plain data: sections of sentences, equations and tables, written as text, Markdown or JSON.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace kreda::tools {

/// symbol = formula = the formula with its numbers = result.
struct Equation {
    std::string symbol;
    std::string formula;        ///< empty: the symbol is given
    std::string numbers;        ///< empty: nothing to put in
    std::vector<double> value;  ///< 1 number, or the components of a vector or colour
    std::string note;           ///< a remark behind the result
};

struct Table {
    std::string name;  ///< key in JSON
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

using Item = std::variant<std::string, Equation, Table>;

struct Section {
    std::string id;  ///< one word or a few with underscores: key in JSON
    std::string title;
    std::vector<Item> items;

    void say(std::string sentence) {
        items.emplace_back(std::move(sentence));
    }
    void put(Table table) {
        items.emplace_back(std::move(table));
    }
    void equation(std::string symbol, std::string formula, std::string numbers, std::vector<double> value,
                  std::string note = {}) {
        items.emplace_back(
            Equation{std::move(symbol), std::move(formula), std::move(numbers), std::move(value), std::move(note)});
    }
    void equation(std::string symbol, std::string formula, std::string numbers, float value, std::string note = {}) {
        equation(std::move(symbol), std::move(formula), std::move(numbers), std::vector<double>{value},
                 std::move(note));
    }
    void equation(std::string symbol, std::string formula, std::string numbers, const glm::vec3& value,
                  std::string note = {}) {
        equation(std::move(symbol), std::move(formula), std::move(numbers),
                 std::vector<double>{value.x, value.y, value.z}, std::move(note));
    }
};

struct Derivation {
    std::string title;
    std::vector<Section> sections;
};

/// A number as it is read: six digits, whole numbers with all of them, "-0" as 0.
[[nodiscard]] std::string number_text(double value);
/// "(0.5, 0.25, 1)"
[[nodiscard]] std::string vector_text(const glm::vec2& v);
[[nodiscard]] std::string vector_text(const glm::vec3& v);
[[nodiscard]] std::string vector_text(const glm::vec4& v);
/// A negative number in brackets, so that it may stand behind an operator.
[[nodiscard]] std::string factor_text(double value);
/// "1·0.5 + 2·0.25 + 3·1"
[[nodiscard]] std::string dot_text(const glm::vec3& a, const glm::vec3& b);

[[nodiscard]] std::string as_text(const Derivation& derivation);
[[nodiscard]] std::string as_markdown(const Derivation& derivation);
/// Every equation with its value at full precision; sections in their order.
[[nodiscard]] std::string as_json(const Derivation& derivation);

}  // namespace kreda::tools
