// The system calls that a boxed command is refused, as a program of the kernel's packet filter (seccomp).
#pragma once

#include <vector>

#include <linux/filter.h>

namespace kreda::tools {

struct FilterWish {
    bool may_start_processes = false;  ///< also: may change the mode of files by their path, as linkers do
    bool may_raise_signals = false;    ///< abort() works; only where a signal cannot reach others
};

/// What is refused gives EPERM: namespaces and mounts, sockets, other processes' memory, signals and limits, shared
/// memory that outlives a process, the kernel's keys, modules and tracing; calls of another architecture end the
/// program. Empty where the architecture is not known (x86-64 and AArch64 are).
[[nodiscard]] std::vector<sock_filter> make_filter(const FilterWish& wish);

}  // namespace kreda::tools
