#include "scene/files/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#if defined(KREDA_COVERAGE)
extern "C" void __gcov_dump();  // of gcc's libgcov
#endif

namespace kreda::scene {

namespace {

/// The two ends of a pipe; what is still open is closed at the end.
struct Pipe {
    int ends[2] = {-1, -1};

    Pipe() = default;
    /// False: errno says why not.
    bool open_both() {
        if (pipe(ends) != 0) return false;
        for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
#if defined(F_SETPIPE_SZ)
        constexpr int kBytes = 1 << 20;  // fewer changes from one process to the other; a smaller pipe works, too
        fcntl(ends[1], F_SETPIPE_SZ, kBytes);
#endif
        return true;
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close_end(int end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
};

/// Bytes of address space that this process has now.
std::int64_t mapped_bytes() {
    std::int64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * sysconf(_SC_PAGESIZE);
}

void set_soft_limit(decltype(RLIMIT_AS) resource, rlim_t wish) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0) return;
    limit.rlim_cur = std::min(wish, limit.rlim_max);
    setrlimit(resource, &limit);
}

void raise_soft_limit(decltype(RLIMIT_AS) resource, rlim_t more) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
    set_soft_limit(resource, limit.rlim_cur + more);
}

/// The limits of the system hold for the whole process. A crash leaves no core file and no text.
void become_limited(const ChildLimits& limits) {
    constexpr unsigned kClockSeconds = 30;
    for (const int signal : {SIGSEGV, SIGABRT, SIGXCPU, SIGALRM, SIGPIPE}) std::signal(signal, SIG_DFL);
    set_soft_limit(RLIMIT_CORE, 0);
    set_soft_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
    const std::int64_t mapped = mapped_bytes();
    if (mapped > 0) set_soft_limit(RLIMIT_AS, static_cast<rlim_t>(mapped + limits.memory_bytes));
    alarm(kClockSeconds * static_cast<unsigned>(limits.seconds));
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
#if !defined(KREDA_SANITIZED)
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
#endif
}

[[noreturn]] void run_child(const ChildLimits& limits, const std::function<void(int)>& send, int pipe) {
    try {
        become_limited(limits);
        send(pipe);
    } catch (const std::exception&) { _exit(1); }
#if defined(KREDA_COVERAGE)
    __gcov_dump();  // writes down which lines were run
#endif
    _exit(0);  // without the destructors of what belongs to the parent
}

/// The signal that ended a child, or 0.
int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return 0;
    }
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

ChildEnd run_in_child(const ChildLimits& limits, const std::function<void(int)>& send,
                      const std::function<bool(int)>& receive) {
    Pipe pipe;
    pid_t child = -1;
    int failure = 0;
    // One thread at a time: a child that is forked meanwhile would inherit the end to write to, and keep it open.
#if defined(_OPENMP)
#pragma omp critical(start_child)
#endif
    {
        child = pipe.open_both() ? fork() : -1;
        failure = errno;
        if (child == 0) {
            pipe.close_end(0);
            run_child(limits, send, pipe.ends[1]);
        }
        pipe.close_end(1);
    }
    if (child < 0) throw std::system_error(failure, std::generic_category(), "no process can be started");
    ChildEnd end;
    try {
        end.is_whole = receive(pipe.ends[0]);
    } catch (...) {
        pipe.close_end(0);  // the child's next write ends it
        wait_for(child);
        throw;
    }
    pipe.close_end(0);
    end.signal = wait_for(child);
    return end;
}

void allow_more(std::int64_t bytes, int seconds) {
    raise_soft_limit(RLIMIT_AS, static_cast<rlim_t>(bytes));
    raise_soft_limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
}

bool write_all(int pipe, const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = write(pipe, at, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += written;
        count -= static_cast<std::size_t>(written);
    }
    return true;
}

bool read_all(int pipe, void* bytes, std::size_t count) {
    char* at = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = read(pipe, at, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace kreda::scene
