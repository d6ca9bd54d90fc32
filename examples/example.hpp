// What all examples share and no lesson is about: the command line, where the pictures go, saving one.
#pragma once

#include <string>
#include <vector>

#include "examples/panel.hpp"
#include "raster/film.hpp"
#include "raster/image.hpp"
#include "scene/scene.hpp"
#include "tools/draw/theme.hpp"

namespace kreda::examples {

/// What the command line says.
struct Options {
    int width = 1920;  ///< size of every picture, in pixels
    int height = 1080;
    bool draft = false;  ///< drawn as fast as the idea allows: the golden images hold drafts
    int samples = 3;     ///< side of a pixel's grid of samples; 1 in a draft, where scenes that say 3 or 2 keep that
    tools::Theme theme = tools::Theme::dark;
    std::string folder;   ///< where the pictures go: OUT/NN_name, there already
    bool panels = false;  ///< write what was computed, panel by panel, and where every text stands, too
};

/// Size of the pictures that are measured, pixel by pixel: that of drafts at most, so that a larger picture does not
/// take longer to measure.
[[nodiscard]] glm::ivec2 measured_size(const Options& options);

/// Read `--out DIR`, `--size WxH`, `--draft`, `--theme NAME`, `--panels`, `--help`; make the folder OUT/name; call
/// draw. The result is main's: 0, or 2 after one line on stderr when the user can mend it.
int run(int argc, char** argv, const std::string& name, void (*draw)(const Options&));

/// Write linear RGB as OUT/NN_name/<file>.png, 8-bit sRGB.
void save(const Options& options, const std::string& file, const raster::Image& linear,
          const raster::FilmSettings& film = {});

/// Put panels side by side in OUT/NN_name/<file>.png. With `--panels` also write each panel that was computed, without
/// its texts, as OUT/NN_name/panels/<file>/<panel_name>.png.
void save_panels(const Options& options, const std::string& file, int columns, const std::vector<Panel>& panels);

/// One panel that is the whole picture; with `--panels` it is OUT/NN_name/panels/<file>.png, too.
void save_panel(const Options& options, const std::string& file, const Panel& panel);

/// Read the scene file of an example and give it the size of the command line.
[[nodiscard]] scene::Scene read_scene(const Options& options, const std::string& path);

/// Render a scene to linear radiance and save it with the scene's own exposure, tone map and transfer function.
void render_and_save(const Options& options, const std::string& file, const scene::Scene& scene);

}  // namespace kreda::examples
