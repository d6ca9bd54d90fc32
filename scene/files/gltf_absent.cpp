// Instead of all other gltf_*.cpp, where tinygltf was not there when Kreda was built.
#include "scene/files/gltf_file.hpp"

namespace kreda::scene {

LoadedMesh load_gltf_file(const std::string& path, const MeshFileOptions&) {
    throw UserError(Place{path},
                    "is a glTF scene, and this Kreda was built without tinygltf; install libtinygltf-dev "
                    "and build it again");
}

}  // namespace kreda::scene
