// A folder of kept maps, or of whatever else takes long to make, does not grow without end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

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

/// A file or folder of a cache.
struct KeptEntry {
    std::filesystem::path path;
    std::filesystem::file_time_type used;
    std::uintmax_t bytes = 0;
    bool is_unfinished = false;  ///< left by a writer that was killed
};

/// Remove what is unfinished, and what was used longest ago until at most `limit` bytes are left. What was used within
/// the last hour stays. What cannot be removed stays, too, and more of the others goes in its place.
void remove_oldest(std::vector<KeptEntry> entries, std::uintmax_t limit);

/// remove_oldest() of the maps in a folder. Only files *.map count, and what writers that were killed left of them,
/// ".NAME.map.NUMBER.tmp": other files in the folder are somebody's own.
void trim_maps(const std::string& folder, std::uintmax_t limit);

}  // namespace kreda::scene
