// Where the texts of an example's pictures stand, as `--panels` writes it, and what is wrong with that.
#pragma once

#include <string>
#include <vector>

namespace kreda::tests {

struct PlacedText {
    std::string picture;
    float width = 0.0f, height = 0.0f;                           ///< of the picture, pixels
    float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;  ///< of the text's ink or strip
    float size = 0.0f;                                           ///< of the em square
    std::string text;
};

/// A file that is not there has no texts.
[[nodiscard]] std::vector<PlacedText> read_layout(const std::string& file);

/// A sentence for each text that leaves its picture, is smaller than 1/30 of its height, or lies over another one.
[[nodiscard]] std::vector<std::string> layout_faults(const std::vector<PlacedText>& texts);

}  // namespace kreda::tests
