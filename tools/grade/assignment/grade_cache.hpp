// What is the same for all submissions and takes long to make: compiled catalogues and their answers.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace kreda::tools {

/// Where it is kept: $KREDA_GRADE_CACHE, else $XDG_CACHE_HOME/kreda/grade, else ~/.cache/kreda/grade; where that cannot
/// be written, a folder in the system's temporary one. The folder exists.
[[nodiscard]] std::filesystem::path grade_cache();

/// The most that it may hold, in bytes: $KREDA_GRADE_CACHE_MB, else 1024 MB. Throws UserError where that is no number.
[[nodiscard]] std::uintmax_t grade_cache_limit();

/// The folder of this name in the cache. Where it is not there, `fill` makes what belongs in it, once: another process
/// that wants the same waits. What was used last longest ago is then removed down to the limit.
[[nodiscard]] std::filesystem::path cached_folder(const std::string& name,
                                                  const std::function<void(const std::filesystem::path&)>& fill);

/// scene::remove_oldest() of what it holds; folders that a process which was killed left half made are unfinished.
void trim_cache(const std::filesystem::path& cache, std::uintmax_t limit);

}  // namespace kreda::tools
