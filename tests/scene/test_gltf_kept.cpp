// What is kept of a glTF file is read anew when a file beside it changes.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/loaded_files.hpp"
#include "tests/scene/temp_folder.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("glTF: the buffer beside a glTF file counts as a part of it") {
    const auto corner = [](float size) {
        const float positions[] = {0, 0, 0, size, 0, 0, 0, size, 0};
        return std::string(reinterpret_cast<const char*>(positions), sizeof positions);
    };
    const TempFolder folder;
    folder.write("a.bin", corner(1.0f));
    folder.write("a.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":36}],)"
                           R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
                           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],)"
                           R"("scenes":[{"nodes":[0]}]})");
    let_files_settle();
    scene::LoadedFiles files;
    const auto corner_of = [&] { return scene::load_mesh(&files, folder.file("a.gltf"), {})->mesh.positions[1].x; };
    CHECK(corner_of() == 1.0f);
    CHECK(corner_of() == 1.0f);
    CHECK(files.reads == 1);
    folder.write("a.bin", corner(2.0f));
    let_files_settle();
    CHECK(corner_of() == 2.0f);
    CHECK(files.reads == 2);
}
