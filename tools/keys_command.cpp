// kreda keys: everything a scene file may say, from the table that the reader itself uses.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "scene/files/read_scene.hpp"
#include "scene/files/scene_keys.hpp"
#include "tools/commands.hpp"
#include "tools/keys_json.hpp"

namespace kreda::tools {

namespace {

std::size_t widest_assignment() {
    std::size_t width = 0;
    for (const scene::KeyInfo& key : scene::scene_keys()) width = std::max(width, default_text(key).size());
    return width;
}

void print_keys() {
    const int width = static_cast<int>(widest_assignment()) + 2;
    std::cout
        << "Behind = stands the default: what holds where the key is not written. A key without = has none; then, and "
           "where the\ndefault shows little, an example follows.\n";
    std::string_view table;
    for (const scene::KeyInfo& key : scene::scene_keys()) {
        if (key.table != table) std::cout << "\n" << scene::table_title(key.table) << "\n";
        table = key.table;
        std::cout << "  " << std::left << std::setw(width) << default_text(key) << key.meaning << "\n"
                  << "  " << std::setw(width) << ""
                  << "  " << type_text(key);
        if (!key.example.empty()) std::cout << "; e.g. " << example_text(key);
        std::cout << "\n";
    }
}

}  // namespace

void add_keys_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("keys", "Print every key of a scene file: default, meaning, what may be written");
    const auto example = std::make_shared<bool>(false);
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--example", *example, "Print a whole scene file to start from instead: the built-in one");
    command->add_flag("--json", *json, "Print the table as JSON, for programs")->excludes("--example");
    command->callback([example, json] {
        if (*example)
            std::cout << scene::built_in_scene_text();
        else if (*json)
            std::cout << keys_as_json().dump(1) << "\n";
        else
            print_keys();
    });
}

}  // namespace kreda::tools
