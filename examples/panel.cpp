#include "examples/panel.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <glm/common.hpp>

#include "raster/platform.hpp"

namespace kreda::examples {

namespace {

constexpr float kPadding = 0.3f;      ///< of a caption's size, around it
constexpr float kLineHeight = 1.17f;  ///< of a caption's size

/// A caption in one line or two.
std::vector<std::string> lines_of(const std::string& caption, float size, float room) {
    if (tools::type_width(caption, size) <= room) return {caption};
    const std::size_t middle = caption.size() / 2;
    std::size_t best = std::string::npos;
    for (std::size_t i = 0; i < caption.size(); ++i) {
        const auto away = [middle](std::size_t at) { return at > middle ? at - middle : middle - at; };
        if (caption[i] == ' ' && (best == std::string::npos || away(i) < away(best))) best = i;
    }
    if (best == std::string::npos) return {caption};
    return {caption.substr(0, best), caption.substr(best + 1)};
}

/// The size at which every caption fits into its panel, if the least one is not too large for that.
float common_size(int picture_height, const std::vector<Panel>& panels) {
    const float wanted = caption_size(picture_height), least = tools::least_type_size(picture_height);
    float size = wanted;
    for (const Panel& panel : panels) {
        const float width = tools::type_width(panel.caption, wanted) + 2.0f * kPadding * wanted;
        if (width > 0.0f) size = std::min(size, wanted * static_cast<float>(panel.image.width) / width);
    }
    return std::max(size, least);
}

/// A caption on a dark strip in the lower left corner of a panel that begins at `corner`.
void write_caption(Composition& onto, const Panel& panel, glm::ivec2 corner, float size,
                   const tools::ThemeColors& colors) {
    if (panel.caption.empty() || !tools::has_typeface()) return;
    const float padding = kPadding * size;
    const auto lines = lines_of(panel.caption, size, static_cast<float>(panel.image.width) - 2.0f * padding);
    float width = 0.0f;
    for (const std::string& line : lines) width = std::max(width, tools::type_width(line, size));
    const float height = kLineHeight * size * static_cast<float>(lines.size()) + padding;
    const glm::ivec2 strip(std::lround(width + 2.0f * padding), std::lround(height));
    const int top = corner.y + panel.image.height - strip.y;
    fill_rectangle(onto.image, corner.x, top, strip.x, strip.y, colors.ground);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float down = 0.5f * padding + (tools::kAscent + kLineHeight * static_cast<float>(i)) * size;
        const glm::vec2 start(static_cast<float>(corner.x) + padding, static_cast<float>(top) + down);
        tools::draw_type(onto.image, start, lines[i], colors.text, size);
    }
    onto.texts.push_back(
        {panel.caption, {glm::vec2(corner.x, top), glm::vec2(corner.x, top) + glm::vec2(strip)}, size});
}

void write_labels(Composition& onto, const Panel& panel, glm::ivec2 corner, bool inked) {
    for (const Label& label : panel.labels) {
        const glm::vec2 start = glm::vec2(corner) + label.start;
        tools::draw_type(onto.image, start, label.text, inked ? tools::on_paper(label.color) : label.color, label.size);
        onto.texts.push_back({label.text, tools::type_ink(start, label.text, label.size), label.size});
    }
}

/// A drawing in ink on paper, but for the pictures in it.
Image inked_image(const Panel& panel) {
    Image image = panel.image;
    glm::vec3 last = kBoard, on_paper = tools::on_paper(last);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (const glm::vec3 color = image.rgb(x, y); color != last) {  // neighbours are often alike
                last = color;
                on_paper = tools::on_paper(color);
            }
            image.set_rgb(x, y, on_paper);
        }
    }
    for (const PixelBox& box : panel.pictures) {
        paste(image, crop(panel.image, box.x, box.y, box.width, box.height), box.x, box.y);
    }
    return image;
}

}  // namespace

std::vector<Panel> with_captions(std::vector<Image> images, const std::vector<std::string>& captions) {
    KREDA_EXPECT(images.size() == captions.size());
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < images.size(); ++i) panels.emplace_back(std::move(images[i]), captions[i]);
    return panels;
}

std::vector<Panel> as_drawings(std::vector<Panel> panels) {
    for (Panel& panel : panels) panel.is_drawing = true;
    return panels;
}

Panel drawing_panel(glm::ivec2 size) {
    Panel panel(make_board(size.x, size.y));
    panel.is_drawing = true;
    return panel;
}

void paste_picture(const Image& picture, glm::ivec2 corner, Panel& drawing) {
    paste(drawing.image, picture, corner.x, corner.y);
    drawing.pictures.push_back({corner.x, corner.y, picture.width, picture.height});
}

Panel empty_panel(glm::ivec2 size) {
    Panel panel = drawing_panel(size);
    panel.is_computed = false;
    return panel;
}

float caption_size(int picture_height) {
    return static_cast<float>(picture_height) / 22.0f;
}

Composition compose(glm::ivec2 size, int columns, const std::vector<Panel>& panels, tools::Theme theme) {
    const tools::ThemeColors colors = colors_of(theme);
    const auto inked = [&](const Panel& panel) { return panel.is_drawing && theme == tools::Theme::light; };
    std::vector<Image> images;
    const auto add = [&](const Panel& panel) { images.push_back(inked(panel) ? inked_image(panel) : panel.image); };
    for (const Panel& panel : panels) add(panel);
    while (images.size() % static_cast<std::size_t>(columns) != 0) {
        add(empty_panel({images.back().width, images.back().height}));
    }
    Composition whole{montage(size.x, size.y, columns, images, colors.division), {}};
    const float type = common_size(size.y, panels);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const glm::ivec2 corner = panel_corner(size.x, size.y, columns, static_cast<int>(i), panels.size(),
                                               {panels[i].image.width, panels[i].image.height});
        write_labels(whole, panels[i], corner, inked(panels[i]));
        write_caption(whole, panels[i], corner, type, colors);
    }
    return whole;
}

std::string panel_name(std::size_t index, const Panel& panel) {
    std::string name = std::to_string(index + 1);
    bool gap = true;
    for (const char c : panel.caption) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
            gap = true;
            continue;
        }
        if (gap) name += '_';
        name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        gap = false;
    }
    return name;
}

}  // namespace kreda::examples
