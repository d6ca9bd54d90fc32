#include "tools/grade/assignment/grade_cache.hpp"

#include <cstdlib>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "scene/files/trim_maps.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

/// An environment variable's value; empty where it is not set.
std::string environment_text(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

bool make_writable(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    return access(folder.c_str(), W_OK) == 0;
}

/// Held while it lives; a second process waits. Where no lock can be had, nobody waits and the work is done twice.
struct FileLock {
    int file;

    explicit FileLock(const fs::path& path) : file(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600)) {
        if (file >= 0) flock(file, LOCK_EX);
    }
    ~FileLock() {
        if (file >= 0) close(file);
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
};

std::uintmax_t bytes_in(const fs::path& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) return fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
    std::uintmax_t sum = 0;
    for (fs::recursive_directory_iterator i(path, error), end; !error && i != end; i.increment(error)) {
        std::error_code gone;
        if (i->is_regular_file(gone)) sum += i->file_size(gone);
    }
    return sum;
}

/// "NAME.NUMBER" is what fill_folder() works in; a process that was killed leaves it.
bool is_unfinished(const fs::path& path) {
    const std::string number = path.extension().string();
    return number.size() > 1 && number.find_first_not_of("0123456789", 1) == std::string::npos;
}

/// Make the folder under another name, then rename it: nobody sees it half made.
void fill_folder(const fs::path& folder, const std::function<void(const fs::path&)>& fill) {
    const fs::path unfinished = folder.string() + "." + std::to_string(getpid());
    std::error_code error;
    fs::remove_all(unfinished, error);
    fs::create_directories(unfinished);
    try {
        fill(unfinished);
    } catch (...) {
        fs::remove_all(unfinished, error);
        throw;
    }
    fs::rename(unfinished, folder, error);
    if (error) fs::remove_all(unfinished, error);  // somebody who had no lock was first
}

}  // namespace

fs::path grade_cache() {
    if (const std::string chosen = environment_text("KREDA_GRADE_CACHE"); !chosen.empty()) {
        fs::create_directories(chosen);
        return chosen;
    }
    const std::string shared = environment_text("XDG_CACHE_HOME"), home = environment_text("HOME");
    if (!shared.empty() && make_writable(fs::path(shared) / "kreda" / "grade")) {
        return fs::path(shared) / "kreda" / "grade";
    }
    if (!home.empty() && make_writable(fs::path(home) / ".cache" / "kreda" / "grade")) {
        return fs::path(home) / ".cache" / "kreda" / "grade";
    }
    fs::path elsewhere = fs::temp_directory_path() / ("kreda-grade-" + std::to_string(getuid()));
    fs::create_directories(elsewhere);
    fs::permissions(elsewhere, fs::perms::owner_all);
    return elsewhere;
}

std::uintmax_t grade_cache_limit() {
    const std::string text = environment_text("KREDA_GRADE_CACHE_MB");
    return text.empty() ? scene::kUsualCacheBytes : scene::bytes_of_megabytes("KREDA_GRADE_CACHE_MB", text);
}

fs::path cached_folder(const std::string& name, const std::function<void(const fs::path&)>& fill) {
    const fs::path cache = grade_cache();
    fs::path folder = cache / name;
    const FileLock lock(cache / (name + ".lock"));
    std::error_code error;
    if (!fs::exists(folder)) {
        fill_folder(folder, fill);
        trim_cache(cache, grade_cache_limit());
    }
    fs::last_write_time(folder, fs::file_time_type::clock::now(), error);
    return folder;
}

void trim_cache(const fs::path& cache, std::uintmax_t limit) {
    std::vector<scene::KeptEntry> entries;
    std::error_code error;
    for (fs::directory_iterator i(cache, error), end; !error && i != end; i.increment(error)) {
        std::error_code gone;  // another process may remove it meanwhile
        const fs::path& path = i->path();
        const scene::KeptEntry entry{path, fs::last_write_time(path, gone), bytes_in(path), is_unfinished(path)};
        if (!gone) entries.push_back(entry);
    }
    scene::remove_oldest(std::move(entries), limit);
}

}  // namespace kreda::tools
