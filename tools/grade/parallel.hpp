// Commands, several at a time, each a process of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace kreda::tools {

struct ParallelJob {
    std::vector<std::string> command;
    std::filesystem::path log;  ///< what it prints goes here
};

/// Run them, at most `at_a_time` at once; `ended(i, why)` is called after each, `why` empty for exit code 0, else "exit
/// code 3" and the like. A job that takes longer than `most_seconds` is killed. When this process dies, so do they.
void run_parallel(const std::vector<ParallelJob>& jobs, int at_a_time, double most_seconds,
                  const std::function<void(std::size_t i, const std::string& why)>& ended);

}  // namespace kreda::tools
