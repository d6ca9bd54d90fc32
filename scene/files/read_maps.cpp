#include "scene/files/read_maps.hpp"

#include <set>

#include "lighting/batch/maps.hpp"
#include "scene/files/file_key.hpp"
#include "scene/files/map_folder.hpp"
#include "scene/files/toml_check.hpp"

namespace kreda::scene {

namespace {

/// The maps that have keys of their own beside `maps`.
std::set<std::string> maps_given(const Value& table) {
    std::set<std::string> given;
    for (const lighting::MapUse& use : lighting::map_uses()) {
        if (find(table, std::string(use.name) + "_map")) given.insert(std::string(use.name));
    }
    if (given.contains("diffuse")) given.insert("albedo");  // a folder's colour is either
    if (find(table, "bump_map")) given.insert("normal");
    return given;
}

/// Two files for one map: the words tell both ways to choose.
[[noreturn]] void throw_twice(const Value& key, const TwoFiles& two, const lighting::Material& material) {
    const bool reads_diffuse = two.map == "albedo" && material.model != lighting::ReflectionModel::cook_torrance;
    const std::string key_of_map = (reads_diffuse ? "diffuse" : two.map) + "_map";
    const bool is_pattern = key.text.find('*') != key.text.npos;
    const std::string folder = is_pattern ? key.text.substr(0, key.text.rfind('/') + 1) : key.text + "/";
    throw UserError(key.place, in_quotes(key.key) + ": " + in_quotes(two.first) + " and " + in_quotes(two.second) +
                                   " are both a map of " + two.map + "; choose one beside it, " + key_of_map + " = \"" +
                                   on_one_line(folder + two.first) +
                                   "\", or let the pattern of 'maps' match fewer files");
}

/// The maps of a folder, under the names that the material's model reads.
void read_folder(const Value& table, const Value& key, const std::string& folder, lighting::Material& material,
                 std::vector<std::string>& warnings) {
    const MapFolder found = find_maps(path_in(folder, key.text), maps_given(table));
    if (!found.problem.empty()) throw UserError(key.place, in_quotes(key.key) + ": " + found.problem);
    if (!found.twice.empty()) throw_twice(key, found.twice.front(), material);
    for (const lighting::MapUse& use : lighting::map_uses()) material.maps.*use.map = found.maps.*use.map;
    material.maps.diffuse = found.maps.albedo;
    if (!find(table, "normal_map_y")) material.maps.normal_y = found.maps.normal_y;
    if (found.not_used.empty()) return;
    std::string names;
    for (const std::string& name : found.not_used) names += (names.empty() ? "" : ", ") + on_one_line(name);
    warnings.push_back(UserError(key.place, "'maps' does not use " + names).what());
}

std::string usual_remedy(const lighting::MapUse& use) {
    if (use.map == &lighting::MaterialMaps::diffuse) return "; its colour is albedo_map";
    if (use.map == &lighting::MaterialMaps::albedo) return "; its colour is diffuse_map";
    return "";
}

void read_map(const Value& key, const lighting::MapUse& use, const std::string& folder, lighting::Material& material,
              std::vector<std::string>& warnings) {
    lighting::Map& map = material.maps.*use.map;
    map.file = existing_file(key, folder);
    if (reads_map(material.model, use)) return;
    const std::string model(find_key("material", "model")->words[static_cast<std::size_t>(material.model)]);
    const std::string what = in_quotes(key.key) + " is not read by model = \"" + model + "\"";
    warnings.push_back(UserError(key.place, what + usual_remedy(use)).what());
}

/// Heights take the place of the normal map, and know no green that may point down.
void read_bump(const Value& table, const std::string& folder, lighting::Material& material,
               std::vector<std::string>& warnings) {
    const Value* const bump = find(table, "bump_map");
    const Value* const scale = find(table, "bump_scale");
    if (scale && !bump && material.maps.bump_scale != lighting::MaterialMaps{}.bump_scale) {
        throw UserError(scale->place, "'bump_scale' in [[material]] needs 'bump_map', the heights that it scales");
    }
    if (!bump) return;
    for (const char* other : {"normal_map", "normal_map_y"}) {
        if (const Value* key = find(table, other)) {
            throw UserError(key->place, in_quotes(other) +
                                            " and 'bump_map' in [[material]] exclude each other; heights "
                                            "give the normals: remove one of them");
        }
    }
    read_map(*bump, {"bump", lighting::MapKind::normal, &lighting::MaterialMaps::normal}, folder, material, warnings);
    material.maps.normal_from_height = true;
    material.maps.normal_y = lighting::NormalMapY::up;
}

}  // namespace

void read_maps(const Value& table, const std::string& folder, lighting::Material& material,
               std::vector<std::string>& warnings) {
    if (const Value* key = find(table, "maps")) read_folder(table, *key, folder, material, warnings);
    for (const lighting::MapUse& use : lighting::map_uses()) {
        const Value* key = find(table, std::string(use.name) + "_map");
        if (key) read_map(*key, use, folder, material, warnings);
    }
    read_bump(table, folder, material, warnings);
    if (!material.maps.emission.file.empty() && !find(table, "emission")) material.phong.emission = glm::vec3(1.0f);
}

}  // namespace kreda::scene
