#include "tools/stages/stage_page.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include <zlib.h>
#include <nlohmann/json.hpp>

#include "raster/film.hpp"
#include "tools/base64.hpp"
#include "tools/draw/draw.hpp"
#include "tools/escape_html.hpp"
#include "tools/stages/stage_page_script.hpp"

namespace kreda::tools {

namespace {

using raster::Image;

constexpr int kThumbnailWidth = 372;

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<unsigned char> packed(size);
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) !=
        Z_OK) {
        throw std::runtime_error("zlib refused to compress");
    }
    packed.resize(size);
    return packed;
}

/// The nearest float whose last 8 bits are 0.
std::uint32_t bits_of(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    return std::isfinite(value) ? bits + 0x80u : bits;
}

nlohmann::ordered_json json_of(const PageEntry& entry) {
    return {{"picture", entry.picture}, {"values", entry.values}, {"title", entry.title},
            {"meaning", entry.meaning}, {"legend", entry.legend}, {"components", entry.components}};
}

std::string script_data(const StagePage& page) {
    nlohmann::ordered_json json = {{"scene", page.scene},
                                   {"width", page.size.x},
                                   {"height", page.size.y},
                                   {"pictureWidth", page.picture_size.x},
                                   {"pictureHeight", page.picture_size.y},
                                   {"left", page.corner.x},
                                   {"top", page.corner.y},
                                   {"hasPixels", page.has_pixels},
                                   {"stages", nlohmann::ordered_json::array()}};
    for (const PageEntry& entry : page.stages) json["stages"].push_back(json_of(entry));
    std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c");  // no </script>
    return text;
}

/// The passes that make the picture, as `kreda plan` lists them.
std::string pass_list(const std::vector<PagePass>& passes) {
    if (passes.empty()) return "";
    std::string html = "<details id=\"passes\"><summary>the passes that ran</summary><ol>\n";
    for (const PagePass& pass : passes)
        html += "<li><b>" + escape_html(pass.name) + "</b> " + escape_html(pass.reason) + "</li>\n";
    return html + "</ol></details>";
}

}  // namespace

std::vector<unsigned char> packed_values(const Image& values) {
    std::vector<unsigned char> bytes;
    bytes.reserve(3 * values.values.size());
    for (int c = 0; c < values.channels; ++c) {
        for (int shift = 24; shift >= 8; shift -= 8) {
            unsigned char before = 0;
            for (std::size_t i = 0; i < values.plane_size(); ++i) {
                const auto byte = static_cast<unsigned char>(bits_of(values.plane(c)[i]) >> shift);
                bytes.push_back(static_cast<unsigned char>(byte - before));
                before = byte;
            }
        }
    }
    return deflated(bytes);
}

std::string values_script(std::size_t stage, const Image& values) {
    return "kredaValues(" + std::to_string(stage) + ", " + std::to_string(values.channels) + ", \"" +
           base64(packed_values(values)) + "\");\n";
}

std::string stage_page_html(const StagePage& page) {
    const std::string title = escape_html(page.title);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           title + ": the stages</title>\n<style>" + kStagePageStyle +
           "</style>\n</head>\n<body>\n<nav id=\"list\"><h1>" + title + "</h1>" + pass_list(page.passes) + "</nav>\n" +
           kStagePageBody + "<script>\nconst page = " + script_data(page) + ";\n" + kStagePageScript +
           "</script>\n</body>\n</html>\n";
}

Image thumbnail(const Image& picture) {
    const int width = std::min(kThumbnailWidth, picture.width);
    const float scale = static_cast<float>(picture.width) / static_cast<float>(width);
    Image small = raster::make_image(
        width, std::max(1, static_cast<int>(std::lround(static_cast<float>(picture.height) / scale))), 3);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const auto range = [&](int i, int size) {
                const int first = std::min(static_cast<int>(static_cast<float>(i) * scale), size - 1);
                return std::pair(
                    first, std::max(first + 1, std::min(static_cast<int>(static_cast<float>(i + 1) * scale), size)));
            };
            const auto [x0, x1] = range(x, picture.width);
            const auto [y0, y1] = range(y, picture.height);
            glm::vec3 sum(0.0f);
            for (int j = y0; j < y1; ++j) {
                for (int i = x0; i < x1; ++i) sum += picture.rgb(i, j);
            }
            small.set_rgb(x, y, sum / static_cast<float>((x1 - x0) * (y1 - y0)));
        }
    }
    return small;
}

Image contact_sheet(const std::string& title, const std::vector<Image>& thumbnails,
                    const std::vector<std::string>& titles) {
    constexpr int kColumns = 5, kGap = 12, kCaption = 34, kTitle = 64;
    const int count = static_cast<int>(thumbnails.size());
    int width = 160, height = 1;
    for (const Image& small : thumbnails) {
        width = std::max(width, small.width);
        height = std::max(height, small.height);
    }
    const int cell_width = width + kGap;
    const int cell_height = height + kCaption + kGap;
    const int columns = std::min(kColumns, std::max(count, 1));
    Image sheet = make_board(columns * cell_width + kGap, kTitle + (count + columns - 1) / columns * cell_height);
    const float room = static_cast<float>(sheet.width - 2 * kGap);
    draw_text(sheet, {kGap, 20.0f}, title, kChalk, std::min(3.5f, 3.5f * room / text_width(title, 3.5f)));
    const auto corner = [&](int i) {
        return glm::ivec2(kGap + i % columns * cell_width, kTitle + i / columns * cell_height);
    };
    for (int i = 0; i < count; ++i) {
        char number[16];
        std::snprintf(number, sizeof number, "%02d ", i + 1);
        const std::string text = number + titles[static_cast<std::size_t>(i)];
        const float scale = std::min(2.2f, 2.2f * static_cast<float>(width) / text_width(text, 2.2f));
        draw_text(sheet, glm::vec2(corner(i)) + glm::vec2(0.0f, height + 6.0f), text, kChalk, scale);
    }
    sheet = develop(sheet, {});
    for (int i = 0; i < count; ++i) paste(sheet, thumbnails[static_cast<std::size_t>(i)], corner(i).x, corner(i).y);
    return sheet;
}

}  // namespace kreda::tools
