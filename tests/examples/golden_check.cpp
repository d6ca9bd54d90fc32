// golden_check PROGRAM GOLDEN_FOLDER PICTURE_FOLDER FAILURE_FOLDER: runs an example at a small size and looks at
//   1. every panel that it computed: the same bytes as the golden one;
//   2. the numbers of every plot: the same lines as the golden ones;
//   3. where the texts stand on its pictures and plots: inside, none over another, none too small, and no curve behind
//      a legend (layout.hpp, plot_layout.hpp);
//   4. PICTURE_FOLDER, docs/images/NN_name: a picture of each name, for the pages.
// Panels that differ are saved to FAILURE_FOLDER: NAME.expected.png, NAME.actual.png, NAME.difference.png. With the
// environment variable KREDA_RENEW_GOLDEN=1 the new panels, numbers and pictures become the golden ones: look at them
// first. Files named measured_* show times of this machine: they have no golden ones.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

#include "golden.hpp"
#include "layout.hpp"
#include "plot_layout.hpp"
#include "scene/files/image_file.hpp"
#include "tools/write_file.hpp"

namespace fs = std::filesystem;
using namespace kreda;

namespace {

constexpr const char* kDraft = "--draft --size 320x180";
constexpr float kHeight = 180.0f;
constexpr const char* kPage = "--size 640x360";         // the pages' pictures
constexpr std::uintmax_t kLargestFile = 60 * 1024;      // golden images live in the repository
constexpr std::uintmax_t kLargestPicture = 300 * 1024;  // the pages' pictures, too

struct Folders {
    fs::path program, golden, pictures, failures, made;
};

/// Files below a folder with this ending, relative to it; those of this machine's times are left out.
std::set<std::string> files_in(const fs::path& folder, const char* ending) {
    std::set<std::string> names;
    if (!fs::is_directory(folder)) return names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const bool measured = entry.path().filename().string().starts_with("measured_");
        if (entry.path().extension() == ending && !measured) names.insert(fs::relative(entry.path(), folder).string());
    }
    return names;
}

/// Names of the pictures that an example made; not its panels, which are in a folder.
std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const std::string& name : files_in(folder, ".png")) {
        if (name.find('/') == std::string::npos) names.insert(name);
    }
    return names;
}

bool are_there(const fs::path& actual, const fs::path& golden, const std::string& name) {
    if (fs::exists(actual) && fs::exists(golden)) return true;
    std::cout << name << (fs::exists(actual) ? ": there is no golden one\n" : ": the example did not write it\n");
    return false;
}

/// Compare one panel; say and save what differs.
bool check_panel(const Folders& at, const std::string& name) {
    const fs::path actual_file = at.made / "panels" / name, golden_file = at.golden / name;
    if (!are_there(actual_file, golden_file, name)) return false;
    const raster::Image actual = scene::read_image(actual_file.string());
    const raster::Image golden = scene::read_image(golden_file.string());
    const tools::Comparison difference = tests::compare_bytes(actual, golden);
    std::cout << name << ": " << describe(difference) << '\n';
    if (difference.passed) return true;
    const fs::path stem = (at.failures / name).replace_extension();
    fs::create_directories(stem.parent_path());
    fs::copy_file(golden_file, stem.string() + ".expected.png", fs::copy_options::overwrite_existing);
    fs::copy_file(actual_file, stem.string() + ".actual.png", fs::copy_options::overwrite_existing);
    if (difference.comparable) {
        scene::write_png(stem.string() + ".difference.png", tests::amplified_difference(actual, golden));
    }
    std::cout << "  see " << stem.string() << ".difference.png\n";
    return false;
}

bool check_numbers(const Folders& at, const std::string& name) {
    if (!are_there(at.made / name, at.golden / name, name)) return false;
    const bool same =
        tools::bytes_of_file((at.made / name).string()) == tools::bytes_of_file((at.golden / name).string());
    std::cout << name << (same ? ": the same numbers\n" : ": other numbers\n");
    return same;
}

/// The plots that the example's panels show and those that are pictures of their own; none without gnuplot.
bool check_plots(const Folders& at) {
    bool all = true;
    for (const fs::directory_entry& file : fs::directory_iterator(at.made)) {
        const std::string name = file.path().filename().string();
        if (file.path().extension() != ".svg" || name.starts_with("measured_")) continue;
        const tests::PlotLayout plot = tests::read_plot_layout(name, tools::bytes_of_file(file.path().string()));
        const std::vector<std::string> faults = tests::plot_faults(plot, kHeight / 30.0f);
        for (const std::string& fault : faults) std::cout << fault << '\n';
        std::cout << name << ": " << plot.texts.size() << " texts, " << plot.curves.size() << " curves\n";
        all = all && faults.empty() && !plot.texts.empty() && !plot.curves.empty();
    }
    return all;
}

bool check_layout(const Folders& at) {
    const auto texts = tests::read_layout((at.made / "panels/layout.txt").string());
    const std::vector<std::string> faults = tests::layout_faults(texts);
    for (const std::string& fault : faults) std::cout << fault << '\n';
    std::cout << "layout: " << texts.size() << " texts\n";
    return check_plots(at) && faults.empty();
}

bool check_pictures(const Folders& at) {
    bool all = true;
    for (const std::string& name : pictures_in(at.made)) {
        const bool is_there = fs::exists(at.pictures / name);
        if (!is_there) std::cout << (at.pictures / name).string() << ": the page has no such picture\n";
        all = all && is_there;
    }
    return all;
}

bool draw(const Folders& at, const std::string& how) {
    fs::remove_all(at.made);
    const std::string command =
        "'" + at.program.string() + "' --panels --out '" + at.made.parent_path().string() + "' " + how;
    if (std::system(command.c_str()) == 0) return true;
    std::cout << "this failed: " << command << '\n';
    return false;
}

bool copy(const fs::path& from, const fs::path& to, std::uintmax_t largest) {
    if (fs::file_size(from) > largest) {
        std::cout << from.string() << " is larger than " << largest << " bytes: too large for the repository\n";
        return false;
    }
    fs::create_directories(to.parent_path());
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
    std::cout << to.string() << ": renewed; look at it before you commit it\n";
    return true;
}

bool renew(const Folders& at) {
    bool all = true;
    fs::remove_all(at.golden);
    for (const std::string& name : files_in(at.made / "panels", ".png")) {
        all = copy(at.made / "panels" / name, at.golden / name, kLargestFile) && all;
    }
    for (const std::string& name : files_in(at.made, ".csv")) {
        all = copy(at.made / name, at.golden / name, kLargestFile) && all;
    }
    if (!draw(at, kPage)) return false;
    fs::remove_all(at.pictures);
    for (const std::string& name : pictures_in(at.made)) {
        all = copy(at.made / name, at.pictures / name, kLargestPicture) && all;
    }
    return all;
}

bool check(const Folders& at) {
    fs::remove_all(at.failures);
    if (!draw(at, kDraft)) return false;
    const char* renew_wish = std::getenv("KREDA_RENEW_GOLDEN");
    if (renew_wish != nullptr && std::string(renew_wish) == "1") return renew(at);
    std::set<std::string> panels = files_in(at.golden, ".png"), numbers = files_in(at.golden, ".csv");
    panels.merge(files_in(at.made / "panels", ".png"));
    numbers.merge(files_in(at.made, ".csv"));
    bool all_same = !panels.empty() || !numbers.empty();
    for (const std::string& panel : panels) all_same = check_panel(at, panel) && all_same;
    for (const std::string& plot : numbers) all_same = check_numbers(at, plot) && all_same;
    all_same = check_layout(at) && all_same;
    return check_pictures(at) && all_same;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: golden_check PROGRAM GOLDEN_FOLDER PICTURE_FOLDER FAILURE_FOLDER\n";
        return 2;
    }
    try {
        Folders at{argv[1], argv[2], argv[3], argv[4], {}};
        const fs::path example = at.golden.filename();
        at.made = at.failures.parent_path().parent_path() / "golden_actual" / example;
        return check(at) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
