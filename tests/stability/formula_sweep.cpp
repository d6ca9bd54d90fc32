#include "tests/stability/formula_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace kreda::tests {

namespace {

/// 24 bits of a number in [0, 1). The library's distributions differ from one library to the next.
double unit_random(std::mt19937& random) {
    return static_cast<double>(random() >> 8) * 0x1p-24;
}

float random_on(const Axis& axis, std::mt19937& random) {
    const double u = unit_random(random);
    const double low = axis.low, high = axis.high;
    const bool is_even = axis.spread == Axis::Spread::even;
    const double x = is_even ? low + u * (high - low) : std::exp2(std::log2(low) + u * std::log2(high / low));
    return std::clamp(static_cast<float>(x), axis.low, axis.high);
}

/// One float above and below each end and edge lies in the domain as well, where it is not beyond an end. Subnormal
/// numbers count as 0: the least normal one stands for them.
std::vector<float> certain_values(const Axis& axis) {
    std::vector<float> values = {axis.low, axis.high, std::nextafter(axis.low, axis.high),
                                 std::nextafter(axis.high, axis.low)};
    for (const float edge : axis.edges) {
        for (const float x : {edge, std::nextafter(edge, axis.low), std::nextafter(edge, axis.high)}) {
            if (x >= axis.low && x <= axis.high) values.push_back(x);
        }
    }
    values.insert(values.end(), axis.outside.begin(), axis.outside.end());
    for (float& x : values) {
        const bool is_subnormal = x != 0.0f && std::fabs(x) < std::numeric_limits<float>::min();
        if (is_subnormal) x = std::copysign(std::numeric_limits<float>::min(), x);
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

void try_inputs(const Formula& formula, const Inputs& inputs, SweepResult& result) {
    const double value = formula.value(inputs);
    ++result.tried;
    if (!(value >= formula.lowest && value <= formula.highest)) {
        if (result.outside == 0) result.where_outside = inputs;
        ++result.outside;
        return;
    }
    const Real exact = formula.exact(inputs);
    const double scale = formula.is_relative ? static_cast<double>(std::fabs(exact)) : 1.0;
    if (formula.is_relative && scale < formula.least) return;
    const double distance = formula.distance ? formula.distance(inputs) : static_cast<double>(std::fabs(value - exact));
    const double error = distance / scale;
    if (error > result.error) {
        result.error = error;
        result.where = inputs;
    }
}

std::string list_of(const Inputs& inputs) {
    std::string list;
    for (const float x : inputs) {
        char text[32];
        std::snprintf(text, sizeof text, "%.4g", static_cast<double>(x));
        list += (list.empty() ? "" : ", ") + std::string(text);
    }
    return list;
}

}  // namespace

Formula formula_of(const VectorFormula& vector) {
    Formula formula{vector.name,        vector.domain,     vector.range, 0.0, vector.longest,
                    vector.is_relative, vector.most_error, vector.axes,  {},  {}};
    const auto value = vector.value;
    const auto exact = vector.exact;
    formula.value = [value](const Inputs& x) { return static_cast<double>(glm::length(Wide(value(x)))); };
    formula.exact = [exact](const Inputs& x) { return glm::length(exact(x)); };
    formula.distance = [=](const Inputs& x) { return static_cast<double>(glm::length(Wide(value(x)) - exact(x))); };
    return formula;
}

std::vector<Formula> joined(std::vector<Formula> first, const std::vector<Formula>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

SweepResult sweep(const Formula& formula, int random_inputs) {
    SweepResult result;
    std::vector<std::vector<float>> certain;
    for (const Axis& axis : formula.axes) certain.push_back(certain_values(axis));
    std::vector<std::size_t> at(certain.size(), 0);
    for (bool is_done = false; !is_done;) {
        Inputs inputs;
        for (std::size_t i = 0; i < at.size(); ++i) inputs.push_back(certain[i][at[i]]);
        try_inputs(formula, inputs, result);
        is_done = true;
        for (std::size_t i = 0; i < at.size() && is_done; ++i) {
            at[i] = (at[i] + 1) % certain[i].size();
            is_done = at[i] == 0;
        }
    }
    std::mt19937 random(97);
    for (int i = 0; i < random_inputs; ++i) {
        Inputs inputs;
        for (std::size_t a = 0; a < certain.size(); ++a) {
            const bool is_certain = random() % 4 == 0;
            inputs.push_back(is_certain ? certain[a][random() % certain[a].size()]
                                        : random_on(formula.axes[a], random));
        }
        try_inputs(formula, inputs, result);
    }
    return result;
}

std::string with_commas(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string rounded_up(double number) {
    if (number == 0.0) return "0";
    const double step = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", std::ceil(number / step * (1.0 - 1e-9)) * step);
    return text;
}

std::string table_row(const Formula& formula, const SweepResult& result) {
    const std::string kind = formula.is_relative ? " of it" : "";
    const std::string where = result.error > 0.0 ? " at " + list_of(result.where) : "";
    return "| `" + formula.name + "` | " + formula.domain + " | " + formula.range + " | " + rounded_up(result.error) +
           kind + where + " | " + with_commas(result.tried) + " |";
}

}  // namespace kreda::tests
