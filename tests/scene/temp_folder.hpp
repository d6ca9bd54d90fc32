// A folder of its own for a test that needs real files; it goes away with the object.
#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <thread>

namespace kreda::tests {

struct TempFolder {
    std::filesystem::path path;

    TempFolder() {
        std::random_device random;
        path = std::filesystem::temp_directory_path() /
               ("kreda_test_" + std::to_string(random()) + std::to_string(random()));
        std::filesystem::create_directories(path);
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const {
        return (path / name).string();
    }

    /// Write a file, with the folders above it, and return its path.
    std::string write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name, std::ios::binary) << bytes;
        return file(name);
    }
};

/// File times have steps; what is read so soon after it was written is not trusted.
inline void let_files_settle() {
    std::this_thread::sleep_for(std::chrono::milliseconds(80));
}

[[nodiscard]] inline std::string bytes_of(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The folder of real inputs, $KREDA_SHARED or ../shared beside the repository; empty where it is absent.
[[nodiscard]] inline std::string shared_data_folder() {
    namespace fs = std::filesystem;
    const char* const named = std::getenv("KREDA_SHARED");
    const fs::path repository = fs::path(__FILE__).parent_path().parent_path().parent_path();
    const fs::path data = (named ? fs::path(named) : repository.parent_path() / "shared") / "data";
    return fs::is_directory(data) ? data.string() : std::string();
}

}  // namespace kreda::tests
