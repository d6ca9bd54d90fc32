// Pictures and views as files: PNG for looking at, EXR for the numbers.
#pragma once

#include <string>

#include "raster/display_bytes.hpp"
#include "raster/film.hpp"
#include "raster/image.hpp"
#include "scene/plan/views.hpp"
#include "scene/plan/wanted.hpp"
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

/// Built without optimisation, to be looked at step by step.
#if defined(__OPTIMIZE__)
inline constexpr bool kBuiltForDebugger = false;
#else
inline constexpr bool kBuiltForDebugger = true;
#endif

/// What is asked for where a PNG of the picture is written: 8 bits a channel. A program that is built for the debugger
/// keeps the film, and develops it afterwards: one step after another.
[[nodiscard]] scene::PlanRequest png_request();

/// Write a picture in 8 bits, and warn of what it could not hold. Throws UserError.
void write_bytes(const std::string& path, const raster::ByteImage& picture, const raster::FilmReport& report);

/// Write the film. Throws UserError.
void write_picture(const std::string& path, const raster::Image& film, const scene::ImageSettings& settings);

}  // namespace kreda::tools
