// Waiting for changes in folders: told by the system where it can (inotify), else at the end of each wait.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace kreda::tools {

class FolderWatch {
public:
    FolderWatch();
    ~FolderWatch();
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    /// From now on these folders and no others; those that are not there are left out.
    void watch(const std::set<std::string>& folders);

    /// Paths, each "FOLDER/NAME", that were written, renamed, made or removed; none after so many milliseconds without.
    /// Changes that follow each other at once come together: an editor saves in several steps.
    [[nodiscard]] std::set<std::string> wait(int milliseconds);

private:
    /// Add what the system tells within so many milliseconds; false: nothing.
    bool collect(int milliseconds, std::set<std::string>& paths);

    int queue_ = -1;                     ///< inotify's; -1: there is none
    std::map<int, std::string> folder_;  ///< by the number of its watch
};

}  // namespace kreda::tools
