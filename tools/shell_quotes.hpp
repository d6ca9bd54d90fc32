// Words of commands that a shell reads.
#pragma once

#include <string>

namespace kreda::tools {

/// The text as one word of a shell's command, whatever is in it.
[[nodiscard]] inline std::string in_shell_quotes(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

}  // namespace kreda::tools
