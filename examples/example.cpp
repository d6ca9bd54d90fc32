#include "examples/example.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <tuple>

#include <CLI/CLI.hpp>
#include <glm/common.hpp>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "tools/shell_quotes.hpp"

namespace kreda::examples {

namespace {

constexpr glm::ivec2 kDraftSize(640, 360);

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

/// `name` may have one folder in it.
void write_panel(const Options& options, const std::string& name, const Image& encoded) {
    const std::filesystem::path file = options.folder + "/panels/" + name + ".png";
    make_folder(file.parent_path().string());
    scene::write_png(file.string(), encoded);
}

/// A line for each text of a picture: the picture's name and size, the text's box and size, the text.
std::string layout_lines(const std::string& file, const Composition& picture) {
    std::ostringstream lines;
    for (const TextBox& text : picture.texts) {
        lines << file << ' ' << picture.image.width << ' ' << picture.image.height << ' ' << text.box.low.x << ' '
              << text.box.low.y << ' ' << text.box.high.x << ' ' << text.box.high.y << ' ' << text.size << ' '
              << text.text << '\n';
    }
    return lines.str();
}

void write_composition(const Options& options, const std::string& file, const Composition& picture) {
    scene::write_png(options.folder + "/" + file + ".png", develop(picture.image, {}));
    if (!options.panels) return;
    make_folder(options.folder + "/panels");
    std::ofstream layout(options.folder + "/panels/layout.txt", std::ios::app);
    if (!(layout << layout_lines(file, picture))) throw scene::UserError(scene::Place{options.folder}, "cannot write");
}

/// The slides of the example's page with the pictures that were drawn: 0, or 2 where they could not be made.
int make_slides(const std::string& out, const std::string& name, const std::string& theme) {
    const std::string command = "python3 " + tools::in_shell_quotes(KREDA_COURSE_FOLDER "/docs/site/slides.py") +
                                " --out " + tools::in_shell_quotes(out) + " --theme " + theme + " " + name;
    if (std::system(command.c_str()) == 0) return 0;
    throw scene::UserError(
        "--slides: the slides were not made; python3 and its matplotlib make them (apt-get install "
        "python3-matplotlib)");
}

}  // namespace

int run(int argc, char** argv, const std::string& name, void (*draw)(const Options&)) {
    Options options;
    std::string out = "out", size, theme = "dark";
    bool slides = false;
    CLI::App app("Example " + name + ": writes its pictures to OUT/" + name + "/. Its page: docs/" + name + ".md");
    app.add_option("--out", out, "folder for the pictures, made if need be (default: out)");
    app.add_option("--size", size, "size of the pictures (default: 1920x1080, of drafts 640x360)");
    app.add_flag("--draft", options.draft, "small and fast, as the pages show them: fewer samples a pixel");
    app.add_option("--theme", theme, "dark, for a projector, or light, for paper: captions, plots, drawings");
    app.add_flag("--slides", slides,
                 "also slides of 1920 x 1080 with the equations of the page: OUT/" + name + "/slides and slides.pdf");
    app.add_flag("--panels", options.panels,
                 "also write what was computed, panel by panel and without any text, and where the texts stand");
    try {
        app.parse(argc, argv);
        options.theme = tools::theme_named(theme, "--theme");
        if (options.draft) options.samples = 1;
        if (options.draft) std::tie(options.width, options.height) = std::tuple(kDraftSize.x, kDraftSize.y);
        if (!size.empty()) read_size(size, options);
        options.folder = out + "/" + name;
        make_folder(options.folder);
        std::filesystem::remove_all(options.folder + "/panels");
        draw(options);
        return slides ? make_slides(out, name, theme) : 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const scene::UserError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}

void save(const Options& options, const std::string& file, const raster::Image& linear,
          const raster::FilmSettings& film) {
    const Image picture = develop(linear, film);
    scene::write_png(options.folder + "/" + file + ".png", picture);
    if (options.panels) write_panel(options, file, picture);
}

void save_panels(const Options& options, const std::string& file, int columns, const std::vector<Panel>& panels) {
    write_composition(options, file, compose({options.width, options.height}, columns, panels, options.theme));
    for (std::size_t i = 0; options.panels && i < panels.size(); ++i) {
        if (!panels[i].is_computed) continue;
        write_panel(options, file + "/" + panel_name(i, panels[i]), develop(panels[i].image, {}));
    }
}

void save_panel(const Options& options, const std::string& file, const Panel& panel) {
    write_composition(options, file, compose({panel.image.width, panel.image.height}, 1, {panel}, options.theme));
    if (options.panels && panel.is_computed) write_panel(options, file, develop(panel.image, {}));
}

glm::ivec2 measured_size(const Options& options) {
    return glm::min(glm::ivec2(options.width, options.height), kDraftSize);
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
