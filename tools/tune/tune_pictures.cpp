#include "tools/tune/tune_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "raster/film.hpp"
#include "tools/draw/draw.hpp"
#include "tools/measure/finding.hpp"

namespace kreda::tools {

namespace {

constexpr float kFullCodes = 8.0f;
constexpr int kWidth = 960, kHeight = 540, kMargin = 56, kThumb = 160;

const std::array<glm::vec3, 6>& colors() {
    static const std::array<glm::vec3, 6> all = {kOrange, kBlue, kGreen, kRed, kYellow, kChalk};
    return all;
}

/// Costs from left to right, errors upwards, both logarithmic.
struct Axes {
    double least_cost, most_cost, least_error, most_error;

    [[nodiscard]] glm::vec2 place(double cost, double error) const {
        const double x = std::log(cost / least_cost) / std::log(most_cost / least_cost);
        const double y = std::log(std::max(error, least_error) / least_error) / std::log(most_error / least_error);
        return {kMargin + static_cast<float>(x) * (kWidth - 2 * kMargin),
                kHeight - kMargin - static_cast<float>(y) * (kHeight - 2 * kMargin)};
    }
};

Axes axes_of(const std::vector<KnapsackChoice>& front) {
    Axes axes{1e30, 0.0, 0.01, 0.1};
    for (const KnapsackChoice& choice : front) {
        axes.least_cost = std::min(axes.least_cost, std::max(choice.cost, 1e-6));
        axes.most_cost = std::max(axes.most_cost, choice.cost);
        axes.most_error = std::max(axes.most_error, choice.error);
    }
    axes.most_cost = std::max(axes.most_cost, 1.01 * axes.least_cost);
    return axes;
}

Image linear_of(const Image& encoded) {
    Image linear = encoded;
    for (float& value : linear.values) value = raster::linear_from_srgb(value);
    return linear;
}

void draw_axes(Image& image, const Axes& axes, const std::string& unit) {
    const glm::vec2 corner = axes.place(axes.least_cost, axes.least_error);
    draw_line(image, corner, axes.place(axes.most_cost, axes.least_error), 2.0f, kSlate);
    draw_line(image, corner, axes.place(axes.least_cost, axes.most_error), 2.0f, kSlate);
    draw_text(image, {kMargin, kHeight - 24},
              "cost " + digits(axes.least_cost) + " to " + digits(axes.most_cost) + " " + unit, kDust, 2);
    draw_text(image, {kMargin, 12}, "predicted error [codes], up to " + digits(axes.most_error), kDust, 2);
}

}  // namespace

Image front_picture(const SceneSource& source, const Tuned& tuned, const TuneOptions& options) {
    Image image = make_board(kWidth, kHeight);
    if (tuned.front.empty()) return image;
    const Axes axes = axes_of(tuned.front);
    draw_axes(image, axes, options.cost_by == CostBy::plan ? "million operations" : "ms");
    DrawnSets thumbnails;
    const std::size_t thumbs = std::min<std::size_t>(4, tuned.front.size());
    for (std::size_t i = 0; i < thumbs; ++i) {
        const std::size_t at = thumbs > 1 ? i * (tuned.front.size() - 1) / (thumbs - 1) : 0;
        const KnapsackChoice& choice = tuned.front[tuned.front.size() - 1 - at];
        std::vector<Setting> settings = settings_of(tuned.found.terms, choice.chosen);
        settings.push_back(probe_size(read_with(source, {}).image, options.probe_pixels));
        const Picture drawn = draw_with_baked(thumbnails, read_with(source, settings), options.threads);
        const Image small = fit(linear_of(drawn.encoded), kThumb, kThumb * 9 / 16);
        const int x = kMargin + 40 + static_cast<int>(i) * (kThumb + 50), y = 44;
        draw_line(image, axes.place(choice.cost, choice.error),
                  {static_cast<float>(x + kThumb / 2), static_cast<float>(y + kThumb * 9 / 16)}, 1.0f, kSlate);
        paste(image, small, x, y);
    }
    for (const KnapsackChoice& choice : tuned.front)
        draw_disc(image, axes.place(choice.cost, choice.error), 3.0f, kBlue);
    draw_disc(image, axes.place(std::max(tuned.choice.cost, axes.least_cost), tuned.choice.error), 7.0f, kOrange);
    draw_text(image, {kWidth - 260, kHeight - 24}, "orange: the choice", kOrange, 2);
    return image;
}

Image attribution_picture(const std::vector<Term>& terms, const std::vector<std::vector<float>>& codes, int width,
                          int height) {
    Image image = make_board(width, height, glm::vec3(0.0f));
    std::vector<std::size_t> spenders;  // the most first
    std::vector<double> sums(terms.size(), 0.0);
    for (std::size_t t = 0; t < terms.size(); ++t) {
        sums[t] = std::accumulate(codes[t].begin(), codes[t].end(), 0.0);
        if (sums[t] > 0.0) spenders.push_back(t);
    }
    std::sort(spenders.begin(), spenders.end(), [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    if (spenders.size() > colors().size()) spenders.resize(colors().size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            float most = 0.0f;
            for (std::size_t s = 0; s < spenders.size(); ++s) {
                const float here = codes[spenders[s]][pixel];
                if (here <= most) continue;
                most = here;
                image.set_rgb(x, y, std::min(here / kFullCodes, 1.0f) * colors()[s]);
            }
        }
    }
    const int scale = text_scale(height);
    for (std::size_t s = 0; s < spenders.size(); ++s) {
        const std::string mean = fixed(sums[spenders[s]] / (static_cast<double>(width) * height), 2);
        const glm::vec2 corner(4, 4 + static_cast<int>(s) * 11 * scale);
        draw_text(image, corner, terms[spenders[s]].name + " " + mean, colors()[s], static_cast<float>(scale));
    }
    return image;
}

}  // namespace kreda::tools
