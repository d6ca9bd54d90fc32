#include "tools/grade/assignment/argument_text.hpp"

#include <cmath>
#include <span>

namespace kreda::tools {

namespace {

/// The word that a number stands for; a number that stands for none is written as it is.
std::string word_text(double value, std::span<const char* const> words, NumberText number) {
    const bool is_word = value == std::floor(value) && value >= 0.0 && value < static_cast<double>(words.size());
    return is_word ? words[static_cast<std::size_t>(value)] : number(value);
}

constexpr const char* kLights[] = {"directional", "point", "spot"};
constexpr const char* kFogModes[] = {"none", "linear", "exp", "exp2"};
constexpr const char* kFogDistances[] = {"radial", "planar"};
constexpr const char* kFrequencies[] = {"flat", "gouraud", "phong"};

/// The words of a column of numbers that stand for words; none: it holds numbers. "distance" is a word beside a fog's
/// "mode" alone.
std::span<const char* const> words_of(const StageTable& input, const StageColumn& c) {
    if (c.name == "mode") return kFogModes;
    if (c.name == "distance" && input.find("mode") != nullptr) return kFogDistances;
    if (c.name == "frequency") return kFrequencies;
    return {};
}

std::string argument_text(const StageTable& input, const StageColumn& c, std::size_t row, NumberText number) {
    const double* values = c.values.data() + row * c.components;
    if (c.name == "light_kind_inner_outer") {
        return "light = " + word_text(values[0], kLights, number) +
               ", cos_inner_outer = " + numbers_text(values + 1, 2, number);
    }
    const std::span<const char* const> words = words_of(input, c);
    return c.name + " = " +
           (words.empty() ? numbers_text(values, c.components, number) : word_text(values[0], words, number));
}

}  // namespace

std::string numbers_text(const double* values, std::size_t count, NumberText number) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + number(values[i]);
    return count > 1 ? "(" + text + ")" : text;
}

std::string arguments_text(const StageTable& input, std::size_t row, NumberText number) {
    std::string text;
    for (const StageColumn& c : input.columns) {
        if (c.per_row) text += (text.empty() ? "" : ", ") + argument_text(input, c, row, number);
    }
    return text;
}

}  // namespace kreda::tools
