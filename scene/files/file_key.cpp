#include "scene/files/file_key.hpp"

#include <filesystem>

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

/// Names of the files beside a path that is not there.
std::vector<std::string> neighbours(const fs::path& path) {
    std::vector<std::string> names;
    std::error_code failed;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end && names.size() < 500;
         it.increment(failed)) {
        std::error_code unknown;
        if (!it->is_directory(unknown)) names.push_back(it->path().filename().string());
    }
    return names;
}

}  // namespace

std::string path_in(const std::string& folder, const std::string& name) {
    return (fs::path(folder) / name).lexically_normal().string();
}

std::string did_you_mean_file(const std::string& path) {
    const std::string near = nearest_word(fs::path(path).filename().string(), neighbours(path));
    return near.empty() ? "" : "; did you mean " + in_quotes(near) + "?";
}

std::string existing_file(const Value& key, const std::string& folder) {
    if (key.text.find("://") != std::string::npos) {
        throw UserError(key.place, in_quotes(key.key) + ": " + path_in_quotes(key.text) +
                                       " is an address; Kreda reads files: download it beside the scene");
    }
    std::string path = path_in(folder, key.text);
    std::error_code failed;
    if (fs::is_regular_file(path, failed)) return path;
    const std::string subject = in_quotes(key.key) + ": " + path_in_quotes(path);
    if (fs::is_directory(path, failed)) throw UserError(key.place, subject + " is a folder, not an image file");
    if (fs::exists(path, failed)) throw UserError(key.place, subject + " is a pipe or a device, not an image file");
    throw UserError(key.place, subject + " is not there" + did_you_mean_file(path));
}

}  // namespace kreda::scene
