#include "tools/write_file.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "scene/error.hpp"

namespace kreda::tools {

void write_file(const std::string& path, const std::string& text) {
    const std::string temporary = path + ".tmp";
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    std::error_code failed;
    if (file) std::filesystem::rename(temporary, path, failed);
    if (file && !failed) return;
    std::filesystem::remove(temporary, failed);
    throw scene::UserError(scene::Place{path}, "cannot be written");
}

void make_folder(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) throw scene::UserError(scene::Place{path}, "this folder cannot be made: " + failed.message());
}

}  // namespace kreda::tools
