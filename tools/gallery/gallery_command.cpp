// kreda gallery: pages for a browser from the pictures that the examples drew.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "tools/commands.hpp"
#include "tools/gallery/gallery.hpp"

namespace kreda::tools {

namespace {

struct GalleryOptions {
    std::string out = "out";
    std::string docs = "docs";
};

}  // namespace

void add_gallery_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("gallery", "Write index.html for the examples' pictures (./course calls it)");
    const auto options = std::make_shared<GalleryOptions>();
    command->add_option("out", options->out, "Folder with NN_name/*.png; index.html goes here")->type_name("OUT_DIR");
    command->add_option("docs", options->docs, "Folder with NN_name.md")->type_name("DOCS_DIR");
    command->callback([options] {
        const auto examples = find_examples(options->out, options->docs);
        write_gallery(examples, options->out, options->docs);
        const std::filesystem::path index = std::filesystem::path(options->out) / "index.html";
        std::cerr << "wrote " << index.string() << " (" << examples.size() << " examples)\n";
    });
}

}  // namespace kreda::tools
