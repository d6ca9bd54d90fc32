// Text on pictures in a real typeface, by FreeType: antialiased, blended in linear light. Sizes are those of the em
// square in pixels; capital letters are 0.73 of it high. Positions are in pixels, y down, and need not be whole.
#pragma once

#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/image.hpp"

namespace kreda::tools {

/// A rectangle on the picture, in pixels.
struct TypeBox {
    glm::vec2 low{0.0f}, high{0.0f};  ///< upper left and lower right corner
};

/// Parts of the em: what a line of text reaches above and below its baseline, and the height of capitals.
inline constexpr float kAscent = 0.93f;
inline constexpr float kDescent = 0.24f;
inline constexpr float kCapitals = 0.73f;

/// The least size of letters on a picture of this height: 1/30 of it.
[[nodiscard]] float least_type_size(int picture_height);

/// Is there a typeface? When it is asked for the first time and there is none, a line on stderr says what to install.
[[nodiscard]] bool has_typeface();

/// How far a text advances, in pixels, with the markup of tools/draw/markup.hpp; 0 without a typeface.
[[nodiscard]] float type_width(std::string_view markup, float size);

/// The smallest box that holds all ink of a text whose baseline begins at `start`; empty at `start` without ink.
[[nodiscard]] TypeBox type_ink(glm::vec2 start, std::string_view markup, float size);

/// Draw a text whose baseline begins at `start`; `color` is linear RGB. What lies outside is cut off. Nothing is drawn
/// without a typeface.
void draw_type(raster::Image& image, glm::vec2 start, std::string_view markup, const glm::vec3& color, float size);

}  // namespace kreda::tools
