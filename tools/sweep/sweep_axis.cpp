#include "tools/sweep/sweep_axis.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "scene/error.hpp"

namespace kreda::tools {

namespace {

using scene::UserError;

SweepAxis split_at_equals(const std::string& set) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == set.size()) {
        throw UserError("--set " + set + ": expected KEY=VALUE, KEY=A,B,C or, with --frames, KEY=FROM..TO");
    }
    return {set.substr(0, equals), {set.substr(equals + 1)}};
}

/// The parts between commas that stand outside of brackets and quotes.
std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[') {
            ++depth;
        } else if (c == ']') {
            --depth;
        } else if (c == ',' && depth == 0) {
            parts.emplace_back();
            continue;
        }
        parts.back() += c;
    }
    return parts;
}

/// A number, or the numbers of a list in brackets; empty if it is neither.
std::vector<double> numbers_of(std::string text) {
    const bool is_list = text.size() > 1 && text.front() == '[' && text.back() == ']';
    if (is_list) text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    for (std::string part : is_list ? split_list(text) : std::vector<std::string>{text}) {
        part.erase(0, part.find_first_not_of(" \t+"));
        part.erase(part.find_last_not_of(" \t") + 1);
        double number = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc() || end != part.data() + part.size()) return {};
        numbers.push_back(number);
    }
    return numbers;
}

/// Six digits are more than a picture shows, and TOML keeps a whole number apart from a fraction: keys take both.
std::string number_in_toml(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

std::string value_between(const std::vector<double>& from, const std::vector<double>& to, double share, bool is_list) {
    std::string text;
    for (std::size_t i = 0; i < from.size(); ++i) {
        text += (i > 0 ? "," : "") + number_in_toml(from[i] + share * (to[i] - from[i]));
    }
    return is_list ? "[" + text + "]" : text;
}

}  // namespace

SweepAxis listed_axis(const std::string& set) {
    SweepAxis axis = split_at_equals(set);
    axis.values = split_list(axis.values[0]);
    for (const std::string& value : axis.values) {
        if (!value.empty()) continue;
        throw UserError("--set " + set + ": there is no value between two commas");
    }
    return axis;
}

SweepAxis stepped_axis(const std::string& set, int count, bool around) {
    SweepAxis axis = split_at_equals(set);
    const std::string range = axis.values[0];
    const std::size_t dots = range.find("..");
    if (dots == std::string::npos) return axis;
    const std::vector<double> from = numbers_of(range.substr(0, dots)), to = numbers_of(range.substr(dots + 2));
    if (from.empty() || from.size() != to.size()) {
        throw UserError("--set " + set + ": expected two numbers, FROM..TO, or two lists of as many, [..]..[..]");
    }
    const int steps = around ? count : std::max(count - 1, 1);
    axis.values.clear();
    for (int i = 0; i < count; ++i) {
        axis.values.push_back(value_between(from, to, static_cast<double>(i) / steps, range.front() == '['));
    }
    return axis;
}

}  // namespace kreda::tools
