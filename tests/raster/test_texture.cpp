// Textures against brute force: the pyramid as integrals over areas, look-ups as sums over texels, levels as stretch.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "raster/texture_passes.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

namespace {

Image random_image(Random& random, int width, int height, int channels = 1) {
    Image image = make_image(width, height, channels);
    for (float& value : image.values) value = random.real(0.0f, 1.0f);
    return image;
}

double mean_of(const Image& image) {
    double sum = 0.0;
    for (const float value : image.values) sum += double{value};
    return sum / static_cast<double>(image.values.size());
}

/// The integral of an image over a box, in texels, divided by its area: texels are squares of one value.
double mean_over_box(const Image& image, double x0, double x1, double y0, double y1) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double across = std::max(0.0, std::min(x1, x + 1.0) - std::max(x0, double(x)));
            const double down = std::max(0.0, std::min(y1, y + 1.0) - std::max(y0, double(y)));
            sum += across * down * double{image.at(0, x, y)};
        }
    }
    return sum / ((x1 - x0) * (y1 - y0));
}

/// Weight of texel k at u: a tent of width 2 around its centre; with repeat also around the centres of its copies.
double tent_weight(double u, int k, int side, TextureWrap wrap) {
    const double x = u * side - 0.5;
    if (wrap == TextureWrap::clamp) {
        const double inside = std::min(std::max(x, 0.0), side - 1.0);
        return std::max(0.0, 1.0 - std::abs(inside - k));
    }
    double weight = 0.0;
    const double cycle = std::floor(x / side) * side;
    for (int copy = -1; copy <= 2; ++copy) weight += std::max(0.0, 1.0 - std::abs(x - cycle - k - copy * side));
    return weight;
}

double bilinear_by_sum(const Image& image, double u, double v, TextureWrap wrap) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            sum += tent_weight(u, x, image.width, wrap) * tent_weight(1.0 - v, y, image.height, wrap) *
                   double{image.at(0, x, y)};
        }
    }
    return sum;
}

constexpr TextureWrap kWraps[] = {TextureWrap::repeat, TextureWrap::clamp};

}  // namespace

TEST_CASE("Centre of a texel is that texel exactly: nearest and bilinear and trilinear at level 0") {
    Random random(1);
    for (const auto& [width, height] : {std::pair(8, 4), std::pair(1, 1), std::pair(1, 16), std::pair(64, 2)}) {
        const Image image = random_image(random, width, height);
        const Texture texture = make_texture(image);
        for (const TextureWrap wrap : kWraps) {
            const TextureView view = view_of(texture, wrap);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
                    const float v = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
                    REQUIRE(sample_nearest(view, u, v, 0) == image.at(0, x, y));
                    REQUIRE(sample_bilinear(view, u, v, 0) == image.at(0, x, y));
                    REQUIRE(sample_trilinear(view, u, v, 0.0f, 0) == image.at(0, x, y));
                    REQUIRE(sample_trilinear(view, u, v, -7.0f, 0) == image.at(0, x, y));
                }
            }
        }
    }
}

TEST_CASE("Row 0 of the image is on top: v = 1 and u = 0 is its upper left corner") {
    Image image = make_image(2, 2, 1);
    image.values = {10, 11, 20, 21};
    const Texture texture = make_texture(image);
    const TextureView view = view_of(texture, TextureWrap::clamp);
    CHECK(sample_nearest(view, 0.1f, 0.9f, 0) == 10.0f);
    CHECK(sample_nearest(view, 0.9f, 0.9f, 0) == 11.0f);
    CHECK(sample_nearest(view, 0.1f, 0.1f, 0) == 20.0f);
    CHECK(sample_bilinear(view, 0.0f, 0.0f, 0) == 20.0f);
    CHECK(sample_bilinear(view, 0.5f, 0.5f, 0) == 15.5f);
}

TEST_CASE("Bilinear look-up is the sum over all texels with tent weights for any size and wrap") {
    Random random(2);
    for (int i = 0; i < 400; ++i) {
        const int width = random.integer(1, 9), height = random.integer(1, 9);
        const Image image = random_image(random, width, height);
        const Texture texture = make_texture(image, false);
        for (const TextureWrap wrap : kWraps) {
            const TextureView view = view_of(texture, wrap);
            const float u = random.real(-2.0f, 3.0f), v = random.real(-2.0f, 3.0f);
            CAPTURE(width);
            CAPTURE(height);
            CAPTURE(u);
            CAPTURE(v);
            // u times 9 texels rounds by 1.3e-7 of a texel for each unit of u, the difference of two texels is below 1.
            REQUIRE(std::abs(sample_bilinear(view, u, v, 0) - bilinear_by_sum(image, u, v, wrap)) < 4e-6);
        }
    }
}

TEST_CASE("Weights of all texels sum to one at any point: partition of unity") {
    Random random(3);
    const int width = 5, height = 3;
    for (int i = 0; i < 100; ++i) {
        const float u = random.real(-1.0f, 2.0f), v = random.real(-1.0f, 2.0f), level = random.real(0.0f, 3.0f);
        for (const TextureWrap wrap : kWraps) {
            double sum = 0.0;
            for (int k = 0; k < width * height; ++k) {
                Image image = make_image(width, height, 1);
                image.values[static_cast<std::size_t>(k)] = 1.0f;
                const Texture texture = make_texture(image);
                sum += double{sample_trilinear(view_of(texture, wrap), u, v, level, 0)};
            }
            REQUIRE(std::abs(sum - 1.0) < 1e-6);  // 15 texels, each rounded
        }
    }
}

TEST_CASE("Even image stays exactly even on every level and with every filter") {
    Random random(4);
    for (const auto& [width, height] : {std::pair(16, 16), std::pair(13, 7), std::pair(1, 11), std::pair(30, 1)}) {
        Image image = make_image(width, height, 1);
        std::fill(image.values.begin(), image.values.end(), 0.7f);
        const Texture texture = make_texture(image);
        for (const float texel : texture.texels) REQUIRE(texel == 0.7f);
        const TextureView view = view_of(texture, TextureWrap::repeat);
        for (int i = 0; i < 100; ++i) {
            const float u = random.real(-3.0f, 3.0f), v = random.real(-3.0f, 3.0f);
            REQUIRE(sample_trilinear(view, u, v, random.real(0.0f, 5.0f), 0) == 0.7f);
        }
    }
}

TEST_CASE("Texel of the next level is the mean of the area it covers for even and odd sizes") {
    Random random(5);
    for (const auto& [width, height] :
         {std::pair(8, 8), std::pair(7, 5), std::pair(9, 2), std::pair(3, 1), std::pair(1, 6)}) {
        const Texture texture = make_texture(random_image(random, width, height));
        for (int level = 1; level < texture.level_count; ++level) {
            const Image fine = level_image(texture, level - 1), coarse = level_image(texture, level);
            const double across = double(fine.width) / coarse.width, down = double(fine.height) / coarse.height;
            for (int y = 0; y < coarse.height; ++y) {
                for (int x = 0; x < coarse.width; ++x) {
                    const double mean = mean_over_box(fine, x * across, (x + 1) * across, y * down, (y + 1) * down);
                    REQUIRE(std::abs(coarse.at(0, x, y) - mean) < 1e-7);  // rounded to float once
                }
            }
        }
    }
}

TEST_CASE("Every level has the mean of the image and the last one is a single texel") {
    Random random(6);
    for (const auto& [width, height] : {std::pair(256, 256), std::pair(100, 37), std::pair(1000, 3), std::pair(1, 1)}) {
        const Image image = random_image(random, width, height);
        const Texture texture = make_texture(image);
        CHECK(texture.level_count == 1 + static_cast<int>(std::log2(std::max(width, height))));
        for (int level = 0; level < texture.level_count; ++level) {
            CHECK(std::abs(mean_of(level_image(texture, level)) - mean_of(image)) < 1e-6);
        }
        const Image last = level_image(texture, texture.level_count - 1);
        CHECK(last.values.size() == 1);
    }
}

TEST_CASE("Power of two: a texel of level L is the mean of 4^L texels of the image") {
    Random random(7);
    const Image image = random_image(random, 32, 16);
    const Texture texture = make_texture(image);
    const Image level = level_image(texture, 3);
    REQUIRE(level.width == 4);
    REQUIRE(level.height == 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) {
            const double mean = mean_over_box(image, x * 8.0, x * 8.0 + 8.0, y * 8.0, y * 8.0 + 8.0);
            CHECK(std::abs(level.at(0, x, y) - mean) < 3e-7);  // rounded to float three times
        }
    }
}

TEST_CASE("Checkerboard is exactly grey from level 1 on") {
    Image image = make_image(64, 64, 1);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) image.at(0, x, y) = static_cast<float>((x + y) % 2);
    }
    const Texture texture = make_texture(image);
    for (int level = 1; level < texture.level_count; ++level) {
        for (const float texel : level_image(texture, level).values) REQUIRE(texel == 0.5f);
    }
}

TEST_CASE("Repeat has no seam: the picture goes on where it ends and whole turns change nothing") {
    Random random(8);
    const Texture texture = make_texture(random_image(random, 16, 8));
    const TextureView view = view_of(texture, TextureWrap::repeat);
    for (int i = 0; i < 200; ++i) {
        const float v = random.real(0.0f, 1.0f), level = random.real(0.0f, 3.0f);
        const float left = sample_trilinear(view, -1e-6f, v, level, 0);
        const float right = sample_trilinear(view, 1e-6f, v, level, 0);
        REQUIRE(std::abs(left - right) < 2e-6f * 16 + 1e-6f);  // slope at most 16 a unit of u
        const float u = static_cast<float>(random.integer(0, 255)) / 256.0f;
        REQUIRE(sample_bilinear(view, u, v, 0) == sample_bilinear(view, u + 7.0f, v, 0));
        REQUIRE(sample_bilinear(view, u, v, 0) == sample_bilinear(view, u - 5.0f, v, 0));
    }
}

TEST_CASE("Any number as uv or level reads a texel of the texture") {
    Random random(9);
    const Texture texture = make_texture(random_image(random, 5, 3));
    const float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN();
    const float odd[] = {0.0f,  -0.0f,  1.0f, -1e-30f, 1e-30f,    0.99999994f, -1.0f,
                         1e20f, -1e20f, huge, -huge,   kInfinity, -kInfinity,  nan};
    for (const TextureWrap wrap : kWraps) {
        const TextureView view = view_of(texture, wrap);
        for (const float u : odd) {
            for (const float v : odd) {
                for (const float level : odd) {
                    REQUIRE(texel_at(u, 5, wrap) >= 0);
                    REQUIRE(texel_at(u, 5, wrap) < 5);
                    const TexelPair pair = texels_around(u, 5, wrap);
                    REQUIRE(std::min(pair.first, pair.second) >= 0);
                    REQUIRE(std::max(pair.first, pair.second) < 5);
                    const float value = sample_trilinear(view, u, v, level, 0);
                    REQUIRE(value >= 0.0f);
                    REQUIRE(value <= 1.0f);
                }
            }
        }
    }
}

TEST_CASE("Level of detail is log2 of the longer step in texels") {
    const glm::vec2 none(0.0f);
    for (int level = -3; level <= 8; ++level) {
        const float texels = std::ldexp(1.0f, level);
        CHECK(level_of_detail({texels / 256, 0.0f}, none, 256, 64) == static_cast<float>(level));
        CHECK(level_of_detail({0.0f, texels / 64}, none, 256, 64) == static_cast<float>(level));
        CHECK(level_of_detail(none, {texels / 256, 0.0f}, 256, 64) == static_cast<float>(level));
        CHECK(level_of_detail({0.001f / 256, 0.0f}, {0.0f, -texels / 64}, 256, 64) == static_cast<float>(level));
    }
    const float diagonal = level_of_detail({3.0f / 128, 4.0f / 128}, none, 128, 128);
    CHECK(diagonal == doctest::Approx(std::log2(5.0)).epsilon(1e-6));
    CHECK(level_of_detail(none, none, 64, 64) == -63.0f);
    CHECK(level_of_detail({kInfinity, 0.0f}, none, 64, 64) > 15.0f);
}

TEST_CASE("Trilinear at a whole level is that level and between two levels their mean") {
    Random random(10);
    const Texture texture = make_texture(random_image(random, 16, 16));
    const TextureView view = view_of(texture, TextureWrap::repeat);
    for (int i = 0; i < 100; ++i) {
        const float u = random.real(0.0f, 1.0f), v = random.real(0.0f, 1.0f);
        for (int level = 0; level < 4; ++level) {
            const float here = sample_level(view, u, v, level, 0), next = sample_level(view, u, v, level + 1, 0);
            REQUIRE(sample_trilinear(view, u, v, static_cast<float>(level), 0) == here);
            const float between = sample_trilinear(view, u, v, static_cast<float>(level) + 0.5f, 0);
            REQUIRE(std::abs(between - 0.5f * (here + next)) < 1e-6f);
        }
        REQUIRE(sample_trilinear(view, u, v, 99.0f, 0) == texture.texels.back());
    }
}

TEST_CASE("Batch look-up is the scalar look-up bit by bit and its level is that of the steps") {
    Random random(11);
    const Texture color = make_texture(random_image(random, 21, 13, 3));
    const Texture value = make_texture(random_image(random, 8, 8, 1));
    const auto fragments = std::make_unique<Fragments>();
    const auto level = std::make_unique<Channel>(), grey = std::make_unique<Channel>();
    const auto rgb = std::make_unique<Channel3>();
    fragments->count = 77;
    for (int i = 0; i < kChannelSize; ++i) {
        fragments->u.set(i, random.real(-2.0f, 2.0f));
        fragments->v.set(i, random.real(-2.0f, 2.0f));
        for (Channel* step : {&fragments->du_dx, &fragments->dv_dx, &fragments->du_dy, &fragments->dv_dy}) {
            step->set(i, random.real(-0.2f, 0.2f));
        }
    }
    const glm::vec2 scale(3.0f, 0.7f);
    set_levels(*fragments, color, {TextureFilter::trilinear, TextureWrap::repeat, scale}, *level);
    for (const auto filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
        for (const TextureWrap wrap : kWraps) {
            sample_color(*fragments, *level, color, {filter, wrap, scale}, *rgb);
            sample_value(*fragments, *level, value, {filter, wrap, scale}, *grey);
            const auto expected = [&](const Texture& texture, int i, int channel) {
                const TextureView view = view_of(texture, wrap);
                const float u = 3.0f * fragments->u.at(i), v = 0.7f * fragments->v.at(i);
                if (filter == TextureFilter::nearest) return sample_nearest(view, u, v, channel);
                if (filter == TextureFilter::bilinear) return sample_bilinear(view, u, v, channel);
                return sample_trilinear(view, u, v, level->at(i), channel);
            };
            for (int i = 0; i < fragments->count; ++i) {
                REQUIRE(rgb->at(i) == glm::vec3(expected(color, i, 0), expected(color, i, 1), expected(color, i, 2)));
                REQUIRE(grey->at(i) == expected(value, i, 0));
            }
        }
    }
    const glm::vec2 right(3.0f * fragments->du_dx.at(5), 0.7f * fragments->dv_dx.at(5));
    const glm::vec2 down(3.0f * fragments->du_dy.at(5), 0.7f * fragments->dv_dy.at(5));
    CHECK(level->at(5) == level_of_detail(right, down, 21, 13));
}
