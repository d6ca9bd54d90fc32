#include "tools/scene_options.hpp"

#include <charconv>
#include <iostream>
#include <system_error>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/load_maps.hpp"
#include "scene/files/mesh_file.hpp"
#include "scene/plan/plan_warnings.hpp"
#include "tools/mesh_scene.hpp"
#include "tools/stages/stage.hpp"

namespace kreda::tools {

namespace {

/// "640x360" -> "[640,360]", what --set image.size wants. Throws UserError.
std::string size_value(const std::string& text) {
    const auto whole = [](const std::string& digits) {
        int number = 0;
        const char* end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, number);
        return error == std::errc() && stop == end ? number : 0;
    };
    const std::size_t x = text.find_first_of("xX");
    const int width = x == std::string::npos ? 0 : whole(text.substr(0, x));
    const int height = x == std::string::npos ? 0 : whole(text.substr(x + 1));
    if (width < 1 || height < 1) {
        throw scene::UserError("--size " + text +
                               ": expected WIDTHxHEIGHT in pixels, both at least 1, e.g. --size 640x360");
    }
    return "[" + std::to_string(width) + "," + std::to_string(height) + "]";
}

scene::Scene with_light_alone(const scene::Scene& scene, int light) {
    const std::size_t count = scene.lights.size();
    if (static_cast<std::size_t>(light) < count) return with_only_light(scene, static_cast<std::size_t>(light));
    throw scene::UserError("--light " + std::to_string(light) + ": the scene has " + std::to_string(count) +
                           (count == 1 ? " light" : " lights") + ", numbered from 0");
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command
        .add_option("scene", options.file,
                    "The scene file (TOML), or a mesh (OBJ) to look at; without it, a built-in teapot")
        ->type_name("SCENE.toml|MESH.obj");
    command
        .add_option("--set", options.read.overrides,
                    "Override a value of the scene: camera.position=[0,1,4], light.0.intensity=2, "
                    "material.gold.shininess=64; as often as you like")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_flag("--allow-outside", options.read.allow_outside,
                     "Let OBJ and MTL files name files outside their own folder");
    command.add_option("--size", options.size, "Width and height in pixels, e.g. 640x360")->type_name("WxH");
    command.add_option("--samples", options.samples, "N x N samples a pixel (antialiasing)")
        ->type_name("N")
        ->check(CLI::Range(1, 8));
    command.add_flag("--quiet", options.quiet, "Print no warnings");
    command.add_flag("--strict", options.strict, "A warning is an error: nothing is written (for grading)");
    command.add_option("--light", options.light, "With light.I alone, as if all others were off")
        ->type_name("I")
        ->check(CLI::Range(0, 1000000));
}

void add_threads_option(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Threads; by default one a core")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
}

scene::Scene load_scene(const SceneOptions& given) {
    SceneOptions options = given;
    std::vector<std::string>& overrides = options.read.overrides;
    if (!options.size.empty()) overrides.push_back("image.size=" + size_value(options.size));
    if (options.samples > 0) overrides.push_back("image.samples=" + std::to_string(options.samples));
    const auto read = [&]() -> scene::Scene {
        if (options.file.empty()) {
            return scene::read_scene_text(scene::built_in_scene_text(), "built-in scene", "", options.read);
        }
        if (is_mesh_file(options.file)) return read_scene_around_mesh(options.file, options.read);
        const std::string other = scene::other_format(options.file);
        if (!other.empty()) throw scene::UserError(scene::Place{options.file}, other);
        return scene::read_scene(options.file, options.read);
    };
    const scene::Scene scene = read();
    warn_of_scene(scene.warnings, options);
    return options.light < 0 ? scene : with_light_alone(scene, options.light);
}

void warn_of_scene(const std::vector<std::string>& warnings, const SceneOptions& options) {
    for (const std::string& warning : warnings) {
        if (!options.quiet) warn(warning);
    }
    if (!options.strict || warnings.empty()) return;
    throw scene::UserError("--strict: " + std::to_string(warnings.size()) +
                           (warnings.size() == 1 ? " warning is an error" : " warnings are errors") +
                           (options.quiet ? ": " + warnings.front() : ""));
}

PlannedScene load_and_plan(const SceneOptions& given, const scene::PlanRequest& request,
                           const std::function<void(scene::Scene&)>& adapt) {
    SceneOptions options = given;
    options.read.maps_later = request.views.empty() || !wanted_of(request).maps;
    PlannedScene loaded{load_scene(options), {}};
    loaded.scene.warnings.clear();  // they are printed
    adapt(loaded.scene);
    const scene::LoadingPlan loading = plan_loading(loaded.scene, request);
    load_maps(loaded.scene, loading.maps, options.read.files);
    scene::PlanRequest with_seen = request;
    with_seen.seen = &loading.seen;
    loaded.plan = make_plan_for(loaded.scene, with_seen);
    const std::string file = loaded.scene.file.empty() ? "" : loaded.scene.file + ": ";
    for (const std::string& warning : plan_warnings(loaded.scene, loaded.plan)) {
        loaded.scene.warnings.push_back(file + warning);
    }
    warn_of_scene(loaded.scene.warnings, options);
    return loaded;
}

void warn(const std::string& message) {
    std::cerr << "warning: " << message << "\n";
}

}  // namespace kreda::tools
