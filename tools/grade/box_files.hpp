// Looking at what a boxed command left, without trusting any of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <sys/types.h>

namespace kreda::tools {

/// Whether the files below `folder` are larger than `most_bytes` together, or so many or so hidden that they cannot be
/// counted. Links are not followed.
[[nodiscard]] bool holds_too_much(const std::filesystem::path& folder, std::uint64_t most_bytes);

/// A file that a boxed command wrote into its work folder.
struct BoxedFile {
    std::string bytes;
    std::string problem;  ///< why it was not read: "is absent", "is a link", "is larger than ..."; empty: it was
};

/// Read a plain file of at most `most_bytes`; a link, a device, a pipe or a file with a second name is refused.
[[nodiscard]] BoxedFile read_boxed_file(const std::filesystem::path& file, std::uint64_t most_bytes);

/// How many threads of all processes run as this user, now.
[[nodiscard]] std::uint64_t count_threads_of(uid_t user);

}  // namespace kreda::tools
