#include "scene/files/map_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>

#include "scene/files/map_names.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

/// Does a name match a pattern in which * stands for any characters?
bool matches(std::string_view name, std::string_view pattern) {
    if (pattern.empty()) return name.empty();
    if (pattern.front() != '*') {
        return !name.empty() && name.front() == pattern.front() && matches(name.substr(1), pattern.substr(1));
    }
    for (std::size_t skipped = 0; skipped <= name.size(); ++skipped) {
        if (matches(name.substr(skipped), pattern.substr(1))) return true;
    }
    return false;
}

/// Names of the folder's files that match, in alphabetical order: the same on every machine.
std::vector<std::string> matching_files(const fs::path& folder, const std::string& pattern) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        const std::string name = it->path().filename().string();
        if (it->is_regular_file(failed) && name.front() != '.' && matches(name, pattern)) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) text += (i ? ", " : "") + on_one_line(names[i]);
    return text + (names.size() > kMost ? ", ..." : "");
}

lighting::Map* map_named(lighting::MaterialMaps& maps, const std::string& name) {
    if (name == "albedo") return &maps.albedo;
    if (name == "emission") return &maps.emission;
    if (name == "metallic") return &maps.metallic;
    if (name == "roughness") return &maps.roughness;
    return name == "ao" ? &maps.ao : &maps.normal;
}

/// The names by the map that they announce.
std::map<std::string, std::vector<std::string>> sorted_by_map(const std::vector<std::string>& names,
                                                              const std::set<std::string>& given) {
    std::map<std::string, std::vector<std::string>> of_map;
    for (const std::string& name : names) {
        const std::string map = map_announced_by(name);
        if (!given.contains(map == "normal_down" ? "normal" : map)) of_map[map].push_back(name);
    }
    return of_map;
}

}  // namespace

MapFolder find_maps(const std::string& pattern, const std::set<std::string>& given) {
    std::error_code failed;
    const bool is_folder = fs::is_directory(pattern, failed);
    fs::path folder = is_folder ? fs::path(pattern) : fs::path(pattern).parent_path();
    MapFolder found;
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, failed)) {
        found.problem = "there is no folder " + path_in_quotes(folder.string());
        return found;
    }
    const std::string wanted = is_folder ? "*" : fs::path(pattern).filename().string();
    const std::vector<std::string> names = matching_files(folder, wanted);
    auto files_of = sorted_by_map(names, given);
    found.not_used = files_of[""];
    files_of.erase("");
    if (files_of.contains("normal_down") && files_of.contains("normal")) files_of.erase("normal_down");
    if (files_of.contains("normal_down")) found.maps.normal_y = lighting::NormalMapY::down;
    for (const auto& [map, files] : files_of) {
        if (files.size() > 1) {
            found.twice.push_back({map == "normal_down" ? "normal" : map, files[0], files[1]});
        } else {
            map_named(found.maps, map)->file = (folder / files[0]).string();
        }
    }
    if (files_of.empty() && given.empty()) {
        found.problem = "no map is found by " + in_quotes(pattern) + "; expected files whose names end in " +
                        announcing_words() + (names.empty() ? "" : "; found " + joined(names)) +
                        "; name each of them with a key of its own, e.g. albedo_map, normal_map";
    }
    return found;
}

}  // namespace kreda::scene
