#include "scene/files/file_state.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>

namespace kreda::scene {

namespace {

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// Systems count file times in steps of up to some ten milliseconds.
bool is_settled(const FileState& state) {
    constexpr std::int64_t kStep = 50'000'000;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return state.changed_ns < std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() - kStep;
}

}  // namespace

FileState state_of_file(const std::string& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return {};
#if defined(__APPLE__)
    const timespec modified = found.st_mtimespec, changed = found.st_ctimespec;
#else
    const timespec modified = found.st_mtim, changed = found.st_ctim;
#endif
    return {true,
            static_cast<std::uint64_t>(found.st_dev),
            static_cast<std::uint64_t>(found.st_ino),
            static_cast<std::int64_t>(found.st_size),
            nanoseconds(modified),
            nanoseconds(changed)};
}

UsedFile use_file(const std::string& path, FileUse use) {
    const FileState state = state_of_file(path);
    return {path, use, state, use == FileUse::presence || is_settled(state)};
}

bool is_unchanged(const std::vector<UsedFile>& used) {
    return std::all_of(used.begin(), used.end(), [](const UsedFile& file) {
        const FileState now = state_of_file(file.path);
        return file.use == FileUse::presence ? now.is_there == file.state.is_there
                                             : file.is_settled && now == file.state;
    });
}

std::string canonical_path(const std::string& path) {
    std::error_code failed;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, failed);
    return failed ? path : real.string();
}

}  // namespace kreda::scene
