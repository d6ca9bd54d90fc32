#include "scene/files/file_content.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace kreda::scene {

namespace {

constexpr std::string_view kUnpack = ", not what its name says; unpack it first";
constexpr std::string_view kExport = "; Kreda reads meshes as OBJ or glTF: export one with Blender (File, Export)";
constexpr std::string_view kConvert = "; save it as PNG, JPEG or EXR";

/// How its files begin: in lower case, blanks and what XML says of itself skipped.
struct Kind {
    std::string_view start;
    std::string_view is;
    std::string_view remedy;
};

constexpr std::array<Kind, 22> kKinds = {{
    {"<!doctype html", "a web page (HTML)", ", not what its name says; download the file itself"},
    {"<html", "a web page (HTML)", ", not what its name says; download the file itself"},
    {"version https://git-lfs", "a Git LFS pointer",
     ", not what its name says; fetch the file itself with `git lfs pull`"},
    {"\x1f\x8b", "a gzip archive", kUnpack},
    {"pk\3\4", "a zip archive", kUnpack},
    {"7z\xbc\xaf", "a 7z archive", kUnpack},
    {"\3757zxz", "an xz archive", kUnpack},
    {"rar!", "a RAR archive", kUnpack},
    {"<svg", "an SVG drawing", kConvert},
    {"%pdf", "a PDF document", kConvert},
    {"\xabktx", "a KTX texture", kConvert},
    {"ply\n", "a PLY mesh", kExport},
    {"ply\r", "a PLY mesh", kExport},
    {"solid ", "an STL mesh", kExport},
    {"off\n", "an OFF mesh", kExport},
    {"off\r", "an OFF mesh", kExport},
    {"gltf", "a glTF scene", ", not what its name says; call it .glb"},
    {"kaydara fbx", "an FBX scene", kExport},
    {"<collada", "a COLLADA scene", kExport},
    {"blender", "a Blender file", kExport},
    {"#vrml", "a VRML scene", kExport},
    {"#usda", "a USD scene", kExport},
}};

/// ISO media files (HEIC, AVIF, MP4) name their brand behind "ftyp".
std::string_view media_brand(std::string_view start) {
    return start.size() >= 12 && start.substr(4, 4) == "ftyp" ? start.substr(8, 4) : std::string_view();
}

std::string in_lower_case_without_margin(std::string_view start) {
    if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
    if (start.starts_with("<?xml")) start.remove_prefix(std::min(start.size(), start.find('>') + 1));
    while (!start.empty() && std::isspace(static_cast<unsigned char>(start.front()))) start.remove_prefix(1);
    std::string text(start.substr(0, 64));
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

}  // namespace

std::string other_content(std::string_view start) {
    const auto sentence = [](std::string_view is, std::string_view remedy) {
        return "is " + std::string(is) + std::string(remedy);
    };
    const std::string_view brand = media_brand(start);
    if (brand.starts_with("hei") || brand == "mif1") return sentence("a HEIC picture", kConvert);
    if (brand.starts_with("avi")) return sentence("an AVIF picture", kConvert);
    if (!brand.empty()) return sentence("a movie", kConvert);
    const std::string text = in_lower_case_without_margin(start);
    const auto kind = std::ranges::find_if(kKinds, [&](const Kind& k) { return text.starts_with(k.start); });
    return kind == kKinds.end() ? "" : sentence(kind->is, kind->remedy);
}

}  // namespace kreda::scene
