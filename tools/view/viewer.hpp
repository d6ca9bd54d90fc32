// A scene that is drawn again and again: what the page of `kreda view` asks of the module, without the browser.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "raster/film.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/toml_tree.hpp"
#include "scene/render/render.hpp"

namespace kreda::tools {

/// A picture for a screen: red, green, blue and 255 for each pixel, rows from the top.
struct ScreenPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// The bytes that a display shows of radiances that begin with the same upper 16 bits: one, and from `next` on the one
/// after it.
struct DisplayStep {
    float next = 0.0f;  ///< NaN: there is none
    int first = 0;      ///< -1: they are more than two
};

/// What a display shows, looked up: developing a film value by value takes longer than drawing it.
struct DisplayBytes {
    raster::FilmSettings settings;
    std::vector<DisplayStep> steps;  ///< one for each 16 bits; empty: not made yet
};

/// All that lives from frame to frame.
struct Viewer {
    std::string path;   ///< of the scene or the mesh
    std::string text;   ///< of the scene file, or of the scene around the mesh
    scene::Value tree;  ///< the same with all changes
    scene::Scene scene;
    scene::LoadedFiles files;           ///< meshes and images that a change does not touch are not read again
    const scene::View* view = nullptr;  ///< nullptr: the picture itself
    scene::RenderPlan plan;
    bool is_planned = false;
    scene::RenderBuffers buffers;
    DisplayBytes display;
    ScreenPicture picture;
};

/// Read a scene file, or a mesh and the scene around it, with these changes ("fog.density=0.3"). Where that fails the
/// viewer stays as it is. Throws UserError.
void open_scene(Viewer& viewer, const std::string& path, const std::vector<std::string>& overrides);

/// What the page makes its controls of: "warnings"; "tables", the scene file as it was read; "camera" as it stands
/// after all changes; "views" that the scene can show.
[[nodiscard]] nlohmann::ordered_json describe(const Viewer& viewer);

/// Where the camera stands, in the file's world.
struct CameraPose {
    glm::dvec3 position{0.0}, target{0.0}, up{0.0, 1.0, 0.0};
};
void move_camera(Viewer& viewer, const CameraPose& pose);

/// The size of the next picture in pixels, and the samples a pixel; 0: what the scene says.
void set_size(Viewer& viewer, int width, int height, int samples);

/// Show this view from now on; "": the picture. Throws UserError where there is none of that name.
void choose_view(Viewer& viewer, const std::string& name);

/// Draw one frame into viewer.picture. Returns the milliseconds of all passes, without the way to the screen.
double draw(Viewer& viewer);

/// The picture's own frame, linear, as the film holds it: a hash of its bits.
[[nodiscard]] std::uint64_t hash_of_film(const Viewer& viewer);

/// The life of a pixel: "text" as `kreda explain` prints it; "vectors": n, v, and l, h, r of each light, from "at", all
/// in pixels of the picture.
[[nodiscard]] nlohmann::ordered_json explain_on_screen(const Viewer& viewer, int x, int y);

/// The scene file with these changes.
[[nodiscard]] std::string changed_text(const Viewer& viewer, const std::vector<std::string>& overrides);

}  // namespace kreda::tools
