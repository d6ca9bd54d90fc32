#include "examples/plot_legend.hpp"

#include <cstdint>

namespace kreda::examples {

Panel plot_legend(const Options& options, glm::ivec2 size, const std::vector<std::string>& texts) {
    struct Style {
        const char* marker;
        std::uint32_t dark, light;
    };
    constexpr Style kStyles[] = {
        {"● ", 0xf0e442, 0x0072b2}, {"■ ", 0x56b4e9, 0xd55e00}, {"▲ ", 0xe69f00, 0x007a5e}, {"◆ ", 0xf2eee4, 0x000000}};
    const bool is_light = options.theme == tools::Theme::light;
    Panel panel = empty_panel(size);
    panel.image = make_board(size.x, size.y, colors_of(options.theme).ground);
    panel.is_drawing = false;
    const float type = caption_size(options.height);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const Style& style = kStyles[i % 4];
        const glm::vec3 color = srgb(is_light ? style.light : style.dark);
        const float down = 1.8f * static_cast<float>(i + 1);
        panel.labels.push_back({type * glm::vec2(0.8f, down), style.marker + texts[i], color, type});
    }
    return panel;
}

}  // namespace kreda::examples
