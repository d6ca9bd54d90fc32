// glTF files that are wrong, on purpose or by damage: one line with the place, never a crash.
#include <cmath>
#include <filesystem>
#include <random>

#include <sys/stat.h>

#include <doctest/doctest.h>

#include "tests/scene/gltf_maker.hpp"
#include "tests/scene/raw_png.hpp"

using namespace kreda;
using namespace kreda::scene;
using namespace kreda::tests;

namespace {

/// A file with a bit of everything, for damage.
GltfMaker rich_maker(std::string& rest) {
    GltfMaker maker;
    maker.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, kFloat, 3);
    maker.add(std::vector<std::uint16_t>{0, 1, 2, 1, 3, 2}, kUnsignedShort, 1);
    maker.add(std::vector<std::uint8_t>{0, 0, 255, 0, 0, 255, 255, 255}, kUnsignedByte, 2, ",\"normalized\":true");
    const int view = maker.add_view(one_pixel_png(8, 2, "\x33\x66\xcc"));
    const std::uint8_t place = 3;
    const int where = maker.add_view(std::string(1, char(place)));
    const float value[] = {1, 2, 3};
    const int what = maker.add_view(std::string(reinterpret_cast<const char*>(value), sizeof value));
    maker.add_accessor(0, kFloat, "VEC3", 4,
                       ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":" + std::to_string(where) +
                           ",\"componentType\":5121},\"values\":{\"bufferView\":" + std::to_string(what) + "}}");
    rest =
        "\"scene\":0,\"scenes\":[{\"nodes\":[0,2]}],\n\"nodes\":[{\"children\":[1],\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,"
        "5,6,7,1]},"
        "{\"mesh\":0,\"translation\":[1,2,3],\"rotation\":[0,0,0,1],\"scale\":[1,-1,2]},"
        "{\"mesh\":0,\"camera\":0,\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}],\n"
        "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.7,\"znear\":0.1}}],\n"
        "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\",\"spot\":{\"outerConeAngle\":0.7}}]}},"
        "\n"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":2},\"indices\":1,\"material\":0},"
        "{\"attributes\":{\"POSITION\":3},\"mode\":5}]}],\n"
        "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_"
        "transform\":"
        "{\"offset\":[0.5,0],\"rotation\":1,\"scale\":[2,2]}}},\"roughnessFactor\":0.5},\"emissiveFactor\":[1,1,1]}],\n"
        "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"magFilter\":9728,\"wrapS\":33071}],\n"
        "\"images\":[{\"mimeType\":\"image/png\",\"bufferView\":" +
        std::to_string(view) + "}]";
    return maker;
}

/// Whatever the bytes are: an error of one line, or a mesh that can be drawn.
void check_survives(const TempFolder& folder, const std::string& name, const std::string& bytes) {
    folder.write(name, bytes);
    try {
        const LoadedMesh loaded = load_mesh_file(folder.file(name));
        REQUIRE(loaded.mesh.indices.size() >= 3);
        for (const std::uint32_t index : loaded.mesh.indices) REQUIRE(index < loaded.mesh.positions.size());
        for (const glm::vec3& p : loaded.mesh.positions) REQUIRE(std::isfinite(p.x + p.y + p.z));
        for (const glm::vec3& n : loaded.mesh.normals) REQUIRE(std::isfinite(n.x + n.y + n.z));
        REQUIRE(loaded.mesh.normals.size() == loaded.mesh.positions.size());
        REQUIRE((loaded.mesh.uvs.empty() || loaded.mesh.uvs.size() == loaded.mesh.positions.size()));
    } catch (const UserError& error) { REQUIRE(std::string(error.what()).find('\n') == std::string::npos); }
}

}  // namespace

TEST_CASE("gltf errors: numbers that lead out of the file are told with their place") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    maker.add(std::vector<std::uint8_t>{0, 1, 3}, kUnsignedByte, 1);
    const auto accessor = [&](const std::string& more, std::size_t count = 3, const char* type = "VEC3", int view = 0) {
        GltfMaker changed = maker;
        const int number = changed.add_accessor(view, kFloat, type, count, more);
        return error_of_gltf(changed.gltf(one_mesh("\"attributes\":{\"POSITION\":" + std::to_string(number) + "}")));
    };
    CHECK(has(accessor("", 4), "a.gltf:7:1: accessors[2]: 4 elements of 12 bytes from byte 0 on do not lie in the 36"));
    CHECK(has(accessor(",\"byteOffset\":4"), "accessors[2]: 3 elements"));
    CHECK(has(accessor(",\"byteOffset\":18446744073709551612"), "from byte 18446744073709551612 on do not lie"));
    CHECK(has(accessor("", std::size_t(1) << 62), "elements, more than there are bytes for them"));
    CHECK(has(accessor("", std::size_t(1) << 62, "VEC3", -1), "elements, more than there are bytes for them"));
    CHECK(has(accessor("", 0), "has no elements"));
    CHECK(has(accessor("", 3, "VEC2"), "has no elements of 3 numbers"));
    CHECK(has(accessor("", 3, "VEC3", 9), "names bufferView 9 of 2"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh(kPosition0 + ",\"indices\":1"))), "accessors[1]: names vertex 3 of 3"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh("\"attributes\":{\"POSITION\":-5}"))), "has no POSITION"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh("\"attributes\":{\"POSITION\":99}"))), "names accessor 99 of 2"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh(kPosition0 + ",\"material\":3"))), "names material 3 of 0"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh(kPosition0 + ",\"mode\":1"))), "holds no triangle"));
    CHECK(has(error_of_gltf(maker.gltf(one_mesh(kPosition0, "", "\"mesh\":4"))), "nodes[0]: names mesh 4 of 1"));
    GltfMaker wild = maker;
    const float bad[] = {0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0};
    const int number = wild.add(std::vector<float>(bad, bad + 9), kFloat, 3);
    CHECK(has(error_of_gltf(wild.gltf(one_mesh("\"attributes\":{\"POSITION\":" + std::to_string(number) + "}"))),
              "POSITION 2 is no finite number"));
}

TEST_CASE("gltf errors: nodes that are no tree and transforms that are none") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const auto error = [&](const std::string& nodes) {
        return error_of_gltf(maker.gltf("\"scenes\":[{\"nodes\":[0]}],\n\"nodes\":[" + nodes +
                                        "],\"meshes\":[{\"primitives\":[{" + kPosition0 + "}]}]"));
    };
    CHECK(has(error("{\"mesh\":0,\"children\":[0]}"), "a.gltf:6:10: nodes[0]: stands in the tree of nodes twice"));
    CHECK(has(error("{\"children\":[1]},{\"children\":[2,2]},{}"), "nodes[2]: stands in the tree of nodes twice"));
    CHECK(has(error("{\"children\":[7]}"), "names node 7 of 1"));
    CHECK(has(error("{\"mesh\":0,\"rotation\":[0,0,0,0]}"), "a quaternion of no length"));
    CHECK(has(error("{\"mesh\":0,\"scale\":[1,1]}"), "its scale has not 3 numbers"));
    CHECK(has(error("{\"mesh\":0,\"scale\":[1e300,1e300,1e300]}"), "beyond 1e30"));
    CHECK(has(error("{\"mesh\":0,\"matrix\":[1,0,0,5,0,1,0,0,0,0,1,0,0,0,0,1]}"), "last row"));
    // A chain of ten thousand nodes is odd and no error.
    std::string chain;
    for (int i = 0; i < 10000; ++i) chain += "{\"children\":[" + std::to_string(i + 1) + "]},";
    CHECK(error(chain + "{\"mesh\":0}") == "no error");
}

TEST_CASE("gltf errors: texts and files that are no glTF") {
    CHECK(
        has(error_of_gltf("{\n\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [,]}"), "a.gltf:3:11: cannot be read: "));
    CHECK(has(error_of_gltf(std::string(100000, '[')), "a.gltf:1:1: is neither JSON"));
    CHECK(has(error_of_gltf("{\"a\":" + std::string(100000, '[')),
              "a.gltf:1:105: is nested more than 100 brackets deep"));
    CHECK(has(error_of_gltf(""), "is empty"));
    CHECK(has(error_of_gltf("<html>"), "a web page"));
    CHECK(has(error_of_gltf("{\"asset\":{\"version\":\"2.0\"}}"), "holds no triangle"));
    CHECK(has(error_of_gltf("glTF", "a.glb"), "cut off"));
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    const std::string glb = maker.glb(one_mesh(kPosition0));
    CHECK(has(error_of_gltf(glb.substr(0, glb.size() - 9), "a.glb"), "is cut off: it has"));
    CHECK(has(error_of_gltf("glTF\1" + glb.substr(5), "a.glb"), "version 1; version 2 is read"));
    CHECK(has(error_of_gltf(glb.substr(0, 12) + "\xff\xff\xff\x7f" + glb.substr(16), "a.glb"), "longer than the file"));
    const std::string draco = ",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]";
    CHECK(has(error_of_gltf(maker.glb(one_mesh(kPosition0, draco)), "a.glb"), "needs the extension 'KHR_draco"));
    CHECK(error_of_gltf(glb) == "no error");  // a .glb that is called .gltf
}

TEST_CASE("gltf errors: buffers stay in the folder of the file unless that is allowed") {
    const TempFolder folder;
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    folder.write("out.bin", maker.bin);
    folder.write("in/my mesh.bin", maker.bin);
    std::filesystem::create_symlink(folder.file("out.bin"), folder.file("in/link.bin"));
    const auto file = [&](const std::string& uri) {
        return folder.write("in/a.gltf", maker.json(one_mesh(kPosition0), "\"uri\":\"" + uri + "\","));
    };
    CHECK(error_of_file(file("my%20mesh.bin")) == "no error");
    for (const std::string& uri : {std::string("../out.bin"), std::string("link.bin"), folder.file("out.bin"),
                                   std::string("%2e%2e/out.bin"), std::string("/dev/zero")}) {
        CAPTURE(uri);
        CHECK(has(error_of_file(file(uri)), "outside the folder of the mesh file"));
    }
    CHECK(error_of_file(file("../out.bin"), true) == "no error");
    CHECK(has(error_of_file(file("/dev/zero"), true), "'/dev/zero' is not a file"));
    CHECK(has(error_of_file(file("absent.bin")), "absent.bin"));
    REQUIRE(mkfifo(folder.file("in/pipe.bin").c_str(), 0600) == 0);
    CHECK(has(error_of_file(file("pipe.bin")), "in/a.gltf: the buffer 'pipe.bin' is not a file"));
    folder.write("in/my mesh.bin", maker.bin.substr(0, 20));
    CHECK(error_of_file(file("my%20mesh.bin")) != "no error");
}

TEST_CASE("gltf errors: a damaged part does not cost the others") {
    GltfMaker maker;
    maker.add(kCorner, kFloat, 3);
    maker.add(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 1}, kFloat, 3);  // normals, two of no length
    const std::string meshes = "\"nodes\":[{\"mesh\":0}],\n\"meshes\":[{\"name\":\"table\",\"primitives\":[{" +
                               kPosition0 +
                               "},{\"attributes\":{\"POSITION\":9}},{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}]}]";
    const LoadedText read = load_loose_gltf(maker.gltf(meshes));
    CHECK(read.loaded.mesh.triangle_count() == 2);
    REQUIRE(read.warnings.size() == 2);
    CHECK(has(read.warnings[0], "primitive 1 of mesh 'table' is left out"));
    CHECK(has(read.warnings[1], "2 normals have no length"));
    CHECK(read.loaded.mesh.normals[3] == glm::vec3(0, 0, 1));
}

TEST_CASE("gltf errors: damaged files are an error or a mesh") {
    std::string rest;
    const GltfMaker maker = rich_maker(rest);
    const std::string files[] = {maker.gltf(rest), maker.glb(rest)};
    const TempFolder folder;
    check_survives(folder, "a.gltf", files[0]);
    CHECK(error_of_file(folder.file("a.gltf")) == "no error");
    std::mt19937 random(1);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    static const char* const kWild[] = {
        "-1", "4294967296", "18446744073709551615", "1e308", "null", "[]", "{}", "\"x\"", "0.5", ""};
    for (int round = 0; round < 1500; ++round) {
        CAPTURE(round);
        std::string bytes = files[round % 2];
        for (std::size_t hit = 0, hits = 1 + below(3); hit < hits; ++hit) {
            const std::size_t at = below(bytes.size());
            const std::size_t digit = bytes.find_first_of("0123456789", at);
            switch (below(4)) {
                case 0: bytes[at] = static_cast<char>(below(256)); break;
                case 1: bytes.erase(at, 1 + below(8)); break;
                case 2: bytes.insert(at, bytes.substr(below(bytes.size()), below(30))); break;
                default:
                    if (digit != bytes.npos) bytes.replace(digit, 1, kWild[below(std::size(kWild))]);
            }
        }
        check_survives(folder, round % 2 ? "b.glb" : "b.gltf", bytes);
    }
}

TEST_CASE("gltf: sample models as they are given away") {
    const std::filesystem::path samples = std::filesystem::path(shared_data_folder()) / "gltf";
    if (shared_data_folder().empty() || !std::filesystem::is_directory(samples)) {
        MESSAGE("SKIPPED: no folder data/gltf beside the repository");
        return;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(samples)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".gltf" && extension != ".glb") continue;
        CAPTURE(entry.path().string());
        const LoadedMesh loaded = load_mesh_file(entry.path().string());
        CHECK(loaded.mesh.triangle_count() > 0);
        CHECK(loaded.mesh.normals.size() == loaded.mesh.positions.size());
    }
}
