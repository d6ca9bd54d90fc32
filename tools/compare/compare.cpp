#include "tools/compare/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace kreda::tools {

namespace {

using raster::Image;

/// As a file holds it: what is outside of 0..1 is cut off.
double code_of(float value, int levels) {
    return static_cast<double>(std::lround(double(std::clamp(value, 0.0f, 1.0f)) * (levels - 1)));
}

/// In steps; see the head of compare.hpp.
double difference(float actual, float expected, int levels) {
    if (levels > 0) return std::abs(code_of(actual, levels) - code_of(expected, levels));
    const double step = std::max(std::abs(expected), kSmallestFloatWhite) / 255.0;
    const double steps = std::abs(double(actual) - double(expected)) / step;
    return steps > kFloatNoise ? steps : 0.0;
}

std::vector<float> difference_of_pixels(const Image& actual, const Image& expected, int levels) {
    std::vector<float> steps(actual.plane_size(), 0.0f);
    for (int c = 0; c < actual.channels; ++c) {
        const float* a = actual.plane(c);
        const float* b = expected.plane(c);
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i] = std::max(steps[i], static_cast<float>(difference(a[i], b[i], levels)));
    }
    return steps;
}

PixelPair worst_pixel(const Image& actual, const Image& expected, int levels, const std::vector<float>& steps) {
    const auto most = static_cast<std::size_t>(std::max_element(steps.begin(), steps.end()) - steps.begin());
    const auto width = static_cast<std::size_t>(actual.width);
    PixelPair pixel{static_cast<int>(most % width), static_cast<int>(most / width), steps[most], {}, {}};
    for (int c = 0; c < actual.channels; ++c) {
        const auto value = [&](const Image& image) {
            const float v = image.plane(c)[most];
            return levels > 0 ? code_of(v, levels) : double(v);
        };
        pixel.actual.push_back(value(actual));
        pixel.expected.push_back(value(expected));
    }
    return pixel;
}

/// The number of marked pixels that can be reached from `start` by steps to marked neighbours, also across corners.
/// They are unmarked.
std::size_t take_blob(std::vector<bool>& marked, int width, int height, std::size_t start) {
    std::vector<std::size_t> open{start};
    marked[start] = false;
    std::size_t count = 0;
    while (!open.empty()) {
        const int x = static_cast<int>(open.back() % static_cast<std::size_t>(width));
        const int y = static_cast<int>(open.back() / static_cast<std::size_t>(width));
        open.pop_back();
        ++count;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
                const std::size_t neighbour = std::size_t(j) * std::size_t(width) + std::size_t(i);
                if (!marked[neighbour]) continue;
                marked[neighbour] = false;
                open.push_back(neighbour);
            }
        }
    }
    return count;
}

std::size_t largest_blob(const std::vector<float>& steps, int width, int height) {
    std::vector<bool> marked(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) marked[i] = steps[i] > 1.0f;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i]) largest = std::max(largest, take_blob(marked, width, height, i));
    }
    return largest;
}

Measurement gate(const std::string& name, bool ok, const std::string& text) {
    return {name, ok ? 0.0 : 1.0, 0.0, text, ok};
}

Measurement counted(const std::string& name, std::size_t count, std::size_t limit, const std::string& text) {
    return {name, double(count), double(limit), text, count <= limit};
}

std::string size_of(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

std::string expected_text(const std::string& found, const std::string& expected) {
    return found == expected ? found : found + ", expected " + expected;
}

Measurement finite_values(const Image& actual, const Image& expected) {
    const std::size_t wrong = raster::count_non_finite(actual), also = raster::count_non_finite(expected);
    std::string text = "NaN or infinite, of " + std::to_string(actual.values.size());
    if (also > 0) text += "; the expected picture itself has " + std::to_string(also) + " of them";
    return {"values not finite", double(wrong), 0.0, text, wrong == 0 && also == 0};
}

void count_tiers(Comparison& result, const Image& actual, Numbers numbers, const CompareLimits& limits,
                 const Image* mask) {
    const std::vector<float>& steps = result.steps;
    const auto any_limit = static_cast<std::size_t>(limits.differing_percent / 100.0 * double(steps.size()) + 1e-9);
    const std::size_t more_limit = std::min(any_limit, static_cast<std::size_t>(limits.more_than_a_step));
    std::size_t more = 0, outside = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i] > 1.0f) ++more;
        if (steps[i] > 1.0f && mask && !(mask->values[i] > 0.5f)) ++outside;
    }
    char share[64];
    std::snprintf(share, sizeof share, "%g %% of %zu pixels", limits.differing_percent, steps.size());
    result.checks.push_back(counted("pixels that differ", result.differing, any_limit, share));
    const std::string step = numbers.levels > 0 ? "one code of " + std::to_string(numbers.levels - 1)
                                                : "1/255 of the expected value, at least 1/4080";
    result.checks.push_back(counted("by more than a step", more, more_limit, "a step is " + step));
    result.checks.push_back(counted("largest blob of those", largest_blob(steps, actual.width, actual.height),
                                    static_cast<std::size_t>(limits.blob), "pixels that touch each other"));
    if (mask) result.checks.push_back(counted("outside of the mask", outside, 0, "by more than a step"));
}

}  // namespace

Comparison compare(const Image& actual, const Image& expected, Numbers numbers, const CompareLimits& limits,
                   const Image* mask) {
    Comparison result;
    const bool same_size = actual.width == expected.width && actual.height == expected.height;
    const bool same_channels = actual.channels == expected.channels;
    result.checks.push_back(gate("size", same_size, expected_text(size_of(actual), size_of(expected))));
    result.checks.push_back(gate("channels", same_channels,
                                 expected_text(std::to_string(actual.channels), std::to_string(expected.channels))));
    result.checks.push_back(finite_values(actual, expected));
    if (mask) {
        const bool fits = mask->width == expected.width && mask->height == expected.height;
        result.checks.push_back(gate("size of the mask", fits, expected_text(size_of(*mask), size_of(expected))));
    }
    const auto is_ok = [](const Measurement& check) { return check.ok; };
    result.comparable = std::all_of(result.checks.begin(), result.checks.end(), is_ok) && !actual.values.empty();
    if (!result.comparable) return result;
    result.identical = actual.values == expected.values;
    result.steps = difference_of_pixels(actual, expected, numbers.levels);
    result.differing = static_cast<std::size_t>(
        std::count_if(result.steps.begin(), result.steps.end(), [](float step) { return step > 0.0f; }));
    if (result.differing > 0) result.worst = worst_pixel(actual, expected, numbers.levels, result.steps);
    count_tiers(result, actual, numbers, limits, mask);
    result.passed = std::all_of(result.checks.begin(), result.checks.end(), is_ok);
    return result;
}

std::string values_text(const std::vector<double>& values) {
    std::string text = "(";
    for (const double value : values) {
        char number[32];
        std::snprintf(number, sizeof number, "%.6g", value);
        text += (text.size() > 1 ? ", " : "") + std::string(number);
    }
    return text + ")";
}

std::string describe(const Comparison& comparison) {
    if (!comparison.comparable) {
        for (const Measurement& check : comparison.checks) {
            if (!check.ok) return "not comparable: " + check.name + ": " + check.text;
        }
        return "not comparable: the picture is empty";
    }
    if (comparison.identical) return "identical";
    std::string text =
        std::to_string(comparison.differing) + " of " + std::to_string(comparison.steps.size()) + " pixels differ";
    if (comparison.differing == 0) return text;
    const PixelPair& worst = comparison.worst;
    char steps[48];
    std::snprintf(steps, sizeof steps, ", %.6g steps", worst.steps);
    return text + ", most at (" + std::to_string(worst.x) + ", " + std::to_string(worst.y) +
           "): " + values_text(worst.actual) + ", expected " + values_text(worst.expected) + steps;
}

}  // namespace kreda::tools
