#include "tools/draw/theme.hpp"

#include <algorithm>

#include <glm/common.hpp>

#include "raster/film.hpp"
#include "scene/error.hpp"
#include "tools/draw/draw.hpp"

namespace kreda::tools {

namespace {

const glm::vec3 kPaper = srgb(0xfbf9f3);
const glm::vec3 kInk = srgb(0x20262b);

/// Lightness l of HSL becomes 1 - l, on codes of sRGB.
glm::vec3 other_lightness(const glm::vec3& linear) {
    const auto code = [](float value) { return raster::srgb_from_linear(std::clamp(value, 0.0f, 1.0f)); };
    const glm::vec3 codes(code(linear.x), code(linear.y), code(linear.z));
    const float low = std::min({codes.x, codes.y, codes.z}), high = std::max({codes.x, codes.y, codes.z});
    return codes + (1.0f - low - high);
}

}  // namespace

Theme theme_named(const std::string& word, const std::string& option) {
    if (word == "dark") return Theme::dark;
    if (word == "light") return Theme::light;
    throw scene::UserError(option + " " + word + ": expected dark or light");
}

ThemeColors colors_of(Theme theme) {
    if (theme == Theme::dark) return {kBoard, kChalk, kDust, kSlate};
    return {kPaper, kInk, srgb(0x5a656c), srgb(0xd8d4c8)};
}

glm::vec3 on_paper(const glm::vec3& color) {
    const glm::vec3 board = other_lightness(kBoard), codes = other_lightness(color);
    const auto one = [&](int c) {
        const float paper = raster::srgb_from_linear(kPaper[c]);
        return raster::linear_from_srgb(std::clamp(codes[c] * paper / board[c], 0.0f, 1.0f));
    };
    return {one(0), one(1), one(2)};
}

}  // namespace kreda::tools
