// Dark for a projector, light for paper.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace kreda::tools {

enum class Theme { dark, light };

/// "dark" or "light". Throws UserError that begins with `option`.
[[nodiscard]] Theme theme_named(const std::string& word, const std::string& option);

/// Linear RGB of what is written and drawn.
struct ThemeColors {
    glm::vec3 ground;    ///< behind everything, and of the strips under captions
    glm::vec3 text;      ///< of titles and captions
    glm::vec3 remark;    ///< of what is less important
    glm::vec3 division;  ///< between panels
};

[[nodiscard]] ThemeColors colors_of(Theme theme);

/// A colour of a drawing in chalk on the board, as it is in ink on paper: dark for light, the hue kept. The board
/// becomes the ground of the light theme.
[[nodiscard]] glm::vec3 on_paper(const glm::vec3& color);

}  // namespace kreda::tools
