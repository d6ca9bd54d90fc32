// hash_scene_files SCENE.toml...: a line a scene with a hash of its film's bits. hash_scene_files.mjs must print the
// same lines.
#include <cstdio>
#include <exception>
#include <span>

#include "scene/files/hash_of_bytes.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        try {
            const raster::Image film = render(scene::read_scene(argv[i]));
            const std::uint64_t hash = scene::hash_of_bytes(std::as_bytes(std::span(film.values)));
            std::printf("%016llx %s\n", static_cast<unsigned long long>(hash), argv[i]);
        } catch (const std::exception& error) { std::printf("%s\n", error.what()); }
        std::fflush(stdout);
    }
}
