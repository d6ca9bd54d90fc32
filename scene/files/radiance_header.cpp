#include "scene/files/radiance_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

namespace {

/// The next line without its end; it is taken from the text.
std::string take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

std::vector<float> numbers_in(const std::string& text) {
    std::vector<float> numbers;
    const char* at = text.c_str();
    for (char* end = nullptr;; at = end) {
        const float number = std::strtof(at, &end);
        if (end == at) return numbers;
        numbers.push_back(number);
    }
}

bool are_factors(const std::vector<float>& numbers, std::size_t count) {
    return numbers.size() == count && std::all_of(numbers.begin(), numbers.end(),
                                                  [](float factor) { return factor > 0.0f && std::isfinite(factor); });
}

/// Only the first complaint is kept: a header may hold any number of lines.
void remark_once(std::string& remark, const std::string& line, const char* what) {
    if (remark.empty()) remark = "says " + in_quotes(line) + what;
}

/// Photoshop writes zeros, and sRGB's white differs from the format's own: both mean the usual ones.
bool are_usual_primaries(const std::vector<float>& numbers) {
    if (std::all_of(numbers.begin(), numbers.end(), [](float number) { return number == 0.0f; })) return true;
    constexpr float kUsual[] = {0.64f, 0.33f, 0.295f, 0.6f, 0.15f, 0.06f, 0.323f, 0.331f};
    constexpr float kTolerance = 0.012f;
    if (numbers.size() != std::size(kUsual)) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!(std::abs(numbers[i] - kUsual[i]) < kTolerance)) return false;
    }
    return true;
}

/// A header while it is read.
struct Reading {
    RadianceHeader header;
    std::string no_factor, primaries, gamma;  ///< remarks

    void multiply(const std::string& line, const std::vector<float>& factors, std::size_t count) {
        if (!are_factors(factors, count)) {
            remark_once(no_factor, line, ", which is no factor; the line is left out");
            return;
        }
        for (std::size_t c = 0; c < 3; ++c) header.multiplier[c] *= factors[count == 1 ? 0 : c];
    }

    void read_variable(const std::string& line) {
        const std::vector<float> numbers = numbers_in(line.substr(line.find('=') + 1));
        if (line.starts_with("EXPOSURE=")) multiply(line, numbers, 1);
        if (line.starts_with("COLORCORR=")) multiply(line, numbers, 3);
        if (line.starts_with("FORMAT=32-bit_rle_xyze")) header.is_xyz = true;
        if (line.starts_with("PRIMARIES=") && !are_usual_primaries(numbers)) {
            remark_once(primaries, line, "; its colours are taken as those of sRGB's primaries");
        }
        if (line.starts_with("GAMMA=") && numbers != std::vector<float>{1.0f}) {
            remark_once(gamma, line, ", which the format does not know; its values are taken as linear");
        }
    }

    /// The product of all factors may be none itself.
    void finish_multiplier() {
        const auto [r, g, b] = header.multiplier;
        if (!are_factors({r, g, b}, 3)) {
            header.multiplier = {1, 1, 1};
            no_factor = "says EXPOSURE or COLORCORR whose product is no factor; they are left out";
        }
        if (header.multiplier == std::array<float, 3>{1, 1, 1}) return;
        char text[96];
        std::snprintf(text, sizeof text, r == g && g == b ? "%g" : "(%g, %g, %g)", double(r), double(g), double(b));
        header.remarks.push_back("says that its values were multiplied by " + std::string(text) +
                                 " (EXPOSURE, COLORCORR); they are divided by it");
    }
};

/// "-Y 512 +X 1024": the axis from line to line, then the one within a line; Y grows upwards.
int orientation_of(const std::string& line) {
    const std::size_t second = line.find_first_of("+-", 1);
    if (line.size() < 2 || second == std::string::npos || second + 1 >= line.size()) return 0;
    const std::string axes = line.substr(0, 2) + line.substr(second, 2);
    constexpr std::string_view kAxes[] = {"-Y+X", "-Y-X", "+Y-X", "+Y+X", "+X-Y", "-X-Y", "-X+Y", "+X+Y"};
    const auto found = std::find(std::begin(kAxes), std::end(kAxes), axes);
    return found == std::end(kAxes) ? 0 : static_cast<int>(found - std::begin(kAxes)) + 1;
}

}  // namespace

RadianceHeader read_radiance_header(std::string_view text) {
    Reading reading;
    std::string line = take_line(text);
    while (!line.empty()) {
        reading.read_variable(line);
        line = take_line(text);
    }
    line = take_line(text);
    RadianceHeader& header = reading.header;
    header.orientation = orientation_of(line);
    if (header.orientation > 1) header.remarks.push_back("is stored as " + in_quotes(line) + "; it was set upright");
    reading.finish_multiplier();
    for (const std::string& remark : {reading.no_factor, reading.primaries, reading.gamma}) {
        if (!remark.empty()) header.remarks.push_back(remark);
    }
    return header;
}

}  // namespace kreda::scene
