// Where the letters of pictures come from: DejaVu, as Debian's fonts-dejavu-core and fonts-dejavu-extra install it.
#pragma once

#include <string>

namespace kreda::tools {

struct FontFiles {
    std::string upright;  ///< DejaVuSans.ttf, or "" where it is not installed
    std::string italic;   ///< DejaVuSerif-Italic.ttf for symbols; "": the upright letters are slanted
};

/// In the folder that the environment variable KREDA_FONTS names, and nowhere else; without it, in those where
/// distributions put fonts.
[[nodiscard]] FontFiles find_font_files();

/// What to do about missing letters, one line without an end of line.
[[nodiscard]] std::string missing_font_message();

}  // namespace kreda::tools
