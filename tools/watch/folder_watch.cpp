#include "tools/watch/folder_watch.hpp"

#include <array>
#include <chrono>
#include <cstring>
#include <thread>

#include <unistd.h>
#if defined(__linux__)
#include <poll.h>
#include <sys/inotify.h>
#endif

namespace kreda::tools {

#if defined(__linux__)

FolderWatch::FolderWatch() : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

FolderWatch::~FolderWatch() {
    if (queue_ >= 0) close(queue_);
}

void FolderWatch::watch(const std::set<std::string>& folders) {
    if (queue_ < 0) return;
    constexpr std::uint32_t kChanges = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE;
    std::map<int, std::string> now;
    for (const std::string& folder : folders) {
        const int number = inotify_add_watch(queue_, folder.c_str(), kChanges);
        if (number >= 0) now[number] = folder;
    }
    for (const auto& [number, folder] : folder_) {
        if (!now.contains(number)) inotify_rm_watch(queue_, number);
    }
    folder_ = std::move(now);
}

bool FolderWatch::collect(int milliseconds, std::set<std::string>& paths) {
    pollfd ready{queue_, POLLIN, 0};
    if (poll(&ready, 1, milliseconds) <= 0) return false;
    alignas(inotify_event) std::array<char, 1 << 14> bytes;
    bool any = false;
    for (ssize_t size; (size = read(queue_, bytes.data(), bytes.size())) > 0;) {
        for (ssize_t at = 0; at < size;) {
            inotify_event event;
            std::memcpy(&event, &bytes[static_cast<std::size_t>(at)], sizeof event);
            const char* const name = &bytes[static_cast<std::size_t>(at) + sizeof event];
            const auto folder = folder_.find(event.wd);
            if (event.len > 0 && folder != folder_.end()) any |= paths.insert(folder->second + "/" + name).second;
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
    }
    return any;
}

#else

FolderWatch::FolderWatch() = default;
FolderWatch::~FolderWatch() = default;
void FolderWatch::watch(const std::set<std::string>&) {}
bool FolderWatch::collect(int, std::set<std::string>&) {
    return false;
}

#endif

std::set<std::string> FolderWatch::wait(int milliseconds) {
    constexpr int kQuiet = 8, kMostSteps = 10;
    std::set<std::string> paths;
    if (queue_ < 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        return paths;
    }
    if (!collect(milliseconds, paths)) return paths;
    for (int step = 0; step < kMostSteps && collect(kQuiet, paths);) ++step;
    return paths;
}

}  // namespace kreda::tools
