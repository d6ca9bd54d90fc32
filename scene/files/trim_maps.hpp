// A folder of kept maps does not grow without end.
#pragma once

#include <cstdint>
#include <string>

namespace kreda::scene {

/// What a cache may hold where its user names no limit.
inline constexpr std::uintmax_t kUsualCacheBytes = std::uintmax_t{1024} << 20;

/// The megabytes that an environment variable names, in bytes. Throws UserError where `text` is no whole number.
[[nodiscard]] std::uintmax_t bytes_of_megabytes(const std::string& variable, const std::string& text);

/// The most that the kept maps of one folder may hold, in bytes: $KREDA_CACHE_MB, else 1024 MB. Throws UserError where
/// that is no whole number.
[[nodiscard]] std::uintmax_t kept_maps_limit();

/// Note that a kept map was used now.
void mark_as_used(const std::string& map_file);

/// Remove what was used longest ago until at most `limit` bytes are left; what was used within the last hour stays.
/// Only files *.map count, and what writers that were killed left of them, ".NAME.map.NUMBER.tmp": other files in the
/// folder are somebody's own. What cannot be removed stays.
void trim_maps(const std::string& folder, std::uintmax_t limit);

}  // namespace kreda::scene
