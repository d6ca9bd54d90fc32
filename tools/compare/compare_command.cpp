// kreda compare: are two pictures the same, within limits that are printed beside what was measured?
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tools/commands.hpp"
#include "tools/compare/compare_files.hpp"
#include "tools/compare/compare_pictures.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

constexpr int kTheyDiffer = 1;

constexpr const char* kFooter = R"(
Exit code 0: the same within the limits; 1: they differ; 2: a file cannot be read or an option is wrong.
A pixel differs by the most that any of its channels differs, in steps: codes of an 8-bit picture; for floating-point
pictures 1/255 of the expected value. Size, channels, kind of numbers and finite values have no tolerance.

Examples:
  kreda compare mine.png golden.png
  kreda compare mine.png golden.png --heat-map where.png --side-by-side both.png
  kreda compare mine.exr golden.exr --differing 0 --more 0 --blob 0       nothing may differ
  kreda compare mine.png golden.png --mask edges.png --format json)";

struct CompareOptions {
    std::string actual, expected, mask;
    std::string heat_map, side_by_side;
    std::string format = "text";
    CompareLimits limits;
};

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string verdict(const Comparison& result) {
    if (!result.passed) return "A and B differ";
    return result.identical ? "A and B are identical" : "A and B are the same within the limits";
}

std::string report_text(const ComparedFiles& files) {
    std::string text = "      check                   measured      limit\n";
    for (const Measurement& check : files.result.checks) {
        char line[96];
        std::snprintf(line, sizeof line, "%-4s  %-19s %12s %10s  ", check.ok ? "ok" : "FAIL", check.name.c_str(),
                      number_text(check.value).c_str(), check.limit ? number_text(*check.limit).c_str() : "");
        text += line + check.text + "\n";
    }
    if (files.result.differing > 0) {
        const PixelPair& worst = files.result.worst;
        text += "      worst pixel (" + std::to_string(worst.x) + ", " + std::to_string(worst.y) + "): A " +
                values_text(worst.actual) + ", B " + values_text(worst.expected) + ", " + number_text(worst.steps) +
                " steps\n";
    }
    return text + verdict(files.result) + "\n";
}

std::string report_json(const CompareOptions& options, const Comparison& result) {
    nlohmann::ordered_json json = {{"a", options.actual},
                                   {"b", options.expected},
                                   {"passed", result.passed},
                                   {"identical", result.identical},
                                   {"comparable", result.comparable},
                                   {"checks", nlohmann::ordered_json::array()}};
    for (const Measurement& check : result.checks) {
        nlohmann::ordered_json one = {{"name", check.name}, {"ok", check.ok}, {"value", check.value}};
        if (check.limit) one["limit"] = *check.limit;
        one["text"] = check.text;
        json["checks"].push_back(one);
    }
    if (result.differing > 0) {
        const PixelPair& worst = result.worst;
        json["worst"] = {
            {"x", worst.x}, {"y", worst.y}, {"a", worst.actual}, {"b", worst.expected}, {"steps", worst.steps}};
    }
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void write_pictures(const CompareOptions& options, const ComparedFiles& files) {
    const raster::Image& expected = files.expected.image;
    if (!options.side_by_side.empty()) {
        scene::write_png(options.side_by_side, side_by_side(files.result, files.actual.image, expected, files.numbers));
        std::cerr << "wrote " << options.side_by_side << "\n";
    }
    if (options.heat_map.empty()) return;
    if (!files.result.comparable) {
        std::cerr << options.heat_map << " is not written: " << describe(files.result) << "\n";
        return;
    }
    scene::write_png(options.heat_map, heat_map(files.result, expected, files.numbers));
    std::cerr << "wrote " << options.heat_map << "\n";
}

void compare_command(const CompareOptions& options) {
    const ComparedFiles files = compare_files(options.actual, options.expected, options.mask, options.limits);
    write_pictures(options, files);
    std::cout << (options.format == "json" ? report_json(options, files.result) : report_text(files));
    if (!files.result.passed) throw CLI::RuntimeError(kTheyDiffer);
}

}  // namespace

void add_compare_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("compare", "Tell whether two pictures are the same, and where they are not");
    command->footer(kFooter);
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("A", options->actual, "The picture to judge: PNG, EXR, HDR, JPEG, TIFF, ...")->required();
    command->add_option("B", options->expected, "The picture that it should be")->required();
    command
        ->add_option("--mask", options->mask,
                     "A picture, white where rounding may decide: elsewhere no pixel may differ by more than a step")
        ->type_name("FILE");
    command
        ->add_option("--differing", options->limits.differing_percent, "Percent of the pixels that may differ at all")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command->add_option("--more", options->limits.more_than_a_step, "Pixels that may differ by more than a step")
        ->check(CLI::Range(0, 1 << 30))
        ->capture_default_str();
    command->add_option("--blob", options->limits.blob, "Pixels of those that may touch each other")
        ->check(CLI::Range(0, 1 << 30))
        ->capture_default_str();
    command->add_option("--heat-map", options->heat_map, "Write where they differ, and how much")
        ->type_name("FILE.png");
    command->add_option("--side-by-side", options->side_by_side, "Write A, B and the heat map side by side")
        ->type_name("FILE.png");
    command->add_option("--format", options->format, "text or json")->check(CLI::IsMember({"text", "json"}));
    command->callback([options] { compare_command(*options); });
}

}  // namespace kreda::tools
