#include "scene/map_meshes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "lighting/batch/maps.hpp"
#include "raster/tangents.hpp"

namespace kreda::scene {

namespace {

bool is_visible(const Object& object, std::size_t part) {
    return object.part_hidden.empty() || !object.part_hidden[part];
}

bool wants_tangents(const Scene& scene, const Object& object) {
    for (std::size_t part = 0; part < object.part_material.size(); ++part) {
        const auto material = static_cast<std::size_t>(object.part_material[part]);
        if (is_visible(object, part) && lighting::maps_in_use(scene.materials[material]).normal.texture) return true;
    }
    return false;
}

TangentMesh with_tangents(const std::shared_ptr<const raster::Mesh>& from) {
    auto mesh = std::make_shared<raster::Mesh>(*from);
    const raster::TangentReport report = make_tangents(*mesh);
    return {from, std::move(mesh), report.without_direction};
}

void warn_of_tangents(const Object& object, const TangentMesh& made, std::vector<std::string>& warnings) {
    if (made.without_direction == 0) return;
    warnings.push_back(object.mesh_name + ": " + std::to_string(made.without_direction) +
                       " vertices have no direction of u (the texture coordinates of their triangles lie on a "
                       "line); the normal map tilts them some way");
}

}  // namespace

std::vector<bool> visible_materials(const Scene& scene) {
    std::vector<bool> visible(scene.materials.size(), false);
    for (const Object& object : scene.objects) {
        for (std::size_t part = 0; part < object.part_material.size(); ++part) {
            if (is_visible(object, part)) visible[static_cast<std::size_t>(object.part_material[part])] = true;
        }
    }
    return visible;
}

void drop_maps_without_uv(Scene& scene) {
    std::map<int, int> plain_of;                         // material -> its copy without maps
    std::map<std::pair<std::string, int>, bool> warned;  // mesh, material
    for (Object& object : scene.objects) {
        if (!object.mesh->uvs.empty()) continue;
        for (std::size_t part = 0; part < object.part_material.size(); ++part) {
            const int material = object.part_material[part];
            if (!is_visible(object, part) || !reads_maps(scene.materials[static_cast<std::size_t>(material)])) continue;
            const auto [plain, is_new] = plain_of.try_emplace(material, static_cast<int>(scene.materials.size()));
            if (is_new) {
                lighting::Material copy = scene.materials[static_cast<std::size_t>(material)];
                if (!copy.maps.emission.file.empty() || copy.maps.emission.texture)
                    copy.phong.emission = glm::vec3(0.0f);
                copy.maps = {};
                scene.materials.push_back(std::move(copy));
            }
            object.part_material[part] = plain->second;
            if (!warned.try_emplace({object.mesh_name, material}, true).second) continue;
            scene.warnings.push_back(object.mesh_name +
                                     ": has no texture coordinates (vt); drawn without the maps of '" +
                                     scene.materials[static_cast<std::size_t>(material)].name + "'");
        }
    }
}

void add_tangents(Scene& scene, TangentMeshes& made) {
    std::set<const raster::Mesh*> warned;
    for (Object& object : scene.objects) {
        if (!object.mesh->tangents.empty() || object.mesh->uvs.empty() || !wants_tangents(scene, object)) continue;
        TangentMesh& with = made[object.mesh.get()];
        if (!with.mesh) with = with_tangents(object.mesh);
        if (warned.insert(object.mesh.get()).second) warn_of_tangents(object, with, scene.warnings);
        object.mesh = with.mesh;
    }
}

}  // namespace kreda::scene
