#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "raster/film.hpp"
#include "tools/compare/compare_pictures.hpp"
#include "tools/draw/draw.hpp"

namespace kreda::tools {

namespace {

int enlargement(int width) {
    constexpr int kSmallestWidth = 320;
    return std::max(1, (kSmallestWidth + width - 1) / width);
}

}  // namespace

Image side_by_side(const Comparison& comparison, const Image& actual, const Image& expected, Numbers numbers) {
    constexpr int kGap = 8, kScale = 2, kCaption = 7 * kScale + 2 * kGap;
    std::vector<std::pair<std::string, Image>> panels;
    panels.emplace_back("A", shown(actual, numbers));
    panels.emplace_back("B (expected)", shown(expected, numbers));
    if (comparison.comparable) panels.emplace_back("difference", heat_map(comparison, expected, numbers));
    const int factor = enlargement(std::min(actual.width, expected.width));
    int width = kGap, height = 0;
    for (auto& [caption, panel] : panels) {
        panel = enlarge(panel, factor);
        width += panel.width + kGap;
        height = std::max(height, panel.height);
    }
    Image board = make_board(width, height + kCaption + kGap);
    int x = kGap;
    for (const auto& [caption, panel] : panels) {
        draw_text(board, {x, kGap}, caption, kChalk, kScale);
        x += panel.width + kGap;
    }
    board = raster::develop(board, {});
    x = kGap;
    for (const auto& [caption, panel] : panels) {
        paste(board, panel, x, kCaption);
        x += panel.width + kGap;
    }
    return board;
}

}  // namespace kreda::tools
