// kreda measure: what each approximation costs and what it saves.
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "tools/commands.hpp"
#include "tools/measure/choices.hpp"
#include "tools/measure/measure.hpp"

namespace kreda::tools {

namespace {

struct CommandOptions {
    std::string name;
    MeasureOptions measure{"measured"};
};

void list_experiments() {
    std::cout << "Experiments (kreda measure NAME -o DIR):\n";
    for (const Experiment& experiment : experiments()) {
        std::cout << "  " << experiment.name << std::string(20 - std::min<std::size_t>(19, experiment.name.size()), ' ')
                  << experiment.asks << "\n";
    }
    std::cout << "\nChoices of a scene file, * what the others are measured against:\n" << describe_choices();
}

std::vector<const Experiment*> chosen(const std::string& name) {
    std::vector<const Experiment*> all;
    std::vector<std::string> names = {"list", "all"};
    for (const Experiment& experiment : experiments()) {
        all.push_back(&experiment);
        names.emplace_back(experiment.name);
    }
    if (name == "all") return all;
    if (const Experiment* experiment = find_experiment(name)) return {experiment};
    const std::string near = scene::nearest_word(name, names);
    throw scene::UserError("kreda measure: there is no experiment '" + name + "'" +
                           (near.empty() ? "; kreda measure list names them" : "; did you mean '" + near + "'?"));
}

constexpr const char* kMeasureExamples = R"(
Each experiment writes a table (NAME.csv), a plot (NAME.svg, NAME.png: needs gnuplot) and a paragraph (NAME.txt); report.html
holds them all in one file. What was measured before by the same program is not measured again.

Examples:
  kreda measure list                         the experiments, and the choices that a scene has
  kreda measure fresnel_time -o measured     one of them
  kreda measure all --quick -o measured      all, within ten minutes on two cores)";

}  // namespace

void add_measure_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("measure", "Measure what approximations cost in accuracy and save in time");
    const auto options = std::make_shared<CommandOptions>();
    command->add_option("what", options->name, "An experiment, all of them, or list")
        ->type_name("list|NAME|all")
        ->required();
    command->add_option("-o,--output", options->measure.folder, "Folder for the files, made if need be; measured")
        ->type_name("DIR");
    command->add_flag("--quick", options->measure.quick, "Fewer angles, samples and rounds");
    command->add_flag("--again", options->measure.again, "Also what is measured already");
    command->add_option("--threads", options->measure.threads, "Threads of what is rendered; by default one a core")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    command->footer(kMeasureExamples);
    command->callback([options] {
        if (options->name == "list") {
            list_experiments();
        } else {
            measure_all(chosen(options->name), options->measure);
        }
    });
}

}  // namespace kreda::tools
