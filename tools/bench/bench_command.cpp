// kreda bench: how fast, beside Mesa and against the size of the work.
#include <memory>

#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "tools/bench/bench.hpp"
#include "tools/bench/more_threads.hpp"
#include "tools/bench/peak.hpp"
#include "tools/bench/process_bench.hpp"
#include "tools/commands.hpp"

namespace kreda::tools {

void add_bench_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("bench", "Time workloads, beside Mesa's llvmpipe in turn, or against their size");
    const auto options = std::make_shared<BenchOptions>();
    const auto growth = std::make_shared<bool>(false);
    const auto peak = std::make_shared<bool>(false);
    command->add_option("--workloads", options->workloads, "The folder with W1.toml, W1.mesa, ... to compare")
        ->type_name("DIR");
    command->add_option("--mesa", options->mesa, "The program mesa_peer; without it only kreda is timed")
        ->type_name("PROGRAM");
    command
        ->add_option("--mesa-libraries", options->libraries,
                     "Folders with the libraries of several Mesas: a column each; by default the system's")
        ->type_name("DIR...");
    command->add_flag("--growth", *growth, "Time against pixels, triangles, lights and threads");
    command->add_flag("--peak", *peak,
                      "How much of the processor's arithmetic and cache bandwidth the shading loops reach");
    const auto scenes = std::make_shared<std::vector<std::string>>();
    const auto shared = std::make_shared<std::vector<std::string>>();
    command
        ->add_option("--more-threads", *shared,
                     "Scenes: a frame with one thread and with all cores, and simulated with up to 64")
        ->type_name("SCENE.toml...");
    const auto folder = std::make_shared<std::string>();
    command->add_option("--process", *scenes, "Scenes, each drawn by processes of its own: from command to PNG")
        ->type_name("SCENE.toml...");
    command
        ->add_option("--write-w9", *folder, "Write the workload W9, a million triangles with textures, into a folder")
        ->type_name("DIR");
    const auto layers = std::make_shared<std::string>();
    command->add_option("--write-w10", *layers, "Write the workload W10, a hundred layers of which one is seen")
        ->type_name("DIR");
    command->add_option("--rounds", options->rounds, "How often the programs take turns")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    command->add_option("--frames", options->frames, "Frames a turn; its median counts")
        ->check(CLI::Range(1, 10000))
        ->type_name("N");
    command->add_option("--threads", options->threads, "Threads of each program")
        ->check(CLI::Range(1, 256))
        ->type_name("N");
    command->callback([options, growth, peak, scenes, shared, folder, layers] {
        if (options->workloads.empty() && !*growth && !*peak && scenes->empty() && shared->empty() && folder->empty() &&
            layers->empty()) {
            throw scene::UserError(
                "kreda bench: say what to time: --workloads DIR, --process SCENE, --more-threads SCENE, --growth or "
                "--peak (see kreda bench --help)");
        }
        if (!folder->empty()) write_million_triangles(*folder);
        if (!layers->empty()) write_layers(*layers);
        if (!scenes->empty()) time_processes({*scenes, options->rounds, options->threads});
        if (!options->workloads.empty()) compare_with_mesa(*options);
        if (!shared->empty()) measure_threads(*shared, options->frames);
        if (*growth) measure_growth(options->frames, options->threads);
        if (*peak) measure_peak();
    });
}

}  // namespace kreda::tools
