#include "scene/map_meshes.hpp"

#include <algorithm>
#include <map>

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

std::shared_ptr<const raster::Mesh> with_tangents(const Object& object, std::vector<std::string>& warnings) {
    auto mesh = std::make_shared<raster::Mesh>(*object.mesh);
    const raster::TangentReport report = make_tangents(*mesh);
    if (report.without_direction > 0) {
        warnings.push_back(object.mesh_name + ": " + std::to_string(report.without_direction) +
                           " vertices have no direction of u (the texture coordinates of their triangles lie on a "
                           "line); the normal map tilts them some way");
    }
    return mesh;
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

void add_tangents(Scene& scene) {
    std::map<const raster::Mesh*, std::shared_ptr<const raster::Mesh>> made;
    for (Object& object : scene.objects) {
        if (!object.mesh->tangents.empty() || object.mesh->uvs.empty() || !wants_tangents(scene, object)) continue;
        std::shared_ptr<const raster::Mesh>& mesh = made[object.mesh.get()];
        if (!mesh) mesh = with_tangents(object, scene.warnings);
        object.mesh = mesh;
    }
}

}  // namespace kreda::scene
