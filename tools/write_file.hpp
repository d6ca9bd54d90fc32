// Files, whole: read at once, and written so that they appear whole or not at all.
#pragma once

#include <string>

namespace kreda::tools {

/// Under another name first, then renamed: a browser never shows half a page. Throws UserError.
void write_file(const std::string& path, const std::string& text);

/// Every byte of a file; "" where it cannot be read, for callers to whom an absent file is an empty one.
[[nodiscard]] std::string bytes_of_file(const std::string& path);

/// The folder and those above it, if they are not there yet. Throws UserError.
void make_folder(const std::string& path);

}  // namespace kreda::tools
