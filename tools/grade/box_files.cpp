#include "tools/grade/box_files.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene/error.hpp"
#include "tools/grade/box.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::string problem_of_open(int error) {
    if (error == ENOENT) return "is absent";
    if (error == ELOOP) return "is a link";
    return std::string("cannot be opened: ") + std::strerror(error);
}

std::uint64_t number_behind(const std::string& text, const std::string& key) {
    const std::size_t at = text.find(key);
    return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

}  // namespace

bool holds_too_much(const fs::path& folder, std::uint64_t most_bytes) {
    constexpr std::uint64_t kMostFiles = 4096;
    constexpr int kDeepest = 64;
    std::error_code failed;
    std::uint64_t bytes = 0, files = 0;
    fs::recursive_directory_iterator at(folder, failed), end;
    while (!failed && at != end) {
        struct stat what {};
        if (lstat(at->path().c_str(), &what) == 0) bytes += static_cast<std::uint64_t>(what.st_size);
        if (bytes > most_bytes || ++files > kMostFiles || at.depth() > kDeepest) return true;
        at.increment(failed);
        if (failed == std::errc::no_such_file_or_directory) return false;  // it was deleted meanwhile: look again later
    }
    return static_cast<bool>(failed);
}

BoxedFile read_boxed_file(const fs::path& file, std::uint64_t most_bytes) {
    BoxedFile read_file;
    const int opened = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (opened < 0) {
        read_file.problem = problem_of_open(errno);
        return read_file;
    }
    struct stat what {};
    if (fstat(opened, &what) != 0 || !S_ISREG(what.st_mode)) read_file.problem = "is no plain file";
    if (read_file.problem.empty() && what.st_nlink != 1) read_file.problem = "has a second name";
    if (read_file.problem.empty() && static_cast<std::uint64_t>(what.st_size) > most_bytes)
        read_file.problem = "is larger than " + std::to_string(most_bytes) + " bytes";
    if (read_file.problem.empty()) {
        read_file.bytes.resize(static_cast<std::size_t>(what.st_size));
        std::size_t filled = 0;
        while (filled < read_file.bytes.size()) {
            const ssize_t size = read(opened, read_file.bytes.data() + filled, read_file.bytes.size() - filled);
            if (size <= 0) break;
            filled += static_cast<std::size_t>(size);
        }
        read_file.bytes.resize(filled);
    }
    close(opened);
    return read_file;
}

std::uint64_t count_threads_of(uid_t user) {
    std::uint64_t threads = 0;
    std::error_code failed;
    for (fs::directory_iterator at("/proc", failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream file(at->path() / "status");
        const std::string status{std::istreambuf_iterator<char>(file), {}};
        if (!status.empty() && number_behind(status, "\nUid:") == user) threads += number_behind(status, "\nThreads:");
    }
    return threads;
}

BoxFolder::BoxFolder() {
    std::string name = (fs::temp_directory_path() / ("kreda-box-" + std::to_string(getpid()) + "-XXXXXX")).string();
    if (!mkdtemp(name.data()))
        throw scene::UserError(scene::Place{name}, std::string("cannot be made: ") + std::strerror(errno));
    path_ = name;
    if (geteuid() == 0) chmod(name.c_str(), 0755);  // its boxes run as other users
}

BoxFolder::~BoxFolder() {
    std::error_code failed;
    fs::remove_all(path_, failed);
    if (!failed) return;
    // A student's program may nest folders deeper than paths are long, or close them: these programs manage.
    const std::string name = path_.string();
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", "chmod -R u+rwx -- \"$0\"; rm -rf -- \"$0\"", name.c_str(), nullptr);
        _exit(127);
    }
    if (child > 0) waitpid(child, nullptr, 0);
}

}  // namespace kreda::tools
