#include "tools/sweep/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "raster/film.hpp"
#include "tools/draw/draw.hpp"

namespace kreda::tools {

namespace {

constexpr int kGap = 8;

/// Where things lie, in pixels: letters are capitals a thirtieth of the sheet's height.
struct Layout {
    float scale = 2.0f;  ///< of the letters
    int line = 0;        ///< height of a line of text
    int left = 0;        ///< room for the rows' headings
    int top = 0;         ///< room for the columns' headings
    int below = 0;       ///< room under each picture
    glm::ivec2 picture;  ///< size of a picture
};

/// Width of the widest text, in pixels.
int widest(const std::vector<std::string>& texts, float scale) {
    float width = 0.0f;
    for (const std::string& text : texts) width = std::max(width, text_width(text, scale));
    return static_cast<int>(std::ceil(width));
}

bool any_text(const std::vector<std::string>& texts) {
    return std::any_of(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
}

Layout layout_for(const Sheet& sheet, int sheet_height) {
    Layout layout;
    layout.scale = std::max(1.0f, static_cast<float>(sheet_height) / (30.0f * 7.0f));
    layout.line = static_cast<int>(std::lround(11.0f * layout.scale));
    const int heading = std::max(widest(sheet.rows, layout.scale), widest({sheet.row_key}, layout.scale));
    layout.left = heading > 0 ? heading + 2 * kGap : 0;
    const int lines = (sheet.column_key.empty() ? 0 : 1) + (any_text(sheet.columns) ? 1 : 0);
    layout.top = std::max(lines, sheet.row_key.empty() ? 0 : 1) * layout.line;
    layout.below = sheet.remarks.empty() ? 0 : layout.line;
    return layout;
}

glm::ivec2 sheet_size(const Sheet& sheet, const Layout& layout) {
    const int columns = static_cast<int>(sheet.columns.size()), rows = static_cast<int>(sheet.rows.size());
    return {layout.left + columns * (layout.picture.x + kGap) + kGap,
            layout.top + rows * (layout.picture.y + layout.below + kGap) + kGap};
}

glm::ivec2 corner_of(const Layout& layout, int column, int row) {
    return {layout.left + kGap + column * (layout.picture.x + kGap),
            layout.top + kGap + row * (layout.picture.y + layout.below + kGap)};
}

/// In the middle of a picture's width; smaller where it is too long.
void write_centred(Image& image, const Layout& layout, int column, int y, const std::string& text,
                   const glm::vec3& color) {
    const auto room = static_cast<float>(layout.picture.x);
    const float width = text_width(text, layout.scale);
    if (width == 0.0f) return;
    const float share = std::min(1.0f, room / width);
    const float x = static_cast<float>(corner_of(layout, column, 0).x) + 0.5f * (room - share * width);
    draw_text(image, {x, y}, text, color, share * layout.scale);
}

void write_headings(Image& image, const Sheet& sheet, const Layout& layout) {
    const int padding = static_cast<int>(2.0f * layout.scale);
    if (!sheet.column_key.empty())
        draw_text(image, {corner_of(layout, 0, 0).x, padding}, sheet.column_key, kDust, layout.scale);
    for (std::size_t c = 0; c < sheet.columns.size(); ++c) {
        write_centred(image, layout, static_cast<int>(c), layout.top - layout.line + padding, sheet.columns[c], kChalk);
    }
    if (!sheet.row_key.empty())
        draw_text(image, {kGap, layout.top - layout.line + padding}, sheet.row_key, kDust, layout.scale);
    for (std::size_t r = 0; r < sheet.rows.size(); ++r) {
        const int y = corner_of(layout, 0, static_cast<int>(r)).y +
                      (layout.picture.y - static_cast<int>(7.0f * layout.scale)) / 2;
        draw_text(image, {kGap, y}, sheet.rows[r], kChalk, layout.scale);
    }
}

}  // namespace

glm::ivec2 sheet_picture_size(const Sheet& sheet, glm::ivec2 sheet_size, float aspect) {
    const Layout layout = layout_for(sheet, sheet_size.y);
    const int columns = static_cast<int>(sheet.columns.size()), rows = static_cast<int>(sheet.rows.size());
    const int width = (sheet_size.x - layout.left - kGap) / columns - kGap;
    const int height = (sheet_size.y - layout.top - kGap) / rows - kGap - layout.below;
    const int fitting = std::min(width, static_cast<int>(std::lround(height * aspect)));
    return {std::max(fitting, 1), std::max(static_cast<int>(std::lround(fitting / aspect)), 1)};
}

raster::Image draw_sheet(const Sheet& sheet) {
    const raster::Image& first = sheet.pictures.at(0);
    const int rows = static_cast<int>(sheet.rows.size());
    Layout layout = layout_for(sheet, rows * first.height);
    layout.picture = {first.width, first.height};
    const glm::ivec2 size = sheet_size(sheet, layout);
    Image image = make_board(size.x, size.y);
    write_headings(image, sheet, layout);
    const int columns = static_cast<int>(sheet.columns.size());
    for (std::size_t i = 0; i < sheet.remarks.size(); ++i) {
        const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
        const int y = corner_of(layout, column, row).y + layout.picture.y + static_cast<int>(2.0f * layout.scale);
        write_centred(image, layout, column, y, sheet.remarks[i], kDust);
    }
    image = raster::develop(image, {});
    for (std::size_t i = 0; i < sheet.pictures.size(); ++i) {
        const glm::ivec2 corner = corner_of(layout, static_cast<int>(i) % columns, static_cast<int>(i) / columns);
        paste(image, sheet.pictures[i], corner.x, corner.y);
    }
    return image;
}

}  // namespace kreda::tools
