#include "scene/files/trim_maps.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "scene/error.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

std::vector<KeptEntry> kept_maps(const std::string& folder) {
    std::vector<KeptEntry> maps;
    std::error_code failed;
    for (fs::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
        const std::string name = i->path().filename().string();
        const bool is_unfinished =
            name.starts_with(".") && name.ends_with(".tmp") && name.find(".map.") != std::string::npos;
        if (!name.ends_with(".map") && !is_unfinished) continue;
        std::error_code gone;  // another process may remove it meanwhile
        const KeptEntry map{i->path(), i->last_write_time(gone), i->file_size(gone), is_unfinished};
        if (!gone) maps.push_back(map);
    }
    return maps;
}

}  // namespace

std::uintmax_t bytes_of_megabytes(const std::string& variable, const std::string& text) {
    const bool is_number = !text.empty() && text.size() < 8 &&
                           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_number) throw UserError(variable + "=" + text + ": expected a whole number of megabytes");
    return std::uintmax_t{std::stoul(text)} << 20;
}

std::uintmax_t kept_maps_limit() {
    const char* const wish = std::getenv("KREDA_CACHE_MB");
    return wish ? bytes_of_megabytes("KREDA_CACHE_MB", wish) : kUsualCacheBytes;
}

void mark_as_used(const std::string& map_file) {
    std::error_code read_only;
    fs::last_write_time(map_file, fs::file_time_type::clock::now(), read_only);
}

void remove_oldest(std::vector<KeptEntry> entries, std::uintmax_t limit) {
    std::sort(entries.begin(), entries.end(), [](const KeptEntry& a, const KeptEntry& b) {
        return a.is_unfinished != b.is_unfinished ? a.is_unfinished : a.used < b.used;
    });
    std::uintmax_t sum = 0;
    for (const KeptEntry& entry : entries) sum += entry.bytes;
    const fs::file_time_type just_now = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const KeptEntry& entry : entries) {
        if (entry.used > just_now || (sum <= limit && !entry.is_unfinished)) continue;
        std::error_code failed;
        fs::remove_all(entry.path, failed);
        if (!failed) sum -= entry.bytes;
    }
}

void trim_maps(const std::string& folder, std::uintmax_t limit) {
    remove_oldest(kept_maps(folder), limit);
}

}  // namespace kreda::scene
