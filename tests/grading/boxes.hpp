// What tests of boxes ask: can this machine make one, and is something left of it?
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "tests/scene/temp_folder.hpp"
#include "tools/grade/box.hpp"

namespace kreda::tests {

/// Whether such a box can be made here; says SKIPPED where not.
[[nodiscard]] inline bool can_box(tools::BoxTier tier) {
    const tools::BoxFolder work;
    const tools::BoxRequest request{{"/bin/true"}, {}, work.path(), {}, tier};
    const bool can = run_in_box(request, true).end == tools::BoxOutcome::End::exited;
    if (!can) MESSAGE("SKIPPED: " << name_of(tier) << " does not work here");
    return can;
}

/// Whether another process lives that was started with this path.
[[nodiscard]] inline bool lives(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code failed;
    for (fs::directory_iterator at("/proc", failed), end; !failed && at != end; at.increment(failed)) {
        const std::string command = bytes_of((at->path() / "cmdline").string());
        const std::string name = at->path().filename().string();
        if (name != std::to_string(getpid()) && command.find(path) != std::string::npos) return true;
    }
    return false;
}

}  // namespace kreda::tests
