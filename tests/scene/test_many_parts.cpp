// Meshes of very many groups or materials: they are read and drawn, and parts cost no more than their triangles.
#include <string>

#include <doctest/doctest.h>

#include "raster/triangle_setup.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::scene;
using kreda::tests::TempFolder;

namespace {

/// `side` x `side` quads in the xy plane over [-1, 1]^2; `before(k)` is written before quad k.
template <class Before>
std::string quads(int side, Before before) {
    std::string text = "mtllib a.mtl\n";
    for (int i = 0; i < (side + 1) * (side + 1); ++i) {
        text += "v " + std::to_string(2.0 * (i % (side + 1)) / side - 1.0) + " " +
                std::to_string(2.0 * (i / (side + 1)) / side - 1.0) + " 0\n";
    }
    for (int k = 0; k < side * side; ++k) {
        const int a = k / side * (side + 1) + k % side + 1, above = a + side + 1;
        text += before(k) + "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(above + 1) +
                " " + std::to_string(above) + "\n";
    }
    return text;
}

/// Materials m0 .. whose red is k / count.
std::string materials(int count) {
    std::string text;
    for (int k = 0; k < count; ++k) {
        text += "newmtl m" + std::to_string(k) + "\nKa 0 0 0\nKd " + std::to_string(double(k) / count) + " 0.5 1\n";
    }
    return text;
}

std::string use_of(int k) {
    return "usemtl m" + std::to_string(k) + "\n";
}

const std::string kFront =
    "[image]\nsize = [96, 96]\n[camera]\nposition = [0, 0, 3]\nprojection = 'orthographic'\nheight = 2\n"
    "[[light]]\ntype = 'point'\nposition = [0.3, 0.2, 1]\n";

Scene read_parts_in(const TempFolder& folder, const std::string& more) {
    return read_scene_text(kFront + more, "s.toml", folder.path.string());
}

}  // namespace

TEST_CASE("many parts: a picture of eight materials in one mesh is that of eight meshes, bit by bit") {
    const TempFolder folder;
    folder.write("a.mtl", materials(8));
    folder.write("all.obj", quads(16, [](int k) { return use_of(k % 8); }));
    for (int m = 0; m < 8; ++m) {
        std::string part = quads(16, [](int) { return std::string(); }), kept;
        int k = 0;
        for (std::size_t at = 0, end; at < part.size(); at = end) {
            end = part.find('\n', at) + 1;
            if (part[at] != 'f' || k++ % 8 == m) kept += part.substr(at, end - at);
        }
        const std::size_t first_face = kept.find("f ");
        folder.write("m" + std::to_string(m) + ".obj", kept.insert(first_face, use_of(m)));
    }
    for (const char* frequency : {"flat", "gouraud", "phong"}) {
        CAPTURE(frequency);
        const std::string shading = "[shading]\nfrequency = '" + std::string(frequency) + "'\n";
        std::string eight = shading;
        for (int m = 0; m < 8; ++m) eight += "[[object]]\nmesh = 'm" + std::to_string(m) + ".obj'\n";
        const raster::Image one_mesh = render(read_parts_in(folder, shading + "[[object]]\nmesh = 'all.obj'\n"));
        CHECK(one_mesh.values == render(read_parts_in(folder, eight)).values);
    }
}

TEST_CASE("many parts: chunks hold parts of any size, and hidden ones draw nothing") {
    const TempFolder folder;
    folder.write("a.mtl", materials(2));
    folder.write("all.obj", quads(64, [](int k) { return "g part" + std::to_string(k) + "\n" + use_of(k % 2); }));
    const auto draw = [&](const std::string& more, RenderBuffers& buffers) {
        const Scene scene = read_parts_in(folder, "[[object]]\nmesh = 'all.obj'\n" + more);
        return render(scene, make_plan(scene), buffers).triangles;
    };
    RenderBuffers buffers, without;
    CHECK(draw("", buffers).input == 2 * 64 * 64);
    CHECK(buffers.triangles.chunks.size() == 2);  // 8192 triangles
    CHECK(draw("hide = ['part0', 'part2079']\n", without).input == 2 * 64 * 64 - 4);
    int changed = 0;
    for (int i = 0; i < 96 * 96; ++i) changed += buffers.film.plane(2)[i] != without.film.plane(2)[i];
    CHECK(changed > 0);
    CHECK(changed <= 2 * 3 * 3);  // quads of one and a half pixels
}

TEST_CASE("many parts: 66,000 groups and 70,000 switches of material are drawn") {
    const TempFolder folder;
    folder.write("a.mtl", materials(2));
    folder.write("groups.obj", quads(257, [](int k) { return "g part" + std::to_string(k) + "\n"; }));
    folder.write("switches.obj", quads(265, [](int k) { return use_of(k % 2); }));
    const Scene groups = read_parts_in(folder, "[[object]]\nmesh = 'groups.obj'\n");
    CHECK(groups.objects[0].mesh->triangle_count() == 2 * 257 * 257);
    CHECK(groups.objects[0].mesh->parts.size() == 1);  // parts of one material are one part
    const Scene switches = read_parts_in(folder, "[[object]]\nmesh = 'switches.obj'\n");
    CHECK(switches.objects[0].mesh->triangle_count() == 2 * 265 * 265);
    CHECK(switches.objects[0].mesh->parts.size() == 2);
    const raster::Image film = render(switches);
    for (const int x : {3, 50, 90}) CHECK(film.at(2, x, x) > 0.0f);
}

TEST_CASE("many parts: 66,000 materials that all differ are drawn, too") {
    const TempFolder folder;
    folder.write("a.mtl", materials(257 * 257));
    folder.write("all.obj", quads(257, [](int k) { return use_of(k); }));
    const Scene scene = read_parts_in(folder, "[[object]]\nmesh = 'all.obj'\n");
    CHECK(scene.objects[0].mesh->parts.size() == 257 * 257);
    const raster::Image film = render(scene);
    for (const int y : {5, 48, 90}) {
        for (const int x : {3, 47, 91}) {  // red over blue is the number of the quad seen at the pixel's centre
            const int column = static_cast<int>((x + 0.5) / 96.0 * 257.0);
            const int row = static_cast<int>((95.5 - y) / 96.0 * 257.0);
            const double share = (row * 257.0 + column) / (257.0 * 257.0);
            CHECK(film.at(0, x, y) / film.at(2, x, y) == doctest::Approx(share).epsilon(1e-4));  // six digits of Kd
        }
    }
}
