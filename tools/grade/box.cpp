#include "tools/grade/box.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "raster/platform.hpp"
#include "scene/error.hpp"
#include "tools/grade/box_bubblewrap.hpp"
#include "tools/grade/box_files.hpp"
#include "tools/grade/box_filter.hpp"
#include "tools/grade/box_keeper.hpp"
#include "tools/grade/box_landlock.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using End = BoxOutcome::End;

/// An open file that is closed with the object. Never 0, 1 or 2: those are replaced in the child.
class File {
public:
    explicit File(int number = -1) : number_(number) {
        if (number_ < 0 || number_ > 2) return;
        number_ = fcntl(number, F_DUPFD_CLOEXEC, 3);
        ::close(number);
    }
    ~File() {
        close();
    }
    File(File&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    File& operator=(File&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }
    [[nodiscard]] int number() const {
        return number_;
    }

private:
    int number_;
};

struct Pipe {
    File read_end, write_end;
};

Pipe make_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe2");
    Pipe made;
    made.read_end = File(ends[0]);
    made.write_end = File(ends[1]);
    return made;
}

/// The program for bubblewrap's --seccomp, as an open file.
File file_of(const std::vector<sock_filter>& filter) {
    if (filter.empty()) return File();
    File file(memfd_create("kreda filter", MFD_CLOEXEC));
    const std::size_t size = filter.size() * sizeof(sock_filter);
    if (write(file.number(), filter.data(), size) != static_cast<ssize_t>(size) ||
        lseek(file.number(), 0, SEEK_SET) != 0) {
        throw std::system_error(errno, std::generic_category(), "memfd_create");
    }
    return file;
}

/// Root's boxes each run as a user of their own, so that they cannot meet; other people's run as themselves (0).
/// Where a container knows few users, several share one.
uid_t boxed_user() {
    if (geteuid() != 0) return 0;
    constexpr std::uint64_t kFirst = 0x70000000, kBoxesAtOnce = 8, kNobody = 65534;
    static std::atomic<std::uint64_t> boxes{0};
    const std::uint64_t wish = kFirst + std::uint64_t(getpid()) * kBoxesAtOnce + boxes++ % kBoxesAtOnce;
    std::uint64_t best = 1;
    std::ifstream map("/proc/self/uid_map");
    for (std::uint64_t inside, outside, count; map >> inside >> outside >> count;) {
        for (const std::uint64_t user : {kNobody, wish}) {
            if (user >= inside && user - inside < count) best = std::max(best, user);
        }
    }
    return static_cast<uid_t>(best);
}

/// The kernel counts all processes of a user. Root's boxes have users of their own; other people go on working.
std::uint64_t most_processes(const BoxRequest& request, uid_t user) {
    constexpr int kOfBubblewrap = 2, kThreads = 64;
    const std::uint64_t most = std::uint64_t(request.limits.processes) + kOfBubblewrap + kThreads;
    return user != 0 ? most : most + count_threads_of(geteuid());
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    return list;
}

/// Everything that run() needs, with the memory that BoxStart points to.
struct Prepared {
    BoxStart start;
    std::vector<std::string> command, environment, must_open;
    std::string folder;
    File filter, rules, nowhere;
};

void prepare(const BoxRequest& request, BoxTier tier, Prepared& made) {
    const bool is_program = request.limits.processes <= 1;
    const bool is_alone = tier == BoxTier::bubblewrap || landlock_version() >= 6 || geteuid() == 0;
    const std::vector<sock_filter> filter = make_filter({!is_program, is_alone});
    made.folder = request.work.string();
    made.environment = {"PATH=/usr/bin:/bin", "HOME=" + made.folder, "TMPDIR=" + made.folder, "LANG=C.UTF-8"};
    made.command = request.command;
    made.nowhere = File(open("/dev/null", O_RDWR | O_CLOEXEC));
    for (const fs::path& path : request.readable) made.must_open.push_back(path.string());
    if (tier == BoxTier::bubblewrap) {
        made.filter = file_of(filter);
        made.command = bubblewrap_command(find_bubblewrap(), request, made.filter.number());
        made.start.passed_file = made.filter.number();
    } else if (tier == BoxTier::landlock) {
        std::vector<fs::path> readable = system_folders();
        readable.insert(readable.end(), request.readable.begin(), request.readable.end());
        made.rules = File(make_landlock_rules(readable, request.work));
        made.start.landlock_rules = made.rules.number();
        made.start.filter = filter;
    }
    made.start.command = pointers(made.command);
    made.start.environment = pointers(made.environment);
    for (const std::string& path : made.must_open) made.start.must_open.push_back(path.c_str());
    made.start.folder = made.folder.c_str();
    made.start.limits = request.limits;
    made.start.user = boxed_user();
    made.start.most_processes = most_processes(request, made.start.user);
    made.start.nowhere = made.nowhere.number();
    if (made.start.user != 0) static_cast<void>(!lchown(made.folder.c_str(), made.start.user, made.start.user));
}

/// Take what is there to read; false at the end of the file.
bool take(int file, std::string& text, std::uint64_t most) {
    char part[1 << 14];
    const ssize_t size = read(file, part, sizeof part);
    if (size < 0) return errno == EINTR || errno == EAGAIN;
    if (text.size() < most)
        text.append(part, std::min(static_cast<std::size_t>(size), std::size_t(most - text.size())));
    return size > 0;
}

/// Read until all is said, and stop what goes beyond its limits; `orders` is closed to stop it.
void watch(const BoxLimits& limits, const std::string& work, Clock::time_point begin, pollfd (&files)[4],
           std::string* (&texts)[4], File& orders, End& broken) {
    constexpr int kLook = 25;  // milliseconds between two looks into the work folder
    const auto stop = [&](End why) {
        if (orders.number() >= 0) broken = why;
        orders.close();
    };
    auto looked = begin;
    int open_files = 4;
    while (open_files > 0) {
        static_cast<void>(poll(files, 4, kLook));
        for (std::size_t i = 0; i < 4; ++i) {
            if (files[i].fd < 0 || files[i].revents == 0) continue;
            if (take(files[i].fd, *texts[i], limits.output_bytes + 1)) continue;
            files[i].fd = -1;
            --open_files;
        }
        const auto now = Clock::now();
        if (std::chrono::duration<double>(now - begin).count() > limits.wall_seconds) stop(End::timed_out);
        if (texts[0]->size() + texts[1]->size() > limits.output_bytes) stop(End::too_much_output);
        if (now - looked < std::chrono::milliseconds(kLook)) continue;
        looked = now;
        if (holds_too_much(work, limits.output_bytes)) stop(End::too_much_output);
    }
}

/// How the command ended; bubblewrap tells of a signal with exit code 128 + signal.
void judge(const BoxLimits& limits, int status, End broken, BoxOutcome& outcome) {
    const bool is_signal = WIFSIGNALED(status);
    outcome.end = is_signal ? End::signalled : End::exited;
    outcome.code = is_signal ? WTERMSIG(status) : WEXITSTATUS(status);
    if (outcome.tier == BoxTier::bubblewrap && !is_signal && outcome.code > 128 && outcome.code < 128 + NSIG) {
        outcome.end = End::signalled;
        outcome.code -= 128;
    }
    const bool is_killed = outcome.end == End::signalled && (outcome.code == SIGXCPU || outcome.code == SIGKILL);
    if (is_killed && (outcome.code == SIGXCPU || outcome.cpu_seconds >= limits.cpu_seconds))
        outcome.end = End::timed_out;
    if (outcome.end == End::signalled && outcome.code == SIGXFSZ) outcome.end = End::too_much_output;
    if (broken != End::exited) outcome.end = broken;
    if (outcome.tier == BoxTier::bubblewrap && outcome.code == 1 && outcome.err.starts_with("bwrap: "))
        outcome.end = End::could_not_start;
}

BoxOutcome run(const BoxRequest& request, BoxTier tier) {
    BoxOutcome outcome;
    outcome.tier = tier;
    Prepared prepared;
    prepare(request, tier, prepared);
    Pipe out = make_pipe(), err = make_pipe(), failure = make_pipe(), report = make_pipe(), orders = make_pipe();
    prepared.start.out = out.write_end.number();
    prepared.start.err = err.write_end.number();
    prepared.start.failure = failure.write_end.number();
    prepared.start.report = report.write_end.number();
    prepared.start.orders = orders.read_end.number();
    const auto begin = Clock::now();
    const pid_t keeper = start_keeper(prepared.start);
    for (Pipe* pipe : {&out, &err, &failure, &report}) pipe->write_end.close();
    orders.read_end.close();
    if (keeper < 0) {
        outcome.err = "no process can be started: " + std::string(std::strerror(errno));
        return outcome;
    }
    std::string why, told;
    pollfd files[4] = {{out.read_end.number(), POLLIN, 0},
                       {err.read_end.number(), POLLIN, 0},
                       {failure.read_end.number(), POLLIN, 0},
                       {report.read_end.number(), POLLIN, 0}};
    std::string* texts[4] = {&outcome.out, &outcome.err, &why, &told};
    End broken = End::exited;
    watch(request.limits, prepared.folder, begin, files, texts, orders.write_end, broken);
    waitpid(keeper, nullptr, 0);
    outcome.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    BoxReport end;
    if (!why.empty() || told.size() != sizeof end) {
        outcome.err = why.empty() ? "the box ended without a word" : why;
        return outcome;
    }
    std::memcpy(&end, told.data(), sizeof end);
    outcome.cpu_seconds = end.cpu_seconds;
    if (broken == End::exited && holds_too_much(prepared.folder, request.limits.output_bytes))
        broken = End::too_much_output;
    judge(request.limits, end.status, broken, outcome);
    return outcome;
}

/// Does this tier run a command, and is a file that it must not see hidden?
bool works(BoxTier tier) {
    if (tier == BoxTier::bubblewrap && find_bubblewrap().empty()) return false;
    if (tier == BoxTier::landlock && landlock_version() == 0) return false;
    if (make_filter({}).empty()) return false;
    const BoxFolder hidden, work;
    std::ofstream(hidden.path() / "secret") << "x";
    BoxRequest request{{"/bin/cat", (hidden.path() / "secret").string()}, {}, work.path(), {}, {}};
    const BoxOutcome outcome = run(request, tier);
    return outcome.end == End::exited && outcome.code == 1 && outcome.out.empty();
}

}  // namespace

std::optional<BoxTier> strongest_tier() {
    static const std::optional<BoxTier> strongest = []() -> std::optional<BoxTier> {
        for (const BoxTier tier : {BoxTier::bubblewrap, BoxTier::landlock}) {
            if (works(tier)) return tier;
        }
        return std::nullopt;
    }();
    return strongest;
}

BoxOutcome run_in_box(const BoxRequest& request, bool allow_unsafe) {
    KREDA_EXPECT(!request.command.empty() && request.work.is_absolute());
    std::optional<BoxTier> tier = request.tier ? request.tier : strongest_tier();
    if (!tier && allow_unsafe) tier = BoxTier::unsafe;
    if (!tier || (*tier == BoxTier::unsafe && !allow_unsafe)) {
        throw scene::UserError(
            "a student's program is not run without a box: install bubblewrap, or use Linux 5.13 or newer with "
            "Landlock "
            "(--unsafe runs it with limits alone: only in a machine that may be lost)");
    }
    return run(request, *tier);
}

std::string name_of(BoxTier tier) {
    switch (tier) {
        case BoxTier::bubblewrap: return "bubblewrap";
        case BoxTier::landlock: return "landlock";
        case BoxTier::unsafe: break;
    }
    return "unsafe";
}

std::string describe(const BoxOutcome& outcome, const BoxLimits& limits) {
    std::ostringstream text;
    switch (outcome.end) {
        case End::exited: text << "ended with exit code " << outcome.code; break;
        case End::signalled:
            text << "was ended by signal " << outcome.code << " (" << strsignal(outcome.code) << ")";
            break;
        case End::timed_out:
            text << "took longer than " << limits.cpu_seconds << " s of the processor or " << limits.wall_seconds
                 << " s in all";
            break;
        case End::too_much_output: text << "wrote more than " << (limits.output_bytes >> 20) << " MB"; break;
        case End::could_not_start: text << "could not start: " << outcome.err; break;
    }
    return text.str();
}

}  // namespace kreda::tools
