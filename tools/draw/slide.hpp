// Slides of 1920 x 1080: a title, a picture, a caption in letters that are read from the last row.
#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "raster/image.hpp"
#include "scene/scene.hpp"
#include "tools/draw/theme.hpp"

namespace kreda::tools {

inline constexpr int kSlideWidth = 1920;
inline constexpr int kSlideHeight = 1080;

/// UTF-8; what does not fit is written smaller.
struct SlideText {
    std::string title;
    std::string caption;
    std::string remark;  ///< a second, smaller line
};

/// The largest picture of this shape that a slide has room for, and where its upper left corner comes to lie.
[[nodiscard]] glm::ivec2 slide_picture_size(int width, int height);
[[nodiscard]] glm::ivec2 slide_picture_corner(glm::ivec2 size);

/// Give a scene's picture the size that fills the slide.
void fit_to_slide(scene::ImageSettings& image);

/// The slide; picture and result are encoded for a PNG, three channels. A picture that is too large is cut off.
[[nodiscard]] raster::Image make_slide(const raster::Image& picture, const SlideText& text, Theme theme);

/// What a scene is called on its slides: the title of its example's page where it is the scene of an example
/// ("22 Phong's terms"), else the file's name without its ending.
[[nodiscard]] std::string title_of_scene(const std::string& file);

}  // namespace kreda::tools
