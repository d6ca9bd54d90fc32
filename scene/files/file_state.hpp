// Whether a file is still what it was when it was read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kreda::scene {

/// What the system knows of a file, or of a folder: its times change with what is in it.
struct FileState {
    bool is_there = false;
    std::uint64_t device = 0, inode = 0;
    std::int64_t bytes = 0;
    std::int64_t modified_ns = 0, changed_ns = 0;  ///< since 1970
    bool operator==(const FileState&) const = default;
};

[[nodiscard]] FileState state_of_file(const std::string& path);

/// What of a path something depends on.
enum class FileUse { content, presence };

/// A path that was looked at, and what was there just before.
struct UsedFile {
    std::string path;
    FileUse use = FileUse::content;
    FileState state;
    /// It changed so shortly before that another change may bear the same time: nothing made of it is kept for long.
    bool is_settled = true;
};

/// Look at a path now; what is made of it is made afterwards.
[[nodiscard]] UsedFile use_file(const std::string& path, FileUse use = FileUse::content);

/// Is all of it as it was?
[[nodiscard]] bool is_unchanged(const std::vector<UsedFile>& used);

/// The same file has the same name, however a scene writes it: all links followed.
[[nodiscard]] std::string canonical_path(const std::string& path);

}  // namespace kreda::scene
