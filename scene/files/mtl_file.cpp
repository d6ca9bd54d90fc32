#include "scene/files/mtl_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include <tiny_obj_loader.h>

namespace kreda::scene {

namespace {

/// Which statements a material has: the library does not tell a colour that is absent from black.
struct Given {
    bool Ka = false, Kd = false, Ks = false, Ke = false, Ns = false, Pr = false, Pm = false;
};

struct MtlScan {
    std::string statements;    // what the library gets: checked, a statement a line
    std::vector<Given> given;  // one for each newmtl
};

struct Scanner {
    const ObjText& text;
    const MtlPaths& paths;
    MtlMaterials& into;
    ObjCursor cursor;
    MtlScan scan;
};

void warn(Scanner& s, std::string_view keyword, const std::string& message) {
    add_warning(s.into.warnings, s.text, s.cursor.offset_of(keyword), message);
}

bool* given_color(Given& given, std::string_view keyword) {
    if (keyword == "Ka") return &given.Ka;
    if (keyword == "Kd") return &given.Kd;
    if (keyword == "Ks") return &given.Ks;
    return keyword == "Ke" ? &given.Ke : nullptr;
}

bool* given_number(Given& given, std::string_view keyword) {
    if (keyword == "Ns") return &given.Ns;
    if (keyword == "Pr") return &given.Pr;
    return keyword == "Pm" ? &given.Pm : nullptr;
}

/// Kd r [g b]: one number means grey, which the library would read as red.
void scan_color(Scanner& s, std::string_view keyword, bool& given) {
    std::string_view token = s.cursor.next_number_token();
    if (token == "spectral" || token == "xyz") {
        return warn(s, keyword, std::string(keyword) + " " + std::string(token) + " is ignored; write r g b");
    }
    std::array<std::string_view, 3> rgb;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == 1 && token.empty()) {
            rgb[1] = rgb[2] = rgb[0];
            break;
        }
        parse_finite(s.cursor, token, "a colour: r g b");
        rgb[i] = token;
        token = s.cursor.next_number_token();
    }
    if (!token.empty()) s.cursor.fail(token, "a colour has 3 numbers: r g b");
    s.scan.statements += keyword;
    for (const std::string_view number : rgb) s.scan.statements.append(" ").append(number);
    s.scan.statements += '\n';
    given = true;
}

void scan_number(Scanner& s, std::string_view keyword, bool& given) {
    const std::string_view token = s.cursor.next_number_token();
    const double value = parse_finite(s.cursor, token, "a number");
    if (keyword == "Ns" && value < 0.0) s.cursor.fail(token, "Ns is the specular exponent: 0 or more");
    if (keyword != "Ns" && (value < 0.0 || value > 1.0)) {
        s.cursor.fail(token, std::string(keyword) + (keyword == "Pr" ? " is the roughness" : " is the metallic share") +
                                 ": 0 to 1");
    }
    s.scan.statements.append(keyword).append(" ").append(token).append("\n");
    given = true;
}

bool is_number(std::string_view word) {
    return !word.empty() && word.find_first_not_of("+-.0123456789eE") == word.npos;
}

/// `-bm 0.5 -s 1 1 1 wood grain.png` -> `wood grain.png`. An option has one word, these three up to three numbers.
std::string without_map_options(const std::string& rest) {
    std::size_t at = 0;
    const auto word = [&] {
        const std::size_t end = std::min(rest.find_first_of(" \t", at), rest.size());
        return std::string_view(rest).substr(at, end - at);
    };
    const auto skip = [&] { at = std::min(rest.find_first_not_of(" \t", at + word().size()), rest.size()); };
    while (at < rest.size() && rest[at] == '-' && word().find('.') == std::string_view::npos) {
        const std::string_view option = word();
        const bool has_numbers = option == "-o" || option == "-s" || option == "-t" || option == "-mm";
        skip();
        if (!has_numbers) skip();
        for (int i = 0; has_numbers && i < 3 && is_number(word()); ++i) skip();
    }
    return rest.substr(at);
}

/// A map that there is no place for, or whose file is absent, is dropped with a warning: real files have such.
void scan_map(Scanner& s, std::string_view keyword) {
    static constexpr std::array<std::string_view, 4> kUsed = {"map_Kd", "map_Pr", "map_Pm", "norm"};
    const std::string rest = s.cursor.rest_of_statement();
    if (std::find(kUsed.begin(), kUsed.end(), keyword) == kUsed.end()) {
        return warn(s, keyword, in_quotes(keyword) + " is ignored; map_Kd, map_Pr, map_Pm and norm are used");
    }
    const std::string name = without_map_options(rest);
    if (name.empty())
        s.cursor.fail(rest.empty() ? s.cursor.next_token() : keyword, "expected the name of an image file");
    if (name != rest) warn(s, keyword, "the options of " + std::string(keyword) + " are ignored");
    const std::size_t offset = s.cursor.offset_of(keyword);
    const std::string path = resolve_named_path(s.text, offset, name, s.paths.root, s.paths.allow_outside);
    std::error_code failed;
    if (!std::filesystem::exists(path, failed)) return warn(s, keyword, "no such image file: " + path);
    s.scan.statements.append(keyword).append(" ").append(path).append("\n");
}

void scan_statement(Scanner& s) {
    const std::string_view keyword = s.cursor.next_token();
    if (keyword.empty() || keyword.front() == '#') return;
    if (keyword == "newmtl") {
        const std::string name = s.cursor.rest_of_statement();
        if (name.empty()) s.cursor.fail(s.cursor.next_token(), "expected the material's name");
        s.scan.statements.append("newmtl ").append(name).append("\n");
        s.scan.given.emplace_back();
        return;
    }
    if (s.scan.given.empty()) return warn(s, keyword, in_quotes(keyword) + " before the first newmtl is ignored");
    Given& given = s.scan.given.back();
    if (bool* const color = given_color(given, keyword)) return scan_color(s, keyword, *color);
    if (bool* const number = given_number(given, keyword)) return scan_number(s, keyword, *number);
    const bool is_map = keyword.starts_with("map_") || keyword == "norm" || keyword == "bump" || keyword == "disp" ||
                        keyword == "refl" || keyword == "decal";
    if (is_map) return scan_map(s, keyword);
    if (keyword == "illum") s.scan.statements.append("illum ").append(s.cursor.next_number_token()).append("\n");
}

glm::vec3 color(const tinyobj::real_t (&rgb)[3]) {
    return {rgb[0], rgb[1], rgb[2]};
}

lighting::PhongMaterial phong_constants(const tinyobj::material_t& mtl, const Given& given) {
    lighting::PhongMaterial phong;
    if (given.Ka) phong.ambient = color(mtl.ambient);
    if (given.Kd) phong.diffuse = color(mtl.diffuse);
    phong.specular = given.Ks ? color(mtl.specular) : glm::vec3(0.0f);
    if (given.Ke) phong.emission = color(mtl.emission);
    if (given.Ns) phong.shininess = mtl.shininess;
    return phong;
}

lighting::Material convert(const tinyobj::material_t& mtl, const Given& given) {
    lighting::Material material;
    material.name = mtl.name;
    material.phong = phong_constants(mtl, given);
    if (given.Kd) material.cook_torrance.albedo = color(mtl.diffuse);
    if (given.Pr) material.cook_torrance.roughness = mtl.roughness;
    if (given.Pm) material.cook_torrance.metallic = mtl.metallic;
    material.maps.albedo.file = material.maps.diffuse.file = mtl.diffuse_texname;
    material.maps.roughness.file = mtl.roughness_texname;
    material.maps.metallic.file = mtl.metallic_texname;
    material.maps.normal.file = mtl.normal_texname;
    const bool is_pbr = given.Pr || given.Pm || !mtl.roughness_texname.empty() || !mtl.metallic_texname.empty();
    const bool is_matt = material.phong.specular == glm::vec3(0.0f) || mtl.illum == 1;
    material.model = is_pbr    ? lighting::ReflectionModel::cook_torrance
                     : is_matt ? lighting::ReflectionModel::lambert
                               : lighting::ReflectionModel::blinn_phong;
    return material;
}

}  // namespace

void add_mtl(const ObjText& text, const MtlPaths& paths, MtlMaterials& into) {
    Scanner s{text, paths, into, ObjCursor(text), {}};
    while (!s.cursor.at_end()) {
        scan_statement(s);
        s.cursor.skip_statement();
    }
    std::map<std::string, int> unused_index;
    std::vector<tinyobj::material_t> materials;
    std::istringstream stream(s.scan.statements);
    std::string warnings, errors;
    tinyobj::LoadMtl(&unused_index, &materials, &stream, &warnings, &errors);
    // Without any newmtl the library still gives one, nameless: there is nothing to convert then.
    for (std::size_t i = 0; i < s.scan.given.size() && i < materials.size(); ++i) {
        into.index_of_name.emplace(materials[i].name, static_cast<int>(into.materials.size()));
        into.materials.push_back(convert(materials[i], s.scan.given[i]));
    }
}

}  // namespace kreda::scene
