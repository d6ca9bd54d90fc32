// kreda brdf: plots of what each reflection model does with light.
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "tools/brdf/lobe_plots.hpp"
#include "tools/commands.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

using scene::UserError;

struct CommandOptions {
    std::string name, folder = "brdf";
};

std::vector<LobeModel> chosen(const std::string& name) {
    if (name == "all") return lobe_models();
    std::vector<std::string> names = {"all", "list"};
    for (const LobeModel& model : lobe_models()) {
        if (model.name == name) return {model};
        names.emplace_back(model.name);
    }
    const std::string near = scene::nearest_word(name, names);
    throw UserError("kreda brdf: there is no model '" + name + "'" +
                    (near.empty() ? "; kreda brdf list names them" : "; did you mean '" + near + "'?"));
}

void run(const CommandOptions& options) {
    if (options.name == "list") {
        for (const LobeModel& model : lobe_models()) std::cout << model.name << ": " << model.title << "\n";
        return;
    }
    const std::vector<LobeModel> models = chosen(options.name);
    make_folder(options.folder);
    bool all_drawn = true;
    for (const LobeModel& model : models) all_drawn &= write_figure(model, options.folder);
    const std::string table = (std::filesystem::path(options.folder) / "reflectance.csv").string();
    write_file(table, reflectance_csv(models));
    std::cerr << "wrote " << models.size() << (models.size() == 1 ? " model" : " models") << " and reflectance.csv to "
              << options.folder << "\n";
    if (!all_drawn)
        std::cerr << "warning: no figures, the numbers alone: gnuplot is not installed (gnuplot-nox) or failed\n";
}

constexpr const char* kBrdfExamples = R"(
For each model NAME.png (polar and cartesian plots, lobes in space, a lit ball; needs gnuplot) and NAME.csv, and
reflectance.csv: which share of the light is given back.

Examples:
  kreda brdf list                 the models
  kreda brdf ggx -o brdf          one of them
  kreda brdf all -o brdf          all, side by side on docs/brdf_plots.md)";

}  // namespace

void add_brdf_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("brdf", "Plot where each reflection model sends light, and how much");
    const auto options = std::make_shared<CommandOptions>();
    command->add_option("what", options->name, "A model, all of them, or list")->type_name("list|NAME|all")->required();
    command->add_option("-o,--output", options->folder, "Folder for the files, made if need be; brdf")
        ->type_name("DIR");
    command->footer(kBrdfExamples);
    command->callback([options] { run(*options); });
}

}  // namespace kreda::tools
