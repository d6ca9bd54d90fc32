// Textures: an image with its mip pyramid, and what one point of it looks like: nearest, bilinear, trilinear.
//
// uv: u grows to the right and v upwards over the unit square, (0, 0) is the lower left corner of the picture. Texel
// centres of an image w x h stand at u = (x + 0.5) / w, v = 1 - (y + 0.5) / h, with row y = 0 on top.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "raster/aligned_vector.hpp"
#include "raster/image.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::raster {

/// How texels become a colour (docs/17_textures.md).
enum class TextureFilter {
    nearest,   ///< the texel that holds the point
    bilinear,  ///< the four texels around it
    trilinear  ///< eight: four on each of the two levels whose texels are nearest in size to a sample of the picture
};

/// What lies outside of the unit square.
enum class TextureWrap {
    repeat,  ///< the picture again
    clamp    ///< its border texels go on
};

/// Levels of the largest texture that can be read.
inline constexpr int kMaxTextureLevels = 16;

/// Every level half as large as the one before, rounded down, to a single texel; behind one another in `texels`, each
/// row by row from the top, the channels of a texel together (a look-up finds them in one cache line).
struct Texture {
    int width = 0;                                     ///< of level 0
    int height = 0;                                    ///< of level 0
    int channels = 0;                                  ///< 1 or 3
    int level_count = 0;                               ///< 1: there is no pyramid
    std::array<int, kMaxTextureLevels> first_texel{};  ///< of each level
    AlignedVector<float> texels;                       ///< linear; channel c of texel i is texels[channels * i + c]
};

/// A texture from an image of 1 or 3 linear channels, 1 to 32768 a side.
/// A texel of the next level is the mean of the area that it covers: 2 texels a side, or 3 weighted where the side is
/// odd (Guthe & Heckbert 2005). So the mean of every level is that of the image, and an even image stays exactly even.
[[nodiscard]] Texture make_texture(const Image& image, bool with_pyramid = true);

/// Width or height of a level.
inline int level_side(int side, int level) {
    const int shorter = side >> level;
    return shorter > 1 ? shorter : 1;
}

/// One level as an image, for looking at it.
[[nodiscard]] Image level_image(const Texture& texture, int level);

/// A texture as batch loops take it: by value, without owning anything.
struct TextureView {
    const float* texels = nullptr;            ///< of all levels; the texture owns them
    int width = 1;                            ///< of level 0, texels
    int height = 1;                           ///< of level 0, texels
    int channels = 1;                         ///< of a texel
    int level_count = 1;                      ///< at least 1
    TextureWrap wrap = TextureWrap::repeat;   ///< what lies beyond 0..1 of u and v
    int first_texel[kMaxTextureLevels] = {};  ///< where each level begins, texels
};

/// The texture as the sampling functions read it.
[[nodiscard]] TextureView view_of(const Texture& texture, TextureWrap wrap);

// ------------------------------------------------------------------------------------------------ along one axis

/// u within the picture: its fraction, or clamped. In [0, 1]; NaN and infinity become 0.
inline float wrapped(float u, TextureWrap wrap) {
    return saturate(wrap == TextureWrap::repeat ? u - std::floor(u) : u);
}

/// The texel of a row of `side` that holds u.
inline int texel_at(float u, int side, TextureWrap wrap) {
    const int texel = static_cast<int>(wrapped(u, wrap) * static_cast<float>(side));
    return texel < side ? texel : side - 1;
}

/// The two texels whose centres stand around a point, and how near it is to the second.
struct TexelPair {
    int first = 0, second = 0;  ///< columns or rows
    float weight = 0.0f;        ///< of the second, in [0, 1)
};

/// Both texels of the pair lie in the row: the one before the first is the last (repeat) or the first again (clamp).
inline TexelPair texels_around(float u, int side, TextureWrap wrap) {
    const bool repeat = wrap == TextureWrap::repeat;
    const float x = wrapped(u, wrap) * static_cast<float>(side) - 0.5f;
    const float below = std::floor(x);
    const int first = static_cast<int>(below);
    const int second = first + 1;
    const int before_first = repeat ? side - 1 : 0;
    const int after_last = repeat ? 0 : side - 1;
    return {first < 0 ? before_first : first, second < side ? second : after_last, x - below};
}

/// (1 - t) a + t b in the form that gives exactly a where a = b: what is even stays even.
inline float mix_texels(float a, float b, float t) {
    return a + t * (b - a);
}

// -------------------------------------------------------------------------------------------------------- look-ups

/// The texel that holds (u, v), level 0.
inline float sample_nearest(const TextureView& t, float u, float v, int channel) {
    const int x = texel_at(u, t.width, t.wrap);
    const int y = t.height - 1 - texel_at(v, t.height, t.wrap);
    return t.texels[t.channels * (y * t.width + x) + channel];
}

/// The four texels around (u, v) on one level, mixed by nearness.
inline float sample_level(const TextureView& t, float u, float v, int level, int channel) {
    const int width = level_side(t.width, level);
    const int height = level_side(t.height, level);
    const TexelPair x = texels_around(u, width, t.wrap);
    const TexelPair y = texels_around(v, height, t.wrap);
    const int lower = t.first_texel[level] + (height - 1 - y.first) * width;
    const int upper = t.first_texel[level] + (height - 1 - y.second) * width;
    const float lower_left = t.texels[t.channels * (lower + x.first) + channel];
    const float lower_right = t.texels[t.channels * (lower + x.second) + channel];
    const float upper_left = t.texels[t.channels * (upper + x.first) + channel];
    const float upper_right = t.texels[t.channels * (upper + x.second) + channel];
    const float below = mix_texels(lower_left, lower_right, x.weight);
    const float above = mix_texels(upper_left, upper_right, x.weight);
    return mix_texels(below, above, y.weight);
}

/// One channel, bilinear on the finest level.
inline float sample_bilinear(const TextureView& t, float u, float v, int channel) {
    return sample_level(t, u, v, 0, channel);
}

/// Between the two levels next to `level_of_detail`; below 0 the finest, beyond the last the last.     Williams 1983
inline float sample_trilinear(const TextureView& t, float u, float v, float level_of_detail, int channel) {
    const float coarsest = static_cast<float>(t.level_count - 1);
    const float not_finer = level_of_detail > 0.0f ? level_of_detail : 0.0f;
    const float level = not_finer < coarsest ? not_finer : coarsest;
    const int fine = static_cast<int>(level);
    const int coarse = fine + 1 < t.level_count ? fine + 1 : fine;
    const float of_fine = sample_level(t, u, v, fine, channel);
    const float of_coarse = sample_level(t, u, v, coarse, channel);
    return mix_texels(of_fine, of_coarse, level - static_cast<float>(fine));
}

/// Level of detail   lambda = log2 max(|step_x|, |step_y|)   in texels of level 0: 0 where a sample of the picture is
/// as wide as a texel, 1 where it is two wide.                 Williams 1983; OpenGL 4.6 specification, section 8.14.1
/// step_x, step_y: what (u, v) changes to the sample to the right and below. Negative where texels are larger than
/// samples; at least -63. Infinite steps give 64, the last level.
inline float level_of_detail(const glm::vec2& step_x, const glm::vec2& step_y, int width, int height) {
    const float w = static_cast<float>(width);
    const float h = static_cast<float>(height);
    const float right2 = step_x.x * w * (step_x.x * w) + step_x.y * h * (step_x.y * h);
    const float down2 = step_y.x * w * (step_y.x * w) + step_y.y * h * (step_y.y * h);
    const float longer2 = right2 > down2 ? right2 : down2;
    const float not_huge = longer2 < kMaxFinite ? longer2 : kMaxFinite;
    return 0.5f * log2(not_huge > kMinNormal ? not_huge : kMinNormal);
}

}  // namespace kreda::raster
