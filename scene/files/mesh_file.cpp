// From an OBJ file to a mesh (a glTF file goes its own way): read and scan the text, let the library parse it,
// triangulate, find normals, share vertices.
#include "scene/files/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "raster/normals.hpp"
#include "raster/platform.hpp"
#include "raster/polygon.hpp"
#include "scene/files/gltf_file.hpp"
#include "scene/files/gltf_text.hpp"
#include "scene/files/mtl_file.hpp"
#include "scene/files/obj_centre.hpp"
#include "scene/files/obj_polygons.hpp"
#include "scene/files/obj_scan.hpp"

namespace kreda::scene {

namespace {

struct Triangles {
    std::vector<ObjCorner> corners;               // three a triangle
    std::vector<std::uint32_t> smoothing_groups;  // one a triangle
    std::vector<raster::MeshPart> parts;
};

// ---- materials -------------------------------------------------------------------------------------------------

struct MaterialReader {
    const ObjText& obj;
    NamedFileLimits limits;
    ObjWarnings warnings;
    MtlMaterials materials;

    void add(const ObjName& library, const std::string& name) {
        const std::string path = find_named_file(obj, library.offset, name, limits, "material file", "", warnings);
        if (!path.empty()) add_mtl(read_obj_text(path), limits, materials);
    }
};

/// `mtllib wood and steel.mtl` may be one file or three: one if there is such a file.
void read_material_file(const ObjName& library, MaterialReader& reader) {
    std::string name = library.name;
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    if (name.empty()) return reader.warnings.add("mtllib without a file", library.offset, "mtllib names no file");
    const std::string whole = resolve_named_path(reader.obj, library.offset, name, reader.limits).path;
    if (!whole.empty() || name.find_first_of(" \t") == std::string::npos) return reader.add(library, name);
    std::istringstream words(name);
    for (std::string word; words >> word;) reader.add(library, word);
}

/// What a name may mean that no material has: quotes and comments are no part of it, and capitals may differ. "":
/// nothing.
std::string nearly_same_name(const MtlMaterials& materials, const std::string& name) {
    const auto plain = [](std::string word) {
        if (word.size() > 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
        return in_lower_case(without_comment(word));
    };
    std::string found;
    for (const auto& [known, index] : materials.index_of_name) {
        if (plain(known) == plain(name) && (found.empty() || known < found)) found = known;
    }
    return found;
}

/// Materials that faces use and that are in no MTL: those of nearly the same name are used instead.
void settle_missing(const ObjScan& scan, MaterialReader& reader) {
    std::vector<std::string> names;
    for (const lighting::Material& material : reader.materials.materials) names.push_back(material.name);
    constexpr const char* kLost = "materials that are in no MTL file";
    for (const ObjName& used : scan.materials) {
        if (reader.materials.index_of_name.contains(used.name)) continue;
        const std::string other = nearly_same_name(reader.materials, used.name);
        const bool is_shown = other.empty() && !reader.warnings.has_enough_of(kLost);
        const std::string near = is_shown ? nearest_word(used.name, names) : "";  // as slow as there are names
        const std::string remedy = !other.empty()  ? "; " + token_in_quotes(other) + " is used instead"
                                   : !near.empty() ? "; did you mean " + token_in_quotes(near) + "?"
                                                   : "";
        if (!other.empty()) reader.materials.index_of_name[used.name] = reader.materials.index_of_name[other];
        reader.warnings.add(kLost, used.offset,
                            "the material " + token_in_quotes(used.name) + " is in no MTL file" + remedy);
    }
}

MtlMaterials read_materials(const ObjText& obj, const ObjScan& scan, bool allow_outside) {
    MaterialReader reader{obj, {folder_of(obj.file), allow_outside}, ObjWarnings(obj), {}};
    for (const ObjName& library : scan.material_files) read_material_file(library, reader);
    settle_missing(scan, reader);
    const std::vector<std::string> lines = reader.warnings.lines();
    reader.materials.warnings.insert(reader.materials.warnings.begin(), lines.begin(), lines.end());
    return std::move(reader.materials);
}

// ---- triangles -------------------------------------------------------------------------------------------------

/// A triangle with a corner twice covers nothing and has no plane; other degenerate ones are the rasterizer's to count.
bool has_corner_twice(const ObjCorner& a, const ObjCorner& b, const ObjCorner& c) {
    return a.position == b.position || b.position == c.position || c.position == a.position;
}

struct Triangulation {
    Triangles triangles;
    std::size_t bad_polygons = 0;
    std::size_t first_bad_offset = 0;
};

void add_polygon(const ObjPolygons& obj, std::size_t polygon, const ObjFaceOrigin& origin, Triangulation& out) {
    const std::size_t first = obj.first_corner[polygon];
    const std::span<const ObjCorner> corners =
        std::span(obj.corners).subspan(first, obj.first_corner[polygon + 1] - first);
    PolygonTriangles cut{{0, 1, 2}, true};
    if (corners.size() > 3) {
        std::vector<glm::vec3> outline;
        for (const ObjCorner& corner : corners) outline.push_back(obj.positions[std::size_t(corner.position)]);
        cut = triangulate_polygon(outline);
    }
    if (!cut.area_agrees && out.bad_polygons++ == 0) out.first_bad_offset = origin.offset;
    for (std::size_t i = 0; i < cut.corners.size(); i += 3) {
        const ObjCorner &a = corners[cut.corners[i]], &b = corners[cut.corners[i + 1]],
                        &c = corners[cut.corners[i + 2]];
        if (has_corner_twice(a, b, c)) continue;
        out.triangles.corners.insert(out.triangles.corners.end(), {a, b, c});
        out.triangles.smoothing_groups.push_back(origin.smoothing_group);
    }
}

std::uint32_t count(const Triangles& triangles) {
    return static_cast<std::uint32_t>(triangles.smoothing_groups.size());
}

int material_index(const MtlMaterials& materials, const std::string& name) {
    const auto found = materials.index_of_name.find(name);
    return found == materials.index_of_name.end() ? -1 : found->second;
}

Triangulation triangulate(const ObjPolygons& obj, const ObjScan& scan, const MtlMaterials& materials) {
    Triangulation out;
    for (std::size_t i = 0; i < obj.runs.size(); ++i) {
        const ObjRun& run = obj.runs[i];
        const std::size_t end = i + 1 < obj.runs.size() ? obj.runs[i + 1].first_polygon : scan.faces.size();
        raster::MeshPart part{run.name, count(out.triangles), 0, material_index(materials, run.material)};
        for (std::size_t p = run.first_polygon; p < end; ++p) add_polygon(obj, p, scan.faces[p], out);
        part.triangle_count = count(out.triangles) - part.first_triangle;
        if (part.triangle_count > 0) out.triangles.parts.push_back(part);
    }
    return out;
}

// ---- vertices --------------------------------------------------------------------------------------------------

struct CornerOfPart {
    ObjCorner corner;
    std::uint32_t part = 0;
    bool operator==(const CornerOfPart&) const = default;
};

struct CornerHash {
    std::size_t operator()(const CornerOfPart& key) const {
        const ObjCorner& c = key.corner;
        std::uint64_t h = std::uint64_t{key.part} << 32 | static_cast<std::uint32_t>(c.position);
        h = h * 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(c.uv);
        h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u + static_cast<std::uint32_t>(c.normal);
        h = (h ^ (h >> 32)) * 0x94d049bb133111ebu;
        return h ^ (h >> 29);
    }
};

/// One vertex for each different corner of a part, in the order of first use; what no triangle uses is left out. No
/// vertex belongs to two parts, because parts differ in their material: Gouraud lights each vertex with one.
raster::Mesh share_vertices(const ObjPolygons& obj, const Triangles& triangles) {
    const auto has = [&](int ObjCorner::*index) {
        return std::any_of(triangles.corners.begin(), triangles.corners.end(),
                           [&](const ObjCorner& c) { return c.*index >= 0; });
    };
    const bool has_uvs = has(&ObjCorner::uv), has_normals = has(&ObjCorner::normal);
    raster::Mesh mesh;
    mesh.parts = triangles.parts;
    mesh.indices.reserve(triangles.corners.size());
    std::unordered_map<CornerOfPart, std::uint32_t, CornerHash> vertex_of_corner;
    vertex_of_corner.reserve(obj.positions.size());
    for (std::uint32_t p = 0; p < mesh.parts.size(); ++p) {
        const raster::MeshPart& part = mesh.parts[p];
        const auto corners = std::span(triangles.corners).subspan(3 * std::size_t(part.first_triangle));
        for (const ObjCorner& c : corners.first(3 * std::size_t(part.triangle_count))) {
            const auto [vertex, is_new] =
                vertex_of_corner.try_emplace({c, p}, static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.indices.push_back(vertex->second);
            if (!is_new) continue;
            mesh.positions.push_back(obj.positions[std::size_t(c.position)]);
            if (has_uvs) mesh.uvs.push_back(c.uv >= 0 ? obj.uvs[std::size_t(c.uv)] : glm::vec2(0.0f));
            if (has_normals) mesh.normals.push_back(obj.normals[std::size_t(c.normal)]);
        }
    }
    return mesh;
}

// ---- normals ---------------------------------------------------------------------------------------------------

/// Bring the file's normals to unit length. Those of no length become 0; returns how many.
std::size_t normalize_normals(std::vector<glm::vec3>& normals) {
    std::size_t bad = 0;
    for (glm::vec3& n : normals) {
        const double length = glm::length(glm::dvec3(n));
        const bool is_usable = std::isfinite(length) && length > 0.0;
        n = is_usable ? glm::vec3(glm::dvec3(n) / length) : glm::vec3(0.0f);
        bad += is_usable ? 0 : 1;
    }
    return bad;
}

/// Returns how many corners have no normal now.
std::size_t forget_normals(const ObjPolygons& obj, bool all, std::vector<ObjCorner>& corners) {
    std::size_t missing = 0;
    for (ObjCorner& corner : corners) {
        const bool is_usable = corner.normal >= 0 && obj.normals[std::size_t(corner.normal)] != glm::vec3(0.0f);
        if (all || !is_usable) corner.normal = -1;
        missing += corner.normal < 0 ? 1 : 0;
    }
    return missing;
}

/// Smooth normals for the corners without one, added to the file's: by the file's smoothing groups if it has any.
void make_missing_normals(const ObjScan& scan, const std::optional<float>& crease, ObjPolygons& obj,
                          Triangles& triangles) {
    Triangles bare = triangles;
    for (ObjCorner& corner : bare.corners) corner.normal = -1;
    raster::Mesh mesh = share_vertices(obj, bare);
    if (crease) {
        raster::make_smooth_normals(mesh, *crease);
    } else if (scan.has_smoothing_groups) {
        raster::make_smooth_normals_by_group(mesh, bare.smoothing_groups);
    } else {
        raster::make_smooth_normals_without_specks(mesh);
    }
    const std::size_t first_made = obj.normals.size();
    obj.normals.insert(obj.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
        int& normal = triangles.corners[i].normal;
        if (normal < 0) normal = static_cast<int>(first_made + mesh.indices[i]);
    }
}

raster::Mesh build_mesh(const ObjScan& scan, const MeshFileOptions& options, ObjPolygons& obj, Triangles& triangles,
                        std::vector<std::string>& warnings, const std::string& file) {
    const Normals normals = options.normals;
    const std::size_t unusable = normalize_normals(obj.normals);
    const std::size_t missing = forget_normals(obj, normals != Normals::file, triangles.corners);
    if (normals == Normals::file && unusable > 0) {
        warnings.push_back(
            UserError(Place{file}, std::to_string(unusable) + " normals have no length; smooth ones are used instead")
                .what());
    }
    if (normals == Normals::flat) {
        raster::Mesh mesh = share_vertices(obj, triangles);
        raster::make_flat_normals(mesh);
        return mesh;
    }
    if (missing > 0) make_missing_normals(scan, options.crease, obj, triangles);
    return share_vertices(obj, triangles);
}

}  // namespace

LoadedMesh load_mesh_file(const std::string& path, const MeshFileOptions& options) {
    const std::string other = other_format(path);
    if (!other.empty()) throw UserError(Place{path}, other);
    if (is_gltf_name(path)) return load_gltf_file(path, options);
    const ObjText text = read_obj_text(path);
    ObjScan scan = scan_obj(text);
    MtlMaterials materials = read_materials(text, scan, options.allow_outside);
    ObjPolygons obj = read_polygons(text, scan);
    const MeshFrame frame = keep_about_centre(scan, obj);
    Triangulation cut = triangulate(obj, scan, materials);
    if (count(cut.triangles) == 0) throw UserError(Place{path}, "holds no triangle; all its faces use a corner twice");

    LoadedMesh loaded;
    loaded.warnings = std::move(scan.warnings);
    loaded.warnings.insert(loaded.warnings.end(), materials.warnings.begin(), materials.warnings.end());
    if (cut.bad_polygons > 0) {
        loaded.warnings.push_back(
            warning_at(text, cut.first_bad_offset,
                       "this face crosses itself or has no area; such faces: " + std::to_string(cut.bad_polygons)));
    }
    loaded.mesh = build_mesh(scan, options, obj, cut.triangles, loaded.warnings, path);
    loaded.mesh.origin = frame.origin;
    loaded.mesh.unit = frame.unit;
    loaded.materials = std::move(materials.materials);
    return loaded;
}

}  // namespace kreda::scene
