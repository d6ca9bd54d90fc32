// kreda render: a scene file becomes a picture.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"
#include "scene/render/light_depth.hpp"
#include "scene/render/render.hpp"
#include "scene/render/stopwatch.hpp"
#include "scene/render/threads.hpp"
#include "tools/bench/time_report.hpp"
#include "tools/commands.hpp"
#include "tools/draw/draw.hpp"
#include "tools/draw/slide.hpp"
#include "tools/kept_frames.hpp"
#include "tools/render_output.hpp"
#include "tools/scene_options.hpp"
#include "tools/stages/stage.hpp"
#include "tools/watch/watch.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::Place;
using scene::UserError;

struct RenderOptions {
    SceneOptions scene;
    CacheOptions cache;
    std::string output;  ///< empty: the scene's name and .png, in the current folder
    std::string view;    ///< a view's name; empty: the picture itself
    int threads = 0;     ///< 0: as many as there are cores
    int repeat = 1;
    bool time = false;
    bool watch = false;   ///< draw again at every change
    std::string slides;   ///< "dark" or "light"; empty: the picture alone
    std::string title;    ///< of the slide; empty: the example's or the scene's name
    std::string caption;  ///< of the slide; empty: the view, or what --set changed
};

std::string output_path(const RenderOptions& options) {
    if (!options.output.empty()) return options.output;
    if (options.scene.file.empty()) return "built_in.png";
    return fs::path(options.scene.file).stem().string() + ".png";
}

const scene::View* chosen_view(const std::string& name) {
    if (name.empty()) return nullptr;
    std::vector<std::string> names;
    for (const scene::View* view : scene::known_views()) {
        if (view->name == name) return view;
        names.emplace_back(view->name);
    }
    const std::string near = scene::nearest_word(name, names);
    throw UserError("--view " + name + ": there is no such view" +
                    (near.empty() ? "" : "; did you mean " + near + "?") + " (kreda render --help lists them)");
}

/// What stands on the slide: by default the view, else what the command line changed in the scene.
SlideText slide_text(const RenderOptions& options, const scene::View* view) {
    SlideText text{options.title.empty() ? title_of_scene(options.scene.file) : options.title, options.caption, ""};
    if (view) text.remark = view->meaning;
    if (!text.caption.empty()) return text;
    if (view) text.caption = view->name;
    for (const std::string& change : options.scene.read.overrides)
        text.caption += (text.caption.empty() ? "" : ", ") + change;
    return text;
}

raster::Image values_of(const scene::View& view, const scene::RenderBuffers& buffers) {
    return scene::is_light_depth(&view) ? light_depth(buffers) : buffers.views[0];
}

void write_slide(const std::string& path, const RenderOptions& options, const scene::View* view,
                 const scene::RenderBuffers& buffers, const scene::Scene& scene) {
    raster::FilmReport report;
    raster::Image picture = view ? picture_of(*view, values_of(*view, buffers), scene).encoded
                                 : develop(buffers.film, film_settings(scene.image), &report);
    if (scene::is_light_depth(view)) {
        const glm::ivec2 size = slide_picture_size(picture.width, picture.height);
        picture = fit(picture, size.x, size.y);
    }
    scene::write_png(path, make_slide(picture, slide_text(options, view), theme_named(options.slides, "--slides")));
    warn_of_film(report, false);
    std::cerr << "wrote " << path << " (a slide of " << kSlideWidth << " x " << kSlideHeight << ")\n";
}

bool is_black(const scene::RenderPlan& plan, const scene::RenderBuffers& buffers,
              const scene::RenderStatistics& frame) {
    if (plan.bytes) return !frame.shown.any_light;
    const auto& values = buffers.film.values;
    return std::all_of(values.begin(), values.end(), [](float value) { return value == 0.0f; });
}

/// What leads to the view alone; a light's shadow map is found on the way to the picture. An EXR and a slide, which
/// fits the picture into its frame, are made of radiance.
scene::PlanRequest request_for(const RenderOptions& options, const std::string& path, const scene::View* view) {
    if (!view) return is_exr(path) || !options.slides.empty() ? scene::PlanRequest{} : png_request();
    if (scene::is_light_depth(view)) return {.prune = false};
    return {.views = {view}, .film = false};
}

void check_view(const scene::RenderPlan& plan, const scene::Scene& scene, const scene::View& view) {
    if (can_show(plan, scene, view)) return;
    std::string why = "--view " + std::string(view.name) + ": this scene has nothing to show; it needs " +
                      std::string(view.requires_what);
    for (const scene::LeftOutPass& pass : plan.left_out) {
        if (scene::is_light_depth(&view) && pass.name == "shadows") why += "; here " + pass.why_not;
    }
    throw UserError(why);
}

void check_slides(const RenderOptions& options, const std::string& path) {
    if (options.slides.empty()) {
        if (options.title.empty() && options.caption.empty()) return;
        throw UserError("--title and --caption are written on slides: add --slides dark or --slides light");
    }
    static_cast<void>(theme_named(options.slides, "--slides"));
    if (is_exr(path)) throw UserError(Place{path}, "a slide is a .png; without --slides an .exr holds the numbers");
}

/// Read, draw and write. `writing` is held while a file is written.
void render_once(const RenderOptions& options, const std::string& path, const scene::View* view, KeptFrames& kept,
                 std::mutex& writing) {
    TimeReport report;
    scene::Stopwatch watch;
    SceneOptions with_store = options.scene;
    if (options.watch) with_store.read.files = &kept.files;
    auto [scene, plan] = load_and_plan(with_store, request_for(options, path, view), [&](scene::Scene& loaded) {
        if (!options.slides.empty()) fit_to_slide(loaded.image);
    });
    if (view) check_view(make_plan_for(scene, scene::PlanRequest{.prune = false}), scene, *view);
    report.around.load = watch.lap_ms();
    bake_kept(scene, plan, options.cache, kept);
    report.around.bake = watch.lap_ms();
    const scene::RenderBuffers& buffers = kept.buffers;
    for (int i = 0; i < options.repeat; ++i) {
        report.frames.push_back(render(scene, plan, kept.buffers, options.threads));
    }
    const std::uint64_t dropped = report.frames.back().triangles.non_finite;
    if (dropped > 0) warn(std::to_string(dropped) + " triangles were dropped: a corner is not a finite number");
    if (plan.film && plan.draws_objects && is_black(plan, buffers, report.frames.back())) {
        warn_of_scene({"the picture is black; what is seen needs a light that is on, ambient light or emission"},
                      options.scene);
    }
    watch.lap_ms();
    const std::lock_guard<std::mutex> whole(writing);
    const scene::ThreadLimit limit(options.threads);  // strips of a PNG are compressed side by side
    if (!options.slides.empty())
        write_slide(path, options, view, buffers, scene);
    else if (view)
        write_view(path, *view, values_of(*view, buffers), scene);
    else if (plan.bytes)
        write_bytes(path, buffers.bytes, report.frames.back().shown.report);
    else
        write_picture(path, buffers.film, scene.image);
    if (!options.time) return;
    report.around.write = watch.lap_ms();
    report.width = scene.image.width;
    report.height = scene.image.height;
    report.samples = scene.image.samples;
    report.threads = static_cast<int>(buffers.scratch.size());
    std::cout << json_line(report) << std::endl;
}

void check_watch(const RenderOptions& options) {
    std::error_code unknown;
    if (fs::is_regular_file(options.scene.file, unknown)) return;
    throw UserError("--watch needs a scene file or a mesh that can change" +
                    (options.scene.file.empty() ? "" : ": " + options.scene.file + " is no file"));
}

void render_command(const RenderOptions& options) {
    const std::string path = output_path(options);
    check_output(path);
    check_slides(options, path);
    if (options.watch) check_watch(options);
    const scene::View* view = chosen_view(options.view);
    KeptFrames kept;
    kept.buffers.keeps_results = options.watch && options.repeat == 1;
    std::mutex writing;
    if (options.watch) watch(path, kept.files, writing, [&] { render_once(options, path, view, kept, writing); });
    render_once(options, path, view, kept, writing);
}

std::string view_list() {
    std::string list = "Views:\n";
    for (const scene::View* view : scene::known_views()) {
        std::string line = "  " + std::string(view->name);
        line.resize(std::max<std::size_t>(line.size() + 2, 21), ' ');
        list += line + std::string(view->meaning) + "\n";
    }
    return list;
}

constexpr const char* kRenderExamples = R"(
A view is a quantity of the pipeline as a picture: an EXR holds its numbers, a PNG shows light as the scene's own picture,
directions as (x + 1) / 2, shares of 0..1 as 255 x, other numbers between the least (black) and the greatest (white).
light_depth is as large as the map (shadow.size; six in a row for a point light: +x -x +y -y +z -z), and an EXR of it holds
3.4e38 where nothing casts. Of several lights, --light chooses.

The scene file is described by `kreda keys`; a value given here wins over the file's.
--time prints one line of JSON, milliseconds from the loaded scene to the linear film, without loading, tone mapping and
writing. Its stages are the passes of kreda plan, in that order; those that threads share tile by tile take parts of the
common time. Baking is done before, and not part of total_ms; "around" has what loading, baking and writing take, once, and
what the tone map and 8 bits take where a PNG is written: the stage "film" then, which is not part of total_ms.
pixels_shaded counts visible samples: with --samples 2 up to four a pixel.
An environment is baked before the first frame. Its maps are kept in .kreda-cache beside the scene file, for the next render;
delete the folder at will.

Examples:
  kreda render scene.toml -o picture.png
  kreda render bunny.obj                                         any mesh, the camera in front of it
  kreda render lamp.glb                                          a glTF scene with its materials, camera and lights
  kreda render scene.toml -o picture.exr --size 1920x1080        linear float, before tone mapping
  kreda render scene.toml --set camera.position=[0,1,4] --samples 4
  kreda render scene.toml --cache ../maps                        keep the environment's maps there
  kreda render scene.toml --watch                                draw again whenever a file of the scene is saved
  kreda render scene.toml --view normal -o normal.png
  kreda render scene.toml --light 0 --view light_depth           what light.0 sees: its shadow map
  kreda render scene.toml -o slide.png --slides dark             1920 x 1080 with title and caption
  kreda render --repeat 15 --time --threads 2                    how long a frame takes)";

}  // namespace

void add_render_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Draw a scene into a PNG or EXR file");
    const auto options = std::make_shared<RenderOptions>();
    add_scene_options(*command, options->scene);
    add_cache_options(*command, options->cache);
    command
        ->add_option("-o,--output", options->output,
                     "The picture: .png (8-bit sRGB) or .exr (linear float); by default SCENE.png in this folder")
        ->type_name("FILE");
    add_threads_option(*command, options->threads);
    command
        ->add_option("--slides", options->slides,
                     "A slide of 1920 x 1080, dark or light: the picture in the shape of --size, as large as it fits")
        ->type_name("GROUND");
    command->add_option("--title", options->title, "Title of the slide; by default the example's or the scene's name")
        ->type_name("TEXT");
    command
        ->add_option("--caption", options->caption, "Caption of the slide; by default the view, or what --set changed")
        ->type_name("TEXT");
    command->add_flag("--time", options->time, "Print the time of each pass as one line of JSON");
    command->add_option("--repeat", options->repeat, "Draw N times; --time gives the median of each number")
        ->type_name("N")
        ->check(CLI::Range(1, 100000));
    command->add_flag("--watch", options->watch,
                      "Draw again whenever the scene or a file that it names changes; Ctrl-C ends it");
    command->add_option("--view", options->view, "Draw this quantity instead of the picture; the list is below")
        ->type_name("NAME");
    command->footer("\n" + view_list() + kRenderExamples);
    command->callback([options] { render_command(*options); });
}

}  // namespace kreda::tools
