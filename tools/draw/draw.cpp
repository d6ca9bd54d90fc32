#include "tools/draw/draw.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "raster/film.hpp"
#include "raster/screen.hpp"
#include "tools/draw/markup.hpp"
#include "tools/draw/type.hpp"

namespace kreda::tools {

namespace {

constexpr int kGap = 4;

void blend(Image& image, int x, int y, const glm::vec3& color, float coverage) {
    if (coverage <= 0.0f) return;
    image.set_rgb(x, y, (1.0f - coverage) * image.rgb(x, y) + coverage * color);
}

/// The pixels that a shape within [low, high] may touch.
struct Box {
    int x0, y0, x1, y1;
};
Box box_of(const Image& image, glm::vec2 low, glm::vec2 high) {
    const auto cut = [](float value, int size) {
        return static_cast<int>(std::floor(std::clamp(value, 0.0f, static_cast<float>(size))));
    };
    return {cut(low.x - 1.0f, image.width), cut(low.y - 1.0f, image.height), cut(high.x + 2.0f, image.width),
            cut(high.y + 2.0f, image.height)};
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 ab = b - a;
    const float length2 = glm::dot(ab, ab);
    const float t = length2 > 0.0f ? std::clamp(glm::dot(p - a, ab) / length2, 0.0f, 1.0f) : 0.0f;
    const glm::vec2 d = p - (a + t * ab);
    return std::sqrt(glm::dot(d, d));
}

}  // namespace

glm::vec3 srgb(std::uint32_t rrggbb) {
    const auto channel = [&](int shift) {
        return raster::linear_from_srgb(static_cast<float>((rrggbb >> shift) & 0xffu) / 255.0f);
    };
    return {channel(16), channel(8), channel(0)};
}

Image make_board(int width, int height, const glm::vec3& color) {
    Image image = raster::make_image(width, height, 3);
    for (int c = 0; c < 3; ++c) std::fill_n(image.plane(c), image.plane_size(), color[c]);
    return image;
}

Image as_rgb(const Image& image) {
    if (image.channels >= 3) return image;
    Image rgb = raster::make_image(image.width, image.height, 3);
    for (int c = 0; c < 3; ++c) std::copy_n(image.plane(0), image.plane_size(), rgb.plane(c));
    return rgb;
}

Image grey_image(int width, int height, std::span<const float> values) {
    Image image = raster::make_image(width, height, 3);
    for (int c = 0; c < 3; ++c) std::copy_n(values.begin(), image.plane_size(), image.plane(c));
    return image;
}

glm::vec3 signed_color(float value) {
    const float strength = std::min(std::abs(value), 1.0f);
    return (1.0f - strength) * kBoard + strength * (value < 0.0f ? kBlue : kOrange);
}

void fill_rectangle(Image& image, int x, int y, int width, int height, const glm::vec3& color) {
    for (int j = std::max(y, 0); j < std::min(y + height, image.height); ++j) {
        for (int i = std::max(x, 0); i < std::min(x + width, image.width); ++i) image.set_rgb(i, j, color);
    }
}

void draw_line(Image& image, glm::vec2 from, glm::vec2 to, float width, const glm::vec3& color) {
    const glm::vec2 reach(0.5f * width);
    const Box box = box_of(image, glm::min(from, to) - reach, glm::max(from, to) + reach);
    for (int y = box.y0; y < box.y1; ++y) {
        for (int x = box.x0; x < box.x1; ++x) {
            const float d = distance_to_segment(glm::vec2(x, y) + 0.5f, from, to);
            blend(image, x, y, color, std::clamp(0.5f * width + 0.5f - d, 0.0f, std::min(width, 1.0f)));
        }
    }
}

void draw_disc(Image& image, glm::vec2 center, float radius, const glm::vec3& color) {
    draw_line(image, center, center, 2.0f * radius, color);
}

void fill_triangle(Image& image, const glm::vec2 (&corner)[3], const glm::vec3& color) {
    raster::ScreenVertex v[3];
    for (int i = 0; i < 3; ++i) {
        v[i].x = raster::round_half_up_to_int(corner[i].x * raster::kSubpixels);
        v[i].y = raster::round_half_up_to_int(corner[i].y * raster::kSubpixels);
    }
    if (raster::edge_function(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y) < 0) std::swap(v[1], v[2]);
    const raster::SampleBox box = sample_box(v[0], v[1], v[2], image.width, image.height);
    for (int y = box.y_first; y <= box.y_last; ++y) {
        for (int x = box.x_first; x <= box.x_last; ++x) {
            if (covers_sample(v[0], v[1], v[2], x, y)) image.set_rgb(x, y, color);
        }
    }
}

void draw_triangle_outline(Image& image, const glm::vec2 (&corner)[3], float width, const glm::vec3& color) {
    for (int i = 0; i < 3; ++i) draw_line(image, corner[i], corner[(i + 1) % 3], width, color);
}

namespace {

/// Size of the em square whose capitals are 7 `scale` pixels high.
float em_of(float scale) {
    return 7.0f * scale / kCapitals;
}

}  // namespace

void draw_text(Image& image, glm::vec2 corner, std::string_view text, const glm::vec3& color, float scale) {
    draw_type(image, corner + glm::vec2(0.0f, 7.0f * scale), plain_markup(text), color, em_of(scale));
}

float text_width(std::string_view text, float scale) {
    return type_width(plain_markup(text), em_of(scale));
}

int text_scale(int picture_height) {
    return std::max(1, picture_height / 180);
}

Image enlarge(const Image& image, int factor) {
    Image large = raster::make_image(image.width * factor, image.height * factor, image.channels);
    for (int c = 0; c < image.channels; ++c) {
        for (int y = 0; y < large.height; ++y) {
            for (int x = 0; x < large.width; ++x) large.at(c, x, y) = image.at(c, x / factor, y / factor);
        }
    }
    return large;
}

Image enlarge_with_grid(const Image& image, int factor) {
    Image large = enlarge(image, factor);
    const float unit = static_cast<float>(factor);
    for (int x = 0; x < image.width; ++x) fill_rectangle(large, x * factor, 0, 1, large.height, kSlate);
    for (int y = 0; y < image.height; ++y) fill_rectangle(large, 0, y * factor, large.width, 1, kSlate);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            draw_disc(large, (glm::vec2(x, y) + 0.5f) * unit, 0.06f * unit, kDust);
        }
    }
    return large;
}

Image fit(const Image& image, int width, int height, const glm::vec3& around) {
    const double scale = std::min(double(width) / image.width, double(height) / image.height);
    const int wide = std::clamp(static_cast<int>(image.width * scale), 1, width);
    const int high = std::clamp(static_cast<int>(image.height * scale), 1, height);
    const int left = (width - wide) / 2, top = (height - high) / 2;
    Image whole = raster::make_image(width, height, image.channels);
    for (int c = 0; c < image.channels; ++c) {
        std::fill_n(whole.plane(c), whole.plane_size(), around[c]);
        for (int y = 0; y < high; ++y) {
            for (int x = 0; x < wide; ++x) {
                whole.at(c, left + x, top + y) = image.at(c, x * image.width / wide, y * image.height / high);
            }
        }
    }
    return whole;
}

Image box_average(const Image& fine, int n) {
    if (n == 1) return fine;
    Image image = make_board(fine.width / n, fine.height / n);
    const float weight = 1.0f / static_cast<float>(n * n);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            glm::vec3 sum(0.0f);
            for (int s = 0; s < n * n; ++s) sum += fine.rgb(x * n + s % n, y * n + s / n);
            image.set_rgb(x, y, weight * sum);
        }
    }
    return image;
}

Image crop(const Image& image, int x, int y, int width, int height) {
    Image part = make_board(width, height);
    paste(part, image, -x, -y);
    return part;
}

void paste(Image& onto, const Image& image, int x, int y) {
    for (int j = std::max(0, -y); j < std::min(image.height, onto.height - y); ++j) {
        for (int i = std::max(0, -x); i < std::min(image.width, onto.width - x); ++i) {
            onto.set_rgb(x + i, y + j, image.rgb(i, j));
        }
    }
}

glm::ivec2 panel_size(int width, int height, int columns, int rows) {
    return {(width - (columns - 1) * kGap) / columns, (height - (rows - 1) * kGap) / rows};
}

glm::ivec2 panel_corner(int width, int height, int columns, int index, std::size_t count, glm::ivec2 panel) {
    const int rows = (static_cast<int>(count) + columns - 1) / columns;
    const glm::ivec2 cell = panel_size(width, height, columns, rows);
    const glm::ivec2 corner = glm::ivec2(index % columns, index / columns) * (cell + kGap);
    return corner + (cell - panel) / 2;
}

Image montage(int width, int height, int columns, const std::vector<Image>& panels, const glm::vec3& division) {
    Image whole = make_board(width, height, division);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const glm::ivec2 corner = panel_corner(width, height, columns, static_cast<int>(i), panels.size(),
                                               {panels[i].width, panels[i].height});
        paste(whole, panels[i], corner.x, corner.y);
    }
    return whole;
}

}  // namespace kreda::tools
