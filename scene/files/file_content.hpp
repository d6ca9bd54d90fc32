// What a file really holds, told by its first bytes, where people commonly have another file than they think.
#pragma once

#include <string>
#include <string_view>

namespace kreda::scene {

/// "is a web page (HTML), not what its name says; download the file itself": for web pages, Git LFS pointers, packed
/// files, drawings, movies, and meshes in other formats than OBJ; "" for anything else. `start`: its first bytes.
[[nodiscard]] std::string other_content(std::string_view start);

}  // namespace kreda::scene
