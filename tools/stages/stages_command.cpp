// kreda stages: every stage and every term of a picture as a picture of its own.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/plan/environment_plan.hpp"
#include "tools/bake/bake_scene.hpp"
#include "tools/commands.hpp"
#include "tools/draw/slide.hpp"
#include "tools/progress_bar.hpp"
#include "tools/scene_options.hpp"
#include "tools/stages/stage.hpp"
#include "tools/stages/stage_page.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::UserError;

struct StagesOptions {
    SceneOptions scene;
    CacheOptions cache;
    std::string output;
    std::string zoom;
    std::string slides;
    std::string title;
    bool exr = false;
    int threads = 0;  ///< 0: as many as there are cores
};

/// Writes one stage after another and remembers what the page and the contact sheet need.
class StageWriter {
public:
    StageWriter(const StagesOptions& options, const scene::Scene& scene, std::optional<Theme> ground)
        : options_(options), ground_(ground) {
        page_.title = options.title.empty() ? title_of_scene(options.scene.file) : options.title;
        page_.scene = options.scene.file;
        page_.size = {scene.image.width, scene.image.height};
        page_.picture_size = ground_ ? glm::ivec2(kSlideWidth, kSlideHeight) : page_.size;
        page_.corner = ground_ ? slide_picture_corner(page_.size) : glm::ivec2(0);
        page_.has_pixels = options.zoom.empty();
    }

    /// What `kreda plan` lists for the scene.
    void note_passes(const scene::RenderPlan& plan) {
        for (const scene::PlannedPass& pass : plan.passes) page_.passes.push_back({pass.name, pass.reason});
    }

    void write(const Stage& stage) {
        char number[16];
        std::snprintf(number, sizeof number, "%02zu_", page_.stages.size() + 1);
        const std::string name = number + stage.name;
        show_status(name);
        raster::Image picture = stage.picture;
        if (ground_) picture = make_slide(picture, slide_text(stage), *ground_);
        if (!ground_ && !page_.has_pixels) page_.picture_size = {picture.width, picture.height};
        scene::write_png(path(name + ".png"), picture);
        PageEntry entry{name + ".png", "", stage.title, stage.meaning, stage.legend, stage.components};
        if (!stage.values.values.empty()) {
            entry.values = "values/" + name + ".js";
            write_file(path(entry.values), values_script(page_.stages.size(), stage.values));
            if (options_.exr) scene::write_exr(path(name + ".exr"), without_non_finite(stage.values), stage.components);
        }
        page_.stages.push_back(entry);
        thumbnails_.push_back(thumbnail(stage.picture));
        titles_.push_back(stage.title);
    }

    void finish() {
        scene::write_png(path("contact_sheet.png"), contact_sheet(page_.title + ": the stages", thumbnails_, titles_));
        write_file(path("index.html"), stage_page_html(page_));
        show_status("");
        std::cerr << "wrote " << page_.stages.size() << " stages, contact_sheet.png and index.html to "
                  << options_.output << "\n";
    }

private:
    [[nodiscard]] std::string path(const std::string& file) const {
        return (fs::path(options_.output) / file).string();
    }

    [[nodiscard]] SlideText slide_text(const Stage& stage) const {
        return {page_.title, stage.title, stage.meaning + (stage.legend.empty() ? "" : ". " + stage.legend)};
    }

    const StagesOptions& options_;
    std::optional<Theme> ground_;
    StagePage page_;
    std::vector<raster::Image> thumbnails_;
    std::vector<std::string> titles_;
};

/// "300,140,12,8" -> a rectangle inside the picture.
PixelRectangle read_zoom(const std::string& text, const scene::ImageSettings& image) {
    const auto refuse = [&](const std::string& expected) {
        throw UserError("--zoom " + text + ": expected " + expected);
    };
    PixelRectangle part;
    char after = 0;
    const int read =
        std::sscanf(text.c_str(), "%6d,%6d,%6d,%6d%c", &part.x, &part.y, &part.width, &part.height, &after);
    if (read != 4) refuse("X,Y,W,H in pixels from the upper left, e.g. --zoom 300,140,12,8");
    if (part.width < 1 || part.height < 1 || part.width > 400 || part.height > 400)
        refuse("a width and height from 1 to 400 pixels");
    if (part.x < 0 || part.y < 0 || part.x + part.width > image.width || part.y + part.height > image.height) {
        refuse("pixels inside the picture, which is " + std::to_string(image.width) + " x " +
               std::to_string(image.height));
    }
    return part;
}

scene::Scene load(const StagesOptions& options) {
    scene::Scene scene = load_scene(options.scene);
    if (!options.slides.empty() && options.zoom.empty()) fit_to_slide(scene.image);
    return scene;
}

void stages_command(const StagesOptions& options) {
    std::optional<Theme> ground;
    if (!options.slides.empty()) ground = theme_named(options.slides, "--slides");
    scene::Scene scene = load(options);
    const glm::ivec2 zoom_room = options.slides.empty() ? glm::ivec2(1920, 1080) : slide_picture_size(1800, 760);
    std::optional<PixelRectangle> part;
    if (!options.zoom.empty()) part = read_zoom(options.zoom, scene.image);
    make_folder((fs::path(options.output) / "values").string());
    bake_scene(scene, environment_needs(scene), options.cache);
    StageWriter writer(options, scene, ground);
    writer.note_passes(make_plan_for(scene, {}));
    const auto write = [&](const Stage& stage) { writer.write(stage); };
    if (part) {
        for (const Stage& stage : zoom_stages(scene, *part, zoom_room.x, zoom_room.y, options.threads)) write(stage);
    } else {
        for_each_stage(scene, write, options.threads);
    }
    writer.finish();
}

constexpr const char* kStagesExamples = R"(
DIR gets one numbered PNG a stage, contact_sheet.png, and index.html, which opens from the file without a network: the
arrow keys step, the numbers of the pixel under the pointer stand below the picture, a click holds a pixel.
Only stages that the scene requires are there (kreda plan says which). The last picture is what kreda render writes.

Examples:
  kreda stages scene.toml -o stages
  kreda stages scene.toml -o stages --exr                  the numbers as EXR files, too
  kreda stages scene.toml -o slides --slides dark          1920 x 1080 with title and caption
  kreda stages scene.toml -o zoom --zoom 300,140,12,8      a few pixels drawn large: centres, vertices, edges)";

}  // namespace

void add_stages_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("stages", "Write every stage and every term of a picture as a picture");
    const auto options = std::make_shared<StagesOptions>();
    add_scene_options(*command, options->scene);
    add_cache_options(*command, options->cache);
    command->add_option("-o,--output", options->output, "Folder for the pictures, made if need be")
        ->type_name("DIR")
        ->required();
    add_threads_option(*command, options->threads);
    command->add_option("--zoom", options->zoom, "Only these pixels, drawn large with centres, vertices and edges")
        ->type_name("X,Y,W,H");
    command->add_option("--slides", options->slides, "Slides of 1920 x 1080: dark or light")->type_name("GROUND");
    command
        ->add_option("--title", options->title,
                     "Title of page and slides; by default the example's or the scene's name")
        ->type_name("TEXT");
    command->add_flag("--exr", options->exr, "Also write the numbers of each stage as an EXR file");
    command->footer(kStagesExamples);
    command->callback([options] { stages_command(*options); });
}

}  // namespace kreda::tools
