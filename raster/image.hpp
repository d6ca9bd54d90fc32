// An image as plain data: float channels, each a plane of its own (what a batch loop wants), the top row first.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>

#include "raster/aligned_vector.hpp"
#include "raster/platform.hpp"

namespace kreda::raster {

/// Channel c of the pixel in column x and row y is values[(c * height + y) * width + x].
struct Image {
    int width = 0;                ///< pixels
    int height = 0;               ///< pixels, row 0 on top
    int channels = 0;             ///< planes: 1, or 3 for red, green, blue
    AlignedVector<float> values;  ///< one plane a channel

    /// Place of a value in `values`.
    [[nodiscard]] std::size_t index(int c, int x, int y) const {
        KREDA_EXPECT(c >= 0 && c < channels && x >= 0 && x < width && y >= 0 && y < height);
        return (std::size_t(c) * std::size_t(height) + std::size_t(y)) * std::size_t(width) + std::size_t(x);
    }
    /// Value of channel c at column x, row y.
    [[nodiscard]] float at(int c, int x, int y) const {
        return values[index(c, x, y)];
    }
    /// The same, to be changed.
    [[nodiscard]] float& at(int c, int x, int y) {
        return values[index(c, x, y)];
    }

    /// The first value of channel c; width * height values follow, row by row.
    [[nodiscard]] const float* plane(int c) const {
        return values.data() + plane_size() * std::size_t(c);
    }
    /// The same, to be changed.
    [[nodiscard]] float* plane(int c) {
        return values.data() + plane_size() * std::size_t(c);
    }
    /// Values a channel: width times height.
    [[nodiscard]] std::size_t plane_size() const {
        return std::size_t(width) * std::size_t(height);
    }

    /// The first three channels of a pixel; an image of one or two channels is grey.
    [[nodiscard]] glm::vec3 rgb(int x, int y) const {
        return channels >= 3 ? glm::vec3(at(0, x, y), at(1, x, y), at(2, x, y)) : glm::vec3(at(0, x, y));
    }
    /// Replaces the first three channels.
    void set_rgb(int x, int y, glm::vec3 color) {
        at(0, x, y) = color.x;
        at(1, x, y) = color.y;
        at(2, x, y) = color.z;
    }
};

/// All values 0.
[[nodiscard]] inline Image make_image(int width, int height, int channels) {
    KREDA_EXPECT(width >= 0 && height >= 0 && channels >= 0);
    Image image{width, height, channels, {}};
    image.values.resize(image.plane_size() * std::size_t(channels));
    return image;
}

/// How many values are NaN or infinite: what golden images and environments must be asked before anything is quantised.
[[nodiscard]] inline std::size_t count_non_finite(const Image& image) {
    return static_cast<std::size_t>(
        std::count_if(image.values.begin(), image.values.end(), [](float v) { return !std::isfinite(v); }));
}

}  // namespace kreda::raster
