#include "tools/grade/parallel.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace kreda::tools {

namespace {

using Clock = std::chrono::steady_clock;

struct Running {
    std::size_t job = 0;
    Clock::time_point begin;
    bool is_late = false;
};

pid_t start(const ParallelJob& job) {
    std::vector<std::string> words = job.command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child != 0) return child;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int log = open(job.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (getppid() == parent && log >= 0 && nothing >= 0 && dup2(nothing, 0) == 0 && dup2(log, 1) == 1 &&
        dup2(log, 2) == 2) {
        execv(arguments[0], arguments.data());
    }
    _exit(127);
}

std::string why_ended(int status, bool is_late, double most_seconds) {
    if (is_late) return "took longer than " + std::to_string(static_cast<int>(most_seconds)) + " s";
    if (WIFSIGNALED(status)) return std::string("was ended by signal ") + strsignal(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? "" : "exit code " + std::to_string(WEXITSTATUS(status));
}

/// Kill what takes too long.
void kill_late(std::map<pid_t, Running>& running, double most_seconds) {
    for (auto& [process, job] : running) {
        if (std::chrono::duration<double>(Clock::now() - job.begin).count() < most_seconds) continue;
        job.is_late = true;
        kill(process, SIGKILL);
    }
}

}  // namespace

void run_parallel(const std::vector<ParallelJob>& jobs, int at_a_time, double most_seconds,
                  const std::function<void(std::size_t, const std::string&)>& ended) {
    std::map<pid_t, Running> running;
    std::size_t next = 0;
    while (next < jobs.size() || !running.empty()) {
        while (next < jobs.size() && running.size() < static_cast<std::size_t>(std::max(at_a_time, 1))) {
            const pid_t process = start(jobs[next]);
            if (process < 0) {
                ended(next, std::string("no process can be started: ") + std::strerror(errno));
            } else {
                running[process] = {next, Clock::now(), false};
            }
            ++next;
        }
        int status = 0;
        pid_t process = 0;
        while (!running.empty() && (process = waitpid(-1, &status, WNOHANG)) > 0) {
            const auto it = running.find(process);
            if (it == running.end()) continue;
            const Running job = it->second;
            running.erase(it);
            ended(job.job, why_ended(status, job.is_late, most_seconds));
        }
        kill_late(running, most_seconds);
        constexpr timespec kTenMilliseconds{0, 10'000'000};
        if (!running.empty()) nanosleep(&kTenMilliseconds, nullptr);
    }
}

}  // namespace kreda::tools
