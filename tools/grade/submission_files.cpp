#include "tools/grade/submission_files.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>

#include "scene/error.hpp"
#include "scene/files/hash_of_bytes.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 16 << 20;

/// What stands for one file: its name, its length and its bytes.
std::string content_of_file(const fs::path& file, const std::string& name) {
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(file, failed);
    std::string content = name;
    content += '\0';
    if (fs::is_symlink(status)) return content + "link";
    if (!fs::is_regular_file(status)) return content + "other";
    const std::uintmax_t size = fs::file_size(file, failed);
    content += std::to_string(size);
    content += '\0';
    if (failed || size > kLargestFile) return content;
    std::ifstream stream(file, std::ios::binary);
    return content.append(std::istreambuf_iterator<char>(stream), {});
}

std::vector<fs::path> files_below(const fs::path& folder) {
    constexpr std::size_t kMostFiles = 10'000;
    std::vector<fs::path> files;
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed), end;
    for (; !failed && at != end && files.size() < kMostFiles; at.increment(failed)) {
        const bool is_folder = fs::is_directory(at->symlink_status(failed));
        if (at->path().filename().string().starts_with(".")) {  // .git, .DS_Store: not the student's work
            if (is_folder) at.disable_recursion_pending();
        } else if (!is_folder) {
            files.push_back(at->path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

std::string content_of(const fs::path& folder) {
    // Two hashes with different seeds: 128 bits, so that among thousands of submissions none are equal by chance.
    std::uint64_t first = 1, second = 2;
    const auto add = [&](const std::string& content) {
        first = scene::hash_of_bytes(std::as_bytes(std::span(content)), first);
        second = scene::hash_of_bytes(std::as_bytes(std::span(content)), second);
    };
    std::error_code failed;
    if (!fs::is_directory(folder, failed)) {
        add(content_of_file(folder, ""));
    } else {
        for (const fs::path& file : files_below(folder))
            add(content_of_file(file, file.lexically_relative(folder).generic_string()));
    }
    char text[36];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(first),
                  static_cast<unsigned long long>(second));
    return text;
}

std::vector<std::string> submissions_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (fs::is_directory(at->symlink_status(failed)) && !name.starts_with(".")) names.push_back(name);
    }
    if (failed) throw scene::UserError(scene::Place{folder.string()}, "cannot be read: " + failed.message());
    if (names.empty())
        throw scene::UserError(scene::Place{folder.string()}, "holds no folders; each submission is one");
    std::sort(names.begin(), names.end());
    return names;
}

std::string link_of(const std::string& name) {
    std::string link;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '-' || c == '.' || c == '_' || c == '~') {
            link += c;
        } else {
            char escape[4];
            std::snprintf(escape, sizeof escape, "%%%02X", byte);
            link += escape;
        }
    }
    return link;
}

void remove_stale_box_folders() {
    std::error_code failed;
    const std::string start = "kreda-box-";
    for (fs::directory_iterator at(fs::temp_directory_path(), failed), end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (!name.starts_with(start)) continue;
        const long process = std::strtol(name.c_str() + start.size(), nullptr, 10);
        const bool is_over = process > 0 && kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
        std::error_code ignored;
        if (is_over) fs::remove_all(at->path(), ignored);
    }
}

}  // namespace kreda::tools
