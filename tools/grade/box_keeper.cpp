#include "tools/grade/box_keeper.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>

#include <fcntl.h>
#include <grp.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/grade/box_landlock.hpp"

namespace kreda::tools {

namespace {

constexpr int kCannotStart = 127;

[[noreturn]] void fail(int failure, const char* what, const char* name = "") {
    const char* const reason = std::strerror(errno);
    for (const char* part : {what, name, ": ", reason}) {
        if (write(failure, part, std::strlen(part)) < 0) break;
    }
    _exit(kCannotStart);
}

bool limit(int resource, std::uint64_t soft, std::uint64_t hard) {
    const rlimit both{soft, hard};
    return setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

void obey_limits(const BoxStart& start) {
    constexpr std::uint64_t kMostFiles = 256;
    const BoxLimits& limits = start.limits;
    const auto seconds = static_cast<std::uint64_t>(std::ceil(limits.cpu_seconds));
    const bool done =
        limit(RLIMIT_CPU, seconds, seconds + 1) && limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes) &&
        limit(RLIMIT_FSIZE, limits.output_bytes, limits.output_bytes) &&
        limit(RLIMIT_NPROC, start.most_processes, start.most_processes) &&
        limit(RLIMIT_NOFILE, kMostFiles, kMostFiles) && limit(RLIMIT_CORE, 0, 0) && limit(RLIMIT_MSGQUEUE, 0, 0);
    if (!done) fail(start.failure, "a limit cannot be set");
}

void become_user(const BoxStart& start) {
    if (start.user == 0) return;
    const gid_t group = start.user;
    if (setgroups(0, nullptr) != 0 || setresgid(group, group, group) != 0 ||
        setresuid(start.user, start.user, start.user) != 0) {
        fail(start.failure, "cannot become an unprivileged user");
    }
}

void check_files(const BoxStart& start) {
    for (const char* path : start.must_open) {
        if (access(path, R_OK) != 0) fail(start.failure, "the boxed user cannot read ", path);
    }
    if (access(start.folder, R_OK | W_OK | X_OK) != 0)
        fail(start.failure, "the boxed user cannot work in ", start.folder);
    if (chdir(start.folder) != 0) fail(start.failure, "cannot enter ", start.folder);
}

/// Never returns: becomes the command.
[[noreturn]] void become_command(const BoxStart& start, pid_t keeper) {
    setsid();
    signal(SIGPIPE, SIG_DFL);
    if (dup2(start.nowhere, 0) < 0 || dup2(start.out, 1) < 0 || dup2(start.err, 2) < 0)
        fail(start.failure, "files cannot be opened");
    umask(022);
    obey_limits(start);
    become_user(start);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != keeper) _exit(kCannotStart);
    check_files(start);
    if (start.passed_file >= 0) fcntl(start.passed_file, F_SETFD, 0);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail(start.failure, "no_new_privs cannot be set");
    if (start.landlock_rules >= 0 && !obey_landlock_rules(start.landlock_rules))
        fail(start.failure, "Landlock cannot be obeyed");
    if (!start.filter.empty()) {
        const sock_fprog program{static_cast<unsigned short>(start.filter.size()),
                                 const_cast<sock_filter*>(start.filter.data())};
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) fail(start.failure, "seccomp cannot be obeyed");
    }
    execve(start.command[0], start.command.data(), start.environment.data());
    fail(start.failure, "cannot start ", start.command[0]);
}

/// Everything that is open in the grader but those.
void close_others(int* kept, int count) {
    std::sort(kept, kept + count);
    unsigned first = 3;
    for (int i = 0; i < count; ++i) {
        const auto file = static_cast<unsigned>(kept[i]);
        if (kept[i] < 3) continue;
        if (file > first) syscall(SYS_close_range, first, file - 1, 0);
        first = file + 1;
    }
    syscall(SYS_close_range, first, ~0u, 0);
}

/// Kill the children of this process; what they leave behind becomes its children in turn.
void kill_children(pid_t first) {
    char text[4096];
    const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    const ssize_t size = file >= 0 ? read(file, text, sizeof text - 1) : -1;
    if (file >= 0) close(file);
    if (size <= 0) {  // such a kernel is rare: the first child's session is all that is known
        kill(first, SIGKILL);
        kill(-first, SIGKILL);
        return;
    }
    text[size] = '\0';
    for (char* at = text; *at != '\0';) {
        char* end = nullptr;
        const long child = std::strtol(at, &end, 10);
        if (end == at) break;
        if (child > 1) kill(static_cast<pid_t>(child), SIGKILL);
        at = end;
    }
}

/// Wait until the child has ended or the grader wants an end.
void wait_for_end(const BoxStart& start, pid_t child) {
    const int ended = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
    constexpr int kPollMilliseconds = 10;  // only where the kernel has no pidfd
    pollfd files[] = {{start.orders, POLLIN, 0}, {ended, POLLIN, 0}};
    while (poll(files, 2, ended >= 0 ? -1 : kPollMilliseconds) >= 0 || errno == EINTR) {
        if (files[0].revents != 0 || files[1].revents != 0) return;
        siginfo_t info{};
        if (ended < 0 && waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            info.si_pid == child) {
            return;
        }
    }
}

/// Kill and wait until there is no child left; how the first one ended. The kernel's list may miss a child that is just
/// handed over: the next round finds it.
int reap_all(pid_t first) {
    int status_of_first = 0;
    for (;;) {
        kill_children(first);
        int status = 0;
        pid_t ended = 0;
        while ((ended = waitpid(-1, &status, WNOHANG)) > 0) {
            if (ended == first) status_of_first = status;
        }
        if (ended < 0 && errno == ECHILD) return status_of_first;
        constexpr timespec kAMillisecond{0, 1'000'000};
        nanosleep(&kAMillisecond, nullptr);
    }
}

[[noreturn]] void keep(const BoxStart& start) {
    setsid();  // no Ctrl-C of the terminal ends it before its work is done
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) signal(number, SIG_IGN);
    signal(SIGCHLD, SIG_DFL);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    int kept[] = {start.landlock_rules, start.passed_file, start.nowhere, start.out, start.err,
                  start.failure,        start.orders,      start.report};
    close_others(kept, static_cast<int>(std::size(kept)));
    const pid_t keeper = getpid();
    const pid_t child = fork();
    if (child == 0) {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) signal(number, SIG_DFL);
        become_command(start, keeper);
    }
    if (child < 0) fail(start.failure, "cannot fork");
    for (const int file : {start.out, start.err, start.failure}) close(file);
    wait_for_end(start, child);
    BoxReport report;
    report.status = reap_all(child);
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
    report.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    static_cast<void>(!write(start.report, &report, sizeof report));
    _exit(0);
}

}  // namespace

pid_t start_keeper(const BoxStart& start) {
    const pid_t keeper = fork();
    if (keeper == 0) keep(start);
    return keeper;
}

}  // namespace kreda::tools
