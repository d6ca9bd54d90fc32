#include "course.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <doctest/doctest.h>

#include "examples/draw.hpp"
#include "raster/film.hpp"
#include "scene/files/image_file.hpp"

namespace kreda::tests {

raster::Image golden(const std::string& file) {
    return scene::read_image(std::string(KREDA_SOURCE_DIR) + "/tests/golden/" + file);
}

namespace {

constexpr glm::ivec2 kGoldenSize(320, 180);

/// The files of a picture's panels by their numbers, from 0: "tests/golden/22_phong_terms/terms/1_ambient.png" is 0.
std::map<int, std::string> panel_files(const std::string& picture) {
    const std::filesystem::path folder = std::string(KREDA_SOURCE_DIR) + "/tests/golden/" + picture;
    REQUIRE_MESSAGE(std::filesystem::is_directory(folder), folder.string(), " has no golden panels");
    std::map<int, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files[std::stoi(entry.path().filename().string()) - 1] = entry.path().string();
    }
    return files;
}

}  // namespace

raster::Image golden_montage(const std::string& picture, int columns) {
    std::vector<raster::Image> panels;
    for (const auto& [number, file] : panel_files(picture)) {
        REQUIRE(number == static_cast<int>(panels.size()));
        panels.push_back(scene::read_image(file));
    }
    return examples::montage(kGoldenSize.x, kGoldenSize.y, columns, panels);
}

raster::Image linear_panel(const std::string& picture, int columns, int rows, int index) {
    const std::map<int, std::string> files = panel_files(picture);
    REQUIRE(files.contains(index));
    const raster::Image panel = scene::read_image(files.at(index));
    const glm::ivec2 size = examples::panel_size(kGoldenSize.x, kGoldenSize.y, columns, rows);
    raster::Image image = examples::make_board(size.x, size.y, glm::vec3(0.0f));
    examples::paste(image, panel, (size.x - panel.width) / 2, (size.y - panel.height) / 2);
    for (float& value : image.values) value = raster::linear_from_srgb(value);
    return image;
}

std::vector<glm::dvec2> golden_series(const std::string& plot, const std::string& series) {
    std::istringstream lines(repository_text("tests/golden/" + plot + ".csv"));
    std::vector<glm::dvec2> points;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(series + ",")) continue;
        glm::dvec2 point;
        REQUIRE(std::sscanf(line.c_str() + series.size(), ",%lf,%lf", &point.x, &point.y) == 2);
        points.push_back(point);
    }
    REQUIRE_MESSAGE(!points.empty(), plot, " has no series ", series);
    return points;
}

double golden_value(const std::string& plot, const std::string& series, double x) {
    for (const glm::dvec2& point : golden_series(plot, series)) {
        if (std::abs(point.x - x) < 1e-9) return point.y;
    }
    FAIL(plot, ", ", series, " has no point at ", x);
    return 0.0;
}

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(KREDA_SOURCE_DIR) + "/examples")) {
        const std::string name = entry.path().filename().string();  // "22_phong_terms", but not "assignments"
        const bool is_numbered = name[0] >= '0' && name[0] <= '9';
        if (is_numbered && std::filesystem::exists(entry.path() / "main.cpp")) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string repository_text(const std::string& path) {
    std::ifstream file(std::string(KREDA_SOURCE_DIR) + "/" + path);
    REQUIRE_MESSAGE(file.good(), path, " is not in the repository");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

double documented_number(const std::string& example, const std::string& key) {
    return quoted_number(example, key).value;
}

bool rounds_to(double number, const QuotedNumber& quoted) {
    return std::abs(number - quoted.value) <= 0.5001 * quoted.step;  // the page's own decimal fraction is no double
}

std::vector<QuotedNumber> numbers_in(const std::string& text) {
    std::string plain = std::regex_replace(text, std::regex("<!--.*?-->"), "");
    plain = std::regex_replace(plain, std::regex("\u2212"), "-");
    // A sign, digits with a fraction, an exponent; not inside a word.
    const std::regex number(R"((^|[^\w.])(-?)(\d+)(\.\d+)?(e-?\d+)?(?!\w))");
    std::vector<QuotedNumber> numbers;
    for (std::sregex_iterator it(plain.begin(), plain.end(), number), end; it != end; ++it) {
        const std::smatch& match = *it;
        const double sign = match[2].length() > 0 ? -1.0 : 1.0;
        const int decimals = match[4].matched ? static_cast<int>(match[4].length()) - 1 : 0;
        const double scale = std::stod("1" + match[5].str());
        numbers.push_back({sign * std::stod(match[3].str() + match[4].str()) * scale, scale * std::pow(0.1, decimals)});
    }
    return numbers;
}

QuotedNumber quoted_number(const std::string& example, const std::string& key) {
    const std::string text = repository_text("docs/" + example + ".md");
    const std::string mark = "<!-- number: " + key + " = ";
    const std::size_t at = text.find(mark);
    REQUIRE_MESSAGE(at != std::string::npos, "docs/", example, ".md has no mark ", mark);
    const std::size_t digits = at + mark.size();
    return numbers_in(text.substr(digits, text.find(" -->", digits) - digits)).at(0);
}

std::vector<QuotedNumber> documented_row(const std::string& example, const std::string& heading,
                                         const std::string& row) {
    std::istringstream page(repository_text("docs/" + example + ".md"));
    bool in_table = false;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("|")) {
            if (in_table) break;
            continue;
        }
        in_table = in_table || line.find(heading) != std::string::npos;
        if (in_table && line.starts_with("| " + row + " |")) return numbers_in(line.substr(row.size() + 3));
    }
    FAIL("docs/", example, ".md has no table ", heading, " with a row ", row);
    return {};
}

}  // namespace kreda::tests
