#include "scene/files/named_file.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "scene/files/file_key.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
    std::error_code failed;
    return fs::exists(path, failed) && !fs::is_directory(path, failed);
}

/// Whether a path ends inside a folder when all links are followed.
bool is_inside(const fs::path& path, const std::string& root) {
    std::error_code failed;
    const fs::path inside = fs::weakly_canonical(path, failed);
    const fs::path canonical_root = failed ? fs::path() : fs::weakly_canonical(root, failed);
    const fs::path relative = failed ? fs::path() : inside.lexically_relative(canonical_root);
    return !failed && !relative.empty() && *relative.begin() != "..";
}

/// What a folder holds under a name, capitals or not: the first in the order of bytes, "" where there is none.
std::string in_any_capitals(const fs::path& folder, const std::string& name) {
    std::string found;
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        const std::string other = it->path().filename().string();
        if (in_lower_case(other) == in_lower_case(name) && (found.empty() || other < found)) found = other;
    }
    return found;
}

/// A relative path, each of whose parts may differ in capitals from what is there.
fs::path with_capitals_of_disk(const fs::path& folder, const fs::path& relative) {
    fs::path path = folder;
    for (const fs::path& part : relative) {
        std::error_code failed;
        if (fs::exists(path / part, failed)) {
            path /= part;
            continue;
        }
        const std::string other = in_any_capitals(path, part.string());
        if (other.empty()) return {};
        path /= other;
    }
    return path;
}

std::string with_slashes(std::string named) {
    std::replace(named.begin(), named.end(), '\\', '/');
    return named;
}

/// What a path in a text leads to.
NamedPath find_path(const ObjText& text, std::size_t offset, const std::string& whole_name,
                    const NamedFileLimits& limits) {
    const std::string bare = without_comment(whole_name);
    if (bare != whole_name && !is_there(fs::path(folder_of(text.file)) / with_slashes(whole_name))) {
        return find_path(text, offset, bare, limits);
    }
    const std::string& named = whole_name;
    const fs::path folder = folder_of(text.file), portable = with_slashes(named);
    const fs::path path = folder / portable;
    const auto may_be_read = [&](const fs::path& file) { return limits.allow_outside || is_inside(file, limits.root); };
    if (is_there(path) && may_be_read(path)) return {path.string(), false};
    if (portable.has_filename()) {
        const fs::path other = portable.is_absolute() ? fs::path() : with_capitals_of_disk(folder, portable);
        for (const fs::path& file : {other, with_capitals_of_disk(folder, portable.filename())}) {
            if (!file.empty() && file != path && is_there(file) && may_be_read(file)) return {file.string(), true};
        }
    }
    if (!is_there(path)) return {};
    throw UserError(place_at(text, offset), path_in_quotes(named) +
                                                " is outside the folder of the mesh file; move it "
                                                "there, or allow it with --allow-outside");
}

}  // namespace

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string without_comment(const std::string& name) {
    const std::size_t comment = std::min(name.find(" #"), name.find("\t#"));
    return name.substr(0, name.substr(0, comment).find_last_not_of(" \t") + 1);
}

NamedPath resolve_named_path(const ObjText& text, std::size_t offset, const std::string& whole_name,
                             const NamedFileLimits& limits) {
    NamedPath found = find_path(text, offset, whole_name, limits);
    if (!limits.used) return found;
    const std::string path = (fs::path(folder_of(text.file)) / with_slashes(whole_name)).string();
    limits.used->push_back(use_file(path, FileUse::presence));
    if (found.path == path) return found;
    // Whatever appears near by may be what is meant.
    for (const std::string& folder : {folder_of(text.file), folder_of(path)}) limits.used->push_back(use_file(folder));
    if (!found.path.empty()) limits.used->push_back(use_file(found.path, FileUse::presence));
    return found;
}

std::string find_named_file(const ObjText& text, std::size_t offset, const std::string& named,
                            const NamedFileLimits& limits, const std::string& kind, const std::string& without,
                            ObjWarnings& warnings) {
    const NamedPath found = resolve_named_path(text, offset, named, limits);
    const std::string lost = kind + "s that are not there";
    if (found.path.empty()) {
        const bool is_shown = !warnings.has_enough_of(lost);
        const std::string near = is_shown ? did_you_mean_file(folder_of(text.file) + "/" + with_slashes(named)) : "";
        warnings.add(lost, offset, "no such " + kind + ": " + path_in_quotes(named) + without + near);
    } else if (found.is_other) {
        warnings.add(kind + "s of nearly the same path", offset,
                     path_in_quotes(named) + " is not there; " + path_in_quotes(found.path) + " is used instead");
    }
    return found.path;
}

}  // namespace kreda::scene
