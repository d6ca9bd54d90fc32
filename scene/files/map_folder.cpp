#include "scene/files/map_folder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

struct Announcement {
    std::string_view map;
    std::vector<std::string_view> words;  ///< the usual one first
};

/// The names that Substance, ambientCG, Poly Haven, glTF and Unreal tools write, in lower case without separators.
const std::vector<Announcement>& announcements() {
    static const std::vector<Announcement> all = {
        {"albedo",
         {"albedo", "basecolor", "color", "col", "diffuse", "diff", "bc", "basecolour", "colour",
          "albedotransparency"}},
        {"emission", {"emission", "emissive", "emit", "glow", "selfillumination"}},
        {"metallic", {"metallic", "metalness", "metal"}},
        {"roughness", {"roughness", "rough"}},
        {"ao", {"ao", "ambientocclusion", "occlusion", "occ"}},
        {"normal", {"normal", "normalgl", "normalopengl", "norgl", "nor", "nrm", "norm", "normalogl", "nrm16"}},
        {"normal_down", {"normaldx", "normaldirectx", "nordx"}},
    };
    return all;
}

std::vector<std::string> words_of(const std::string& stem) {
    std::vector<std::string> words(1);
    for (const char c : stem) {
        const bool separates = c == '_' || c == '-' || c == '.' || c == ' ';
        if (separates)
            words.emplace_back();
        else
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    std::erase_if(words, [](const std::string& word) { return word.empty(); });
    return words;
}

/// "2048", "1k", "4k", and as sizes go what libraries put behind them: "png", "jpg", "lod0", "var1"
bool is_size(std::string_view word) {
    if (word == "png" || word == "jpg" || word == "jpeg" || word == "exr" || word == "tif") return true;
    if (word.ends_with('k')) word.remove_suffix(1);
    if (word.starts_with("lod") || word.starts_with("var")) word.remove_prefix(3);
    return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
}

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

/// Unreal's T_Rock_D: a letter alone says something only behind that T.
std::string map_of_letter(const std::vector<std::string>& words) {
    if (words.size() < 3 || words.front() != "t") return "";
    const std::string& letter = words.back();
    if (letter == "d") return "albedo";
    if (letter == "n") return "normal_down";  // Unreal's green points down
    if (letter == "r") return "roughness";
    return letter == "m" ? "metallic" : "";
}

/// What the last word says, or the last two.
std::string announced_by(const std::vector<std::string>& words) {
    if (words.empty()) return "";
    const std::string last = words.back();
    const std::string last_two = words.size() > 1 ? words[words.size() - 2] + last : last;
    for (const std::string& candidate : {last_two, last}) {
        for (const Announcement& announcement : announcements()) {
            const auto& known = announcement.words;
            if (std::find(known.begin(), known.end(), candidate) != known.end()) return std::string(announcement.map);
        }
    }
    return map_of_letter(words);
}

/// Poliigon ends every name of a set in its workflow, behind the size: X_COL_2K_METALNESS.
void drop_workflow(std::vector<std::string>& words) {
    if (words.size() < 3 || (words.back() != "metalness" && words.back() != "specular")) return;
    std::vector<std::string> before(words.begin(), words.end() - 1);
    if (!is_size(before.back())) return;
    while (!before.empty() && is_size(before.back())) before.pop_back();
    constexpr std::array<std::string_view, 10> kOthers = {"disp", "disp16", "displacement", "height", "gloss",
                                                          "refl", "bump",   "bump16",       "mask",   "sss"};
    const bool is_other = !before.empty() && std::find(kOthers.begin(), kOthers.end(), before.back()) != kOthers.end();
    if (is_other || !announced_by(before).empty()) words = before;  // else X_2K_Metalness, which is the map
}

lighting::Map* map_named(lighting::MaterialMaps& maps, const std::string& name) {
    if (name == "albedo") return &maps.albedo;
    if (name == "emission") return &maps.emission;
    if (name == "metallic") return &maps.metallic;
    if (name == "roughness") return &maps.roughness;
    return name == "ao" ? &maps.ao : &maps.normal;
}

}  // namespace

std::string map_announced_by(const std::string& file_name) {
    std::vector<std::string> words = words_of(fs::path(file_name).stem().string());
    drop_workflow(words);
    while (!words.empty() && is_size(words.back())) words.pop_back();
    return announced_by(words);
}

std::string announcing_words() {
    std::string text;
    for (const Announcement& announcement : announcements()) {
        if (announcement.map == "normal_down") continue;
        text += (text.empty() ? "" : ", ") + std::string(announcement.words[0]);
        text += " (or " + std::string(announcement.words[1]) + ")";
    }
    return text;
}

MapFolder find_maps(const std::string& pattern) {
    std::error_code failed;
    const bool is_folder = fs::is_directory(pattern, failed);
    const fs::path folder = is_folder ? fs::path(pattern) : fs::path(pattern).parent_path();
    MapFolder found;
    if (!fs::is_directory(folder.empty() ? fs::path(".") : folder, failed)) {
        found.problem = "there is no folder " + path_in_quotes(folder.string());
        return found;
    }
    const std::vector<std::string> names = matching_files(folder.empty() ? fs::path(".") : folder,
                                                          is_folder ? "*" : fs::path(pattern).filename().string());
    std::map<std::string, std::string> file_of;
    for (const std::string& name : names) {
        const std::string map = map_announced_by(name);
        if (map.empty()) {
            found.not_used.push_back(name);
        } else if (!file_of.emplace(map, name).second) {
            found.problem = in_quotes(file_of[map]) + " and " + in_quotes(name) + " are both a map of " + map +
                            "; name one of them with " + map + "_map";
        }
    }
    if (file_of.contains("normal_down") && file_of.contains("normal")) file_of.erase("normal_down");
    if (file_of.contains("normal_down")) found.maps.normal_y = lighting::NormalMapY::down;
    for (const auto& [map, name] : file_of) map_named(found.maps, map)->file = (folder / name).string();
    if (file_of.empty()) {
        found.problem = "no map is found by " + in_quotes(pattern) + "; expected files whose names end in " +
                        announcing_words() + (names.empty() ? "" : "; found " + joined(names)) +
                        "; name each of them with a key of its own, e.g. albedo_map, normal_map";
    }
    return found;
}

}  // namespace kreda::scene
