// kreda sweep: a table of pictures over one or two keys, or frames of an animation.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/whole_file.hpp"
#include "tools/commands.hpp"
#include "tools/progress_bar.hpp"
#include "tools/sweep/animated_png.hpp"
#include "tools/sweep/sheet.hpp"
#include "tools/sweep/sweep.hpp"
#include "tools/sweep/sweep_axis.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::UserError;

struct SweepOptions {
    SceneOptions scene;
    CacheOptions cache;
    std::string output;
    std::string view;
    std::string against;  ///< "COLUMN,ROW", from 1; empty: nothing is compared
    std::string sheet = "1920x1080";
    int frames = 0;         ///< 0: a sheet
    int milliseconds = 40;  ///< a frame
    bool around = false;    ///< the last frame is followed by the first
    int threads = 0;
};

/// "1920x1080". Throws UserError.
glm::ivec2 size_of(const std::string& option, const std::string& text) {
    glm::ivec2 size(0);
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest) != 2 || size.x < 16 || size.y < 16 ||
        size.x > 16384 || size.y > 16384) {
        throw UserError(option + " " + text + ": expected WIDTHxHEIGHT, 16 to 16384 pixels each, e.g. 1920x1080");
    }
    return size;
}

/// The keys with several values become the axes, the others stay what --set is.
std::vector<SweepAxis> take_axes(std::vector<std::string>& overrides) {
    std::vector<SweepAxis> axes;
    std::vector<std::string> single;
    for (const std::string& set : overrides) {
        const SweepAxis axis = listed_axis(set);
        if (axis.values.size() > 1)
            axes.push_back(axis);
        else
            single.push_back(set);
    }
    if (axes.empty()) {
        throw UserError("kreda sweep: no key has several values; e.g. --set material.0.roughness=0.1,0.4,0.8");
    }
    if (axes.size() > 2) {
        throw UserError("kreda sweep: a sheet has columns and rows, so two keys may have several values; '" +
                        axes[2].key + "' is the third");
    }
    overrides = single;
    return axes;
}

/// The cell of --against; -1: none. Throws UserError.
int compared_cell(const std::string& against, int columns, int rows) {
    if (against.empty()) return -1;
    int column = 0, row = 1;
    char rest = 0;
    const int read = std::sscanf(against.c_str(), "%d,%d%c", &column, &row, &rest);
    if (read < 1 || read > 2 || column < 1 || column > columns || row < 1 || row > rows) {
        throw UserError("--against " + against + ": expected COLUMN,ROW from 1,1 to " + std::to_string(columns) + "," +
                        std::to_string(rows));
    }
    return (row - 1) * columns + column - 1;
}

/// Show how every picture differs from the chosen one, which stays as it is.
void compare_with(Sheet& sheet, int chosen) {
    const raster::Image expected = sheet.pictures[static_cast<std::size_t>(chosen)];
    for (std::size_t i = 0; i < sheet.pictures.size(); ++i) {
        if (static_cast<int>(i) == chosen) {
            sheet.remarks.emplace_back("compared with this");
            continue;
        }
        const PictureError error = picture_error(sheet.pictures[i], expected);
        char text[64];
        std::snprintf(text, sizeof text, "mean %.2f, worst %d of 255", error.mean, error.worst);
        sheet.remarks.emplace_back(text);
        sheet.pictures[i] = picture_difference(sheet.pictures[i], expected);
    }
}

Sheet empty_sheet(const std::vector<SweepAxis>& axes, bool with_remarks) {
    Sheet sheet{axes[0].key, "", axes[0].values, {""}, {}, {}};
    if (axes.size() > 1) {
        sheet.row_key = axes[1].key;
        sheet.rows = axes[1].values;
    }
    if (with_remarks) sheet.remarks = {""};  // room for them
    return sheet;
}

void make_sheet(SweepOptions options, const scene::View* view) {
    const std::vector<SweepAxis> axes = take_axes(options.scene.read.overrides);
    Sheet sheet = empty_sheet(axes, !options.against.empty());
    const int columns = static_cast<int>(sheet.columns.size()), rows = static_cast<int>(sheet.rows.size());
    const int chosen = compared_cell(options.against, columns, rows);
    const glm::ivec2 whole = size_of("--sheet", options.sheet);
    SweepRenderer renderer(options.scene, options.cache, view, options.threads);
    if (options.scene.size.empty()) {
        const glm::ivec2 size = renderer.picture_size();
        renderer.set_size(sheet_picture_size(sheet, whole, static_cast<float>(size.x) / static_cast<float>(size.y)));
    }
    sheet.remarks.clear();
    ProgressBar bar("drawing " + std::to_string(columns * rows) + " pictures");
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            bar.show(static_cast<double>(row * columns + column) / (columns * rows));
            std::vector<std::string> values{axes[0].override_at(static_cast<std::size_t>(column))};
            if (axes.size() > 1) values.push_back(axes[1].override_at(static_cast<std::size_t>(row)));
            sheet.pictures.push_back(renderer.draw(values));
        }
    }
    bar.clear();
    if (chosen >= 0) compare_with(sheet, chosen);
    const raster::Image picture = draw_sheet(sheet);
    scene::write_png(options.output, picture);
    std::cerr << "wrote " << options.output << " (" << picture.width << " x " << picture.height << ", " << columns
              << " x " << rows << " pictures)\n";
}

/// Frames as files in a folder, 0001.png, 0002.png and so on; the names of as many digits as the last needs, at
/// least 4.
void write_frames(const std::string& folder, const std::vector<std::vector<unsigned char>>& frames) {
    make_folder(folder);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "%04zu.png", i + 1);
        scene::write_whole_file((fs::path(folder) / name).string(), {std::as_bytes(std::span(frames[i]))});
    }
}

/// The PNG files of pictures, encoded side by side: that takes longer than drawing most of them.
void encode_side_by_side(const std::string& path, std::vector<raster::Image>& pictures,
                         std::vector<std::vector<unsigned char>>& files) {
    const int count = static_cast<int>(pictures.size());
    const std::size_t first = files.size();
    std::exception_ptr failure;
    files.resize(first + pictures.size());
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<std::size_t>(i);
        try {
            files[first + number] = scene::png_file_of(path, pictures[number]);
        } catch (...) {
#pragma omp critical(encoding_failed)
            failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
    pictures.clear();
}

void make_frames(SweepOptions options, const scene::View* view) {
    constexpr std::size_t kTogether = 8;  // pictures that wait to be encoded
    std::vector<SweepAxis> axes;
    for (const std::string& set : options.scene.read.overrides)
        axes.push_back(stepped_axis(set, options.frames, options.around));
    options.scene.read.overrides.clear();
    SweepRenderer renderer(options.scene, options.cache, view, options.threads);
    std::vector<std::vector<unsigned char>> frames;
    std::vector<raster::Image> drawn;
    ProgressBar bar("drawing " + std::to_string(options.frames) + " frames");
    for (int i = 0; i < options.frames; ++i) {
        bar.show(static_cast<double>(i) / options.frames);
        std::vector<std::string> values;
        for (const SweepAxis& axis : axes)
            values.push_back(axis.override_at(axis.values.size() > 1 ? static_cast<std::size_t>(i) : 0));
        drawn.push_back(renderer.draw(values));
        if (drawn.size() == kTogether) encode_side_by_side(options.output, drawn, frames);
    }
    encode_side_by_side(options.output, drawn, frames);
    bar.clear();
    if (fs::path(options.output).extension() == ".png") {
        const std::vector<unsigned char> file = animated_png(frames, options.milliseconds);
        scene::write_whole_file(options.output, {std::as_bytes(std::span(file))});
    } else {
        write_frames(options.output, frames);
    }
    std::cerr << "wrote " << options.output << " (" << frames.size() << " frames)\n";
}

void sweep_command(const SweepOptions& options) {
    const std::string extension = fs::path(options.output).extension().string();
    if (options.frames == 0 && extension != ".png") {
        throw UserError("-o " + options.output + ": a sheet is a .png; with --frames also a folder");
    }
    if (options.frames > 0 && !extension.empty() && extension != ".png") {
        throw UserError("-o " + options.output + ": frames become an animated .png, or numbered files in a folder");
    }
    if (options.frames > 0 && !options.against.empty()) throw UserError("--against is for sheets, not for --frames");
    const scene::View* view = options.view.empty() ? nullptr : scene::find_view(options.view);
    if (!options.view.empty() && !view) {
        throw UserError("--view " + options.view + ": there is no such view (kreda render --help lists them)");
    }
    if (options.frames > 0)
        make_frames(options, view);
    else
        make_sheet(options, view);
}

constexpr const char* kSweepExamples = R"(
A --set with several values, KEY=A,B,C, is an axis: the first becomes the columns, the second the rows. With --frames N a
--set KEY=FROM..TO walks from the first number, or list of numbers, to the last, several keys side by side.
camera.orbit turns the camera about its target: camera.orbit=0..360 with --around is a turntable without a jump.
-o turn.png is an animated PNG, which every browser shows; -o turn a folder of 0001.png, 0002.png, ...; of those ffmpeg
makes a film: ffmpeg -framerate 25 -i turn/%04d.png -pix_fmt yuv420p turn.mp4

Examples:
  kreda sweep ball.toml --set material.0.roughness=0.1,0.3,0.5,0.7,0.9 --set material.0.metallic=0,0.5,1 -o sheet.png
  kreda sweep shadows.toml --set shadow.size=256,1024,4096 --set 'shadow.filter="none","pcf"' --against 3,1 -o sheet.png
  kreda sweep scene.toml --frames 48 --set camera.orbit=0..360 --around -o turn.png
  kreda sweep scene.toml --frames 25 --set fog.density=0..0.4 -o fog)";

}  // namespace

void add_sweep_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("sweep", "A table of pictures over one or two keys, or frames of an animation");
    const auto options = std::make_shared<SweepOptions>();
    add_scene_options(*command, options->scene);
    add_cache_options(*command, options->cache);
    command->add_option("-o,--output", options->output, "The sheet or the animation (.png), or a folder for frames")
        ->type_name("FILE|FOLDER")
        ->required();
    command->add_option("--view", options->view, "Draw this quantity instead of the picture")->type_name("NAME");
    command
        ->add_option("--against", options->against,
                     "Show how each picture differs from this one, 4 times as strong about grey, with the error below")
        ->type_name("COLUMN,ROW");
    command->add_option("--sheet", options->sheet, "Size of the whole sheet, unless --size gives that of a picture")
        ->type_name("WxH")
        ->capture_default_str();
    command->add_option("--frames", options->frames, "Draw N frames instead of a sheet")
        ->type_name("N")
        ->check(CLI::Range(2, 9999));
    command->add_flag("--around", options->around, "The last frame is a step before the first, for turns of 360");
    command->add_option("--ms", options->milliseconds, "How long an animated PNG shows a frame, in milliseconds")
        ->type_name("MS")
        ->check(CLI::Range(1, 65535))
        ->capture_default_str();
    add_threads_option(*command, options->threads);
    command->footer(kSweepExamples);
    command->callback([options] { sweep_command(*options); });
}

}  // namespace kreda::tools
