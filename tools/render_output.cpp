#include "tools/render_output.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <vector>

#include "scene/files/image_file.hpp"
#include "scene/plan/origin_words.hpp"
#include "tools/scene_options.hpp"

namespace kreda::tools {

namespace fs = std::filesystem;
using scene::Place;
using scene::UserError;

bool is_exr(const std::string& path) {
    const std::string extension = fs::path(path).extension().string();
    return extension == ".exr" || extension == ".EXR";
}

/// Before anything is loaded or drawn: nobody should wait for a picture that cannot be written.
void check_output(const std::string& path) {
    const std::string extension = fs::path(path).extension().string();
    if (!is_exr(path) && extension != ".png" && extension != ".PNG") {
        throw UserError(Place{path},
                        "pictures are .png (8-bit sRGB) or .exr (linear float); end the name with one of them");
    }
    const fs::path folder = fs::path(path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
        throw UserError(Place{path}, "the folder " + folder.string() + " does not exist; create it first");
    }
    if (fs::is_directory(path, ignored)) throw UserError(Place{path}, "is a folder; a picture needs a file name");
}

void warn_of_film(const raster::FilmReport& report, bool linear) {
    const auto values = [](std::uint64_t count, const char* what) { return std::to_string(count) + what; };
    if (report.not_a_number > 0)
        warn(values(report.not_a_number, " values of the picture are not a number; written as 0"));
    if (report.infinite > 0)
        warn(values(report.infinite, " values of the picture are infinite; written as the largest value"));
    if (report.negative > 0 && !linear)
        warn(values(report.negative, " values of the picture are negative; written as 0"));
}

void write_view(const std::string& path, const scene::View& view, const raster::Image& values,
                const scene::Scene& scene) {
    if (is_exr(path)) {
        const bool grey = view.components == 1;
        scene::write_exr(path, raster::without_non_finite(values),
                         grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"});
    } else {
        const scene::ViewPicture picture = picture_of(view, values, scene);
        scene::write_png(path, picture.encoded);
        for (const scene::ValueRange& range : picture.ranges) {
            if (std::isfinite(range.least)) {
                std::cerr << "black is " << range.least << ", white is " << range.greatest << "\n";
            } else {
                std::cerr << "all of it is background\n";
            }
        }
    }
    std::cerr << "wrote " << path << " (" << values.width << " x " << values.height << "), " << view.name << ": "
              << view.meaning << "\n";
    if (view.name == "position" && scene::is_far_from_zero(scene)) std::cerr << scene::origin_sentence(scene) << "\n";
}

scene::PlanRequest png_request() {
    return {.bytes = !kBuiltForDebugger};
}

void write_bytes(const std::string& path, const raster::ByteImage& picture, const raster::FilmReport& report) {
    scene::write_png(path, scene::PngPicture{picture.width, picture.height, picture.channels, picture.values});
    warn_of_film(report, false);
    std::cerr << "wrote " << path << " (" << picture.width << " x " << picture.height << ")\n";
}

void write_picture(const std::string& path, const raster::Image& film, const scene::ImageSettings& settings) {
    raster::FilmReport report;
    const bool linear = is_exr(path);
    if (linear) {
        scene::write_exr(path, raster::without_non_finite(film, &report));
    } else {
        scene::write_png(path, raster::develop(film, film_settings(settings), &report));
    }
    warn_of_film(report, linear);
    std::cerr << "wrote " << path << " (" << film.width << " x " << film.height << ")\n";
}

}  // namespace kreda::tools
