// The process between the grader and what is boxed: it starts the command, and when the command ends, the grader says
// so or the grader itself is gone, it kills everything that the command started, in whatever session it hides.
#pragma once

#include <cstdint>
#include <vector>

#include <linux/filter.h>
#include <sys/types.h>

#include "tools/grade/box.hpp"

namespace kreda::tools {

/// All that is needed after fork(), made before it: then nothing may allocate. Files are open ones, close-on-exec.
struct BoxStart {
    std::vector<char*> command, environment;  ///< each with a nullptr at its end
    std::vector<const char*> must_open;       ///< checked for being readable as the boxed user
    const char* folder = nullptr;             ///< the current folder inside
    BoxLimits limits;
    std::uint64_t most_processes = 0;  ///< RLIMIT_NPROC
    uid_t user = 0;                    ///< 0: stay who you are
    int landlock_rules = -1;
    std::vector<sock_filter> filter;  ///< obeyed by the command; empty: none
    int passed_file = -1;             ///< stays open in the command
    int nowhere = -1;                 ///< /dev/null
    int out = -1, err = -1;           ///< where the command prints
    int failure = -1;                 ///< a sentence is written here when the command cannot be started
    int orders = -1;                  ///< its end of file: kill everything
    int report = -1;                  ///< a BoxReport is written here at the end
};

struct BoxReport {
    int status = 0;  ///< as waitpid tells it
    double cpu_seconds = 0.0;
};

/// Fork the keeper; its process id, or -1. Whoever calls this waits for it.
[[nodiscard]] pid_t start_keeper(const BoxStart& start);

}  // namespace kreda::tools
