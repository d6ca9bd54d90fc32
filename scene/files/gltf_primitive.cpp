#include "scene/files/gltf_primitive.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "raster/normals.hpp"
#include "scene/files/gltf_accessor.hpp"

namespace kreda::scene {

namespace {

/// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

template <class Vector>
std::vector<Vector> read_vectors(const GltfFile& gltf, int accessor, const std::string& what) {
    constexpr int kComponents = Vector::length();
    const std::vector<float> floats = read_floats(gltf, accessor, kComponents, what);
    std::vector<Vector> vectors(floats.size() / static_cast<std::size_t>(kComponents));
    for (std::size_t i = 0; i < floats.size(); ++i)
        vectors[i / kComponents][static_cast<int>(i % kComponents)] = floats[i];
    return vectors;
}

template <class Vector>
bool is_finite(const Vector& v) {
    for (int c = 0; c < Vector::length(); ++c) {
        if (!std::isfinite(v[c])) return false;
    }
    return true;
}

std::vector<glm::vec3> read_positions(const GltfFile& gltf, const tinygltf::Primitive& primitive) {
    const int accessor = attribute(primitive, "POSITION");
    if (accessor < 0) throw UserError(Place{gltf.text.json.file}, "a primitive has no POSITION");
    std::vector<glm::vec3> positions = read_vectors<glm::vec3>(gltf, accessor, "POSITION");
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (is_finite(positions[i])) continue;
        throw gltf_error(gltf.text, "accessors", static_cast<std::size_t>(accessor),
                         "POSITION " + std::to_string(i) + " is no finite number");
    }
    return positions;
}

/// An attribute with one entry a vertex; the vertices are counted first, so that no memory is asked for in vain.
template <class Vector>
std::vector<Vector> read_attribute(const GltfFile& gltf, const tinygltf::Primitive& primitive, const std::string& name,
                                   std::size_t vertices) {
    const int accessor = attribute(primitive, name);
    if (accessor < 0) return {};
    if (element_count(gltf, accessor, name) != vertices) {
        throw gltf_error(gltf.text, "accessors", static_cast<std::size_t>(accessor),
                         name + " has " + std::to_string(element_count(gltf, accessor, name)) + " entries for " +
                             std::to_string(vertices) + " vertices");
    }
    return read_vectors<Vector>(gltf, accessor, name);
}

/// The corners in the order of the file: indices, or the vertices one after another.
std::vector<std::uint32_t> read_corners(const GltfFile& gltf, const tinygltf::Primitive& primitive,
                                        std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
        corners.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) corners[i] = static_cast<std::uint32_t>(i);
        return corners;
    }
    corners = read_indices(gltf, primitive.indices, "indices");
    for (const std::uint32_t corner : corners) {
        if (corner < vertices) continue;
        throw gltf_error(gltf.text, "accessors", static_cast<std::size_t>(primitive.indices),
                         "names vertex " + std::to_string(corner) + " of " + std::to_string(vertices));
    }
    return corners;
}

/// Strip:  (i, i + 1, i + 2), the second two swapped where i is odd.   Fan:  (i + 1, i + 2, 0).
/// glTF 2.0 specification, section 3.7.2.1
std::vector<std::uint32_t> triangles_of(int mode, const std::vector<std::uint32_t>& c) {
    std::vector<std::uint32_t> triangles;
    const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        if (p != q && q != r && r != p) triangles.insert(triangles.end(), {p, q, r});
    };
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        for (std::size_t i = 0; i + 2 < c.size(); i += 3) add(c[i], c[i + 1], c[i + 2]);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < c.size(); ++i) add(c[i], c[i + 1 + i % 2], c[i + 2 - i % 2]);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        for (std::size_t i = 0; i + 2 < c.size(); ++i) add(c[i + 1], c[i + 2], c[0]);
    }
    return triangles;
}

/// Bring normals to unit length; returns how many have none.
std::size_t normalize(std::vector<glm::vec3>& normals) {
    std::size_t bad = 0;
    for (glm::vec3& n : normals) {
        const double length = glm::length(glm::dvec3(n));
        const bool is_usable = std::isfinite(length) && length > 0.0;
        if (is_usable) n = glm::vec3(glm::dvec3(n) / length);
        bad += is_usable ? 0 : 1;
    }
    return bad;
}

/// Tangents of no length or number leave the whole attribute out: the renderer makes its own.
std::vector<glm::vec4> usable_tangents(std::vector<glm::vec4> tangents) {
    for (const glm::vec4& t : tangents) {
        if (!is_finite(t) || glm::length(glm::vec3(t)) == 0.0f) return {};
    }
    return tangents;
}

void name_left_out(const tinygltf::Primitive& primitive, LeftOut& left_out) {
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) left_out.add("points and lines");
    if (attribute(primitive, "COLOR_0") >= 0) left_out.add("colours of vertices (COLOR_0)");
    if (!primitive.targets.empty()) left_out.add("morph targets");
    if (primitive.extensions.contains("KHR_materials_variants")) left_out.add("material variants");
    for (const auto& [name, value] : primitive.extensions) {
        if (name != "KHR_materials_variants") left_out.add(on_one_line(name));
    }
}

}  // namespace

GltfPrimitive read_gltf_primitive(const GltfFile& gltf, const tinygltf::Primitive& primitive,
                                  const GltfMaterials& materials, LeftOut& left_out) {
    name_left_out(primitive, left_out);
    GltfPrimitive read;
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) return read;
    if (primitive.material >= 0 && !has_element(materials.materials, primitive.material)) {
        throw UserError(Place{gltf.text.json.file}, "a primitive names material " + std::to_string(primitive.material) +
                                                        " of " + std::to_string(materials.materials.size()));
    }
    read.material = primitive.material;
    raster::Mesh& mesh = read.mesh;
    mesh.positions = read_positions(gltf, primitive);
    const std::size_t vertices = mesh.positions.size();
    mesh.indices = triangles_of(primitive.mode, read_corners(gltf, primitive, vertices));
    mesh.parts = {{"", 0, mesh.triangle_count(), primitive.material}};
    mesh.normals = read_attribute<glm::vec3>(gltf, primitive, "NORMAL", vertices);
    mesh.tangents = usable_tangents(read_attribute<glm::vec4>(gltf, primitive, "TANGENT", vertices));
    const GltfUv how = primitive.material >= 0 ? materials.uv[static_cast<std::size_t>(primitive.material)] : GltfUv{};
    mesh.uvs = read_attribute<glm::vec2>(gltf, primitive, "TEXCOORD_" + std::to_string(how.set), vertices);
    for (glm::vec2& uv : mesh.uvs) uv = uv_of(how, is_finite(uv) ? uv : glm::vec2(0.0f));
    read.bad_normals = normalize(mesh.normals);
    if (mesh.normals.empty() || read.bad_normals > 0) {
        mesh.tangents.clear();  // they belong to the normals
        raster::make_flat_normals(mesh);
    }
    return read;
}

}  // namespace kreda::scene
