#include "tests/fuzz/readers.hpp"

#include <fstream>

#include "scene/error.hpp"
#include "scene/files/file_content.hpp"
#include "scene/files/icc_profile.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/files/radiance_header.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/webp_file.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::tests {

namespace {

std::string write_fuzzed(const std::string& folder, const std::string& name, const std::string& bytes) {
    std::ofstream(folder + "/" + name, std::ios::binary) << bytes;
    return folder + "/" + name;
}

/// As `kreda plan` reads it: the text, its meshes, and what would be done. Nothing is drawn.
void read_fuzzed_scene(const std::string& bytes, const std::string& folder) {
    scene::ReadOptions options;
    options.maps_later = true;
    const scene::Scene read = scene::read_scene_text(bytes, "fuzzed.toml", folder, options);
    (void)scene::describe(scene::make_plan(read), true);
}

void read_fuzzed_obj(const std::string& bytes, const std::string& folder) {
    write_fuzzed(folder, "a.mtl", "newmtl a\nKd 1 0 0\nmap_Kd a.png\nnewmtl b\nKs 1 1 1\nNs 9\n");
    (void)scene::load_mesh_file(write_fuzzed(folder, "fuzzed.obj", bytes));
}

void read_fuzzed_mtl(const std::string& bytes, const std::string& folder) {
    write_fuzzed(folder, "fuzzed.mtl", bytes);
    const std::string obj = "mtllib fuzzed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";
    (void)scene::load_mesh_file(write_fuzzed(folder, "a.obj", obj));
}

/// Binary or text: the first bytes say which, as in any file.
void read_fuzzed_gltf(const std::string& bytes, const std::string& folder) {
    const std::string name = bytes.starts_with("glTF") ? "fuzzed.glb" : "fuzzed.gltf";
    (void)scene::load_mesh_file(write_fuzzed(folder, name, bytes));
}

/// OpenImageIO runs in a child process, whose steps a fuzzer does not see; what is ours is called here once more.
void read_fuzzed_image(const std::string& bytes, const std::string& folder) {
    (void)scene::other_content(bytes);
    (void)scene::profile_other_than_srgb(bytes);
    (void)scene::webp_orientation(bytes);
    if (scene::is_webp(bytes)) (void)scene::webp_without_alpha(bytes);
    if (bytes.starts_with("#?")) (void)scene::read_radiance_header(bytes);
    scene::ImageReadOptions options;
    options.max_values = 1 << 20;
    options.spare_seconds = 2;
    (void)scene::read_image(write_fuzzed(folder, "fuzzed", bytes), options);
}

/// A refusal is what a damaged file should meet; any other exception ends the program.
template <void (*Read)(const std::string&, const std::string&)>
void read_or_refuse(const std::string& bytes, const std::string& folder) {
    try {
        Read(bytes, folder);
    } catch (const scene::UserError&) {}
}

}  // namespace

const std::vector<FuzzedReader>& fuzzed_readers() {
    static const std::vector<FuzzedReader> readers = {{"scene", read_or_refuse<read_fuzzed_scene>},
                                                      {"obj", read_or_refuse<read_fuzzed_obj>},
                                                      {"mtl", read_or_refuse<read_fuzzed_mtl>},
                                                      {"gltf", read_or_refuse<read_fuzzed_gltf>},
                                                      {"image", read_or_refuse<read_fuzzed_image>}};
    return readers;
}

}  // namespace kreda::tests
