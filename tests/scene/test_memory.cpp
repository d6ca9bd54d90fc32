// Memory of a frame: what is asked for, counted by the program itself, against 64 bytes a pixel plus 100 a triangle.
#include <doctest/doctest.h>

#include <fstream>
#include <memory>
#include <string>

#include "raster/shapes.hpp"
#include "scene/render/render.hpp"

#if defined(__linux__) && !defined(KREDA_SANITIZED)
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace kreda;

namespace {

/// Largest resident memory of this process so far, in bytes.
double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

scene::Scene scene_of(const std::string& shape, int detail, int width, int height, scene::ShadingFrequency frequency) {
    scene::Scene scene;
    scene.image.width = width;
    scene.image.height = height;
    scene.shading.frequency = frequency;
    scene.camera.position = {0.0f, 1.2f, 1.8f};
    scene.camera.near = 0.1f;
    scene.lights.resize(1);
    scene.materials.resize(1);
    scene.materials[0].model = lighting::ReflectionModel::blinn_phong;
    scene::Object object;
    object.mesh = std::make_shared<raster::Mesh>(raster::make_shape(shape, detail).value());
    object.part_material.assign(object.mesh->parts.size(), 0);
    scene.objects = {object};
    return scene;
}

/// Give back what was freed, and let the largest resident memory be today's.
void forget_peak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// How much the peak of a process of its own grows while it renders the scene twice (the mesh itself is there before).
double memory_of_frame(const scene::Scene& scene) {
    int channel[2];
    REQUIRE(pipe(channel) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        forget_peak();
        const double before = peak_memory();
        scene::RenderBuffers buffers;
        const scene::RenderPlan plan = make_plan(scene);
        render(scene, plan, buffers, 1);  // one thread: OpenMP does not survive a fork
        render(scene, plan, buffers, 1);
        const double grown = peak_memory() - before;
        const bool told = write(channel[1], &grown, sizeof grown) == sizeof grown;
        _exit(told ? 0 : 1);
    }
    double grown = -1.0;
    REQUIRE(read(channel[0], &grown, sizeof grown) == sizeof grown);
    waitpid(child, nullptr, 0);
    close(channel[0]);
    close(channel[1]);
    return grown;
}

}  // namespace

TEST_CASE("a frame takes at most 64 bytes a pixel and 100 bytes a triangle") {
    using scene::ShadingFrequency;
    // Scratch of a thread, stacks, code that is touched for the first time: the same for every scene.
    constexpr double kFixed = 8e6;
    for (const ShadingFrequency frequency :
         {ShadingFrequency::phong, ShadingFrequency::gouraud, ShadingFrequency::flat}) {
        CAPTURE(static_cast<int>(frequency));
        const double pixels = memory_of_frame(scene_of("sphere", 64, 2048, 2048, frequency));
        CAPTURE(pixels);
        CHECK(pixels - kFixed <= 64.0 * 2048 * 2048);
        CHECK(pixels >= 12.0 * 2048 * 2048);  // the film alone: the measurement sees something
        // In a picture of the same size, so that most of the two million triangles are drawn and not dropped.
        const double triangles = memory_of_frame(scene_of("terrain", 1000, 2048, 2048, frequency)) - pixels;
        CAPTURE(triangles);
        CHECK(triangles <= 100.0 * 2e6);
        CHECK(triangles >= 16.0 * 1e6);  // a ScreenVertex for each of the million vertices
        MESSAGE(doctest::toString(pixels / (2048.0 * 2048.0)), " bytes a pixel, ", doctest::toString(triangles / 2e6),
                " bytes a triangle");
    }
}

#endif
