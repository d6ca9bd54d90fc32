// Text and paths from files, made fit to stand in a message of one line.
#pragma once

#include <string>
#include <string_view>

namespace kreda::scene {

/// Control characters become '?', long text is cut in the middle: the end of a path is its name.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// A path between quotes: what is too long is cut at its beginning, and the file's name stays whole.
[[nodiscard]] std::string path_in_quotes(std::string_view path);

}  // namespace kreda::scene
