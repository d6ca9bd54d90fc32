// Files that an OBJ or MTL names: found where the text says, or near by, and never outside of the mesh's folder.
#pragma once

#include <string>
#include <vector>

#include "scene/files/file_state.hpp"
#include "scene/files/obj_text.hpp"

namespace kreda::scene {

/// Where the paths in a text may lead.
struct NamedFileLimits {
    std::string root;                       ///< the OBJ's folder
    bool allow_outside = false;             ///< files outside of root may be read, too
    std::vector<UsedFile>* used = nullptr;  ///< told what was looked at; the files themselves are used by their readers
};

/// What a path in a text leads to.
struct NamedPath {
    std::string path;       ///< the file to read, empty: there is none that may be read
    bool is_other = false;  ///< not what the text says, but the nearest to it
};

/// Resolve a path that `text` names, relative to its own folder, with / or \ between folders. Where nothing is there, a
/// file whose path differs in capitals alone is taken, else one of the same name beside the text: texts come from
/// systems that do not tell capitals apart and are full of paths of other people's disks. Unless allow_outside, nothing
/// outside of root (symbolic links followed) is given back; a file that is there, but outside, is an error at `offset`.
[[nodiscard]] NamedPath resolve_named_path(const ObjText& text, std::size_t offset, const std::string& named,
                                           const NamedFileLimits& limits);

/// The same; a warning says which file is used instead, or that there is none and which name is near. `kind`: "image
/// file"; `without`: what becomes of a missing one, e.g. "; drawn without it".
[[nodiscard]] std::string find_named_file(const ObjText& text, std::size_t offset, const std::string& named,
                                          const NamedFileLimits& limits, const std::string& kind,
                                          const std::string& without, ObjWarnings& warnings);

/// A name up to a comment: "wood.png # oak" -> "wood.png". Whoever has a thing of the whole name takes that: "Material
/// #25" is one.
[[nodiscard]] std::string without_comment(const std::string& name);

/// The folder of a file: "." where its path names none.
[[nodiscard]] std::string folder_of(const std::string& path);

}  // namespace kreda::scene
