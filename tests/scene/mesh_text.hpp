// Meshes as texts, for tests: what a text becomes, its warnings, and what is complained about, without the folder's
// name.
#pragma once

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/files/mesh_file.hpp"
#include "tests/scene/errors_and_views.hpp"
#include "tests/scene/temp_folder.hpp"

namespace kreda::tests {

inline const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// "a.obj:LINE:COL: ..." instead of "/tmp/.../a.obj:LINE:COL: ...".
[[nodiscard]] inline std::string without_folder(const TempFolder& folder, const std::string& message) {
    const std::string start = folder.path.string() + "/";
    return message.starts_with(start) ? message.substr(start.size()) : message;
}

struct LoadedText {
    scene::LoadedMesh loaded;
    std::vector<std::string> warnings;
};

[[nodiscard]] inline LoadedText load(const TempFolder& folder, const std::string& file) {
    LoadedText result{scene::load_mesh_file(folder.file(file)), {}};
    for (const std::string& warning : result.loaded.warnings)
        result.warnings.push_back(without_folder(folder, warning));
    return result;
}

/// a.obj and, where it is given, a.mtl.
[[nodiscard]] inline LoadedText load_text(const std::string& obj, const std::string& mtl = "") {
    const TempFolder folder;
    folder.write("a.obj", obj);
    if (!mtl.empty()) folder.write("a.mtl", mtl);
    return load(folder, "a.obj");
}

[[nodiscard]] inline std::string error_of_file(const std::string& path, bool allow_outside = false) {
    try {
        scene::MeshFileOptions options;
        options.allow_outside = allow_outside;
        (void)scene::load_mesh_file(path, options);
    } catch (const scene::UserError& error) { return error.what(); }
    return "no error";
}

[[nodiscard]] inline std::string error_of(const std::string& obj, const std::string& mtl = "") {
    const TempFolder folder;
    if (!mtl.empty()) folder.write("a.mtl", mtl);
    return without_folder(folder, error_of_file(folder.write("a.obj", obj)));
}

/// Lines that are not as they should be, and what is said about them.
struct OddText {
    std::string text;   // behind kVertices: starts in line 4
    std::string start;  // of the message: the place
    std::string words;  // in it
};

inline void check_says(const std::string& message, const OddText& odd) {
    CAPTURE(odd.text);
    CAPTURE(message);
    CHECK(message.starts_with(odd.start));
    CHECK(has(message, odd.words));
}

}  // namespace kreda::tests
