#include "tools/grade/box_landlock.hpp"

#include <cstdint>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

// linux/landlock.h as of Linux 6.12: the distributions' headers are older than their kernels.
struct RulesetAttributes {
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scoped = 0;
};
struct [[gnu::packed]] PathBeneath {
    std::uint64_t allowed = 0;
    std::int32_t folder = -1;
};
constexpr std::uint64_t kExecute = 1 << 0, kWriteFile = 1 << 1, kReadFile = 1 << 2, kReadFolder = 1 << 3;
constexpr std::uint64_t kTruncate = 1 << 14;
constexpr std::uint64_t kFilesOfFirstVersion = (1 << 13) - 1, kRefer = 1 << 13, kIoctl = 1 << 15;
constexpr std::uint64_t kOnFiles = kExecute | kWriteFile | kReadFile | kTruncate | kIoctl;
constexpr std::uint64_t kBindAndConnect = 3, kSocketsAndSignals = 3;
constexpr int kRuleOfPath = 1, kAskVersion = 1;

long create_ruleset(const RulesetAttributes* attributes, std::size_t size, int flags) {
    return syscall(SYS_landlock_create_ruleset, attributes, size, flags);
}

RulesetAttributes all_that_is_known(int version) {
    RulesetAttributes all;
    all.files = kFilesOfFirstVersion;
    if (version >= 2) all.files |= kRefer;
    if (version >= 3) all.files |= kTruncate;
    if (version >= 5) all.files |= kIoctl;
    if (version >= 4) all.network = kBindAndConnect;
    if (version >= 6) all.scoped = kSocketsAndSignals;
    return all;
}

bool allow(int rules, const fs::path& path, std::uint64_t allowed) {
    const int folder = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (folder < 0) return true;  // what does not exist cannot be opened either
    struct stat what {};
    if (fstat(folder, &what) == 0 && !S_ISDIR(what.st_mode)) allowed &= kOnFiles;
    const PathBeneath rule{allowed, folder};
    const bool done = syscall(SYS_landlock_add_rule, rules, kRuleOfPath, &rule, 0) == 0;
    close(folder);
    return done;
}

}  // namespace

int landlock_version() {
    const long version = create_ruleset(nullptr, 0, kAskVersion);
    return version > 0 ? static_cast<int>(version) : 0;
}

int make_landlock_rules(const std::vector<fs::path>& readable, const fs::path& writable) {
    const int version = landlock_version();
    if (version == 0) return -1;
    const RulesetAttributes all = all_that_is_known(version);
    const int rules = static_cast<int>(create_ruleset(&all, sizeof all, 0));
    if (rules < 0) return -1;
    // Neither devices nor sockets may be made; links and renames stay within the folder (kRefer).
    constexpr std::uint64_t kMakeDevicesAndSockets = 1 << 6 | 1 << 9 | 1 << 11;
    bool done = allow(rules, writable, all.files & ~kMakeDevicesAndSockets & ~kIoctl);
    for (const fs::path& path : readable)
        done = done && allow(rules, path, all.files & (kExecute | kReadFile | kReadFolder));
    for (const char* device : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
        done = done && allow(rules, device, all.files & (kReadFile | kWriteFile | kTruncate));
    if (done) return rules;
    close(rules);
    return -1;
}

bool obey_landlock_rules(int rules) {
    return syscall(SYS_landlock_restrict_self, rules, 0) == 0;
}

}  // namespace kreda::tools
