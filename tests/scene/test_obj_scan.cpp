// What is read of an OBJ text: the same as tinyobjloader reads of a plain one, however the text is written and however
// it is cut into stretches that are scanned side by side.
#include "scene/files/obj_scan.hpp"

#include <cstdio>
#include <random>
#include <sstream>

#include <doctest/doctest.h>
#include <tiny_obj_loader.h>

#include "tests/scene/damaged_text.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// One text twice: as programs may write it, and as plainly as can be.
struct TwoTexts {
    std::string odd, plain;
};

class TextMaker {
public:
    explicit TextMaker(unsigned seed) : random_(seed) {}

    TwoTexts make() {
        for (int i = 0; i < 3; ++i) element(i);
        for (int i = 0; i < 60; ++i) statement();
        return texts_;
    }

private:
    int below(int n) {
        return std::uniform_int_distribution<int>(0, n - 1)(random_);
    }

    std::string number() {
        char text[64];
        const double value = std::uniform_real_distribution<double>(-4.0, 4.0)(random_);
        static constexpr const char* kFormats[] = {"%.6f", "%.9g",  "%.3f",  "%.12e",
                                                   "%.0f", "%+.4f", "%.17g", "%.8fe-3"};
        std::snprintf(text, sizeof text, kFormats[below(8)], value);
        return text;
    }

    /// The words of a statement, with what is no part of any word between them.
    void line(const std::vector<std::string>& words) {
        std::string plain, odd;
        for (const std::string& word : words) {
            static constexpr const char* kGaps[] = {" ", "\t", "  ", " \t ", " \\\n", "\t\\\r\n  "};
            odd += (odd.empty() ? (below(9) == 0 ? "  " : "") : kGaps[below(12) == 0 ? below(6) : 0]) + word;
            plain += (plain.empty() ? "" : " ") + word;
        }
        static constexpr const char* kEnds[] = {"\n", "\r\n", "\r", " \n", "\n\n", "\n# a \\\n", "\t\r\n", " # 1 2\n"};
        const bool is_name = words[0] == "g" || words[0] == "o";  // names may hold #
        texts_.odd += odd + kEnds[below(6) == 0 ? below(is_name ? 7 : 8) : 0];
        texts_.plain += plain + "\n";
    }

    void element(int kind) {
        static constexpr const char* kWords[] = {"v", "vt", "vn"};
        std::vector<std::string> words{kWords[kind]};
        const int numbers = kind == 1 ? 1 + below(3) : 3;
        for (int i = 0; i < numbers; ++i) words.push_back(number());
        line(words);
        ++counts_[kind];
    }

    std::string index(int kind) {
        const int index = 1 + below(counts_[kind]);
        return std::to_string(below(3) == 0 ? index - counts_[kind] - 1 : index);
    }

    void face() {
        std::vector<std::string> words{"f"};
        const int form = below(4), corners = below(3) == 0 ? 3 + below(6) : 3;
        for (int i = 0; i < corners; ++i) {
            std::string corner = index(0);
            if (form == 1) corner += "/" + index(1);
            if (form == 2) corner += "//" + index(2);
            if (form == 3) corner += "/" + index(1) + "/" + index(2);
            words.push_back(corner);
        }
        line(words);
    }

    void statement() {
        const int kind = below(12);
        if (kind < 6) return element(kind % 3);
        if (kind < 10) return face();
        if (kind == 10) return line({"g", "group" + std::to_string(below(3)), "other"});
        line({"o", "thing" + std::to_string(below(3))});
    }

    std::mt19937 random_;
    int counts_[3] = {0, 0, 0};
    TwoTexts texts_;
};

/// Faces one after another: the name of their group, and their corners.
struct PlainFace {
    std::string name;
    std::vector<scene::ObjCorner> corners;
    bool operator==(const PlainFace&) const = default;
};

std::vector<PlainFace> faces_of(const scene::ObjScan& scan) {
    std::vector<PlainFace> faces;
    std::size_t run = 0;
    for (std::size_t f = 0; f < scan.faces.size(); ++f) {
        while (run + 1 < scan.runs.size() && scan.runs[run + 1].first_face <= f) ++run;
        const auto end = f + 1 < scan.faces.size() ? scan.faces[f + 1].first_corner : scan.corners.size();
        faces.push_back({scan.runs[run].name,
                         {scan.corners.begin() + scan.faces[f].first_corner,
                          scan.corners.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
    return faces;
}

/// What the library's callbacks are told. Its other interface leaves faces out at times.
struct LibraryMesh {
    std::vector<float> numbers[3];  ///< positions, texture coordinates, normals
    std::vector<PlainFace> faces;
    std::string name;
};

LibraryMesh& mesh_of(void* user_data) {
    return *static_cast<LibraryMesh*>(user_data);
}

void on_face(void* user_data, tinyobj::index_t* indices, int count) {
    LibraryMesh& mesh = mesh_of(user_data);
    PlainFace face{mesh.name, {}};
    const auto from_zero = [&](int index, std::size_t kind) {
        const int numbers_each = kind == 1 ? 2 : 3;
        const int elements = static_cast<int>(mesh.numbers[kind].size()) / numbers_each;
        return index > 0 ? index - 1 : index == 0 ? -1 : elements + index;
    };
    for (int i = 0; i < count; ++i) {
        face.corners.push_back({from_zero(indices[i].vertex_index, 0), from_zero(indices[i].texcoord_index, 1),
                                from_zero(indices[i].normal_index, 2)});
    }
    mesh.faces.push_back(face);
}

LibraryMesh read_with_library(const std::string& text) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* data, float x, float y, float z, float) {
        mesh_of(data).numbers[0].insert(mesh_of(data).numbers[0].end(), {x, y, z});
    };
    callbacks.texcoord_cb = [](void* data, float u, float v, float) {
        mesh_of(data).numbers[1].insert(mesh_of(data).numbers[1].end(), {u, v});
    };
    callbacks.normal_cb = [](void* data, float x, float y, float z) {
        mesh_of(data).numbers[2].insert(mesh_of(data).numbers[2].end(), {x, y, z});
    };
    callbacks.index_cb = on_face;
    callbacks.object_cb = [](void* data, const char* name) { mesh_of(data).name = name; };
    callbacks.group_cb = [](void* data, const char** names, int count) {
        mesh_of(data).name = names[0];
        for (int i = 1; i < count; ++i) mesh_of(data).name.append(" ").append(names[i]);
    };
    LibraryMesh mesh;
    std::istringstream stream(text);
    REQUIRE(tinyobj::LoadObjWithCallback(stream, callbacks, &mesh));
    return mesh;
}

std::vector<float> floats_of(const scene::ObjScan& scan, int kind) {
    std::vector<float> floats;
    const auto add = [&](auto value) { floats.push_back(static_cast<float>(value)); };
    for (const glm::dvec3& p : scan.positions)
        if (kind == 0) add(p.x), add(p.y), add(p.z);
    for (const glm::vec2& uv : scan.uvs)
        if (kind == 1) add(uv.x), add(uv.y);
    for (const glm::vec3& n : scan.normals)
        if (kind == 2) add(n.x), add(n.y), add(n.z);
    return floats;
}

/// The scan, or the error's line.
std::pair<scene::ObjScan, std::string> scan_or_error(const scene::ObjText& text, int stretches) {
    try {
        return {scene::scan_obj(text, stretches), ""};
    } catch (const scene::UserError& error) { return {{}, error.what()}; }
}

}  // namespace

TEST_CASE("obj scan: random texts hold what tinyobjloader reads, to the last bit") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        const TwoTexts texts = TextMaker(seed).make();
        CAPTURE(texts.odd);
        const auto [scan, error] = scan_or_error(scene::check_obj_text("a.obj", texts.odd), 1);
        if (texts.plain.find("\nf ") == std::string::npos) continue;
        REQUIRE(error.empty());
        const LibraryMesh library = read_with_library(texts.plain);
        CHECK(floats_of(scan, 0) == library.numbers[0]);
        CHECK(floats_of(scan, 1) == library.numbers[1]);
        CHECK(floats_of(scan, 2) == library.numbers[2]);
        CHECK(faces_of(scan) == library.faces);
    }
}

TEST_CASE("obj scan: a text cut into stretches gives the same scan, the same warnings or the same error") {
    DamagedText damage(11);
    int errors = 0, warnings = 0, clean = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
        std::string text = TextMaker(seed).make().odd + "usemtl a b\ns 1\nf 1 2 3\nusemtl c\ns off\nf 1 2 3\n";
        if (seed % 3 != 0) text = damage.of(text);
        if (seed % 5 == 0) text += "mtllib a.mtl\nl 1 2\nv 1 1 1 1 1 1\n" + TextMaker(seed).make().odd;
        if (text.find('\0') != std::string::npos) continue;
        const scene::ObjText checked{"a.obj", text};
        CAPTURE(text);
        const auto whole = scan_or_error(checked, 1);
        for (const int stretches : {2, 3, 16}) CHECK((scan_or_error(checked, stretches) == whole));
        ++(!whole.second.empty() ? errors : !whole.first.warnings.empty() ? warnings : clean);
    }
    CHECK(errors > 50);
    CHECK(warnings > 50);
    CHECK(clean > 50);
}

TEST_CASE("obj scan: decimals become the nearest number") {
    const scene::ObjScan scan = scene::scan_obj(
        {"a.obj",
         "v 0.1 1e-400 0e999\nv 16777217 -0 .5\nv 3.4028234663852886e38 1.17549435e-38 123456789.125\nf 1 2 3\n"});
    CHECK(scan.positions[0] == glm::dvec3(0.1, 0.0, 0.0));
    CHECK(scan.positions[1] == glm::dvec3(16777217.0, 0.0, 0.5));
    CHECK(std::signbit(scan.positions[1].y));
    CHECK(scan.positions[2] == glm::dvec3(3.4028234663852886e38, 1.17549435e-38, 123456789.125));
}
