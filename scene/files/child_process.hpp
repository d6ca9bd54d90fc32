// Work that a damaged file may crash or blow up, done in a child process with limits: what happens there stays there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace kreda::scene {

/// What a child process may use.
struct ChildLimits {
    std::int64_t memory_bytes = 0;  ///< beyond what this process has mapped when the child begins
    int seconds = 0;                ///< of processor time; thirty times as long by the clock
};

/// How a child process ended.
struct ChildEnd {
    bool is_whole = false;  ///< `receive` had all that it waits for
    int signal = 0;         ///< what ended it, SIGSEGV or SIGXCPU say; 0: it ended by itself
};

/// Run `send` in a child process, which writes into the pipe that it is given, and `receive` here, which reads from it
/// and gives back whether that was whole. The child has copies of everything; what it changes is lost, and what it
/// prints as well. Threads may call it side by side. Only the calling thread goes on in the child: `send` must not use
/// threads that were started before. Throws std::system_error when no process can be started.
[[nodiscard]] ChildEnd run_in_child(const ChildLimits& limits, const std::function<void(int)>& send,
                                    const std::function<bool(int)>& receive);

/// Raise the limits of the child process that calls it, once it knows the size of its work.
void allow_more(std::int64_t bytes, int seconds);

/// Write or read exactly that many bytes; false when the other end is gone.
[[nodiscard]] bool write_all(int pipe, const void* bytes, std::size_t count);
[[nodiscard]] bool read_all(int pipe, void* bytes, std::size_t count);

}  // namespace kreda::scene
