// kreda explain: the life of a pixel.
#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/plan/environment_plan.hpp"
#include "tools/bake/bake_scene.hpp"
#include "tools/commands.hpp"
#include "tools/explain/explain.hpp"
#include "tools/scene_options.hpp"

namespace kreda::tools {

namespace {

struct ExplainOptions {
    SceneOptions scene;
    CacheOptions cache;
    std::string pixel;
    std::string sample;
    std::string format = "text";
    int threads = 0;  ///< 0: as many as there are cores
};

/// "320,180" -> (320, 180).
glm::ivec2 read_pair(const std::string& option, const std::string& text, const char* expected) {
    const auto refuse = [&] { throw scene::UserError(option + " " + text + ": expected " + expected); };
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) refuse();
    const auto whole = [&](const char* begin, const char* end) {
        int number = 0;
        const auto [stop, error] = std::from_chars(begin, end, number);
        if (error != std::errc() || stop != end || number < 0) refuse();
        return number;
    };
    const char* const begin = text.data();
    return {whole(begin, begin + comma), whole(begin + comma + 1, begin + text.size())};
}

void explain_command(const ExplainOptions& options) {
    const glm::ivec2 pixel =
        read_pair("--pixel", options.pixel, "X,Y in pixels from the upper left, e.g. --pixel 320,180");
    PixelRequest request{pixel.x, pixel.y};
    if (!options.sample.empty()) {
        const glm::ivec2 sample =
            read_pair("--sample", options.sample, "I,J counted from 0 within the pixel, e.g. --sample 0,1");
        request.sample_x = sample.x;
        request.sample_y = sample.y;
    }
    scene::Scene scene = load_scene(options.scene);
    check_request(scene.image, request);
    bake_scene(scene, environment_needs(scene), options.cache);
    const Explanation explanation = explain_pixel(scene, request, options.threads);
    if (options.format == "json")
        std::cout << as_json(explanation.derivation);
    else if (options.format == "md")
        std::cout << as_markdown(explanation.derivation);
    else
        std::cout << as_text(explanation.derivation);
}

constexpr const char* kExplainExamples = R"(
The numbers are those of the real picture: the same functions, on a batch of one pixel. The last line is the byte in the
PNG. A pixel that shows the background is explained, too: what lies nearest, what was culled, clipped or hidden.

Examples:
  kreda explain scene.toml --pixel 320,180
  kreda explain scene.toml --pixel 320,180 --format md > pixel.md
  kreda explain scene.toml --pixel 320,180 --set material.gold.roughness=0.1
  kreda explain scene.toml --pixel 40,20 --size 80x45 --samples 2   of the picture that render makes with the same options
  kreda explain --pixel 300,150 --sample 0,2                 another of the pixel's samples)";

}  // namespace

void add_explain_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("explain", "Print the life of one pixel: every formula with its numbers");
    const auto options = std::make_shared<ExplainOptions>();
    add_scene_options(*command, options->scene);
    add_cache_options(*command, options->cache);
    add_threads_option(*command, options->threads);
    command->add_option("--pixel", options->pixel, "The pixel, from the upper left corner, e.g. 320,180")
        ->type_name("X,Y")
        ->required();
    command
        ->add_option("--sample", options->sample,
                     "Which of the pixel's N x N samples is told in full; by default one in the middle that is covered")
        ->type_name("I,J");
    command->add_option("--format", options->format, "text, md (Markdown) or json")
        ->type_name("FORMAT")
        ->check(CLI::IsMember({"text", "md", "json"}));
    command->footer(kExplainExamples);
    command->callback([options] { explain_command(*options); });
}

}  // namespace kreda::tools
