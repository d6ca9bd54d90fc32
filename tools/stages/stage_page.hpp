// The page that steps through the stages in a browser, from a file, offline; and the contact sheet.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "raster/image.hpp"
#include "tools/stages/stage.hpp"

namespace kreda::tools {

/// What the page knows of a stage: its files and words, not its pixels.
struct PageEntry {
    std::string picture;  ///< file, beside the page
    std::string values;   ///< file of its numbers, beside the page; empty: none
    std::string title, meaning, legend;
    std::vector<std::string> components;
};

/// A pass of the plan.
struct PagePass {
    std::string name, reason;
};

struct StagePage {
    std::string title;
    std::string scene;           ///< as it was named on the command line
    glm::ivec2 size{0};          ///< of the scene's picture, in pixels
    glm::ivec2 picture_size{0};  ///< of the picture files; larger than `size` for slides
    glm::ivec2 corner{0};        ///< where the scene's picture begins in them
    bool has_pixels = true;      ///< false where the pictures are drawings without a pixel under the pointer
    std::vector<PageEntry> stages;
    std::vector<PagePass> passes;  ///< what `kreda render` runs for this scene: the plan's, in its order
};

/// index.html: arrow keys step, numbers under the pointer, a click holds a pixel.
[[nodiscard]] std::string stage_page_html(const StagePage& page);

/// The numbers of a stage as a script that the page loads when they are needed (a page from a file may not read other
/// files, but it may run them). Floats without their last 8 bits (relative error 2^-17), byte by byte from the most
/// significant one, each as its difference from the one before, deflated, in base64.
[[nodiscard]] std::string values_script(std::size_t stage, const raster::Image& values);

/// The same bytes before base64: for the script, and for tests.
[[nodiscard]] std::vector<unsigned char> packed_values(const raster::Image& values);

/// A picture as small as it stands on the contact sheet, its shape kept.
[[nodiscard]] raster::Image thumbnail(const raster::Image& picture);

/// All thumbnails with number and title, row by row. Encoded for a PNG.
[[nodiscard]] raster::Image contact_sheet(const std::string& title, const std::vector<raster::Image>& thumbnails,
                                          const std::vector<std::string>& titles);

}  // namespace kreda::tools
