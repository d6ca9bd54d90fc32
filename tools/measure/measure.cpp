#include "tools/measure/measure.hpp"

#include <filesystem>
#include <iostream>

#include "scene/files/hash_of_bytes.hpp"
#include "tools/draw/gnuplot.hpp"
#include "tools/progress_bar.hpp"
#include "tools/scene_options.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::string hash_of_file(const std::string& path) {
    const std::string bytes = bytes_of_file(path);
    return scene::hash_text(scene::hash_of_bytes(std::as_bytes(std::span(bytes))));
}

/// Everything that an experiment depends on: all of it lies in the program itself.
std::string program_hash() {
    static const std::string hash = hash_of_file("/proc/self/exe");
    return hash;
}

/// What was run, how, and what it left.
std::string key_of_files(const Experiment& experiment, const MeasureOptions& options) {
    const std::string path = (fs::path(options.folder) / experiment.name).string();
    std::string text = "program " + program_hash() + (options.quick ? " quick\n" : " full\n");
    for (const char* ending : {".csv", ".txt", ".svg", ".png"}) {
        std::error_code none;
        const bool is_there = fs::exists(path + ending, none);
        text += std::string(ending) + " " + (is_there ? hash_of_file(path + ending) : "absent") + "\n";
    }
    return text;
}

}  // namespace

bool measure_one(const Experiment& experiment, const MeasureOptions& options) {
    const std::string path = (fs::path(options.folder) / experiment.name).string();
    if (!options.again && bytes_of_file(path + ".key") == key_of_files(experiment, options)) return false;
    ProgressBar bar("measuring " + std::string(experiment.name));
    bar.show(0.0);
    const Finding finding = experiment.run({options.quick, options.threads, bar.progress()});
    write_file(path + ".csv", csv_of(finding.table));
    write_file(path + ".txt", finding.text + "\n");
    (void)draw_plot(finding.plot, std::string(experiment.asks), path);
    write_file(path + ".key", key_of_files(experiment, options));
    return true;
}

void measure_all(const std::vector<const Experiment*>& chosen, const MeasureOptions& options) {
    make_folder(options.folder);
    if (!has_gnuplot()) warn("gnuplot is not installed: tables and texts are written, plots are not");
    for (const Experiment* experiment : chosen) {
        const bool ran = measure_one(*experiment, options);
        std::cout << experiment->name << (ran ? ": " : " (measured before): ")
                  << bytes_of_file((fs::path(options.folder) / experiment->name).string() + ".txt") << std::flush;
    }
    const std::string page = (fs::path(options.folder) / "report.html").string();
    write_file(page, report_page(options.folder));
    std::cerr << "wrote " << page << "\n";
}

}  // namespace kreda::tools
