#include "tools/draw/slide.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "raster/film.hpp"
#include "tools/draw/draw.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using raster::Image;

constexpr int kMargin = 60;
constexpr int kPictureTop = 130;
constexpr int kPictureHeight = 775;

/// A line in the middle, as large as it may be.
void write_line(Image& slide, const std::string& text, int top, float largest, const glm::vec3& color) {
    if (text.empty()) return;
    const float room = kSlideWidth - 2 * kMargin;
    const float scale = std::min(largest, largest * room / text_width(text, largest));
    draw_text(slide, {0.5f * (kSlideWidth - text_width(text, scale)), top}, text, color, scale);
}

/// The first heading of a Markdown page, or "".
std::string heading_of(const fs::path& page) {
    std::ifstream file(page);
    std::string line;
    if (!std::getline(file, line) || !line.starts_with("# ")) return "";
    return line.substr(2);
}

bool is_example_name(const std::string& name) {
    return name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) &&
           std::isdigit(static_cast<unsigned char>(name[1])) && name[2] == '_';
}

}  // namespace

glm::ivec2 slide_picture_size(int width, int height) {
    constexpr double kRoom = kSlideWidth - 2 * kMargin;
    const double scale = std::min(kRoom / width, double{kPictureHeight} / height);
    return {std::max(1, static_cast<int>(width * scale)), std::max(1, static_cast<int>(height * scale))};
}

glm::ivec2 slide_picture_corner(glm::ivec2 size) {
    return {(kSlideWidth - size.x) / 2, kPictureTop + (kPictureHeight - size.y) / 2};
}

void fit_to_slide(scene::ImageSettings& image) {
    const glm::ivec2 size = slide_picture_size(image.width, image.height);
    image.width = size.x;
    image.height = size.y;
}

Image make_slide(const Image& picture, const SlideText& text, Theme theme) {
    const ThemeColors colors = colors_of(theme);
    Image slide = make_board(kSlideWidth, kSlideHeight, colors.ground);
    write_line(slide, text.title, 44, 7.0f, colors.text);
    write_line(slide, text.caption, 930, 6.0f, colors.text);
    write_line(slide, text.remark, 1010, 4.0f, colors.remark);
    slide = develop(slide, {});
    const glm::ivec2 corner = slide_picture_corner({picture.width, picture.height});
    paste(slide, picture, corner.x, corner.y);
    return slide;
}

std::string title_of_scene(const std::string& file) {
    if (file.empty()) return "the built-in scene";
    const fs::path path = fs::absolute(file);
    const std::string folder = path.parent_path().filename().string();
    if (!is_example_name(folder)) return path.stem().string();
    std::string heading = heading_of(path.parent_path().parent_path().parent_path() / "docs" / (folder + ".md"));
    if (!heading.empty()) return heading;
    std::string words = folder;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

}  // namespace kreda::tools
