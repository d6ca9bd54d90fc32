// What an example shows: panels, each what was computed and what is written on it, side by side in one picture.
#pragma once

#include <string>
#include <vector>

#include "examples/draw.hpp"
#include "tools/draw/theme.hpp"
#include "tools/draw/type.hpp"

namespace kreda::examples {

/// Text anywhere on a panel, with the markup of tools/draw/markup.hpp. `start` is where its baseline begins, in pixels;
/// `size` is that of the em square.
struct Label {
    glm::vec2 start{0.0f};
    std::string text;
    glm::vec3 color = kChalk;
    float size = 0.0f;
};

/// A rectangle of pixels.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
};

/// `image` holds what was computed, in linear RGB, without any text: golden images are made of it.
struct Panel {
    Panel(Image computed, std::string text = {}) : image(std::move(computed)), caption(std::move(text)) {}

    Image image;
    std::string caption;  ///< in the lower left corner; also the name of its file
    std::vector<Label> labels;
    bool is_computed = true;  ///< false: a plot, a table, an empty place. It has no golden image
    bool is_drawing = false;  ///< in chalk on the board; the light theme shows it and its labels in ink on paper
    std::vector<PixelBox> pictures{};  ///< parts of a drawing that no theme changes
};

/// Images and their captions, one each.
[[nodiscard]] std::vector<Panel> with_captions(std::vector<Image> images, const std::vector<std::string>& captions);

/// The same, each a drawing.
[[nodiscard]] std::vector<Panel> as_drawings(std::vector<Panel> panels);

/// An empty board to draw on.
[[nodiscard]] Panel drawing_panel(glm::ivec2 size);

/// Put a picture, which no theme changes, on a drawing; `corner` is its upper left one.
void paste_picture(const Image& picture, glm::ivec2 corner, Panel& drawing);

/// A place that stays empty: a drawing.
[[nodiscard]] Panel empty_panel(glm::ivec2 size);

/// The size of captions on a picture of this height; what does not fit in its panel is set smaller, down to the least
/// size, and then in two lines.
[[nodiscard]] float caption_size(int picture_height);

/// A text of a picture, and where it stands.
struct TextBox {
    std::string text;
    tools::TypeBox box;
    float size = 0.0f;
};

/// A picture, linear RGB, and all the texts on it.
struct Composition {
    Image image;
    std::vector<TextBox> texts;
};

/// Panels side by side, row by row, each in the middle of its cell, then their texts.
[[nodiscard]] Composition compose(glm::ivec2 size, int columns, const std::vector<Panel>& panels,
                                  tools::Theme theme = tools::Theme::dark);

/// The file's name of a panel without its ending: its number from 1 and its caption, "2_point_1_d_2".
[[nodiscard]] std::string panel_name(std::size_t index, const Panel& panel);

}  // namespace kreda::examples
