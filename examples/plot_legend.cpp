#include "examples/plot_legend.hpp"

#include <cstdint>

namespace kreda::examples {

Panel plot_legend(glm::ivec2 size, int picture_height, const std::vector<std::string>& texts) {
    struct Style {
        const char* marker;
        std::uint32_t color;
    };
    constexpr Style kStyles[] = {{"● ", 0xf0e442}, {"■ ", 0x56b4e9}, {"▲ ", 0xe69f00}, {"◆ ", 0xf2eee4}};
    Panel panel = empty_panel(size);
    const float type = caption_size(picture_height);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const Style& style = kStyles[i % 4];
        const float down = 1.8f * static_cast<float>(i + 1);
        panel.labels.push_back({type * glm::vec2(0.8f, down), style.marker + texts[i], srgb(style.color), type});
    }
    return panel;
}

}  // namespace kreda::examples
