// What is wrong with an OBJ or MTL file becomes one line with the file, the line and the column. Never a crash.
#include "scene/files/mesh_file.hpp"

#include <doctest/doctest.h>

#include "tests/scene/damaged_text.hpp"
#include "tests/scene/mesh_text.hpp"

using namespace kreda::tests;
using kreda::scene::load_mesh_file;
using kreda::scene::UserError;

TEST_CASE("mesh errors: indices outside the file are found where they stand") {
    for (const OddText& bad :
         {OddText{"f 1 2 4\n", "a.obj:4:7: '4': ", "no such position: the file has 3"},
          OddText{"f 1 2 0\n", "a.obj:4:7: '0': ", "indices count from 1"},
          OddText{"f 1 2 -4\n", "a.obj:4:7: '-4': ", "there are 3 before this line"},
          OddText{"f 1 2 4294967299\n", "a.obj:4:7: '4294967299'", "no such position"},  // 2^32 + 3
          OddText{"f 1 2 -4294967295\n", "a.obj:4:7: '-4294967295'", "no such position"},
          OddText{"f 1 2 99999999999999999999\n", "a.obj:4:7: ", "no such position"},  // beyond 64 bits
          OddText{"f 1 2 -99999999999999999999\n", "a.obj:4:7: ", "no such position"},
          OddText{"f 1 2 3\nvt 0 0\n\tf 1/1 2/1 3/2 # c\n", "a.obj:6:12: '3/2'", "the file has 1"},
          OddText{"f 1 2 3\nf 1 2 \\\n  7\n", "a.obj:6:3: '7'", "no such position"}}) {
        check_says(error_of(kVertices + bad.text), bad);
    }
    CHECK(error_of("f -1 -2 -3\n" + kVertices).starts_with("a.obj:1:3: '-1': no such position: there are 0"));
    CHECK(error_of("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 4\r").starts_with("a.obj:4:7: "));
    CHECK(error_of("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 4\r\n").starts_with("a.obj:4:7: "));
    CHECK(error_of("\xef\xbb\xbfv x 0 0\n").starts_with("a.obj:1:3: "));
}

TEST_CASE("mesh errors: numbers that are none are found where they stand") {
    for (const OddText& bad : {OddText{"v nan 0 0\n", "a.obj:4:3: 'nan'", "finite"},
                               OddText{"v 0 -inf 0\n", "a.obj:4:5: '-inf'", "finite"},
                               OddText{"v 0 0 1e39\n", "a.obj:4:7: '1e39'", "at most 3.4e38"},
                               OddText{"v 0 0 1e999\n", "a.obj:4:7: '1e999'", "at most 3.4e38"},
                               OddText{"v 1,5 0 0\n", "a.obj:4:3: '1,5'", "decimals with a point"},
                               OddText{"v 1 2\n", "a.obj:4:6: the line ends", "expected a z coordinate"},
                               OddText{"v\n", "a.obj:4:2: the line ends", "expected an x coordinate"},
                               OddText{"v 1 2 3 4 5\n", "a.obj:4:12: ", "wrong number of coordinates"},
                               OddText{"v 1 2 3 4 5 6 7 8\n", "a.obj:4:17: '8'", "wrong number of coordinates"},
                               OddText{"v 1 2 0x3\n", "a.obj:4:7: '0x3'", "a number"},
                               OddText{"v 1 2 3m\n", "a.obj:4:7: '3m'", "a number"},
                               OddText{"v 1 2 +-3\n", "a.obj:4:7: '+-3'", "a number"},
                               OddText{"vt\n", "a.obj:4:3: the line ends", "texture coordinate"},
                               OddText{"vt 1 2 3 4\n", "a.obj:4:10: '4'", "1, 2 or 3"},
                               OddText{"vn 0 1\n", "a.obj:4:7: the line ends", "normal"},
                               OddText{"vn 0 0 1 0\n", "a.obj:4:10: '0'", "a normal has 3"},
                               OddText{"v -1.#IND 0 0\n", "a.obj:4:3: '-1.#IND'", "an x coordinate, a number"},
                               OddText{"f 1 2 3.5\n", "a.obj:4:7: '3.5'", "expected a corner"},
                               OddText{"f 1/ 2/ x/\n", "a.obj:4:9: 'x/'", "expected a corner"},
                               OddText{"f 1///1 2 3\n", "a.obj:4:3: ", "expected a corner"},
                               OddText{"f 1,2,3\n", "a.obj:4:3: '1,2,3'", "expected a corner"},
                               OddText{"s smooth\n", "a.obj:4:3: 'smooth'", "a number or off"}}) {
        check_says(error_of(kVertices + bad.text + "f 1 2 3\n"), bad);
    }
}

TEST_CASE("mesh errors: a face of more than 10000 corners is refused") {
    std::string face = "f";
    for (int i = 0; i < 10001; ++i) face += " 1";
    CHECK(has(error_of(kVertices + face), "10000 corners at most"));
}

TEST_CASE("mesh errors: what is not a mesh says so") {
    CHECK(has(error_of(""), "a.obj: holds no triangle"));
    CHECK(has(error_of("hello\nworld\n"), "holds no triangle"));
    CHECK(has(error_of("V 0 0 0\nF 1 1 1\n"), "a.obj:1:1: 'V')"));  // capitals are no OBJ
    CHECK(has(error_of(kVertices), "holds no triangle"));
    CHECK(has(error_of(kVertices + "f 1 1 1\n"), "holds no triangle"));
    CHECK(has(error_of(std::string("\xff\xfev\0 \0", 6)), "UTF-16"));
    CHECK(has(error_of(std::string("v 0 0 0\n\0", 9)), "a.obj:2:1: is binary data"));
    const TempFolder folder;
    CHECK(has(error_of_file(folder.path.string()), "is a folder"));
    CHECK(has(error_of_file(folder.file("absent.obj")), "absent.obj: no such file"));
    CHECK(has(error_of_file("/dev/null"), "not a regular file"));
}

TEST_CASE("mesh errors: paths in a file stay in its folder unless that is allowed") {
    const TempFolder folder;
    folder.write("secret.mtl", "newmtl m\n");
    folder.write("in/a.mtl", "newmtl m\nmap_Kd ../secret.mtl\n");
    std::filesystem::create_symlink(folder.file("secret.mtl"), folder.file("in/link.mtl"));
    const std::string face = kVertices + "f 1 2 3\n";
    folder.write("in/x/y.txt", "");
    for (const std::string& name :
         {std::string("../secret.mtl"), std::string("x/../../secret.mtl"), std::string("link.mtl"),
          std::string("..\\secret.mtl"), folder.file("secret.mtl"), std::string("/dev/zero")}) {
        CAPTURE(name);
        const std::string obj = folder.write("in/a.obj", "# c\nmtllib " + name + "\n" + face);
        CHECK(has(error_of_file(obj), "a.obj:2:1: '"));
        CHECK(has(error_of_file(obj), "outside the folder of the OBJ file"));
        if (name != "/dev/zero") CHECK(error_of_file(folder.write("in/x/b.obj", face), true) == "no error");
    }
    const std::string obj = folder.write("in/a.obj", "mtllib a.mtl\n" + face);
    CHECK(has(error_of_file(obj), "a.mtl:2:1: '../secret.mtl' is outside"));
    CHECK(error_of_file(obj, true) == "no error");
    const std::string to_device = folder.write("in/c.obj", "mtllib /dev/zero\n" + face);
    CHECK(has(error_of_file(folder.write("in/d.obj", "mtllib ../secret.mtl\n" + face), true), "no error"));
    CHECK(has(error_of_file(to_device), "outside"));
}

TEST_CASE("mesh errors: damaged files give a mesh or an error and never anything else") {
    const std::string obj =
        "mtllib a.mtl\no pot\nv 0 0 0\nv 1 0 0 1 .5 .5\nv 1 1 0\nv 0 1 0\nv 0.5 0.25 -1e-3\nvt 0 0\nvt 1 0\n"
        "vt 1 1\nvn 0 0 1\nvn nan 0 0\ns 1\nusemtl red\nf 1/1/1 2/2/1 3/3/2 # c\ng lid knob\nf -1 -2 \\\n"
        "-3 -4 -5\ns off\nusemtl blue\nf 1//1 2//1 3//1 4//1\nl 1 2\n";
    const std::string mtl =
        "newmtl red\nKa 1 1 1\nKd .5\nKs 1 0 0\nNs 32\nillum 2\nmap_Kd -s 1 1 a.png\nnewmtl blue\nPr .5\nPm 1\n";
    DamagedText damage(7);
    const TempFolder folder;
    constexpr int kRounds = 1000;
    int meshes = 0;
    folder.write("a.mtl", mtl);
    for (int i = 0; i < kRounds; ++i) {
        // First with a damaged OBJ, then with a damaged MTL: writing files is what takes the time.
        const std::string damaged = i < kRounds / 2 ? damage.of(obj) : damage.of(mtl);
        CAPTURE(damaged);
        folder.write(i < kRounds / 2 ? "a.obj" : "a.mtl", damaged);
        if (i == kRounds / 2) folder.write("a.obj", obj);
        try {
            const kreda::scene::LoadedMesh loaded = load_mesh_file(folder.file("a.obj"));
            for (const std::uint32_t index : loaded.mesh.indices) REQUIRE(index < loaded.mesh.positions.size());
            REQUIRE(loaded.mesh.normals.size() == loaded.mesh.positions.size());
            ++meshes;
        } catch (const UserError& error) { REQUIRE(std::string(error.what()).starts_with(folder.path.string())); }
    }
    CHECK(meshes > 100);
    CHECK(meshes < kRounds);
}
