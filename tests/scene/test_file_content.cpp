// Files that hold something else than their name says: one line names it, with what to do.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/file_content.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/read_scene.hpp"
#include "tests/scene/mesh_text.hpp"

using namespace kreda;
using namespace kreda::tests;
using scene::other_content;

namespace {

std::string image_error(const std::string& name, const std::string& bytes) {
    const TempFolder folder;
    std::vector<std::string> warnings;
    try {
        (void)scene::load_texture(folder.write(name, bytes), lighting::MapKind::color, false, warnings);
    } catch (const scene::UserError& error) { return without_folder(folder, error.what()); }
    return "no error";
}

std::string scene_error(const std::string& text) {
    try {
        (void)scene::read_scene_text(text, "s.toml", "");
    } catch (const scene::UserError& error) { return error.what(); }
    return "no error";
}

}  // namespace

TEST_CASE("file content: what is commonly mistaken for a mesh, a scene or a picture is named") {
    struct Sample {
        std::string start, words;
    };
    for (const Sample& sample :
         {Sample{"\n<!DOCTYPE HTML>\n<html>", "a web page (HTML)"},
          Sample{"\xef\xbb\xbf<html lang='en'>", "a web page (HTML)"},
          Sample{"<?xml version=\"1.0\"?>\n<svg xmlns='x'/>", "an SVG drawing"},
          Sample{"<?xml version=\"1.0\"?>\n<COLLADA>", "a COLLADA scene"},
          Sample{"version https://git-lfs.github.com/spec/v1\noid", "git lfs pull"},
          Sample{std::string("\x1f\x8b\x08\0", 4), "gzip archive, not what its name says; unpack"},
          Sample{"PK\x03\x04", "zip archive"},
          Sample{"\xfd"
                 "7zXZ",
                 "xz archive"},
          Sample{"ply\nformat ascii 1.0", "PLY mesh"}, Sample{"solid cube\n", "STL mesh"},
          Sample{"OFF\n8 6 0\n", "OFF mesh"}, Sample{std::string("glTF\2\0\0\0", 8), "glTF"},
          Sample{std::string("\0\0\0\x18"
                             "ftypheic",
                             12),
                 "HEIC"},
          Sample{std::string("\0\0\0\x18"
                             "ftypavif",
                             12),
                 "AVIF"},
          Sample{std::string("\0\0\0\x18"
                             "ftypmp42",
                             12),
                 "movie"}}) {
        CAPTURE(sample.words);
        CHECK(has(other_content(sample.start), sample.words));
    }
    for (const char* plain : {"", "# a cube\nv 0 0 0\n", "v 0 0 0\n", "mtllib a.mtl\n", "[camera]\n", "o off\n",
                              "\x89PNG", "newmtl solid\n", "<", "#?RADIANCE\n"}) {
        CAPTURE(plain);
        CHECK(other_content(plain).empty());
    }
}

TEST_CASE("file content: meshes, materials and images say it") {
    CHECK(error_of("<html>404</html>\n") ==
          "a.obj: is a web page (HTML), not what its name says; download the file itself");
    CHECK(has(error_of("mtllib a.mtl\n" + kVertices + "f 1 2 3\n", "version https://git-lfs.github.com/spec/v1\n"),
              "a.mtl: is a Git LFS pointer"));
    CHECK(image_error("t.png", "version https://git-lfs.github.com/spec/v1\n") ==
          "t.png: is a Git LFS pointer, not what its name says; fetch the file itself with `git lfs pull`");
    CHECK(has(scene_error("<html>\n"), "s.toml: is a web page (HTML)"));
    CHECK(has(scene_error(std::string("\xff\xfe[\0c\0", 6)), "s.toml: is UTF-16 text; save it as UTF-8"));
    CHECK(has(image_error("t.jpg", "<svg/>"), "t.jpg: is an SVG drawing"));
    CHECK(has(image_error("t.png", "nothing of the kind"), "t.png: cannot be read as an image"));
}
