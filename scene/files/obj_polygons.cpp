#include "scene/files/obj_polygons.hpp"

#include <cmath>
#include <istream>
#include <streambuf>

#include <tiny_obj_loader.h>

#include "raster/platform.hpp"

namespace kreda::scene {

namespace {

/// The library reads a stream; this one reads a string where it is, without a copy.
struct StringView : std::streambuf {
    explicit StringView(const std::string& text) {
        char* const first = const_cast<char*>(text.data());
        setg(first, first, first + text.size());
    }
};

/// The library's object while it reads. It calls the functions below for each statement, with itself as `user_data`.
/// Its other interface is not used: it keeps the corners of a face in a byte, and so loses every 256.
struct Reader {
    const ObjText& text;
    ObjPolygons polygons;
    ObjRun run;
};

Reader& reader_of(void* user_data) {
    return *static_cast<Reader*>(user_data);
}

/// The library's own number parser can still overflow where the scan did not, on numbers like 0e999.
void check_finite(const Reader& reader, float a, float b, float c, const char* what, std::size_t number) {
    if (std::isfinite(a) && std::isfinite(b) && std::isfinite(c)) return;
    throw UserError(Place{reader.text.file}, std::string(what) + " " + std::to_string(number) + " is not finite");
}

void on_position(void* user_data, float x, float y, float z, float) {
    Reader& reader = reader_of(user_data);
    reader.polygons.positions.emplace_back(x, y, z);
    check_finite(reader, x, y, z, "position (v)", reader.polygons.positions.size());
}

void on_uv(void* user_data, float u, float v, float) {
    Reader& reader = reader_of(user_data);
    reader.polygons.uvs.emplace_back(u, v);
    check_finite(reader, u, v, 0.0f, "texture coordinate (vt)", reader.polygons.uvs.size());
}

void on_normal(void* user_data, float x, float y, float z) {
    reader_of(user_data).polygons.normals.emplace_back(x, y, z);
}

/// Indices count from 1, negative ones from the last element back; 0 is the library's word for none.
int from_zero(int index, std::size_t count) {
    if (index > 0) return index - 1;
    return index == 0 ? -1 : static_cast<int>(count) + index;
}

void on_face(void* user_data, tinyobj::index_t* indices, int count) {
    Reader& reader = reader_of(user_data);
    ObjPolygons& polygons = reader.polygons;
    if (polygons.runs.empty() || polygons.runs.back().name != reader.run.name ||
        polygons.runs.back().material != reader.run.material) {
        polygons.runs.push_back({reader.run.name, reader.run.material, polygons.first_corner.size() - 1});
    }
    for (int i = 0; i < count; ++i) {
        polygons.corners.push_back({from_zero(indices[i].vertex_index, polygons.positions.size()),
                                    from_zero(indices[i].texcoord_index, polygons.uvs.size()),
                                    from_zero(indices[i].normal_index, polygons.normals.size())});
    }
    polygons.first_corner.push_back(polygons.corners.size());
}

/// The scan has checked every index: of those that are nowhere it has told the user. The rest holds even if the library
/// reads a token differently.
void check_corners(const ObjText& text, ObjPolygons& polygons) {
    const auto is_within = [](int index, int least, std::size_t count) {
        return index >= least && (index < 0 || static_cast<std::size_t>(index) < count);
    };
    const bool has_uvs = !polygons.uvs.empty();
    for (ObjCorner& corner : polygons.corners) {
        if (!is_within(corner.normal, -1, polygons.normals.size())) corner.normal = -1;
        if (!has_uvs) corner.uv = -1;
        if (is_within(corner.position, 0, polygons.positions.size()) && is_within(corner.uv, -1, polygons.uvs.size())) {
            continue;
        }
        throw UserError(Place{text.file}, "a face's index was misread; write its corners as v, v/vt, v//vn or v/vt/vn");
    }
}

void on_material(void* user_data, const char* name, int) {
    reader_of(user_data).run.material = name;
}

void on_object(void* user_data, const char* name) {
    reader_of(user_data).run.name = name;
}

/// A face may be in several groups: their names become one, as in the file.
void on_group(void* user_data, const char** names, int count) {
    std::string& name = reader_of(user_data).run.name;
    name.clear();
    for (int i = 0; i < count; ++i) name.append(i > 0 ? " " : "").append(names[i]);
}

}  // namespace

ObjPolygons read_polygons(const ObjText& text, const ObjScan& scan) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = on_position;
    callbacks.texcoord_cb = on_uv;
    callbacks.normal_cb = on_normal;
    callbacks.index_cb = on_face;
    callbacks.usemtl_cb = on_material;
    callbacks.object_cb = on_object;
    callbacks.group_cb = on_group;

    Reader reader{text, {}, {}};
    reader.polygons.first_corner.push_back(0);
    StringView buffer(scan.statements);
    std::istream stream(&buffer);
    std::string warnings, errors;
    const bool is_read = tinyobj::LoadObjWithCallback(stream, callbacks, &reader, nullptr, &warnings, &errors);
    if (!is_read || !errors.empty()) throw UserError(Place{text.file}, "cannot be read: " + errors);
    KREDA_EXPECT(reader.polygons.first_corner.size() == scan.faces.size() + 1);
    check_corners(text, reader.polygons);
    return std::move(reader.polygons);
}

}  // namespace kreda::scene
