// kreda hidden: scenes that students do not see, from a seed.
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "tools/commands.hpp"
#include "tools/grade/assignment/hidden_scenes.hpp"

namespace kreda::tools {

namespace {

constexpr const char* kFooter = R"(
Writes one scene for each of the assignment's public scenes, with another camera, other lights and other numbers, and a
picture of each: look at them before you grade with them. The same seed gives the same scenes. Change them as you like;
any scene of at most 512 x 512 pixels with one sample a pixel will do.

Example:
  kreda hidden --rubric A3/rubric.toml --seed 17 -o hidden/A3
  kreda grade anna --rubric A3/rubric.toml --hidden hidden/A3 -o graded/anna)";

struct HiddenOptions {
    std::string rubric, out;
    std::uint32_t seed = 1;
    bool golden = false;
};

void hidden_command(const HiddenOptions& options) {
    const Rubric rubric = read_rubric(options.rubric);
    if (options.out.empty() && !options.golden) throw scene::UserError("kreda hidden: -o DIR is missing");
    if (options.golden) {
        for (const auto& file : write_golden_pictures(rubric)) std::cout << file.string() << "\n";
    }
    if (options.out.empty()) return;
    for (const auto& file : write_hidden_scenes(rubric, options.seed, options.out)) std::cout << file.string() << "\n";
}

}  // namespace

void add_hidden_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("hidden", "Make an assignment's hidden scenes from a seed");
    command->footer(kFooter);
    const auto options = std::make_shared<HiddenOptions>();
    command->add_option("--rubric", options->rubric, "rubric.toml of the assignment")->type_name("FILE")->required();
    command->add_option("--seed", options->seed, "Any number")->capture_default_str();
    command->add_option("-o,--output", options->out, "The folder of the scenes")->type_name("DIR");
    command->add_flag("--golden", options->golden,
                      "Draw the golden pictures of the public scenes anew, too: golden/ beside the rubric");
    command->callback([options] { hidden_command(*options); });
}

}  // namespace kreda::tools
