#include "scene/files/mtl_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include <tiny_obj_loader.h>

namespace kreda::scene {

namespace {

/// A number of a statement, and where it stands.
struct Share {
    float value = 1.0f;
    std::string_view keyword;
};

/// Which statements a material has: the library does not tell a colour that is absent from black. The library knows
/// options of maps that we do not and cuts names at blanks: maps are read here.
struct Given {
    bool Ka = false, Kd = false, Ks = false, Ke = false, Ns = false, Pr = false, Pm = false;
    std::optional<Share> d, Tr;
    lighting::MaterialMaps maps;
    std::string bump_file;
};

struct MtlScan {
    std::string statements;    // what the library gets: checked, a statement a line
    std::vector<Given> given;  // one for each newmtl
};

struct MtlScanner {
    const ObjText& text;
    const NamedFileLimits& limits;
    ObjCursor cursor;
    MtlScan scan;
    ObjWarnings warnings;
    bool has_no_name = false;  // the statements belong to a newmtl without a name
};

/// `kind`: what such warnings have in common.
void warn(MtlScanner& s, std::string_view kind, std::string_view keyword, const std::string& message) {
    s.warnings.add(kind, s.cursor.offset_of(keyword), message);
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

/// A reflectance beyond 0..1 is drawn as it is written, but perhaps not meant so.
void check_share(MtlScanner& s, std::string_view keyword, const std::array<std::string_view, 3>& rgb) {
    for (const std::string_view number : rgb) {
        const double value = parse_finite(s.cursor, number, "a colour: r g b");
        const bool is_bright = value > 1.0 && keyword != "Ke";
        if (value >= 0.0 && !is_bright) continue;
        return warn(s, "colours beyond 0..1", number,
                    token_in_quotes(number) + ": " + std::string(keyword) +
                        (value < 0.0 ? " is less than no light"
                                     : " reflects more light than arrives; bytes are to be divided by 255"));
    }
}

/// Calls scan(); what it complains of is a warning: a surface without one of its numbers is still one.
template <class Scan>
void scan_or_warn(MtlScanner& s, Scan scan) {
    try {
        scan();
    } catch (const UserError& error) {
        s.warnings.add_line("statements that cannot be read", std::string(error.what()) + "; the statement is ignored");
    }
}

/// Kd r [g b]: one number means grey, which the library would read as red.
void scan_color(MtlScanner& s, std::string_view keyword, bool& given) {
    std::string_view token = s.cursor.next_number_token();
    if (token == "spectral" || token == "xyz") {
        return warn(s, "colours that are no r g b", keyword,
                    std::string(keyword) + " " + std::string(token) + " is ignored; write r g b");
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
    if (!token.empty()) {
        warn(s, "colours of more than 3 numbers", token,
             token_in_quotes(token) + ": a colour has 3 numbers, r g b; the rest is ignored");
    }
    check_share(s, keyword, rgb);
    s.scan.statements += keyword;
    for (const std::string_view number : rgb) s.scan.statements.append(" ").append(number);
    s.scan.statements += '\n';
    given = true;
}

/// Ns, Pr and Pm: what lies outside of the range is clearly the end of the range.
void scan_number(MtlScanner& s, std::string_view keyword, bool& given) {
    const std::string_view token = s.cursor.next_number_token();
    const double value = parse_finite(s.cursor, token, "a number");
    const bool is_exponent = keyword == "Ns";
    const bool is_too_small = value < 0.0, is_too_large = !is_exponent && value > 1.0;
    if (is_too_small || is_too_large) {
        const std::string what = is_exponent       ? "the specular exponent: 0 or more"
                                 : keyword == "Pr" ? "the roughness: 0 to 1"
                                                   : "the metallic share: 0 to 1";
        warn(s, "numbers out of range", token,
             token_in_quotes(token) + ": " + std::string(keyword) + " is " + what + "; " + (is_too_small ? "0" : "1") +
                 " is used instead");
    }
    const std::string_view used = is_too_small ? "0" : is_too_large ? "1" : token;
    s.scan.statements.append(keyword).append(" ").append(used).append("\n");
    given = true;
}

/// d [-halo] opacity, Tr 1 - opacity
void scan_opacity(MtlScanner& s, std::string_view keyword, std::optional<Share>& given) {
    std::string_view token = s.cursor.next_number_token();
    if (token == "-halo") token = s.cursor.next_number_token();
    given = Share{static_cast<float>(parse_finite(s.cursor, token, "an opacity: 0 to 1")), keyword};
}

/// Say what is not drawn as it is written, when all of the material is read.
void finish_material(MtlScanner& s) {
    if (s.has_no_name || s.scan.given.empty()) return;
    const Given& given = s.scan.given.back();
    const bool is_opaque = given.d ? given.d->value >= 1.0f : !given.Tr || given.Tr->value <= 0.0f;
    if (is_opaque) return;
    const std::string_view keyword = given.d ? given.d->keyword : given.Tr->keyword;
    warn(s, "transparent materials (d, Tr)", keyword,
         token_in_quotes(keyword) + ": this material is transparent, but drawn opaque; Kreda draws no transparency");
}

bool looks_like_number(std::string_view word) {
    return !word.empty() && word.find_first_not_of("+-.0123456789eE") == word.npos;
}

/// `-bm 0.5 -s 1 1 1 wood grain.png`: the file's name, the factor of -bm, and whether there were other options.
struct MapStatement {
    std::string name;
    float bump = 1.0f;
    bool has_other_options = false;
};

/// An option has one word, -o, -s and -t up to three numbers, -mm two.
MapStatement parse_map(const std::string& rest) {
    MapStatement map;
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
        const std::string_view value = word();
        float factor = 1.0f;
        const bool is_factor = option == "-bm" &&
                               std::from_chars(value.data(), value.data() + value.size(), factor).ec == std::errc() &&
                               std::isfinite(factor);
        if (is_factor) map.bump = factor;
        map.has_other_options |= !is_factor;
        if (!has_numbers) skip();
        for (int i = 0; has_numbers && i < (option == "-mm" ? 2 : 3) && looks_like_number(word()); ++i) skip();
    }
    map.name = rest.substr(at);
    if (map.name.size() > 2 && map.name.front() == '"' && map.name.back() == '"') {
        map.name = map.name.substr(1, map.name.size() - 2);
    }
    return map;
}

/// Where the file of a map belongs; null: no place for it. Programs disagree about capitals.
std::string* file_of_map(Given& given, const std::string& keyword) {
    if (keyword == "map_kd") return &given.maps.diffuse.file;
    if (keyword == "map_ke" || keyword == "map_emissive") return &given.maps.emission.file;
    if (keyword == "map_pr") return &given.maps.roughness.file;
    if (keyword == "map_pm") return &given.maps.metallic.file;
    if (keyword == "norm" || keyword == "map_kn") return &given.maps.normal.file;
    return keyword == "bump" || keyword == "map_bump" ? &given.bump_file : nullptr;
}

/// A map that there is no place for, or whose file is absent, is dropped with a warning: real files have such.
void scan_map(MtlScanner& s, std::string_view keyword) {
    const std::string rest = s.cursor.rest_of_statement();
    std::string* const file = file_of_map(s.scan.given.back(), in_lower_case(keyword));
    if (!file) {
        return warn(
            s, std::string(keyword) + " statements", keyword,
            token_in_quotes(keyword) + " is ignored; map_Kd, map_Ke, map_Pr, map_Pm, norm and map_Bump are used");
    }
    const MapStatement map = parse_map(rest);
    if (map.name.empty()) {
        return warn(s, "maps without a file", keyword,
                    token_in_quotes(keyword) + " names no image file and is ignored");
    }
    const bool is_bump = file == &s.scan.given.back().bump_file;
    if (map.has_other_options || (!is_bump && map.bump != 1.0f)) {
        warn(s, "options of maps", keyword,
             "the options of " + std::string(keyword) + " are ignored" + (is_bump ? ", all but -bm" : ""));
    }
    *file = find_named_file(s.text, s.cursor.offset_of(keyword), map.name, s.limits, "image file", "; drawn without it",
                            s.warnings);
    if (is_bump) s.scan.given.back().maps.bump_scale = lighting::MaterialMaps{}.bump_scale * map.bump;
}

void scan_newmtl(MtlScanner& s, std::string_view keyword) {
    finish_material(s);
    const std::string name = s.cursor.rest_of_statement();
    s.has_no_name = name.empty();
    if (s.has_no_name) {
        return warn(s, "newmtl without a name", keyword,
                    "this newmtl has no name; what follows is ignored up to the next newmtl");
    }
    s.scan.statements.append("newmtl ").append(name).append("\n");
    s.scan.given.emplace_back();
}

void scan_keyword(MtlScanner& s, std::string_view keyword) {
    if (keyword == "newmtl") return scan_newmtl(s, keyword);
    if (s.has_no_name) return;
    if (s.scan.given.empty()) {
        return warn(s, "statements before the first newmtl", keyword,
                    token_in_quotes(keyword) + " before the first newmtl is ignored");
    }
    Given& given = s.scan.given.back();
    if (bool* const color = given_color(given, keyword)) {
        return scan_or_warn(s, [&] { scan_color(s, keyword, *color); });
    }
    if (bool* const number = given_number(given, keyword)) {
        return scan_or_warn(s, [&] { scan_number(s, keyword, *number); });
    }
    if (keyword == "d") return scan_or_warn(s, [&] { scan_opacity(s, keyword, given.d); });
    if (keyword == "Tr") return scan_or_warn(s, [&] { scan_opacity(s, keyword, given.Tr); });
    const bool is_map = keyword.starts_with("map_") || keyword == "norm" || keyword == "bump" || keyword == "disp" ||
                        keyword == "refl" || keyword == "decal";
    if (is_map) return scan_map(s, keyword);
    if (keyword == "illum") s.scan.statements.append("illum ").append(s.cursor.next_number_token()).append("\n");
}

void scan_statement(MtlScanner& s) {
    const std::string_view keyword = s.cursor.next_token();
    if (!keyword.empty() && keyword.front() == '#') return s.cursor.skip_line();
    if (!keyword.empty()) scan_keyword(s, keyword);
    s.cursor.skip_statement();
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
    const bool map_alone = !given.maps.emission.file.empty() && phong.emission == glm::vec3(0.0f);
    if (map_alone) phong.emission = glm::vec3(1.0f);  // exporters write "Ke 0 0 0" beside a map that is to be seen
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
    material.maps = given.maps;
    material.maps.albedo = given.maps.diffuse;
    if (given.maps.normal.file.empty()) {
        material.maps.normal.file = given.bump_file;
        material.maps.normal_from_height = !given.bump_file.empty();
    }
    const bool is_pbr = given.Pr || given.Pm || !given.maps.roughness.file.empty() || !given.maps.metallic.file.empty();
    const bool is_matt = material.phong.specular == glm::vec3(0.0f) || mtl.illum == 1;
    material.model = is_pbr    ? lighting::ReflectionModel::cook_torrance
                     : is_matt ? lighting::ReflectionModel::lambert
                               : lighting::ReflectionModel::blinn_phong;
    return material;
}

}  // namespace

void add_mtl(const ObjText& text, const NamedFileLimits& limits, MtlMaterials& into) {
    MtlScanner s{text, limits, ObjCursor(text), {}, ObjWarnings(text)};
    while (!s.cursor.at_end()) scan_statement(s);
    finish_material(s);
    const std::vector<std::string> lines = s.warnings.lines();
    into.warnings.insert(into.warnings.end(), lines.begin(), lines.end());
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
