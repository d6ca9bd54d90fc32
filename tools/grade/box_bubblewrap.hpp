// The command line that runs a boxed command under bubblewrap.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/grade/box.hpp"

namespace kreda::tools {

/// Where it is installed; empty: nowhere.
[[nodiscard]] std::filesystem::path find_bubblewrap();

/// What every box can read: compilers, libraries, headers and what finds them. /usr/local is no part of it: there
/// Kreda itself may be installed.
[[nodiscard]] std::vector<std::filesystem::path> system_folders();

/// New namespaces of every kind; of the file system only system_folders(), `readable` and, writable, `work`. Everything
/// else that one could write to is made read-only. `filter` is the number of an open file with the seccomp program.
[[nodiscard]] std::vector<std::string> bubblewrap_command(const std::filesystem::path& bubblewrap,
                                                          const BoxRequest& request, int filter);

}  // namespace kreda::tools
