// kreda view: a scene as one page that draws it live, by the same code as WebAssembly.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/loaded_files.hpp"
#include "tools/commands.hpp"
#include "tools/scene_options.hpp"
#include "tools/view/view_page.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

struct ViewOptions {
    SceneOptions scene;
    std::string output;                 ///< empty: the scene's name and .html, in the current folder
    std::vector<std::string> controls;  ///< that stand first
};

std::string output_path(const ViewOptions& options) {
    if (!options.output.empty()) return options.output;
    if (options.scene.file.empty()) return "built_in.html";
    return fs::path(options.scene.file).stem().string() + ".html";
}

/// Before anything is read: nobody should wait for a page that cannot be written.
void check_output(const std::string& path) {
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".html" || extension == ".htm") return;
    throw scene::UserError(scene::Place{path}, "a page is written as .html; end the name with it");
}

/// What the command line changes, as the page's own changes: its controls show them.
std::vector<std::string> changes(const ViewOptions& options, const scene::Scene& scene) {
    std::vector<std::string> all = options.scene.read.overrides;
    if (!options.scene.size.empty()) {
        all.push_back("image.size=[" + std::to_string(scene.image.width) + "," + std::to_string(scene.image.height) +
                      "]");
    }
    if (options.scene.samples > 0) all.push_back("image.samples=" + std::to_string(options.scene.samples));
    for (std::size_t i = 0; options.scene.light >= 0 && i < scene.lights.size(); ++i) {
        if (static_cast<int>(i) != options.scene.light) all.push_back("light." + std::to_string(i) + ".on=false");
    }
    return all;
}

void view_command(ViewOptions options) {
    const std::string path = output_path(options);
    check_output(path);
    const std::string page = read_view_page(view_page_places());
    scene::LoadedFiles loaded;
    options.scene.read.files = &loaded;
    const scene::Scene scene = load_scene(options.scene);
    const CarriedScene carried = files_of_scene(scene, options.scene.file, loaded);
    const std::string text = page_with_scene(page, carried, {changes(options, scene), options.controls});
    write_file(path, text);
    std::cerr << "wrote " << path << " (" << text.size() / 1000 << " kB, " << carried.files.size()
              << (carried.files.size() == 1 ? " file" : " files") << " in it)\n";
    std::cout << "file://" << fs::absolute(path).lexically_normal().string() << "\n";
}

constexpr const char* kViewExamples = R"(
The page holds the program as WebAssembly, the scene and its files: it opens without a network and asks nothing of one. In
it the camera moves, every key of the scene file is a control, every view can be chosen, and a click on a pixel explains it.

Examples:
  kreda view                                      the built-in scene, into built_in.html
  kreda view scene.toml -o live.html
  kreda view bunny.obj                            any mesh, the camera in front of it
  kreda view scene.toml --set fog.density=0.2 --size 480x270)";

}  // namespace

void add_view_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("view", "Write one HTML page that draws a scene live, with controls");
    const auto options = std::make_shared<ViewOptions>();
    add_scene_options(*command, options->scene);
    command->add_option("-o,--output", options->output, "The page; by default SCENE.html in this folder")
        ->type_name("FILE");
    command
        ->add_option("--control", options->controls,
                     "A key whose control stands first, the others folded: fog.density, material.0.roughness; as often "
                     "as you like")
        ->type_name("KEY")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->footer(kViewExamples);
    command->callback([options] { view_command(*options); });
}

}  // namespace kreda::tools
