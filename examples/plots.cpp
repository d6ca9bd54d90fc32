#include "examples/plots.hpp"

#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include <png.h>

#include "raster/film.hpp"
#include "tools/draw/gnuplot.hpp"
#include "tools/write_file.hpp"

namespace kreda::examples {

namespace {

/// A PNG file that gnuplot has just written, as linear RGB; an empty image where it cannot be read.
Image read_plot(const std::string& file) {
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&header, file.c_str()) == 0) return {};
    header.format = PNG_FORMAT_RGB;
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(header));
    if (png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr) == 0) return {};
    Image image = make_board(static_cast<int>(header.width), static_cast<int>(header.height));
    const auto linear = [](png_byte code) { return raster::linear_from_srgb(static_cast<float>(code) / 255.0f); };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const png_byte* pixel = &bytes[3 * static_cast<std::size_t>(y * image.width + x)];
            image.set_rgb(x, y, {linear(pixel[0]), linear(pixel[1]), linear(pixel[2])});
        }
    }
    return image;
}

/// The CSV file, and with gnuplot the pictures.
bool write_plot(const Options& options, const std::string& name, const std::string& title, const Plot& plot,
                glm::ivec2 size, float type_size) {
    const std::string path = options.folder + "/" + name;
    tools::write_file(path + ".csv", csv_of(plot));
    const tools::PlotLook look{size, type_size, options.theme};
    return draw_plot(plot, title, path, look);
}

}  // namespace

Plot empty_plot(std::string x, std::string y, bool log_x, bool log_y) {
    Plot plot;
    plot.x = std::move(x);
    plot.y = std::move(y);
    plot.log_x = log_x;
    plot.log_y = log_y;
    return plot;
}

Panel plot_panel(const Options& options, const std::string& name, const std::string& title, const Plot& plot,
                 glm::ivec2 size) {
    Panel panel = empty_panel(size);
    if (!write_plot(options, name, title, plot, size, tools::least_type_size(options.height))) {
        panel.caption = name + ".csv; no gnuplot";
        return panel;
    }
    const std::string file = options.folder + "/" + name + ".png";
    paste(panel.image, read_plot(file), 0, 0);
    panel.is_drawing = false;
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return panel;
}

void save_plot(const Options& options, const std::string& name, const std::string& title, const Plot& plot) {
    if (write_plot(options, name, title, plot, {options.width, options.height}, caption_size(options.height))) return;
    std::cerr << "note: " << name << ".csv is not drawn: gnuplot is not installed (apt-get install gnuplot-nox)\n";
}

}  // namespace kreda::examples
