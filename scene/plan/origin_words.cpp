#include "scene/plan/origin_words.hpp"

#include <cstdio>

namespace kreda::scene {

namespace {

std::string exact(const glm::dvec3& v) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "[%.16g, %.16g, %.16g]", v.x, v.y, v.z);
    return buffer;
}

}  // namespace

bool is_far_from_zero(const Scene& scene) {
    return scene.origin != glm::dvec3(0.0);
}

std::string origin_sentence(const Scene& scene) {
    return "World places are counted from " + exact(scene.origin) +
           ", because float has 7 digits only; the scene file's are these plus that.";
}

std::string mesh_origin_sentence(const raster::Mesh& mesh) {
    if (mesh.origin == glm::dvec3(0.0) && mesh.unit == 1.0) return "";
    char unit[32];
    std::snprintf(unit, sizeof unit, "%.16g", mesh.unit);
    const std::string scaled = mesh.unit == 1.0 ? "" : std::string(unit) + " times ";
    return "Object places are counted from " + exact(mesh.origin) + "; the mesh file's are " + scaled +
           "these plus that.";
}

}  // namespace kreda::scene
