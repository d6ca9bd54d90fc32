// From an OBJ file to a mesh (a glTF file goes its own way): read and scan the text, triangulate, find normals, share
// vertices.
#include "scene/files/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <utility>

#include <glm/geometric.hpp>

#include "raster/normals.hpp"
#include "raster/platform.hpp"
#include "raster/polygon.hpp"
#include "scene/files/gltf_file.hpp"
#include "scene/files/gltf_text.hpp"
#include "scene/files/mtl_file.hpp"
#include "scene/files/obj_centre.hpp"
#include "scene/files/obj_scan.hpp"
#include "scene/files/repeated_triangles.hpp"
#include "scene/files/share_vertices.hpp"

namespace kreda::scene {

namespace {

// ---- materials -------------------------------------------------------------------------------------------------

struct MaterialReader {
    const ObjText& obj;
    NamedFileLimits limits;
    ObjWarnings warnings;
    MtlMaterials materials;

    void add(const ObjName& library, const std::string& name) {
        const std::string path = find_named_file(obj, library.offset, name, limits, "material file", "", warnings);
        if (path.empty()) return;
        limits.used->push_back(use_file(path));
        add_mtl(read_obj_text(path), limits, materials);
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

MtlMaterials read_materials(const ObjText& obj, const ObjScan& scan, bool allow_outside, std::vector<UsedFile>& used) {
    MaterialReader reader{obj, {folder_of(obj.file), allow_outside, &used}, ObjWarnings(obj), {}};
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
    CornerTriangles triangles;
    std::size_t bad_polygons = 0;
    std::size_t first_bad_offset = 0;
};

void add_triangle(const ObjCorner& a, const ObjCorner& b, const ObjCorner& c, std::uint32_t smoothing_group,
                  CornerTriangles& triangles) {
    if (has_corner_twice(a, b, c)) return;
    triangles.corners.insert(triangles.corners.end(), {a, b, c});
    triangles.smoothing_groups.push_back(smoothing_group);
}

void add_polygon(std::span<const ObjCorner> corners, const MeshArrays& arrays, const ObjFace& face,
                 Triangulation& out) {
    if (corners.size() == 3) {
        return add_triangle(corners[0], corners[1], corners[2], face.smoothing_group, out.triangles);
    }
    std::vector<glm::vec3> outline;
    for (const ObjCorner& corner : corners) outline.push_back(arrays.positions[std::size_t(corner.position)]);
    const PolygonTriangles cut = triangulate_polygon(outline);
    if (!cut.area_agrees && out.bad_polygons++ == 0) out.first_bad_offset = face.offset;
    for (std::size_t i = 0; i < cut.corners.size(); i += 3) {
        add_triangle(corners[cut.corners[i]], corners[cut.corners[i + 1]], corners[cut.corners[i + 2]],
                     face.smoothing_group, out.triangles);
    }
}

std::uint32_t count(const CornerTriangles& triangles) {
    return static_cast<std::uint32_t>(triangles.smoothing_groups.size());
}

int material_index(const MtlMaterials& materials, const std::string& name) {
    const auto found = materials.index_of_name.find(name);
    return found == materials.index_of_name.end() ? -1 : found->second;
}

std::span<const ObjCorner> corners_of(const ObjScan& scan, std::size_t face) {
    const std::size_t first = scan.faces[face].first_corner;
    const bool is_last = face + 1 == scan.faces.size();
    const std::size_t end = is_last ? scan.corners.size() : scan.faces[face + 1].first_corner;
    return std::span(scan.corners).subspan(first, end - first);
}

Triangulation triangulate(const ObjScan& scan, const MeshArrays& arrays, const MtlMaterials& materials) {
    Triangulation out;
    out.triangles.corners.reserve(scan.corners.size());
    out.triangles.smoothing_groups.reserve(scan.faces.size());
    for (std::size_t i = 0; i < scan.runs.size(); ++i) {
        const ObjRun& run = scan.runs[i];
        const std::size_t end = i + 1 < scan.runs.size() ? scan.runs[i + 1].first_face : scan.faces.size();
        raster::MeshPart part{run.name, count(out.triangles), 0, material_index(materials, run.material)};
        for (std::size_t f = run.first_face; f < end; ++f) {
            add_polygon(corners_of(scan, f), arrays, scan.faces[f], out);
        }
        part.triangle_count = count(out.triangles) - part.first_triangle;
        if (part.triangle_count > 0) out.triangles.parts.push_back(part);
    }
    return out;
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
std::size_t forget_normals(const MeshArrays& arrays, bool all, std::vector<ObjCorner>& corners) {
    std::size_t missing = 0;
    for (ObjCorner& corner : corners) {
        const bool is_usable = corner.normal >= 0 && arrays.normals[std::size_t(corner.normal)] != glm::vec3(0.0f);
        if (all || !is_usable) corner.normal = -1;
        missing += corner.normal < 0 ? 1 : 0;
    }
    return missing;
}

/// Smooth normals for the corners without one, added to the file's: by the file's smoothing groups if it has any.
void make_missing_normals(bool has_smoothing_groups, const std::optional<float>& crease, MeshArrays& arrays,
                          CornerTriangles& triangles) {
    CornerTriangles bare = triangles;
    for (ObjCorner& corner : bare.corners) corner.normal = -1;
    raster::Mesh mesh = share_vertices(arrays, bare);
    if (crease) {
        raster::make_smooth_normals(mesh, *crease);
    } else if (has_smoothing_groups) {
        raster::make_smooth_normals_by_group(mesh, bare.smoothing_groups);
    } else {
        raster::make_smooth_normals_without_specks(mesh);
    }
    const std::size_t first_made = arrays.normals.size();
    arrays.normals.insert(arrays.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
        int& normal = triangles.corners[i].normal;
        if (normal < 0) normal = static_cast<int>(first_made + mesh.indices[i]);
    }
}

/// The mesh, each triangle once: what is in the file again is left out with a warning.
raster::Mesh share_different(const MeshArrays& arrays, const CornerTriangles& triangles,
                             std::vector<std::string>& warnings, const std::string& file) {
    raster::Mesh mesh = share_vertices(arrays, triangles);
    const std::string repeated = warning_of_repeated(drop_repeated_triangles(mesh), file);
    if (!repeated.empty()) warnings.push_back(repeated);
    return mesh;
}

raster::Mesh build_mesh(bool has_smoothing_groups, const MeshFileOptions& options, MeshArrays& arrays,
                        CornerTriangles& triangles, std::vector<std::string>& warnings, const std::string& file) {
    const Normals normals = options.normals;
    const std::size_t unusable = normalize_normals(arrays.normals);
    const std::size_t missing = forget_normals(arrays, normals != Normals::file, triangles.corners);
    if (normals == Normals::file && unusable > 0) {
        warnings.push_back(
            UserError(Place{file}, std::to_string(unusable) + " normals have no length; smooth ones are used instead")
                .what());
    }
    if (normals == Normals::flat) {
        raster::Mesh mesh = share_different(arrays, triangles, warnings, file);
        raster::make_flat_normals(mesh);
        return mesh;
    }
    if (missing > 0) make_missing_normals(has_smoothing_groups, options.crease, arrays, triangles);
    return share_different(arrays, triangles, warnings, file);
}

}  // namespace

LoadedMesh load_mesh_file(const std::string& path, const MeshFileOptions& options) {
    const std::string other = other_format(path);
    if (!other.empty()) throw UserError(Place{path}, other);
    if (is_gltf_name(path)) return load_gltf_file(path, options);
    const ObjText text = read_obj_text(path);
    ObjScan scan = scan_obj(text);
    LoadedMesh loaded;
    MtlMaterials materials = read_materials(text, scan, options.allow_outside, loaded.other_files);
    MeshArrays arrays{{}, std::move(scan.uvs), std::move(scan.normals)};
    const MeshFrame frame = keep_about_centre(scan, arrays.positions);
    Triangulation cut = triangulate(scan, arrays, materials);
    if (count(cut.triangles) == 0) throw UserError(Place{path}, "holds no triangle; all its faces use a corner twice");

    loaded.warnings = std::move(scan.warnings);
    loaded.warnings.insert(loaded.warnings.end(), materials.warnings.begin(), materials.warnings.end());
    if (cut.bad_polygons > 0) {
        loaded.warnings.push_back(
            warning_at(text, cut.first_bad_offset,
                       "this face crosses itself or has no area; such faces: " + std::to_string(cut.bad_polygons)));
    }
    loaded.mesh = build_mesh(scan.has_smoothing_groups, options, arrays, cut.triangles, loaded.warnings, path);
    loaded.mesh.origin = frame.origin;
    loaded.mesh.unit = frame.unit;
    loaded.materials = std::move(materials.materials);
    return loaded;
}

}  // namespace kreda::scene
