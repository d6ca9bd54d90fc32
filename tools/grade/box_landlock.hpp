// Landlock: which files a process and its descendants may open. Needs no privilege; Linux 5.13 and newer.
#pragma once

#include <filesystem>
#include <vector>

namespace kreda::tools {

/// What the kernel knows: 0 where it has no Landlock. From 6 on, signals cannot leave the box.
[[nodiscard]] int landlock_version();

/// A set of rules as an open file: read and execute below `readable`, everything below `writable`, nothing elsewhere;
/// no TCP, no signals and abstract sockets out of the box where the kernel can refuse them. -1 when it cannot be made.
/// What does not exist is left out.
[[nodiscard]] int make_landlock_rules(const std::vector<std::filesystem::path>& readable,
                                      const std::filesystem::path& writable);

/// The calling thread and all that it starts obey the rules from now on. Safe between fork and exec.
[[nodiscard]] bool obey_landlock_rules(int rules);

}  // namespace kreda::tools
