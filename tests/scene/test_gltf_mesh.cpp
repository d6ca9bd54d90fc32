// Meshes of glTF files: every way to write a triangle, and where nodes place it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>

#include <doctest/doctest.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "raster/shapes.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/gltf_maker.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;

namespace {

using Indices = std::vector<std::uint32_t>;

/// The positions of the corners, triangle after triangle.
std::vector<glm::vec3> corners_of(const raster::Mesh& mesh) {
    std::vector<glm::vec3> corners;
    for (const std::uint32_t index : mesh.indices) corners.push_back(mesh.positions[index]);
    return corners;
}

/// Five points on a parabola, of which vertex i is at x = i; which vertices the triangles join, by their x.
Indices triangles_of_mode(int mode, const std::string& indices) {
    GltfMaker maker;
    std::vector<float> points;
    for (int i = 0; i < 5; ++i) points.insert(points.end(), {float(i), float(i * i), 0.0f});
    maker.add(points, kFloat, 3);
    std::string more = ",\"mode\":" + std::to_string(mode);
    if (indices == "bytes") {
        maker.add(std::vector<std::uint8_t>{0, 1, 2, 2, 3, 4}, kUnsignedByte, 1);
    } else if (indices == "shorts") {
        maker.add(std::vector<std::uint16_t>{0, 1, 2, 2, 3, 4}, kUnsignedShort, 1);
    } else if (indices == "ints") {
        maker.add(Indices{0, 1, 2, 2, 3, 4}, kUnsignedInt, 1);
    }
    if (!indices.empty()) more += ",\"indices\":1";
    Indices triangles;
    for (const glm::vec3& p : corners_of(load_gltf(maker.gltf(one_mesh(kPosition0 + more))).loaded.mesh))
        triangles.push_back(static_cast<std::uint32_t>(p.x));
    return triangles;
}

std::string numbers_text(const float* numbers, int count) {
    std::string text = "[";
    for (int i = 0; i < count; ++i) {
        char number[40];
        std::snprintf(number, sizeof number, "%.9g", double(numbers[i]));
        text += (i ? "," : "") + std::string(number);
    }
    return text + "]";
}

}  // namespace

TEST_CASE("gltf: a triangle by hand in both kinds of file") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    maker.add(std::vector<float>{0, 0, 1, 0, 0.25f, 0.75f}, kFloat, 2);
    const std::string rest =
        one_mesh("\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1}", "", "\"mesh\":0,\"name\":\"n\"");
    for (const bool binary : {false, true}) {
        const LoadedText read = binary ? load_gltf(maker.glb(rest), "a.glb") : load_gltf(maker.gltf(rest));
        const raster::Mesh& mesh = read.loaded.mesh;
        CHECK(read.warnings.empty());
        CHECK(corners_of(mesh) == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        CHECK(mesh.normals == std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));       // none given: each triangle's own
        CHECK(mesh.uvs == std::vector<glm::vec2>{{0, 1}, {1, 1}, {0.25f, 0.25f}});  // v from above becomes v from below
        REQUIRE(mesh.parts.size() == 1);
        CHECK(mesh.parts[0].name == "n");
        CHECK(mesh.parts[0].material == -1);
        CHECK(mesh.tangents.empty());
    }
}

TEST_CASE("gltf: lists and strips and fans join the vertices that the specification says") {
    for (const char* indices : {"bytes", "shorts", "ints"}) {
        CAPTURE(indices);
        CHECK(triangles_of_mode(4, indices) == Indices{0, 1, 2, 2, 3, 4});
        // 0 1 2 | 1 2 2 | 2 2 3 | 2 3 4: two have a corner twice and cover nothing
        CHECK(triangles_of_mode(5, indices) == Indices{0, 1, 2, 2, 4, 3});
    }
    CHECK(triangles_of_mode(4, "") == Indices{0, 1, 2});
    CHECK(triangles_of_mode(5, "") == Indices{0, 1, 2, 1, 3, 2, 2, 3, 4});
    CHECK(triangles_of_mode(6, "") == Indices{1, 2, 0, 2, 3, 0, 3, 4, 0});
}

TEST_CASE("gltf: numbers of every type and in every arrangement are the same numbers") {
    const auto uvs_of = [](GltfMaker& maker, int accessor) {
        const std::string uv = "\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":" + std::to_string(accessor) + "}";
        std::vector<glm::vec2> uvs = load_loose_gltf(maker.gltf(one_mesh(uv))).loaded.mesh.uvs;
        for (glm::vec2& t : uvs) t.y = 1.0f - t.y;
        return uvs;
    };
    const std::vector<glm::vec2> wanted = {{0, 1}, {1, 0}, {1, 1}};
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const std::string normalized = ",\"normalized\":true";
    const int floats = maker.add(std::vector<float>{0, 1, 1, 0, 1, 1}, kFloat, 2);
    const int bytes = maker.add(std::vector<std::uint8_t>{0, 255, 255, 0, 255, 255}, kUnsignedByte, 2, normalized);
    const int shorts =
        maker.add(std::vector<std::uint16_t>{0, 65535, 65535, 0, 65535, 65535}, kUnsignedShort, 2, normalized);
    const int plain = maker.add(std::vector<std::int8_t>{0, 1, 1, 0, 1, 1}, kByte, 2);
    const int plain_shorts = maker.add(std::vector<std::int16_t>{0, 1, 1, 0, 1, 1}, kShort, 2);
    const int signed_bytes = maker.add(std::vector<std::int8_t>{0, 127, 127, 0, 127, 127}, kByte, 2, normalized);
    std::string interleaved(3 * 12 + 4, '\x55');  // four bytes before, four behind each pair
    const float pairs[] = {0, 1, 1, 0, 1, 1};
    for (std::size_t i = 0; i < 3; ++i) std::memcpy(interleaved.data() + 4 + 12 * i, pairs + 2 * i, 8);
    const int view = maker.add_view(interleaved, 12);
    const int strided = maker.add_accessor(view, kFloat, "VEC2", 3, ",\"byteOffset\":4");
    for (const int accessor : {floats, bytes, shorts, plain, plain_shorts, signed_bytes, strided}) {
        CAPTURE(accessor);
        CHECK(uvs_of(maker, accessor) == wanted);
    }
}

TEST_CASE("gltf: signed shares end at -1 and sparse values replace others") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const int shares = maker.add(std::vector<std::int8_t>{-128, 0, -127, 0, 127, 0}, kByte, 2, ",\"normalized\":true");
    const std::string uv = "\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":" + std::to_string(shares) + "}";
    CHECK(load_loose_gltf(maker.gltf(one_mesh(uv))).loaded.mesh.uvs ==
          std::vector<glm::vec2>{{-1, 1}, {-1, 1}, {1, 1}});

    const std::uint16_t places[] = {2, 0};
    const float values[] = {7, 8, 9, 4, 5, 6};
    const int where = maker.add_view(std::string(reinterpret_cast<const char*>(places), sizeof places));
    const int what = maker.add_view(std::string(reinterpret_cast<const char*>(values), sizeof values));
    const std::string sparse = ",\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":" + std::to_string(where) +
                               ",\"componentType\":5123},\"values\":{\"bufferView\":" + std::to_string(what) + "}}";
    for (const bool has_base : {true, false}) {
        const int accessor = maker.add_accessor(has_base ? 0 : -1, kFloat, "VEC3", 3, sparse);
        const std::string position = "\"attributes\":{\"POSITION\":" + std::to_string(accessor) + "}";
        const glm::vec3 kept = has_base ? glm::vec3(1, 0, 0) : glm::vec3(0);
        CHECK(corners_of(load_loose_gltf(maker.gltf(one_mesh(position))).loaded.mesh) ==
              std::vector<glm::vec3>{{4, 5, 6}, kept, {7, 8, 9}});
    }
}

TEST_CASE("gltf: nodes stand where the product of their matrices puts them and mirrored ones keep their outside") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> some(-2.0f, 2.0f);
    for (int round = 0; round < 40; ++round) {
        float t[3], q[4], s[3], m[16];
        for (float* numbers : {t, s}) std::generate(numbers, numbers + 3, [&] { return some(random); });
        std::generate(q, q + 4, [&] { return some(random); });
        std::generate(m, m + 16, [&] { return some(random); });
        for (const int last : {3, 7, 11}) m[last] = 0.0f;
        m[15] = 1.0f;
        glm::dmat4 outer(1.0);
        for (int i = 0; i < 16; ++i) outer[i / 4][i % 4] = double(m[i]);
        const glm::dquat rotation = glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
        const glm::dmat4 inner = glm::translate(glm::dmat4(1.0), glm::dvec3(t[0], t[1], t[2])) *
                                 glm::mat4_cast(rotation) * glm::scale(glm::dmat4(1.0), glm::dvec3(s[0], s[1], s[2]));
        const glm::dmat4 world = outer * inner;
        GltfMaker maker;
        maker.add(kCorner, kFloat, 3);
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.4, 0.9));
        const std::vector<float> normal = {float(n.x), float(n.y), float(n.z)};
        std::vector<float> normals;
        for (int i = 0; i < 3; ++i) normals.insert(normals.end(), normal.begin(), normal.end());
        maker.add(normals, kFloat, 3);
        const std::string nodes =
            "\"scene\":1,\"scenes\":[{},{\"nodes\":[1]}],\"nodes\":[{\"mesh\":0,\"translation\":" + numbers_text(t, 3) +
            ",\"rotation\":" + numbers_text(q, 4) + ",\"scale\":" + numbers_text(s, 3) +
            "},{\"children\":[0],\"matrix\":" + numbers_text(m, 16) +
            "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}]}]";
        const raster::Mesh mesh = load_loose_gltf(maker.gltf(nodes)).loaded.mesh;
        const bool mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
        const std::vector<glm::vec3> corners = corners_of(mesh);
        const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = mirrored ? (3 - i) % 3 : i;
            const glm::dvec3 wanted(world * glm::dvec4(points[from], 1.0));
            CHECK(glm::distance(glm::dvec3(corners[i]), wanted) < 1e-5);  // coordinates up to 20 in float: 1e-6 each
        }
        // A normal stays perpendicular to what it was perpendicular to: the inverse transpose.
        const glm::dvec3 turned = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(world))) * n);
        CHECK(glm::distance(glm::dvec3(mesh.normals[0]), turned) < 1e-5);
        // Outside stays outside: +z, which the triangle faces, goes where normals go.
        const glm::dvec3 outside = glm::transpose(glm::inverse(glm::dmat3(world))) * glm::dvec3(0, 0, 1);
        const glm::dvec3 faces(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        CHECK(glm::dot(faces, outside) > 0.0);
    }
}

TEST_CASE("gltf: a mirrored tangent keeps its bitangent") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    maker.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, kFloat, 3);
    maker.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, kFloat, 4);
    maker.add(std::vector<float>{0, 1, 1, 1, 0, 0}, kFloat, 2);
    const std::string all =
        "\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3},\"material\":0";
    const std::string normal_map =
        ",\"materials\":[{\"normalTexture\":{\"index\":0}}],\"textures\":[{\"source\":0}],"
        "\"images\":[{\"uri\":\"data:image/png;base64,AAAA\"}]";
    const auto bitangent = [&](const std::string& node) {
        const raster::Mesh mesh = load_loose_gltf(maker.gltf(one_mesh(all, normal_map, node))).loaded.mesh;
        REQUIRE(mesh.tangents.size() == 3);
        return glm::cross(mesh.normals[0], glm::vec3(mesh.tangents[0])) * mesh.tangents[0].w;
    };
    CHECK(bitangent("\"mesh\":0") == glm::vec3(0, 1, 0));
    CHECK(bitangent("\"mesh\":0,\"scale\":[-1,1,1]") == glm::vec3(0, 1, 0));
    CHECK(bitangent("\"mesh\":0,\"scale\":[1,-2,1]") == glm::vec3(0, -1, 0));
    CHECK(bitangent("\"mesh\":0,\"scale\":[1,1,-1]") == glm::vec3(0, 1, 0));
}

TEST_CASE("gltf: the same geometry as OBJ and as glb is the same picture to the last bit") {
    raster::Mesh torus = *raster::make_shape("torus", 12);
    for (glm::vec2& uv : torus.uvs) uv = glm::round(uv * 256.0f) / 256.0f;  // 1 - (1 - v) is v then
    GltfMaker maker;
    std::string obj;
    std::vector<float> positions, normals, uvs;
    const auto line = [&](const char* key, const float* numbers, int count) {
        obj += key;
        for (int i = 0; i < count; ++i) {
            char number[40];
            std::snprintf(number, sizeof number, " %.9g", double(numbers[i]));
            obj += number;
        }
        obj += "\n";
    };
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
        const glm::vec3 p = torus.positions[i], n = torus.normals[i];
        const glm::vec2 t = torus.uvs[i];
        line("v", &p.x, 3);
        line("vn", &n.x, 3);
        line("vt", &t.x, 2);
        positions.insert(positions.end(), {p.x, p.y, p.z});
        normals.insert(normals.end(), {n.x, n.y, n.z});
        uvs.insert(uvs.end(), {t.x, 1.0f - t.y});
    }
    for (std::size_t i = 0; i < torus.indices.size(); i += 3) {
        obj += "f";
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string number = std::to_string(torus.indices[i + c] + 1);
            obj += " " + number + "/" + number + "/" + number;
        }
        obj += "\n";
    }
    maker.add(positions, kFloat, 3);
    maker.add(normals, kFloat, 3);
    maker.add(uvs, kFloat, 2);
    maker.add(torus.indices, kUnsignedInt, 1);
    const TempFolder folder;
    folder.write("a.obj", obj);
    folder.write("a.glb",
                 maker.glb(one_mesh("\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TEXCOORD_0\":2},\"indices\":3")));
    const auto picture = [&](const std::string& mesh) {
        const std::string text =
            "[image]\nsize = [48, 32]\n[camera]\nposition = [1, 2, 3]\n[[light]]\n[[object]]\nmesh = '" + mesh +
            "'\nrotate = [30, 10, 0]\n";
        return render(read_scene_text(text, "s.toml", folder.path.string()));
    };
    CHECK(load(folder, "a.glb").loaded.mesh.uvs == load(folder, "a.obj").loaded.mesh.uvs);
    const raster::Image of_obj = picture("a.obj"), of_glb = picture("a.glb");
    CHECK(std::any_of(of_obj.values.begin(), of_obj.values.end(), [](float v) { return v > 0.1f; }));
    CHECK(std::equal(of_obj.values.begin(), of_obj.values.end(), of_glb.values.begin(), of_glb.values.end()));
}

TEST_CASE("gltf: a mesh far from the origin keeps its shape") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const raster::Mesh mesh =
        load_gltf(maker.gltf(one_mesh(kPosition0, "", "\"mesh\":0,\"translation\":[1e7,-3e7,2.5e7]"))).loaded.mesh;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p = mesh.origin + mesh.unit * glm::dvec3(mesh.positions[i]);
        const glm::dvec3 wanted = glm::dvec3(1e7, -3e7, 2.5e7) + glm::dvec3(kCorner[3 * i], kCorner[3 * i + 1], 0);
        CHECK(glm::distance(p, wanted) < 1e-6);  // a float so far from 0 would round to 2
    }
}

TEST_CASE("gltf: of equal triangles one of each primitive is left, whether it has indices or none") {
    GltfMaker maker;
    std::vector<float> corners;
    for (int i = 0; i < 100; ++i) corners.insert(corners.end(), kCorner.begin(), kCorner.end());
    maker.add(corners, kFloat, 3);
    maker.add(std::vector<std::uint8_t>{0, 1, 2, 1, 2, 0, 2, 1, 0, 3, 4, 5}, kUnsignedByte, 1);
    const std::string two_primitives = one_mesh(kPosition0 + "},{" + kPosition0 + ",\"indices\":1");
    const LoadedText result = load_gltf(maker.gltf(two_primitives));
    CHECK(result.loaded.mesh.triangle_count() == 3);  // one, and one with its back
    REQUIRE(result.warnings.size() == 1);
    CHECK(result.warnings[0] == "a.gltf: 101 triangles have the corners of one before; each is drawn once");
}
