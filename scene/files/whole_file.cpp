#include "scene/files/whole_file.hpp"

#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

#include "scene/error.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

/// A name in the folder of `path` that no other process uses: the rename that ends the writing must not cross file
/// systems.
fs::path temporary_name(const fs::path& path) {
    std::random_device random;
    std::string name = ".";
    name.append(path.filename().string()).append(".").append(std::to_string(random())).append(".tmp");
    return path.parent_path() / name;
}

bool write_parts(const fs::path& path, const std::vector<Bytes>& parts) {
    std::ofstream stream(path, std::ios::binary);
    for (const Bytes& part : parts) {
        stream.write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
    }
    stream.close();
    return stream.good();
}

}  // namespace

void write_whole_file(const std::string& path, const std::vector<Bytes>& parts) {
    std::error_code failed;
    if (fs::exists(path, failed) && !fs::is_regular_file(path, failed)) {
        throw UserError(Place{path}, "is a folder, a pipe or a device and would be replaced; name a file");
    }
    const fs::path temporary = temporary_name(path);
    const bool is_written = write_parts(temporary, parts);
    if (is_written) fs::rename(temporary, path, failed);
    if (is_written && !failed) return;
    const std::string why = failed ? failed.message() : "is the disk full, or the folder protected?";
    fs::remove(temporary, failed);
    throw UserError(Place{path}, "cannot be written: " + why);
}

}  // namespace kreda::scene
