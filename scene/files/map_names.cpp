#include "scene/files/map_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

namespace kreda::scene {

namespace {

using Words = std::vector<std::string>;

struct Announcement {
    std::string_view map;
    std::vector<std::string_view> words;  ///< the usual one first
};

/// In lower case without separators: Substance, ambientCG, Poly Haven, Poliigon, Quixel, textures.com, 3dtextures,
/// cgbookcase, FreePBR, TextureCan, Blender's Node Wrangler, glTF, Unity and Unreal.
const std::vector<Announcement>& announcements() {
    static const std::vector<Announcement> all = {
        {"albedo",
         {"albedo", "basecolor", "color", "col", "diffuse", "diff", "bc", "basecolour", "colour", "alb",
          "albedotransparency", "maintex", "base"}},
        {"emission", {"emission", "emissive", "emit", "glow", "selfillumination", "emissivecolor"}},
        {"metallic", {"metallic", "metalness", "metal", "met", "mtl"}},
        {"roughness", {"roughness", "rough", "rgh"}},
        {"ao", {"ao", "ambientocclusion", "occlusion", "occ"}},
        {"normal",
         {"normal", "normalgl", "normalopengl", "norgl", "nor", "nrm", "norm", "normalogl", "nrm16", "nrml", "nrmgl",
          "norogl", "noropengl"}},
        {"normal_down", {"normaldx", "normaldirectx", "nordx", "nrmdx", "nordirectx"}},
    };
    return all;
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> known) {
    return std::find(known.begin(), known.end(), word) != known.end();
}

std::string map_of_word(const std::string& word) {
    for (const Announcement& announcement : announcements()) {
        const auto& known = announcement.words;
        if (std::find(known.begin(), known.end(), word) != known.end()) return std::string(announcement.map);
    }
    return "";
}

/// Words between separators, in lower case.
Words words_of(const std::string& stem) {
    Words words(1);
    for (const char c : stem) {
        const bool separates = c == '_' || c == '-' || c == '.' || c == ' ' || c == '(' || c == ')';
        if (separates)
            words.emplace_back();
        else
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    std::erase_if(words, [](const std::string& word) { return word.empty(); });
    return words;
}

/// "octostoneBaseColor" -> "octostone_Base_Color"
std::string with_humps_apart(const std::string& stem) {
    std::string apart;
    for (const char c : stem) {
        const bool is_hump = std::isupper(static_cast<unsigned char>(c)) && !apart.empty() &&
                             std::islower(static_cast<unsigned char>(apart.back()));
        if (is_hump) apart += '_';
        apart += c;
    }
    return apart;
}

bool is_number(std::string_view word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// "2048", "1k", "4k", and as sizes go what libraries put behind them: "png", "lod0", "var1", "u1", "v2", "map"
bool is_size(std::string_view word) {
    const bool is_tail = is_one_of(std::string(word), {"png", "jpg", "jpeg", "exr", "tif", "tiff", "tga", "map",
                                                       "texture", "tex", "seamless", "tiled", "tileable"});
    if (is_tail) return true;
    if (word.ends_with('k')) word.remove_suffix(1);
    for (const std::string_view start : {"lod", "var", "u", "v"}) {
        if (word.starts_with(start)) return is_number(word.substr(start.size()));
    }
    return is_number(word);
}

/// A letter alone says something only behind the T of Unreal: T_Rock_D, and of Quixel: T_abc_2K_B.
std::string map_of_letter(const Words& words) {
    if (words.size() < 3 || words.front() != "t") return "";
    const std::string& letter = words.back();
    if (letter == "d" || letter == "b") return "albedo";
    if (letter == "n") return "normal_down";  // Unreal's green points down
    if (letter == "r") return "roughness";
    if (letter == "e") return "emission";
    return letter == "m" ? "metallic" : "";
}

/// What the last two words say, or the last one, a number of one digit at its end left out: roughness2.
std::string announced_by(const Words& words) {
    if (words.empty()) return "";
    const std::string& last = words.back();
    if (words.size() > 1) {
        std::string of_two = map_of_word(words[words.size() - 2] + last);
        if (!of_two.empty()) return of_two;
    }
    std::string of_one = map_of_word(last);
    if (!of_one.empty()) return of_one;
    const bool has_digit = words.size() > 1 && last.size() > 2 && std::isdigit(static_cast<unsigned char>(last.back()));
    std::string of_rest = has_digit ? map_of_word(last.substr(0, last.size() - 1)) : "";
    return of_rest.empty() ? map_of_letter(words) : of_rest;
}

/// Maps that share a file tell so in one word: metallicRoughness, OcclusionRoughnessMetallic.
bool is_packed(const std::string& stem) {
    const Words words = words_of(stem);
    if (words.empty()) return false;
    const std::size_t at = words.size() - 1;
    const Words humps = words_of(with_humps_apart(stem.substr(stem.size() - words[at].size())));
    const auto values = std::count_if(humps.begin(), humps.end(), [](const std::string& word) {
        return is_one_of(map_of_word(word), {"metallic", "roughness", "ao"});
    });
    return values > 1;
}

/// Poliigon ends every name of a set in its workflow, behind the size: X_COL_2K_METALNESS.
void drop_workflow(Words& words) {
    if (words.size() < 3 || (words.back() != "metalness" && words.back() != "specular")) return;
    Words before(words.begin(), words.end() - 1);
    if (!is_size(before.back())) return;
    while (!before.empty() && is_size(before.back())) before.pop_back();
    const bool is_other =
        !before.empty() && is_one_of(before.back(), {"disp", "disp16", "displacement", "height", "gloss", "refl",
                                                     "bump", "bump16", "mask", "sss"});
    if (is_other || !announced_by(before).empty()) words = before;  // else X_2K_Metalness, which is the map
}

void drop_sizes(Words& words) {
    drop_workflow(words);
    while (!words.empty() && is_size(words.back())) words.pop_back();
}

}  // namespace

std::string map_announced_by(const std::string& file_name) {
    const std::string stem = std::filesystem::path(file_name).stem().string();
    if (is_packed(stem)) return "";
    Words words = words_of(stem);
    const bool map_comes_first = words.size() > 2 && is_size(words[1]) && words[1].ends_with('k');  // Albedo_4K__abc
    const std::string first = map_comes_first ? map_of_word(words[0]) : "";
    drop_sizes(words);
    std::string map = announced_by(words);
    if (!map.empty()) return map;
    Words humps = words_of(with_humps_apart(stem));
    drop_sizes(humps);
    const std::string of_humps = announced_by(humps);
    return of_humps.empty() ? first : of_humps;
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

}  // namespace kreda::scene
