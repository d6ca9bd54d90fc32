#include "scene/files/gltf_nodes.hpp"

#include <cmath>
#include <string>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace kreda::scene {

namespace {

constexpr double kFarthestNode = 1e30;  ///< a float's range, and room for the mesh's own size

std::size_t index_of(int node) {
    return static_cast<std::size_t>(node);
}

UserError node_error(const GltfFile& gltf, int node, const std::string& message) {
    return gltf_error(gltf.text, "nodes", index_of(node), message);
}

glm::dquat rotation_of(const GltfFile& gltf, int node, const std::vector<double>& xyzw) {
    const glm::dquat rotation(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = glm::length(rotation);
    if (length > 0.0 && std::isfinite(length)) return rotation / length;
    throw node_error(gltf, node, "its rotation is a quaternion of no length; [0, 0, 0, 1] is no rotation");
}

glm::dmat4 local_transform(const GltfFile& gltf, int index) {
    const tinygltf::Node& node = gltf.model.nodes[index_of(index)];
    const auto wrong_length = [&](const char* key, std::size_t wanted) {
        return node_error(gltf, index, std::string("its ") + key + " has not " + std::to_string(wanted) + " numbers");
    };
    glm::dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
        if (node.matrix.size() != 16) throw wrong_length("matrix", 16);
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[index_of(i)];
        return matrix;
    }
    if (!node.translation.empty()) {
        if (node.translation.size() != 3) throw wrong_length("translation", 3);
        matrix = glm::translate(matrix, glm::dvec3(node.translation[0], node.translation[1], node.translation[2]));
    }
    if (!node.rotation.empty()) {
        if (node.rotation.size() != 4) throw wrong_length("rotation", 4);
        matrix *= glm::mat4_cast(rotation_of(gltf, index, node.rotation));
    }
    if (!node.scale.empty()) {
        if (node.scale.size() != 3) throw wrong_length("scale", 3);
        matrix = glm::scale(matrix, glm::dvec3(node.scale[0], node.scale[1], node.scale[2]));
    }
    return matrix;
}

void check_affine(const GltfFile& gltf, const PlacedNode& placed) {
    const glm::dmat4& m = placed.world_from_node;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (std::abs(m[column][row]) <= kFarthestNode) continue;
            throw node_error(gltf, placed.node, "it stands beyond 1e30, or is scaled beyond that");
        }
        const double wanted = column == 3 ? 1.0 : 0.0;
        if (std::abs(m[column][3] - wanted) <= 1e-6) continue;
        throw node_error(gltf, placed.node,
                         "the last row of its matrix is not 0 0 0 1 (numbers stand column by column)");
    }
}

std::vector<int> roots_of(const GltfFile& gltf) {
    const tinygltf::Model& model = gltf.model;
    if (!model.scenes.empty()) {
        const int chosen = has_element(model.scenes, model.defaultScene) ? model.defaultScene : 0;
        return model.scenes[index_of(chosen)].nodes;
    }
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            if (has_element(model.nodes, child)) is_child[index_of(child)] = true;
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

}  // namespace

std::vector<PlacedNode> place_nodes(const GltfFile& gltf) {
    std::vector<PlacedNode> placed;
    std::vector<PlacedNode> waiting;  // the space is the parent's; no recursion: a chain may be long
    std::vector<bool> seen(gltf.model.nodes.size(), false);
    const auto push_reversed = [&](const std::vector<int>& nodes, const glm::dmat4& space) {
        for (std::size_t i = nodes.size(); i-- > 0;) waiting.push_back({nodes[i], space});
    };
    push_reversed(roots_of(gltf), glm::dmat4(1.0));
    while (!waiting.empty()) {
        PlacedNode next = waiting.back();
        waiting.pop_back();
        if (!has_element(gltf.model.nodes, next.node)) {
            throw UserError(Place{gltf.text.json.file}, "its scene names node " + std::to_string(next.node) + " of " +
                                                            std::to_string(gltf.model.nodes.size()));
        }
        if (seen[index_of(next.node)]) throw node_error(gltf, next.node, "stands in the tree of nodes twice");
        seen[index_of(next.node)] = true;
        next.world_from_node = next.world_from_node * local_transform(gltf, next.node);
        check_affine(gltf, next);
        placed.push_back(next);
        push_reversed(gltf.model.nodes[index_of(next.node)].children, next.world_from_node);
    }
    return placed;
}

}  // namespace kreda::scene
