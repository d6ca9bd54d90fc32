// A program of somebody else: draws a scene with the installed library.
#include <cstdio>

#include <lighting/reflection.hpp>
#include <scene/files/image_file.hpp>
#include <scene/files/read_scene.hpp>
#include <scene/render/render.hpp>

int main(int, char** argv) {
    const kreda::scene::Scene scene =
        kreda::scene::read_scene(argv[1], {.overrides = {"image.size=[64, 36]", "image.samples=1"}});
    kreda::scene::write_exr(argv[2], kreda::scene::render(scene));
    std::printf("%d objects\n", static_cast<int>(scene.objects.size()));
}
