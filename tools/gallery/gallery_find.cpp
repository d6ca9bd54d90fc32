#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/error.hpp"
#include "tools/gallery/gallery.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    return text.str();
}

/// "22_phong_terms" and the like.
bool is_example_name(const std::string& name) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(name[i])) != 0; };
    return name.size() > 3 && digit(0) && digit(1) && name[2] == '_';
}

std::string with_spaces(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// Width and height are the first two numbers of a PNG's first chunk (big-endian, at byte 16).
void read_png_size(const fs::path& path, GalleryPicture& picture) {
    std::ifstream file(path, std::ios::binary);
    unsigned char header[24] = {};
    if (!file.read(reinterpret_cast<char*>(header), sizeof header)) return;
    const auto number = [&](int at) {
        return header[at] << 24 | header[at + 1] << 16 | header[at + 2] << 8 | header[at + 3];
    };
    picture.width = number(16);
    picture.height = number(20);
}

std::vector<GalleryPicture> find_pictures(const fs::path& folder) {
    std::vector<GalleryPicture> pictures;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if (path.extension() != ".png" || path.filename().string()[0] == '.') continue;
        GalleryPicture picture{path.filename().string(), with_spaces(path.stem().string()), 0, 0};
        read_png_size(path, picture);
        pictures.push_back(picture);
    }
    std::sort(pictures.begin(), pictures.end(),
              [](const GalleryPicture& a, const GalleryPicture& b) { return a.file < b.file; });
    return pictures;
}

/// The first line that starts with "# ", without the mark.
std::string first_heading(const std::string& page) {
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("# ", 0) == 0) return line.substr(2);
    }
    return {};
}

/// "22 Phong terms" and "22_phong_terms: ..." lose the number, which the gallery shows by itself.
std::string without_number(const std::string& title, const std::string& number) {
    if (title.rfind(number, 0) != 0) return title;
    const std::size_t start = title.find_first_not_of(" _.:", number.size());
    return start == std::string::npos ? title : title.substr(start);
}

/// The first paragraph of text after "## Goal"; a picture on a line of its own is no paragraph.
std::string goal_of(const std::string& page) {
    std::istringstream lines(page);
    std::string goal;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (!inside) {
            inside = line.rfind("## Goal", 0) == 0;
        } else if (line.empty() || line.rfind("#", 0) == 0 || line.rfind("![", 0) == 0) {
            if (!goal.empty() || line.rfind("#", 0) == 0) break;
        } else {
            goal += (goal.empty() ? "" : " ") + line;
        }
    }
    return goal;
}

}  // namespace

std::vector<GalleryExample> find_examples(const std::string& out, const std::string& docs) {
    if (!fs::is_directory(out))
        throw scene::UserError(scene::Place{out}, "is no folder; the gallery needs the pictures' folder");
    std::vector<GalleryExample> examples;
    for (const fs::directory_entry& entry : fs::directory_iterator(out)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() || !is_example_name(name)) continue;
        GalleryExample example;
        example.name = name;
        example.number = name.substr(0, 2);
        example.page = read_text(fs::path(docs) / (name + ".md"));
        example.title = without_number(first_heading(example.page), example.number);
        if (example.title.empty()) example.title = with_spaces(name.substr(3));
        example.goal = goal_of(example.page);
        example.output = read_text(entry.path() / "output.txt");
        example.pictures = find_pictures(entry.path());
        examples.push_back(example);
    }
    std::sort(examples.begin(), examples.end(),
              [](const GalleryExample& a, const GalleryExample& b) { return a.name < b.name; });
    return examples;
}

}  // namespace kreda::tools
