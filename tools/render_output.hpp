// Pictures and views as files: PNG for looking at, EXR for the numbers.
#pragma once

#include <string>

#include "raster/film.hpp"
#include "raster/image.hpp"
#include "scene/plan/views.hpp"
#include "scene/scene.hpp"

namespace kreda::tools {

[[nodiscard]] bool is_exr(const std::string& path);

/// Before anything is loaded or drawn: nobody should wait for a picture that cannot be written. Throws UserError.
void check_output(const std::string& path);

/// A warning each for values of a film that no picture can show.
void warn_of_film(const raster::FilmReport& report, bool linear);

/// Write a view's values and say what they are. Throws UserError.
void write_view(const std::string& path, const scene::View& view, const raster::Image& values,
                const scene::Scene& scene);

/// Write the film. Throws UserError.
void write_picture(const std::string& path, const raster::Image& film, const scene::ImageSettings& settings);

}  // namespace kreda::tools
