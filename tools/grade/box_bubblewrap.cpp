#include "tools/grade/box_bubblewrap.hpp"

#include <initializer_list>
#include <system_error>

#include <unistd.h>

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void add(Words& words, std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
}

/// /lib and the like: links to folders of /usr today, folders of their own on older systems.
void add_root_folder(Words& words, const std::string& folder) {
    std::error_code absent;
    const fs::path target = fs::read_symlink(folder, absent);
    if (!absent) {
        add(words, {"--symlink", target.string(), folder});
    } else if (fs::is_directory(folder, absent)) {
        add(words, {"--ro-bind", folder, folder});
    }
}

}  // namespace

fs::path find_bubblewrap() {
    for (const char* place : {"/usr/bin/bwrap", "/usr/local/bin/bwrap", "/bin/bwrap"}) {
        if (access(place, X_OK) == 0) return place;
    }
    return {};
}

std::vector<fs::path> system_folders() {
    return {"/usr/bin",         "/usr/sbin",   "/usr/lib",     "/usr/lib32",
            "/usr/lib64",       "/usr/libx32", "/usr/libexec", "/usr/include",
            "/usr/share",       "/bin",        "/sbin",        "/lib",
            "/lib32",           "/lib64",      "/libx32",      "/etc/ld.so.cache",
            "/etc/alternatives"};
}

Words bubblewrap_command(const fs::path& bubblewrap, const BoxRequest& request, int filter) {
    Words words{bubblewrap.string(), "--unshare-all", "--die-with-parent", "--new-session",
                "--cap-drop",        "ALL",           "--hostname",        "box"};
    for (const fs::path& folder : system_folders()) {
        const std::string name = folder.string();
        if (folder.parent_path() == "/") {
            add_root_folder(words, name);
        } else {
            add(words, {"--ro-bind-try", name, name});
        }
    }
    add(words, {"--dev", "/dev", "--remount-ro", "/dev"});
    for (const fs::path& path : request.readable) add(words, {"--ro-bind", path.string(), path.string()});
    const std::string work = request.work.string();
    add(words, {"--bind", work, work, "--remount-ro", "/", "--chdir", work});
    if (filter >= 0) add(words, {"--seccomp", std::to_string(filter)});
    words.push_back("--");
    words.insert(words.end(), request.command.begin(), request.command.end());
    return words;
}

}  // namespace kreda::tools
