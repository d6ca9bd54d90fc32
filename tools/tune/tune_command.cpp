// kreda tune: the cheapest settings within an error, or the most accurate within a time.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "raster/film.hpp"
#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/loaded_files.hpp"
#include "scene/files/scene_keys.hpp"
#include "tools/commands.hpp"
#include "tools/measure/choices.hpp"
#include "tools/measure/finding.hpp"
#include "tools/mesh_scene.hpp"
#include "tools/progress_bar.hpp"
#include "tools/scene_options.hpp"
#include "tools/tune/tune.hpp"
#include "tools/tune/tune_pictures.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::UserError;

struct CommandOptions {
    std::string file, output, pictures;
    std::vector<std::string> keep;
    double max_error = -1.0, budget_ms = -1.0;
    std::string cost = "time";
    TuneOptions tune;
};

std::string text_of_file(const std::string& path, const scene::ReadOptions& read) {
    (void)scene::read_scene(path, read);  // whatever is wrong with the file is said as by every other command
    return bytes_of_file(path);
}

SceneSource source_of(const CommandOptions& options, scene::LoadedFiles& files) {
    scene::ReadOptions read;
    read.files = &files;
    if (options.file.empty()) return {scene::built_in_scene_text(), "built-in scene", "", read};
    if (is_mesh_file(options.file)) {
        const auto loaded = load_mesh(&files, options.file, {});
        return {scene_around_mesh(options.file, *loaded), "scene around " + options.file, "", read};
    }
    return {text_of_file(options.file, read), options.file, fs::path(options.file).parent_path().string(), read};
}

/// "scene.toml" -> "scene_tuned": the chosen scene stands beside the scene, for it names its files from there.
std::string default_stem(const CommandOptions& options) {
    const fs::path file = options.file.empty() ? "built_in" : options.file;
    const fs::path folder = is_mesh_file(options.file) ? fs::path() : file.parent_path();
    return (folder / (file.stem().string() + "_tuned")).string();
}

/// Before anything is measured: would the scene find its files from where it is to be written?
void check_output(const SceneSource& source, const std::string& output) {
    const std::string folder = fs::path(output).parent_path().string();
    try {
        (void)scene::read_scene_text(source.text, source.name, folder, source.read);
    } catch (const UserError& error) {
        throw UserError("-o " + output + ": the scene would not find its files from there (" + error.what() +
                        "); choose a name in the folder of the scene");
    }
}

std::set<std::string> kept_keys(const std::vector<std::string>& keys) {
    std::vector<std::string> known;
    for (const Choice& choice : choices()) known.push_back(key_of(choice));
    for (const std::string& key : keys) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string near = scene::nearest_word(key, known);
        throw UserError("--keep " + key + ": there is no such choice" +
                        (near.empty() ? "; kreda measure list names them" : "; did you mean '" + near + "'?"));
    }
    return {keys.begin(), keys.end()};
}

std::string header_of(const Tuned& tuned, const CommandOptions& options) {
    const std::string unit = options.tune.cost_by == CostBy::plan ? " million operations" : " ms";
    const std::string pictures =
        options.tune.frames == 1 ? "a picture" : "a picture of " + std::to_string(options.tune.frames);
    return "promised: " + fixed(tuned.promised, 2) + " codes in the mean, " + fixed(4.0 * tuned.promised, 2) +
           " in 99 of 100 pixels\nachieved: " + fixed(tuned.achieved.mean, 3) + " and " + fixed(tuned.achieved.p99, 0) +
           " (worst " + fixed(tuned.achieved.worst, 0) + "), against the oracles of all terms\n" + pictures +
           " takes " + digits(tuned.chosen_cost) + unit + "; as the scene was " + digits(tuned.own_cost) + " (" +
           fixed(tuned.own_cost / tuned.chosen_cost, 2) + " times, and missed " + fixed(tuned.own_error.mean, 2) +
           " and " + fixed(tuned.own_error.p99, 0) + "), with all oracles " + digits(tuned.oracle_cost) + " (" +
           fixed(tuned.oracle_cost / tuned.chosen_cost, 2) + " times)\n";
}

void print_terms(const Tuned& tuned) {
    std::cout << "\nterm, what was chosen (as the scene was; oracle): error of it alone\n";
    for (std::size_t t = 0; t < tuned.found.terms.size(); ++t) {
        const Term& term = tuned.found.terms[t];
        const auto name = [&](int o) { return term.options[static_cast<std::size_t>(o)].name; };
        const auto chosen = static_cast<std::size_t>(tuned.choice.chosen[t]);
        std::cout << "  " << term.name << ": " << name(tuned.choice.chosen[t]) << " (" << name(term.own) << "; "
                  << name(term.oracle) << "): " << fixed(tuned.measured.options[t][chosen].error.mean, 3) << "\n";
    }
    std::cout << "left alone:\n";
    for (const PrunedTerm& pruned : tuned.found.pruned) std::cout << "  " << pruned.name << ": " << pruned.why << "\n";
    std::cout << "verified, " << tuned.renders << " settings rendered in all:\n";
    for (const Trial& trial : tuned.trials) {
        std::cout << "  predicted " << fixed(trial.choice.error, 2) << " codes, missed "
                  << fixed(budget_of(trial.error), 2) << (trial.raised.empty() ? "" : "; raised: " + trial.raised)
                  << "\n";
    }
}

/// "# ..." before each line.
std::string as_comment(const std::string& text) {
    std::string comment = "# ";
    for (const char c : text.substr(0, text.size() - 1)) comment += c == '\n' ? std::string("\n# ") : std::string(1, c);
    return comment + "\n";
}

raster::Image srgb_of(const raster::Image& linear) {
    return develop(linear, {});
}

void write_pictures(const SceneSource& source, const Tuned& tuned, const CommandOptions& options) {
    make_folder(options.pictures);
    const auto path = [&](const char* name) { return (fs::path(options.pictures) / name).string(); };
    const raster::Image& chosen = tuned.chosen_picture;
    scene::write_png(path("chosen.png"), chosen);
    scene::write_png(path("oracle.png"), tuned.oracle_picture);
    scene::write_png(path("front.png"), srgb_of(front_picture(source, tuned, options.tune)));
    ProgressBar bar("drawing who spent the error");
    TuneOptions with_bar = options.tune;
    with_bar.progress = bar.progress();
    const Attribution found = attribution(source, tuned, with_bar);
    bar.clear();
    scene::write_png(path("who_spent_it.png"),
                     srgb_of(attribution_picture(tuned.found.terms, found.codes, found.width, found.height)));
    std::cerr << "wrote chosen.png, oracle.png, front.png and who_spent_it.png to " << options.pictures << "\n";
}

void tune_command(CommandOptions options) {
    if ((options.max_error >= 0.0) == (options.budget_ms >= 0.0)) {
        throw UserError("kreda tune: say --max-error CODES or --budget-ms T (see kreda tune --help)");
    }
    if (options.max_error >= 0.0) options.tune.max_error = options.max_error;
    if (options.budget_ms >= 0.0) options.tune.budget_ms = options.budget_ms;
    options.tune.cost_by = options.cost == "plan" ? CostBy::plan : CostBy::time;
    if (options.tune.budget_ms && options.tune.cost_by == CostBy::plan) {
        throw UserError("kreda tune: --budget-ms is a time; --cost plan does not measure any");
    }
    if (options.output.empty()) options.output = default_stem(options) + ".toml";
    if (options.pictures.empty()) options.pictures = default_stem(options);
    const std::set<std::string> kept = kept_keys(options.keep);
    scene::LoadedFiles files;
    const SceneSource source = source_of(options, files);
    check_output(source, options.output);
    Tuned tuned;
    {
        ProgressBar bar("tuning");
        options.tune.progress = bar.progress();
        tuned = tune(source, kept, options.tune);
        options.tune.progress = {};
    }
    const std::string header = header_of(tuned, options);
    std::cout << header;
    print_terms(tuned);
    write_file(options.output, as_comment("Chosen by kreda tune.\n" + header) + tuned.text);
    std::cerr << "wrote " << options.output << "\n";
    write_pictures(source, tuned, options);
}

constexpr const char* kTuneExamples = R"(
An error of CODES allows that much in the mean and four times as much in 99 of 100 pixels, in steps of 8 bits, against a picture
whose every term is computed by its oracle (kreda measure list: 64 samples a pixel, rays to the light, Fresnel's equations,
the environment's integral). The choice is rendered and compared before it is written, so the promise holds for this picture.
What was chosen stands in the scene file with what it saves. front.png shows all best choices, who_spent_it.png which term
changed which pixel most.

Examples:
  kreda tune scene.toml --max-error 2                       the cheapest within 2 codes, into scene_tuned.toml
  kreda tune scene.toml --budget-ms 20 --frames 1000        the most accurate of 20 ms a picture, baked once for 1000
  kreda tune scene.toml --max-error 1 --keep image.samples  leave the number of samples alone)";

}  // namespace

void add_tune_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("tune", "Find the cheapest settings of a scene within an error, and verify them");
    const auto options = std::make_shared<CommandOptions>();
    command
        ->add_option("scene", options->file, "The scene file (TOML) or mesh (OBJ, glTF); without it, a built-in teapot")
        ->type_name("SCENE.toml|MESH.obj");
    command->add_option("--max-error", options->max_error, "The most that the picture may err, in codes of 8 bits")
        ->type_name("CODES")
        ->check(CLI::Range(0.0, 255.0));
    command->add_option("--budget-ms", options->budget_ms, "The most that a picture may take")
        ->type_name("MS")
        ->check(CLI::Range(1e-3, 1e9));
    command->add_option("--frames", options->tune.frames, "Pictures that share what is baked; 1")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--keep", options->keep, "Leave a key as the scene has it: image.samples; as often as you like")
        ->type_name("KEY")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--cost", options->cost, "What cheap means: the time here, or the plan's operations; time")
        ->type_name("time|plan")
        ->check(CLI::IsMember({"time", "plan"}));
    command->add_option("-o,--output", options->output, "The scene file to write; SCENE_tuned.toml")->type_name("FILE");
    command->add_option("--pictures", options->pictures, "Folder for the pictures; SCENE_tuned")->type_name("DIR");
    add_threads_option(*command, options->tune.threads);
    command->footer(kTuneExamples);
    command->callback([options] { tune_command(*options); });
}

}  // namespace kreda::tools
