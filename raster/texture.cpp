#include "raster/texture.hpp"

namespace kreda::raster {

namespace {

/// The texels of the finer row that a texel of the coarser one covers, and the share of each.
struct Taps {
    int first = 0;
    int count = 1;
    double weight[3] = {1.0, 0.0, 0.0};
};

/// Texel k of n = floor(side / 2). It covers side / n texels: two, or 2 + 1/n of three where the side is odd.
Taps taps_of(int k, int side) {
    if (side == 1) return {};
    const int n = side / 2;
    if (side % 2 == 0) return {2 * k, 2, {0.5, 0.5, 0.0}};
    const double s = side;
    return {2 * k, 3, {(n - k) / s, n / s, (k + 1) / s}};
}

/// Weighted mean over the taps, as a difference to the first texel: exact where all are equal.
float reduced_texel(const float* level, int width, int channels, const Taps& x, const Taps& y, int c) {
    const auto texel = [&](int i, int j) {
        return double{level[(std::size_t(y.first + j) * std::size_t(width) + std::size_t(x.first + i)) * channels + c]};
    };
    const double base = texel(0, 0);
    double difference = 0.0;
    for (int j = 0; j < y.count; ++j) {
        for (int i = 0; i < x.count; ++i) difference += y.weight[j] * x.weight[i] * (texel(i, j) - base);
    }
    return static_cast<float>(base + difference);
}

void reduce_level(const float* from, int width, int height, int channels, float* to) {
    const int to_width = level_side(width, 1);
    const int to_height = level_side(height, 1);
    for (int y = 0; y < to_height; ++y) {
        const Taps rows = taps_of(y, height);
        for (int x = 0; x < to_width; ++x) {
            const Taps columns = taps_of(x, width);
            for (int c = 0; c < channels; ++c) *to++ = reduced_texel(from, width, channels, columns, rows, c);
        }
    }
}

/// Give every level its place, down to the single texel.
void lay_out_levels(Texture& texture, bool with_pyramid) {
    int texels = 0;
    for (int level = 0; level < kMaxTextureLevels; ++level) {
        const int width = level_side(texture.width, level);
        const int height = level_side(texture.height, level);
        texture.first_texel[static_cast<std::size_t>(level)] = texels;
        texture.level_count = level + 1;
        texels += width * height;
        if (!with_pyramid || (width == 1 && height == 1)) break;
    }
    texture.texels.resize(std::size_t(texels) * std::size_t(texture.channels));
}

float* level_texels(Texture& texture, int level) {
    return texture.texels.data() +
           std::size_t(texture.channels) * std::size_t(texture.first_texel[static_cast<std::size_t>(level)]);
}

}  // namespace

Texture make_texture(const Image& image, bool with_pyramid) {
    KREDA_EXPECT(image.channels == 1 || image.channels == 3);
    KREDA_EXPECT(image.width >= 1 && image.height >= 1 && image.width <= 32768 && image.height <= 32768);
    Texture texture;
    texture.width = image.width;
    texture.height = image.height;
    texture.channels = image.channels;
    lay_out_levels(texture, with_pyramid);
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    for (std::size_t c = 0; c < channels; ++c) {
        const float* plane = image.plane(static_cast<int>(c));
        for (std::size_t i = 0; i < image.plane_size(); ++i) texture.texels[channels * i + c] = plane[i];
    }
    for (int level = 1; level < texture.level_count; ++level) {
        reduce_level(level_texels(texture, level - 1), level_side(image.width, level - 1),
                     level_side(image.height, level - 1), image.channels, level_texels(texture, level));
    }
    return texture;
}

Image level_image(const Texture& texture, int level) {
    KREDA_EXPECT(level >= 0 && level < texture.level_count);
    Image image = make_image(level_side(texture.width, level), level_side(texture.height, level), texture.channels);
    const std::size_t channels = static_cast<std::size_t>(texture.channels);
    const float* texels =
        texture.texels.data() + channels * std::size_t(texture.first_texel[static_cast<std::size_t>(level)]);
    for (std::size_t c = 0; c < channels; ++c) {
        float* plane = image.plane(static_cast<int>(c));
        for (std::size_t i = 0; i < image.plane_size(); ++i) plane[i] = texels[channels * i + c];
    }
    return image;
}

TextureView view_of(const Texture& texture, TextureWrap wrap) {
    TextureView view;
    view.texels = texture.texels.data();
    view.width = texture.width;
    view.height = texture.height;
    view.channels = texture.channels;
    view.level_count = texture.level_count;
    view.wrap = wrap;
    for (int level = 0; level < texture.level_count; ++level) {
        view.first_texel[level] = texture.first_texel[static_cast<std::size_t>(level)];
    }
    return view;
}

}  // namespace kreda::raster
