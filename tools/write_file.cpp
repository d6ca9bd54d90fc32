#include "tools/write_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "scene/error.hpp"
#include "scene/files/whole_file.hpp"

namespace kreda::tools {

void write_file(const std::string& path, const std::string& text) {
    scene::write_whole_file(path, {std::as_bytes(std::span(text))});
}

std::string bytes_of_file(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void make_folder(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) throw scene::UserError(scene::Place{path}, "this folder cannot be made: " + failed.message());
}

}  // namespace kreda::tools
