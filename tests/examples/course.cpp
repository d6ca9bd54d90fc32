#include "course.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
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

raster::Image linear_panel(const std::string& file, int columns, int rows, int index) {
    constexpr int kGap = 4;  // between the panels of a montage
    const glm::ivec2 size = examples::panel_size(320, 180, columns, rows);
    const glm::ivec2 corner = glm::ivec2(index % columns, index / columns) * (size + kGap);
    raster::Image image = examples::crop(golden(file), corner.x, corner.y, size.x, size.y);
    for (float& value : image.values) value = raster::linear_from_srgb(value);
    return image;
}

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(KREDA_SOURCE_DIR) + "/examples")) {
        if (std::filesystem::exists(entry.path() / "main.cpp")) names.push_back(entry.path().filename().string());
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
    const std::string text = repository_text("docs/" + example + ".md");
    const std::string mark = "<!-- number: " + key + " = ";
    const std::size_t at = text.find(mark);
    REQUIRE_MESSAGE(at != std::string::npos, "docs/", example, ".md has no mark ", mark);
    return std::stod(text.substr(at + mark.size()));
}

}  // namespace kreda::tests
