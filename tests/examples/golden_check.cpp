// golden_check PROGRAM GOLDEN_FOLDER FAILURE_FOLDER: runs an example at a small size and compares every picture it
// writes with the golden one, byte by byte. What differs is saved to FAILURE_FOLDER: NAME.expected.png,
// NAME.actual.png, NAME.difference.png. With the environment variable KREDA_RENEW_GOLDEN=1 the new pictures become the
// golden ones: look at them first. Pictures named measured_*.png show times of this machine: they have no golden image.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

#include "golden.hpp"
#include "scene/files/image_file.hpp"

namespace fs = std::filesystem;
using namespace kreda;

namespace {

constexpr const char* kSize = "320x180";
constexpr std::uintmax_t kLargestFile = 60 * 1024;  // golden images live in the repository

std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    if (!fs::is_directory(folder)) return names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".png" && !name.starts_with("measured_")) names.insert(name);
    }
    return names;
}

/// Compare one picture; say and save what differs.
bool check_picture(const fs::path& actual_file, const fs::path& golden_file, const fs::path& failures) {
    const std::string name = golden_file.filename().string();
    if (!fs::exists(golden_file)) {
        std::cout << name << ": there is no golden image " << golden_file.string() << '\n';
        return false;
    }
    if (!fs::exists(actual_file)) {
        std::cout << name << ": the example did not write it\n";
        return false;
    }
    const raster::Image actual = scene::read_image(actual_file.string());
    const raster::Image golden = scene::read_image(golden_file.string());
    const tools::Comparison difference = tests::compare_bytes(actual, golden);
    std::cout << name << ": " << describe(difference) << '\n';
    if (difference.passed) return true;
    fs::create_directories(failures);
    const std::string stem = (failures / golden_file.stem()).string();
    fs::copy_file(golden_file, stem + ".expected.png", fs::copy_options::overwrite_existing);
    fs::copy_file(actual_file, stem + ".actual.png", fs::copy_options::overwrite_existing);
    if (difference.comparable) {
        scene::write_png(stem + ".difference.png", tests::amplified_difference(actual, golden));
    }
    std::cout << "  see " << stem << ".difference.png\n";
    return false;
}

bool renew(const fs::path& made, const fs::path& golden) {
    fs::create_directories(golden);
    for (const std::string& name : pictures_in(golden)) fs::remove(golden / name);
    for (const std::string& name : pictures_in(made)) {
        if (fs::file_size(made / name) > kLargestFile) {
            std::cout << name << " is larger than " << kLargestFile << " bytes: too large for the repository\n";
            return false;
        }
        fs::copy_file(made / name, golden / name);
        std::cout << name << ": renewed; look at it before you commit it\n";
    }
    return true;
}

bool check(const fs::path& program, const fs::path& golden, const fs::path& failures) {
    const std::string name = golden.filename().string();
    fs::remove_all(failures);
    const fs::path out = failures.parent_path().parent_path() / "golden_actual";
    fs::remove_all(out / name);
    const std::string command = "'" + program.string() + "' --out '" + out.string() + "' --size " + kSize;
    if (std::system(command.c_str()) != 0) {
        std::cout << "this failed: " << command << '\n';
        return false;
    }
    const char* renew_wish = std::getenv("KREDA_RENEW_GOLDEN");
    if (renew_wish != nullptr && std::string(renew_wish) == "1") return renew(out / name, golden);
    std::set<std::string> names = pictures_in(golden);
    names.merge(pictures_in(out / name));
    bool all_same = !names.empty();
    for (const std::string& picture : names) {
        all_same = check_picture(out / name / picture, golden / picture, failures) && all_same;
    }
    return all_same;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: golden_check PROGRAM GOLDEN_FOLDER FAILURE_FOLDER\n";
        return 2;
    }
    try {
        return check(argv[1], argv[2], argv[3]) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
