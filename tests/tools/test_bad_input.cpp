// Whatever a user does wrong: one line on stderr that says where and what, exit code 2, and no file left behind.
// The messages themselves are tested where they are made, in tests/scene; here are one or two of each kind.
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"

using namespace kreda::tests;

namespace {

struct BadInput {
    const char* name;
    std::vector<std::string> args;
    std::vector<std::string> said;  ///< pieces of the line
};

void check_refused(const BadInput& bad, const TempFolder& folder) {
    CAPTURE(bad.name);
    const std::vector<std::string> before = names_in(folder.path.string());
    const Outcome outcome = run_kreda(bad.args, folder.path.string());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(line_count(outcome.err) == 1);
    CHECK(outcome.out.empty());
    for (const std::string& piece : bad.said) {
        CAPTURE(piece);
        CHECK(outcome.err.find(piece) != std::string::npos);
    }
    CHECK(names_in(folder.path.string()) == before);
}

std::string scene_with_mesh(const std::string& mesh) {
    return "[[object]]\nmesh = \"" + mesh + "\"\n";
}

}  // namespace

TEST_CASE("bad scene file: its place and one line and exit code 2 and no picture") {
    const TempFolder folder;
    folder.write("unknown_key.toml", "[camera]\nposition = [0, 1, 4]\npositon = [0, 1, 4]\n");
    folder.write("wrong_type.toml", "[camera]\n\n  near = \"close\"\n");
    folder.write("size_0.toml", "[image]\nsize = [0, 10]\n");
    folder.write("size_huge.toml", "[image]\nsize = [100000, 100000]\n");
    folder.write("samples_huge.toml", "[image]\nsize = [16384, 16384]\nsamples = 8\n");
    folder.write("binary.toml", std::string("\0\1\2\3", 4));
    const std::vector<BadInput> table = {
        {"missing file", {"render", "none.toml"}, {"none.toml"}},
        {"a folder", {"render", "."}, {".: ", "folder"}},
        {"a newline in the name", {"render", "a\nb.toml"}, {"a b.toml"}},
        {"unknown key", {"render", "unknown_key.toml"}, {"unknown_key.toml:3:1: ", "positon", "position"}},
        {"wrong type", {"render", "wrong_type.toml"}, {"wrong_type.toml:3:", "near", "number"}},
        {"size 0", {"render", "size_0.toml"}, {"size_0.toml:2:", "size"}},
        {"size 100000x100000", {"render", "size_huge.toml"}, {"size_huge.toml:2:", "size"}},
        {"too many samples", {"render", "samples_huge.toml"}, {"samples_huge.toml:2:", "samples"}},
        {"binary", {"render", "binary.toml"}, {"binary.toml", "text"}},
        {"the plan of a bad scene", {"plan", "unknown_key.toml"}, {"unknown_key.toml:3:1: "}},
    };
    for (const BadInput& bad : table) check_refused(bad, folder);
}

TEST_CASE("bad mesh: its place and one line and exit code 2 and no picture") {
    const TempFolder folder;
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    folder.write("index.obj", corners + "f 1 2 4\n");
    folder.write("negative.obj", corners + "f 1 2 -4\n");
    folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("no_faces.obj", corners);
    const std::vector<BadInput> table = {
        {"index out of range", {"render", "index.toml"}, {"index.obj:4:", "4"}},
        {"negative index out of range", {"render", "negative.toml"}, {"negative.obj:4:", "-4"}},
        {"NaN vertex", {"render", "nan.toml"}, {"nan.obj:2:"}},
        {"no faces", {"render", "no_faces.toml"}, {"no_faces.obj"}},
        {"missing mesh", {"render", "missing.toml"}, {"missing"}},
    };
    for (const BadInput& bad : table) {
        const std::string scene = bad.args[1];
        folder.write(scene, scene_with_mesh(scene.substr(0, scene.find('.')) + ".obj"));
        check_refused(bad, folder);
    }
}

TEST_CASE("bad command line: one line and exit code 2 and no picture") {
    const TempFolder folder;
    folder.write("picture.png/inside.txt", "a folder that is called like a picture");
    const std::vector<BadInput> table = {
        {"no command", {}, {"kreda --help"}},
        {"unknown command", {"rendr"}, {"rendr", "did you mean 'render'", "--help"}},
        {"unknown option", {"render", "--colour"}, {"--colour", "kreda render --help"}},
        {"size without x", {"render", "--size", "640"}, {"--size 640", "640x360"}},
        {"size 0", {"render", "--size", "0x360"}, {"--size 0x360"}},
        {"size with more behind", {"render", "--size", "64x36cm"}, {"--size 64x36cm"}},
        {"size 100000x100000", {"render", "--size", "100000x100000"}, {"100000"}},
        {"size beyond any number", {"render", "--size", "99999999999x1"}, {"--size 99999999999x1"}},
        {"no samples", {"render", "--samples", "0"}, {"--samples"}},
        {"set without value", {"render", "--set", "camera.near"}, {"camera.near"}},
        {"set of an unknown key", {"render", "--set", "camera.neer=1"}, {"neer", "near"}},
        {"missing output folder", {"render", "-o", "none/picture.png"}, {"none/picture.png", "folder none"}},
        {"unknown extension", {"render", "-o", "picture.jpg"}, {"picture.jpg", ".png", ".exr"}},
        {"no extension", {"render", "-o", "picture"}, {"picture", ".png"}},
        {"output is a folder", {"render", "-o", "picture.png"}, {"picture.png", "folder"}},
    };
    for (const BadInput& bad : table) check_refused(bad, folder);
}

TEST_CASE("a failure leaves an older picture as it was") {
    const TempFolder folder;
    folder.write("scene.toml", "[camera]\nnear = 2\nfar = 1\n");
    folder.write("scene.png", "an older picture");
    CHECK(run_kreda({"render", "scene.toml"}, folder.path.string()).exit_code == 2);
    CHECK(bytes_of(folder.file("scene.png")) == "an older picture");
}
