#include "examples/number_table.hpp"

#include <cstdio>

namespace kreda::examples {

NumberRow number_row(const char* name, glm::vec4 p, int count) {
    NumberRow cells = {name};
    for (int i = 0; i < count; ++i) {
        char text[16];
        std::snprintf(text, sizeof text, "%.3f", double(p[i]));
        cells[std::size_t(i + 1)] = text;
    }
    return cells;
}

void add_row(Panel& table, const NumberRow& cells, float baseline, float size, const glm::vec3& color) {
    const float width = float(table.image.width);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const float right = (0.28f + 0.17f * float(i)) * width;
        const float x = i == 0 ? 0.05f * width : right - tools::type_width(cells[i], size);
        if (!cells[i].empty()) table.labels.push_back({{x, baseline}, cells[i], color, size});
    }
}

}  // namespace kreda::examples
