#include "examples/geometry_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kreda::examples {

namespace {

constexpr int kSamples = 3;  ///< of areas, a side of a pixel

/// A line with a head at `to`.
void draw_arrow(Image& image, glm::vec2 from, glm::vec2 to, float width, const glm::vec3& color) {
    const glm::vec2 along = glm::normalize(to - from), across(-along.y, along.x);
    const glm::vec2 neck = to - 5.0f * width * along;
    draw_line(image, from, neck, width, color);
    draw_line(image, to, neck + 2.0f * width * across, width, color);
    draw_line(image, to, neck - 2.0f * width * across, width, color);
    draw_line(image, to, neck, width, color);
}

void draw_dashes(Image& image, glm::vec2 from, glm::vec2 to, float width, const glm::vec3& color) {
    const int count = std::max(1, static_cast<int>(glm::distance(from, to) / (5.0f * width)));
    for (int i = 0; i < count; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(count);
        draw_line(image, glm::mix(from, to, t), glm::mix(from, to, t + 0.5f / static_cast<float>(count)), width, color);
    }
}

/// A text in the middle of `place`.
Label centered(glm::vec2 place, const std::string& text, const glm::vec3& color, float size) {
    return {place + glm::vec2(-0.5f * tools::type_width(text, size), 0.5f * tools::kCapitals * size), text, color,
            size};
}

Panel drawing(Image image, const std::string& caption = "") {
    Panel panel(std::move(image), caption);
    panel.is_computed = false;
    panel.is_drawing = true;
    return panel;
}

// ------------------------------------------------------------------------------------------- the grooves

constexpr float kPeak = 0.9f;  ///< height of a groove whose half width is 1

/// Height of the grooves at x: 0 at odd x, kPeak at even x.
float height_of_grooves(float x) {
    return kPeak * std::abs(x - 2.0f * std::floor(0.5f * x) - 1.0f);
}

/// Where a ray from a point on the grooves meets them again, at most `longest` away.
float way_to_grooves(glm::vec2 from, glm::vec2 direction, float longest) {
    constexpr float kStep = 0.004f;
    for (float t = 0.1f; t < longest; t += kStep) {
        const glm::vec2 p = from + t * direction;
        if (p.y < height_of_grooves(p.x)) return t;
    }
    return longest;
}

/// Grooves from x = 1 to 5, and a mirror at `x` on the wall that looks to the left; to_light is a direction.
Panel grooves(glm::ivec2 size, int picture_height, float x, glm::vec2 to_light, const char* caption) {
    constexpr float kLength = 2.3f;
    const float unit = static_cast<float>(size.x) / 4.0f, line = 0.016f * unit;
    const auto place = [&](glm::vec2 p) { return glm::vec2((p.x - 1.0f) * unit, 0.68f * float(size.y) - p.y * unit); };
    Image image = averaged(size, kSamples, [&](glm::ivec2 fine) {
        Image ground = make_board(fine.x, fine.y);
        for (int i = 0; i < fine.x; ++i) {
            const float at = 1.0f + static_cast<float>(i) / (kSamples * unit);
            const int top = static_cast<int>(kSamples * place({at, height_of_grooves(at)}).y);
            fill_rectangle(ground, i, top, 1, fine.y - top, kSlate);
        }
        return ground;
    });
    for (int i = 1; i < 5; ++i) {
        const float from = static_cast<float>(i), to = from + 1.0f;
        draw_line(image, place({from, height_of_grooves(from)}), place({to, height_of_grooves(to)}), line, kChalk);
    }
    const glm::vec2 n = glm::normalize(glm::vec2(-kPeak, 1.0f)), p(x, height_of_grooves(x));
    const glm::vec2 l = glm::normalize(to_light), v = 2.0f * glm::dot(n, l) * n - l;  // the mirror vector
    const glm::vec2 along(n.y, -n.x);
    draw_line(image, place(p - 0.2f * along), place(p + 0.2f * along), 3.0f * line, kYellow);
    // The light comes from the far end of its ray; coming from there, it stops where that passes grooves the last time.
    const bool arrives = way_to_grooves(p, l, kLength) >= kLength;
    float last = kLength;
    while (!arrives && (p + last * l).y >= height_of_grooves((p + last * l).x)) last -= 0.004f;
    draw_arrow(image, place(p + kLength * l), place(p + (arrives ? 0.05f : last) * l), 1.6f * line, kOrange);
    if (!arrives) draw_dashes(image, place(p + last * l), place(p), 1.6f * line, kOrange);
    if (arrives) draw_arrow(image, place(p), place(p + way_to_grooves(p, v, kLength) * v), 1.6f * line, kBlue);
    Panel panel = drawing(std::move(image), caption);
    const float type = caption_size(picture_height);
    panel.labels.push_back(centered(place(p + kLength * l) + glm::vec2(0.2f, -0.7f) * type, "$l$", kOrange, type));
    if (arrives && way_to_grooves(p, v, kLength) >= kLength) {
        panel.labels.push_back(centered(place(p + kLength * v) + glm::vec2(0.7f, 0.0f) * type, "$v$", kBlue, type));
    }
    return panel;
}

}  // namespace

std::vector<Panel> shadowing_and_masking(const Options& options) {
    const glm::ivec2 panel = panel_size(options.width, options.height, 3, 1);
    constexpr glm::vec2 kLow(-1.0f, 0.4f);
    const glm::vec2 n = glm::normalize(glm::vec2(-kPeak, 1.0f)), low = glm::normalize(kLow);
    return {grooves(panel, options.height, 3.7f, {-1.0f, 0.55f}, "lit and seen"),
            grooves(panel, options.height, 3.25f, low, "shadowing"),
            grooves(panel, options.height, 3.25f, 2.0f * glm::dot(n, low) * n - low, "masking")};
}

// ----------------------------------------------------------------------------------------- the penumbra

namespace {

/// In heights of the picture, y down.
constexpr float kLampY = 0.13f, kBlockerY = 0.45f, kGroundY = 0.74f, kLampLeft = 0.74f, kLampRight = 1.0f;
constexpr float kBlockerLeft = 0.6f, kBlockerRight = 1.14f;

/// Where a ray from the lamp past an edge of the blocker meets the ground.
float on_ground(float lamp, float edge) {
    return edge + (edge - lamp) * (kGroundY - kBlockerY) / (kBlockerY - kLampY);
}

/// Share of the lamp that a place on the ground sees.
float seen_share(float x) {
    const float right = (x - on_ground(kLampRight, kBlockerRight)) /
                        (on_ground(kLampLeft, kBlockerRight) - on_ground(kLampRight, kBlockerRight));
    const float left = (on_ground(kLampLeft, kBlockerLeft) - x) /
                       (on_ground(kLampLeft, kBlockerLeft) - on_ground(kLampRight, kBlockerLeft));
    return std::clamp(std::max(left, right), 0.0f, 1.0f);
}

/// The two rays past an edge, and the ground between them.
void draw_penumbra(Image& image, float unit, float edge) {
    const glm::vec2 top = unit * glm::vec2(edge, kBlockerY);
    for (const float lamp : {kLampLeft, kLampRight}) {
        const glm::vec2 ground = unit * glm::vec2(on_ground(lamp, edge), kGroundY);
        draw_line(image, unit * glm::vec2(lamp, kLampY), top, 0.004f * unit, kYellow);
        draw_line(image, top, ground, 0.004f * unit, kYellow);
    }
}

/// A measure from `from` to `to` with its name to the right.
void draw_measure(Panel& panel, glm::vec2 from, glm::vec2 to, const char* name, float type) {
    const float width = 0.06f * type;
    const glm::vec2 middle = 0.5f * (from + to);
    draw_arrow(panel.image, middle, from, width, kDust);
    draw_arrow(panel.image, middle, to, width, kDust);
    const bool upright = from.x == to.x;
    const glm::vec2 beside = upright ? glm::vec2(0.9f * type, 0.0f) : glm::vec2(0.0f, 0.75f * type);
    panel.labels.push_back(centered(middle + beside, name, kChalk, type));
}

}  // namespace

Panel penumbra_geometry(glm::ivec2 size) {
    const float unit = static_cast<float>(size.y), type = caption_size(size.y);
    Panel panel = drawing(make_board(size.x, size.y));
    Image& image = panel.image;
    const int top = static_cast<int>(kGroundY * unit), thickness = static_cast<int>(0.03f * unit);
    panel.pictures.push_back({0, top, size.x, thickness});  // bright is bright on paper, too
    for (int x = 0; x < size.x; ++x) {
        const float share = seen_share((static_cast<float>(x) + 0.5f) / unit);
        fill_rectangle(image, x, top, 1, thickness, share * kYellow);
    }
    draw_penumbra(image, unit, kBlockerLeft);
    draw_penumbra(image, unit, kBlockerRight);
    draw_line(image, unit * glm::vec2(kLampLeft, kLampY), unit * glm::vec2(kLampRight, kLampY), 0.018f * unit, kYellow);
    draw_line(image, unit * glm::vec2(kBlockerLeft, kBlockerY), unit * glm::vec2(kBlockerRight, kBlockerY),
              0.03f * unit, kOrange);
    const float below = kGroundY + 0.11f, umbra = on_ground(kLampRight, kBlockerRight),
                all = on_ground(kLampLeft, kBlockerRight);
    const auto write = [&](float x, float y, const char* text) {
        panel.labels.push_back(centered(unit * glm::vec2(x, y), text, kChalk, type));
    };
    write(0.5f * (kLampLeft + kLampRight), kLampY - 0.055f, "lamp, $w$");
    write(0.5f * (on_ground(kLampLeft, kBlockerLeft) + umbra), below, "umbra");
    write(0.5f * (umbra + all), below + 0.055f, "penumbra");
    write(0.5f * (on_ground(kLampLeft, kBlockerLeft) + on_ground(kLampRight, kBlockerLeft)), below + 0.055f,
          "penumbra");
    draw_measure(panel, unit * glm::vec2(umbra, below - 0.06f), unit * glm::vec2(all, below - 0.06f), "$w_p$", type);
    draw_measure(panel, unit * glm::vec2(1.55f, kLampY), unit * glm::vec2(1.55f, kBlockerY), "$d_b$", type);
    draw_measure(panel, unit * glm::vec2(1.66f, kLampY), unit * glm::vec2(1.66f, kGroundY), "$d_r$", type);
    return panel;
}

// --------------------------------------------------------------------------------------- the double sum

namespace {

/// Calls visit(φ, θ) for the middles of n1 x n2 even steps: 0..2π, 0..π/2.
template <class Visit>
void for_each_direction(int n1, int n2, Visit visit) {
    for (int i = 0; i < n1; ++i) {
        for (int j = 0; j < n2; ++j) {
            const double phi = 2.0 * std::numbers::pi * (i + 0.5) / n1;
            const double theta = 0.5 * std::numbers::pi * (j + 0.5) / n2;
            visit(static_cast<float>(phi), static_cast<float>(theta));
        }
    }
}

}  // namespace

std::vector<Panel> double_sum_directions(const Options& options, int n1, int n2) {
    const glm::ivec2 panel = panel_size(options.width, options.height, 2, 1);
    const float type = caption_size(options.height), dot = 0.016f * static_cast<float>(panel.x);
    const glm::vec2 size(panel);
    Panel even = drawing(make_board(panel.x, panel.y), "even steps");
    const glm::vec2 low = size * glm::vec2(0.14f, 0.12f), room = size * glm::vec2(0.8f, 0.6f);
    for (int i = 0; i <= n1; ++i) {
        const float x = low.x + room.x * static_cast<float>(i) / static_cast<float>(n1);
        draw_line(even.image, {x, low.y}, {x, low.y + room.y}, 0.1f * dot, kDust);
    }
    for (int j = 0; j <= n2; ++j) {
        const float y = low.y + room.y * static_cast<float>(j) / static_cast<float>(n2);
        draw_line(even.image, {low.x, y}, {low.x + room.x, y}, 0.1f * dot, kDust);
    }
    even.labels.push_back(centered({low.x - type, low.y + 0.5f * room.y}, "$θ$", kChalk, type));
    even.labels.push_back(centered({low.x + 0.5f * room.x, low.y + room.y + type}, "$φ$", kChalk, type));
    Panel above = drawing(make_board(panel.x, panel.y), "on the hemisphere");
    const glm::vec2 middle = size * glm::vec2(0.5f, 0.44f);
    const float radius = 0.4f * std::min(size.x, size.y);
    draw_disc(above.image, middle, radius, kSlate);
    constexpr float kHalfPi = 0.5f * std::numbers::pi_v<float>, kTwoPi = 2.0f * std::numbers::pi_v<float>;
    for_each_direction(n1, n2, [&](float phi, float theta) {
        draw_disc(even.image, low + room * glm::vec2(phi / kTwoPi, theta / kHalfPi), dot, kOrange);
        const glm::vec2 place = middle + radius * std::sin(theta) * glm::vec2(std::cos(phi), std::sin(phi));
        draw_disc(above.image, place, 1.6f * dot * std::sqrt(std::sin(theta) * std::cos(theta)), kOrange);
    });
    draw_disc(above.image, middle, 0.6f * dot, kChalk);
    above.labels.push_back(centered(middle + glm::vec2(0.0f, -0.75f * type), "$n$", kChalk, type));
    return {even, above};
}

}  // namespace kreda::examples
