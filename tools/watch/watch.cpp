#include "tools/watch/watch.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>

#include <unistd.h>

#include "scene/error.hpp"
#include "scene/files/named_file.hpp"
#include "tools/watch/folder_watch.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::UsedFile;

constexpr int kPollMs = 500;  // for folders of which the system tells nothing, on a network say

/// A thread of its own waits for Ctrl-C: threads that are started after this, and child processes, do not see it.
void end_on_signal(std::mutex& writing) {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM}) sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([signals, &writing] {
        int signal = 0;
        sigwait(&signals, &signal);
        const std::lock_guard<std::mutex> whole(writing);
        _exit(0);
    }).detach();
}

/// What the last picture was made of.
struct Sources {
    std::vector<UsedFile> files;
    std::set<std::string> paths;    ///< as the folders' watch names them
    std::set<std::string> folders;  ///< in which something may change
    bool looks_around = false;      ///< any file that appears may be what was missing
};

void add_path(const std::string& path, Sources& sources) {
    const std::string folder = scene::folder_of(path);
    sources.folders.insert(folder);
    sources.paths.insert(folder + "/" + fs::path(path).filename().string());
}

Sources sources_of(const std::vector<UsedFile>& used, const std::string& output, bool failed) {
    Sources sources;
    sources.looks_around = failed;
    const std::string own = scene::canonical_path(output);
    for (const UsedFile& file : used) {
        const std::string canonical = scene::canonical_path(file.path);
        if (canonical == own) continue;
        std::error_code unknown;
        if (fs::is_directory(file.path, unknown)) {
            sources.looks_around = true;
            sources.folders.insert(file.path);
            continue;
        }
        add_path(file.path, sources);
        add_path(canonical, sources);  // behind a link
        sources.files.push_back(file);
    }
    return sources;
}

bool is_own(const std::string& path, const std::string& output) {
    const std::string name = fs::path(path).filename().string(), own = fs::path(output).filename().string();
    return name == own || (name.starts_with("." + own) && name.ends_with(".tmp")) || name == ".kreda-cache";
}

bool has_changed(const Sources& sources) {
    return std::any_of(sources.files.begin(), sources.files.end(), [](const UsedFile& file) {
        const scene::FileState now = scene::state_of_file(file.path);
        return file.use == scene::FileUse::presence ? now.is_there != file.state.is_there : now != file.state;
    });
}

/// Is one of these changes to the picture's sources?
bool matters(const std::set<std::string>& changed, const Sources& sources, const std::string& output) {
    return std::any_of(changed.begin(), changed.end(), [&](const std::string& path) {
        return !is_own(path, output) && (sources.looks_around || sources.paths.contains(path));
    });
}

void wait_for_change(FolderWatch& folders, const Sources& sources, const std::string& output) {
    while (!has_changed(sources) && !matters(folders.wait(kPollMs), sources, output)) {}
}

/// False: the picture could not be drawn, and why is said.
bool try_to_draw(const std::function<void()>& draw) {
    try {
        draw();
        return true;
    } catch (const scene::UserError& error) { std::cerr << error.what() << "\n"; }
    return false;
}

}  // namespace

void watch(const std::string& output, scene::LoadedFiles& files, std::mutex& writing,
           const std::function<void()>& draw) {
    end_on_signal(writing);
    FolderWatch folders;
    Sources sources;
    for (;;) {
        // Changes from here on are seen, whether or not this picture is made of them already.
        files.used.clear();
        const bool is_drawn = try_to_draw(draw);
        sources = sources_of(files.used, output, !is_drawn);
        folders.watch(sources.folders);
        if (is_drawn) forget_unused(files);
        wait_for_change(folders, sources, output);
    }
}

}  // namespace kreda::tools
