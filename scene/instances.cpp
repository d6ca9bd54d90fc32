#include "scene/instances.hpp"

namespace kreda::scene {

std::vector<raster::MeshInstance> make_instances(const Scene& scene) {
    std::vector<raster::MeshInstance> instances;
    for (const Object& object : scene.objects) {
        raster::MeshInstance instance;
        instance.mesh = object.mesh.get();
        instance.world_from_object = object.world_from_object;
        instance.part_material.assign(object.part_material.begin(), object.part_material.end());
        instance.part_hidden = object.part_hidden;
        instances.push_back(std::move(instance));
    }
    return instances;
}

}  // namespace kreda::scene
