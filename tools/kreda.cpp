// kreda: the command line. Exit code 0: done; 2: something the user can mend, said in one line; 1: a fault of ours, or
// the answer "no" of kreda compare.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "tools/commands.hpp"

namespace {

constexpr int kOurFault = 1;
constexpr int kUserError = 2;

constexpr const char* kVersion = "kreda " KREDA_VERSION;

constexpr const char* kExamples = R"(
Examples:
  kreda render                                    the built-in scene, into built_in.png
  kreda render scene.toml -o picture.png --samples 4
  kreda render scene.toml --set light.0.intensity=2 --set material.gold.shininess=64
  kreda plan scene.toml --why-not                 which passes the scene requires, and why
  kreda stages scene.toml -o stages               every stage a picture; open stages/index.html
  kreda explain scene.toml --pixel 320,180        every formula of one pixel with its numbers
  kreda view scene.toml                           a page that draws it live: camera, controls, views
  kreda sweep scene.toml --set fog.density=0.1,0.2,0.4 -o sheet.png   a table of pictures
  kreda bake dawn.hdr -o dawn                     the maps of light from an image as EXR files
  kreda compare mine.png golden.png               the same within limits? where not?
  kreda grade anna --rubric A3/rubric.toml        a student's work, boxed and marked
  kreda measure all --quick -o measured           what each approximation costs and saves: tables, plots, a page
  kreda tune scene.toml --max-error 2             the cheapest settings whose picture errs by 2 codes at most
  kreda keys                                      everything a scene file may say)";

/// A complaint is one line, whatever is in the names that it quotes.
int complain(std::string message, int exit_code) {
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    std::cerr << message << "\n";
    return exit_code;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

/// CLI11 asks for "a subcommand" when the first word is none: say which word, and what was meant.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
    const std::vector<std::string> names = command_names(app);
    const std::string word = argc > 1 ? argv[1] : "";
    if (word.empty() || word[0] == '-' || std::find(names.begin(), names.end(), word) != names.end()) return {};
    const std::string near = kreda::scene::nearest_word(word, names);
    return "there is no command '" + word + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?");
}

int usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "kreda" : "kreda " + chosen.front()->get_name();
    const std::string unknown = unknown_command(app, argc, argv);
    return complain(command + ": " + (unknown.empty() ? error.what() : unknown) + " (see " + command + " --help)",
                    kUserError);
}

int run(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::RuntimeError& end) {  // a command that says yes or no with its exit code
        std::cout.flush();
        return end.get_exit_code();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) return usage_error(app, error, argc, argv);
        app.exit(error);  // --help and --version
    }
    std::cout.flush();
    return std::cout ? 0 : complain("kreda: the standard output cannot be written", kUserError);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        CLI::App app{"Kreda draws a scene on the CPU, one step at a time, for lectures on lighting.", "kreda"};
        app.set_version_flag("--version", kVersion, "Print the version");
        app.require_subcommand(1);
        app.footer(kExamples);
        kreda::tools::add_render_command(app);
        kreda::tools::add_plan_command(app);
        kreda::tools::add_explain_command(app);
        kreda::tools::add_stages_command(app);
        kreda::tools::add_sweep_command(app);
        kreda::tools::add_bake_command(app);
        kreda::tools::add_compare_command(app);
        kreda::tools::add_grade_command(app);
        kreda::tools::add_hidden_command(app);
        kreda::tools::add_keys_command(app);
        kreda::tools::add_bench_command(app);
        kreda::tools::add_measure_command(app);
        kreda::tools::add_brdf_command(app);
        kreda::tools::add_tune_command(app);
        kreda::tools::add_view_command(app);
        return run(app, argc, argv);
    } catch (const kreda::scene::UserError& error) {
        return complain(error.what(), kUserError);
    } catch (const std::bad_alloc&) {
        return complain("kreda: not enough memory; ask for a smaller image, fewer samples or less detail", kUserError);
    } catch (const std::length_error&) {  // a container that asks for more than there can ever be
        return complain("kreda: not enough memory; ask for a smaller image, fewer samples or less detail", kUserError);
    } catch (const std::exception& error) {
        return complain(std::string("kreda: a fault in kreda itself, please report it: ") + error.what(), kOurFault);
    }
}
