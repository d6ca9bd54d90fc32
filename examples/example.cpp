#include "examples/example.hpp"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

namespace kreda::examples {

namespace {

/// "640x360" -> width and height.
void read_size(const std::string& text, Options& options) {
    constexpr int kMaxSide = 4096;
    const auto refuse = [&] {
        throw scene::UserError("--size " + text + ": expected WIDTHxHEIGHT, each from 16 to " +
                               std::to_string(kMaxSide) + ", for example 640x360");
    };
    int width = 0, height = 0;
    char after_height = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &after_height) != 2) refuse();
    if (width < 16 || height < 16 || width > kMaxSide || height > kMaxSide) refuse();
    options.width = width;
    options.height = height;
}

void make_folder(const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw scene::UserError(scene::Place{folder}, "this folder cannot be made: " + failed.message());
}

}  // namespace

int run(int argc, char** argv, const std::string& name, void (*draw)(const Options&), Options options) {
    std::string out = "out";
    std::string size;
    CLI::App app("Example " + name + ": writes its pictures to OUT/" + name + "/. Its page: docs/" + name + ".md");
    app.add_option("--out", out, "folder for the pictures, made if need be (default: out)");
    app.add_option(
        "--size", size,
        "size of the pictures (default: " + std::to_string(options.width) + "x" + std::to_string(options.height) + ")");
    try {
        app.parse(argc, argv);
        if (!size.empty()) read_size(size, options);
        options.folder = out + "/" + name;
        make_folder(options.folder);
        draw(options);
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const scene::UserError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}

void save(const Options& options, const std::string& file, const raster::Image& linear,
          const raster::FilmSettings& film) {
    scene::write_png(options.folder + "/" + file + ".png", develop(linear, film));
}

scene::Scene read_scene(const Options& options, const std::string& path) {
    scene::Scene scene = scene::read_scene(path);
    scene.image.width = options.width;
    scene.image.height = options.height;
    return scene;
}

void render_and_save(const Options& options, const std::string& file, const scene::Scene& scene) {
    save(options, file, render(scene), film_settings(scene.image));
}

}  // namespace kreda::examples
