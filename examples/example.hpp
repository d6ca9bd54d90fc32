// What all examples share and no lesson is about: the command line, where the pictures go, saving one.
#pragma once

#include <string>

#include "raster/film.hpp"
#include "raster/image.hpp"
#include "scene/scene.hpp"

namespace kreda::examples {

/// What the command line says.
struct Options {
    int width = 640;  ///< size of every picture, in pixels
    int height = 360;
    std::string folder;  ///< where the pictures go: OUT/NN_name, there already
};

/// Read `--out DIR`, `--size WxH`, `--help`; make the folder OUT/name; call draw. The result is main's: 0, or 2 after
/// one line on stderr when the user can mend it.
int run(int argc, char** argv, const std::string& name, void (*draw)(const Options&), Options defaults = {});

/// Write linear RGB as OUT/NN_name/<file>.png, 8-bit sRGB.
void save(const Options& options, const std::string& file, const raster::Image& linear,
          const raster::FilmSettings& film = {});

/// Read the scene file of an example and give it the size of the command line.
[[nodiscard]] scene::Scene read_scene(const Options& options, const std::string& path);

/// Render a scene to linear radiance and save it with the scene's own exposure, tone map and transfer function.
void render_and_save(const Options& options, const std::string& file, const scene::Scene& scene);

}  // namespace kreda::examples
